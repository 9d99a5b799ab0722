// SPDX-License-Identifier: BSD-3-Clause
#include "common/file_hash.hpp"

#include <string>

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(FileHash, IsXxh3OfTheBytesOnEveryMachine) {
    // The values of xxhsum -H3; short, middle and long contents take different ways.
    EXPECT_EQ(file_hash(std::string_view()), 0x2d06800538d394c2ULL);
    EXPECT_EQ(file_hash("ShapeDEM"), 0x9fda933846f73a6aULL);
    EXPECT_EQ(file_hash(std::string(200, 'x')), 0x50ef124fb1e4de53ULL);
    EXPECT_EQ(file_hash(std::string(5000, 'x')), 0x8d8567cbc9ee3d90ULL);
}

}  // namespace
}  // namespace dem
