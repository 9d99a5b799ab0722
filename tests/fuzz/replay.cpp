// SPDX-License-Identifier: BSD-3-Clause
// The main function of a fuzz target in an ordinary build.
//
//   fuzz_READER FILE_OR_FOLDER...               reads the files one after the other
//   fuzz_READER --mutants N FILE_OR_FOLDER...   and N mutants of them, without guidance
//
// A mutant that ends the program or takes more than 5 s of a processor is left in ./mutant; one
// that takes more than 1 GB ends it.
#include "tests/fuzz/mutant.hpp"
#include "tests/fuzz/promise.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

std::string current;  ///< what is read now, for the signal handler

/// Calls nothing but what is safe in a signal handler.
void keep_current(int signal) {
    const int file = open("mutant", O_CREAT | O_WRONLY | O_TRUNC, 0644);
    const bool is_kept = write(file, current.data(), current.size()) >= 0;
    _exit(is_kept ? 128 + signal : 1);
}

void read_current() {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::byte*>(current.data()), current.size());
}

std::vector<std::filesystem::path> files_of(std::span<char* const> arguments) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path argument : arguments) {
        if (std::filesystem::is_directory(argument)) {
            for (const auto& entry : std::filesystem::directory_iterator(argument))
                files.push_back(entry.path());
        } else {
            files.push_back(argument);
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> replay(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> inputs;
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        current.assign(std::istreambuf_iterator<char>(stream), {});
        std::printf("%s\n", file.filename().c_str());
        std::fflush(stdout);  // names the file if reading it ends the program
        read_current();
        inputs.push_back(current);
    }
    return inputs;
}

void read_mutants(const std::vector<std::string>& inputs, std::uint64_t count) {
    // Of the processor: other work on the machine makes no reader slow.
    constexpr itimerval longest{{0, 0}, {5, 0}};
    const auto seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    const rlimit memory{std::size_t{1} << 30U, std::size_t{1} << 30U};
    setrlimit(RLIMIT_AS, &memory);
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGPROF})
        std::signal(signal, keep_current);
    const double start = seconds();
    double last = start;
    double slowest = 0.0;
    for (std::uint64_t k = 0; k < count; ++k) {
        dem::Random random(19, k);
        current = dem::fuzz::mutant(inputs[k % inputs.size()], random);
        setitimer(ITIMER_PROF, &longest, nullptr);
        read_current();
        const double now = seconds();
        slowest = std::max(slowest, now - last);
        last = now;
    }
    constexpr itimerval never{};
    setitimer(ITIMER_PROF, &never, nullptr);
    std::printf("%llu mutants in %.0f s, the slowest in %.3f s\n",
                static_cast<unsigned long long>(count), last - start, slowest);
}

}  // namespace

int main(int argc, char** argv) {
    std::span<char* const> arguments(argv + 1, static_cast<std::size_t>(argc - 1));
    std::uint64_t mutants = 0;
    if (arguments.size() > 2 && std::string_view(arguments[0]) == "--mutants") {
        mutants = std::stoull(arguments[1]);
        arguments = arguments.subspan(2);
    }
    const std::vector<std::string> inputs = replay(files_of(arguments));
    std::printf("%zu inputs\n", inputs.size());
    if (inputs.empty()) return 1;
    if (mutants > 0) read_mutants(inputs, mutants);
    return 0;
}
