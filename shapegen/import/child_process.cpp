// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/child_process.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dem::shapegen {
namespace {

/// The first byte of an answer: what follows.
constexpr char result_follows = 'R';
constexpr char error_follows = 'E';

[[noreturn]] void fail(const char* what) {
    throw Error(what, std::generic_category().message(errno));
}

/// Virtual memory of this process [byte].
std::size_t memory_in_use() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::size_t value) {
    const rlimit both{value, value};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// Dies with its parent, says nothing, leaves no core, takes no more than its share.
void confine(const ChildLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const int signal : {SIGXCPU, SIGALRM, SIGPIPE}) std::signal(signal, SIG_DFL);
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds);
    alarm(10 * limits.seconds);
#ifdef __SANITIZE_ADDRESS__
    constexpr bool has_few_addresses = false;  // the sanitizer takes terabytes of them
#else
    constexpr bool has_few_addresses = true;
#endif
    if (has_few_addresses) limit(RLIMIT_AS, memory_in_use() + limits.bytes);
}

std::string answer(const std::function<std::string()>& work) {
    try {
        return result_follows + work();
    } catch (const std::bad_alloc&) {
        return error_follows + std::string("takes more memory than a file of its size may");
    } catch (const std::exception& error) {
        return error_follows + std::string(error.what());
    }
}

bool write_all(int pipe, const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t written = write(pipe, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno != EINTR) return false;
        done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    return true;
}

std::string read_all(int pipe) {
    std::string bytes;
    std::array<char, 1U << 16U> block{};
    for (;;) {
        const ssize_t size = read(pipe, block.data(), block.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(size));
    }
}

std::string ending(int status) {
    if (!WIFSIGNALED(status)) return "gives no answer";
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL)
        return "takes more time than a file of its size may";
    return std::string("crashes (") + strsignal(signal) + ")";
}

}  // namespace

std::string in_child_process(const std::function<std::string()>& work, const ChildLimits& limits) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
    const pid_t child = fork();
    if (child < 0) {
        const int reason = errno;
        close(ends[0]);
        close(ends[1]);
        errno = reason;
        fail("fork");
    }
    if (child == 0) {
        confine(limits);
        _exit(write_all(ends[1], answer(work)) ? 0 : 1);
    }
    close(ends[1]);
    const std::string bytes = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    const bool is_done = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !bytes.empty();
    if (!is_done) throw Error("the program that reads it " + ending(status));
    if (bytes.front() == error_follows) throw Error(bytes.substr(1));
    return bytes.substr(1);
}

}  // namespace dem::shapegen
