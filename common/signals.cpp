// SPDX-License-Identifier: BSD-3-Clause
#include "common/signals.hpp"

#include <cstdlib>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace dem {

namespace {

volatile std::sig_atomic_t first_signal = 0;

std::time_t steady_time() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);  // safe in a signal handler
    return now.tv_sec;
}

/// One that follows at once is the same request: `timeout` signals a program and then its group.
/// Others than Ctrl-C are repeated by machines while the results are written: SIGXCPU comes every
/// second, and batch systems send SIGTERM after SIGUSR1.
void note(int signal) {
    static volatile std::time_t first_time = 0;
    const std::time_t now = steady_time();
    if (first_signal == 0) {
        first_time = now;
        first_signal = signal;
    } else if (signal == SIGINT && now - first_time > 1) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

bool is_heeded(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_IGN;
}

void note_stop_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
        if (is_heeded(signal)) std::signal(signal, note);
    }
}

const volatile std::sig_atomic_t& stop_signal() {
    return first_signal;
}

void end_by_signal(int signal) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal);  // where the signal is blocked
}

std::string signal_name(int signal) {
    const char* name = sigabbrev_np(signal);
    return name == nullptr ? "signal " + std::to_string(signal) : std::string("SIG") + name;
}

void survive_failing_writes() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void open_standard_streams() {
    int number = 0;
    // The lowest number that is free is the next one given.
    while (number >= 0 && number <= STDERR_FILENO) number = open("/dev/null", O_RDWR);
    if (number > STDERR_FILENO) close(number);
}

}  // namespace dem
