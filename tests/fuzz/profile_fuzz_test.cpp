// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "tests/fuzz/promise.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem {
namespace {

std::vector<std::string> shipped_profiles() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(DEM_SOURCE_DIR "/data/profiles"))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts;
    for (const auto& path : paths) {
        std::ifstream stream(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>());
    }
    texts.emplace_back("start 0 -3\ncurve 1.5 -2 2 0 1.2 2\nbezier 1 3 0.5 3 0 3");
    texts.emplace_back(
        "start 1 -1\nline 2 -1\nfillet 0.3\narc 2 1 through 1.5 0\nellipse_arc 0 3 semi_axes 2 2");
    return texts;
}

/// Ends the program where a promise is broken.
void expect_profile_or_error(const std::string& text) {
    fuzz::reads_profile(std::as_bytes(std::span(text)));
}

TEST(ProfileFuzz, TruncatedFilesAreProfilesOrErrors) {
    for (const std::string& text : shipped_profiles())
        for (std::size_t size = 0; size < text.size(); ++size)
            expect_profile_or_error(text.substr(0, size));
}

TEST(ProfileFuzz, ChangedFilesAreProfilesOrErrors) {
    const std::string letters = "0123456789.-+e =#\n\tmn,;inf";
    Random random(3, 0);
    const auto below = [&random](std::size_t n) {
        return static_cast<std::size_t>(random.next() % n);
    };
    for (const std::string& text : shipped_profiles())
        for (int i = 0; i < 300; ++i) {
            std::string changed = text;
            for (std::size_t k = 1 + below(4); k-- > 0;) {
                const std::size_t at = below(changed.size());
                if (below(3) == 0) {
                    changed[at] = static_cast<char>(random.next());
                } else if (below(2) == 0) {
                    changed[at] = letters[below(letters.size())];
                } else {
                    changed.insert(at, 1, letters[below(letters.size())]);
                }
            }
            expect_profile_or_error(changed);
        }
}

TEST(ProfileFuzz, RandomPathsAreProfilesOrErrors) {
    Random random(4, 0);
    const std::vector<std::string> commands{"line",  "arc",    "ellipse_arc",
                                            "curve", "bezier", "fillet"};
    const auto number = [&random] { return " " + std::to_string(random.uniform(0.0, 3.0)); };
    for (int i = 0; i < 3000; ++i) {
        std::string text = "start" + number() + " -1\n";
        for (int k = 0; k < 4; ++k) {
            const std::string& command = commands[random.next() % commands.size()];
            text += command + number();
            if (command != "fillet") text += number();
            if (command == "arc") text += " radius" + number();
            if (command == "ellipse_arc") text += " semi_axes" + number() + number();
            if (command == "curve") text += number() + number();
            if (command == "bezier") text += number() + number() + number() + number();
            if (random.uniform() < 0.2 && command.ends_with("arc")) text += " right";
            text += "\n";
        }
        expect_profile_or_error(text + "line 0 4\n");
    }
}

}  // namespace
}  // namespace dem
