// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>

namespace dem {

struct Outcome {
    int code;            ///< exit code
    std::string output;  ///< stdout
    std::string errors;  ///< stderr
};

inline std::string content(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A program of the build tree, for the shell.
inline std::string program(const std::string& name) {
    return "'" DEM_BINARY_DIR "/bin/" + name + "'";
}

/// Runs a shell command in `folder`.
inline Outcome run_command(const std::string& shell_command, const std::filesystem::path& folder) {
    const std::filesystem::path errors = folder / "stderr.txt";
    const std::string command =
        "cd '" + folder.string() + "' && " + shell_command + " 2>'" + errors.string() + "'";
    FILE* pipe = popen(command.c_str(), "r");
    Outcome outcome{-1, {}, {}};
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        outcome.output.append(buffer.data(), n);
    }
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.errors = content(errors);
    return outcome;
}

}  // namespace dem
