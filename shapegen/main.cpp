// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/signals.hpp"
#include "common/text.hpp"
#include "shapegen/command_line/command_line.hpp"
#include "shapegen/run_command.hpp"

#include <csignal>
#include <exception>
#include <iostream>
#include <string_view>
#include <thread>

#include <unistd.h>

namespace dem::shapegen {
namespace {

int fail(const std::exception& error, int code) {
    std::cerr << "shapegen: error: " << readable(error.what()) << '\n';
    return code;
}

/// Who interrupts the program leaves nothing half written. A thread waits for that, so that what it
/// does is not bound to what a signal handler may do. A signal that is to be ignored must not be
/// waited for: blocked, it would arrive.
void clean_up_when_interrupted() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (is_heeded(signal)) sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads that are made from now on
    std::thread([signals] {
        int signal = 0;
        sigwait(&signals, &signal);
        remove_pending_files();
        constexpr std::string_view words = "shapegen: interrupted, nothing written\n";
        const auto written = write(STDERR_FILENO, words.data(), words.size());
        _exit(written < 0 ? 1 : 128 + signal);
    }).detach();
}

}  // namespace
}  // namespace dem::shapegen

int main(int argc, char** argv) {
    dem::open_standard_streams();
    dem::shapegen::clean_up_when_interrupted();
    dem::survive_failing_writes();
    try {
        const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
        dem::shapegen::run_command(dem::shapegen::parse_command_line(arguments), std::cout);
        std::cout.flush();
        if (!std::cout) throw dem::Error("standard output", "could not be written");
        return 0;
    } catch (const dem::UsageError& error) {
        return dem::shapegen::fail(error, 2);
    } catch (const std::exception& error) {
        return dem::shapegen::fail(error, 1);
    }
}
