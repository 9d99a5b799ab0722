// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/promise.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace dem::fuzz {

namespace {

bool is_one_line(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 32 || byte == 127;
    });
}

constexpr std::size_t longest_line = 1000;

std::string said(std::string_view fault, std::string_view line) {
    return std::string(fault) + ": " + std::string(line.substr(0, 2 * longest_line));
}

bool says_what_to_do(std::string_view message) {
    constexpr std::array<std::string_view, 6> ways = {"expected", "required", "need",
                                                      "belongs",  "again",    "did you mean"};
    return std::any_of(ways.begin(), ways.end(), [&](std::string_view way) {
        return message.find(way) != std::string_view::npos;
    });
}

class Folder {
  public:
    Folder() {
        // mkdtemp() puts the name's last six letters.
        std::string name = "/dev/shm/dem-fuzz-" + std::string(6, 'X');
        promise(mkdtemp(name.data()) != nullptr, "a folder in /dev/shm");
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace

void promise(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

void check_line(std::string_view line) {
    promise(is_one_line(line), said("it is one line without control characters", line));
    promise(line.size() <= longest_line, said("it is short", line));
}

void check_message(std::string_view thrown, std::span<const std::string> places) {
    // As the programs print it: names of files may hold any character.
    const std::string message = readable(thrown);
    check_line(message);
    const bool has_place = std::any_of(places.begin(), places.end(), [&](const std::string& place) {
        return message.starts_with(place);
    });
    promise(has_place, said("a message begins with its place", message));
    promise(says_what_to_do(message), said("a message says what was expected", message));
}

void promise_finite(double value, std::string_view what) {
    promise(std::isfinite(value), std::string(what) + " is finite");
}

void promise_finite(const Vec3& value, std::string_view what) {
    promise(value.allFinite(), std::string(what) + " is finite");
}

void promise_positive(double value, std::string_view what) {
    promise(std::isfinite(value) && value > 0.0, std::string(what) + " is positive");
}

const std::string& scratch_folder() {
    static const Folder folder;
    return folder.path();
}

}  // namespace dem::fuzz
