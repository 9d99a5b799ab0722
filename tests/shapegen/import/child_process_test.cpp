// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/import/child_process.hpp"

#include "common/error.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

#include <unistd.h>

namespace dem::shapegen {
namespace {

constexpr ChildLimits limits{1, std::size_t{1} << 28U};

std::string refusal(const std::function<std::string()>& work) {
    return message_of<Error>([&] { in_child_process(work, limits); });
}

TEST(ChildProcess, GivesWhatTheWorkReturns) {
    EXPECT_EQ(in_child_process([] { return std::string("a\0b", 3); }, limits),
              std::string("a\0b", 3));
    EXPECT_EQ(in_child_process([] { return std::string(); }, limits), "");
    const std::string large(50'000'000, 'x');
    EXPECT_EQ(in_child_process([&] { return large; }, limits), large);
}

TEST(ChildProcess, PassesErrorsOn) {
    EXPECT_EQ(refusal([]() -> std::string { throw Error("found this, expected that"); }),
              "found this, expected that");
}

TEST(ChildProcess, CrashesAndHangsBecomeErrors) {
    EXPECT_NE(refusal([]() -> std::string { std::abort(); }).find("crashes (Aborted)"),
              std::string::npos);
    EXPECT_NE(refusal([]() -> std::string {
                  std::cerr << "words that nobody is to see\n";
                  std::raise(SIGKILL);
                  return "";
              }).find("more time"),
              std::string::npos);
    EXPECT_NE(refusal([]() -> std::string { _exit(0); }).find("gives no answer"),
              std::string::npos);
    EXPECT_NE(refusal([]() -> std::string {
                  const volatile bool goes_on = true;
                  while (goes_on) continue;
                  return "";
              }).find("more time"),
              std::string::npos);
}

#ifndef __SANITIZE_ADDRESS__
TEST(ChildProcess, MemoryHasALimit) {
    EXPECT_NE(refusal([]() -> std::string {
                  std::vector<std::unique_ptr<char[]>> all;
                  for (;;) all.emplace_back(new char[10'000'000]);
              }).find("more memory"),
              std::string::npos);
}
#endif

}  // namespace
}  // namespace dem::shapegen
