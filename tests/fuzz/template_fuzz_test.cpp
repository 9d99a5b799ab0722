// SPDX-License-Identifier: BSD-3-Clause
#include "common/random.hpp"
#include "tests/formats/sample_template.hpp"
#include "tests/fuzz/promise.hpp"

#include <cstring>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace dem {
namespace {

TEST(TemplateFuzz, EveryTruncationIsRejected) {
    const sample::Bytes good = sample::unchecked(sample::file());
    ASSERT_TRUE(fuzz::reads_template(good.bytes));
    for (std::size_t size = 0; size < good.bytes.size(); ++size) {
        ASSERT_FALSE(fuzz::reads_template(good.bytes.first(size))) << size;
    }
}

TEST(TemplateFuzz, EveryChangedByteIsRejected) {
    const sample::Bytes good = sample::unchecked(sample::file());
    Random random(1, 0);
    for (std::size_t i = 0; i < good.bytes.size(); ++i) {
        const std::byte old = good.bytes[i];
        // Every bit of the header and one or more random bits of every byte of the payload.
        const int tries = i < template_header_size ? 8 : 1;
        for (int k = 0; k < tries; ++k) {
            const unsigned change = i < template_header_size
                                        ? 1U << k
                                        : 1U + static_cast<unsigned>(random.next() % 255);
            good.bytes[i] = old ^ static_cast<std::byte>(change);
            ASSERT_FALSE(fuzz::reads_template(good.bytes)) << "byte " << i;
        }
        good.bytes[i] = old;
    }
    ASSERT_TRUE(fuzz::reads_template(good.bytes));
}

TEST(TemplateFuzz, RandomBytesAreRejectedWithAndWithoutAHeader) {
    for (std::uint64_t round = 0; round < 2000; ++round) {
        Random random(2, round);
        sample::Bytes soup(random.next() % 3000);
        for (std::byte& b : soup.bytes) b = static_cast<std::byte>(random.next());
        EXPECT_FALSE(fuzz::reads_template(soup.bytes));
        EXPECT_FALSE(fuzz::reads_template(sample::sealed(soup.bytes).bytes));
    }
}

/// One to four bytes changed, or left out, or numbers that are out by a little.
std::vector<std::byte> mutant(std::span<const std::byte> good, Random& random) {
    std::vector<std::byte> bytes(good.begin(), good.end());
    for (std::uint64_t k = 1 + random.next() % 4; k > 0; --k) {
        const std::size_t at = random.next() % bytes.size();
        switch (random.next() % 4) {
            case 0:
                bytes[at] = static_cast<std::byte>(random.next());
                break;
            case 1:
                bytes[at] = static_cast<std::byte>(0xff);
                break;
            case 2: {  // an offset or a length out by a little: misplaced, misaligned, too long
                const std::size_t word = at & ~std::size_t{3};
                std::uint32_t value = 0;
                if (word + 4 > bytes.size()) break;
                std::memcpy(&value, &bytes[word], 4);
                value += static_cast<std::uint32_t>(random.next() % 65) - 32U;
                std::memcpy(&bytes[word], &value, 4);
                break;
            }
            default:
                bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
                break;
        }
    }
    return bytes;
}

int rejected_mutants(std::span<const std::byte> good) {
    int rejected = 0;
    for (std::uint64_t round = 0; round < 10000; ++round) {
        Random random(3, round);
        const auto bytes = mutant(good, random);
        rejected += fuzz::reads_template(sample::sealed(bytes).bytes) ? 0 : 1;
    }
    return rejected;
}

TEST(TemplateFuzz, AMutatedPayloadUnderARightChecksumNeverLeavesTheBuffer) {
    const flatbuffers::DetachedBuffer payload = encode_template(sample::file());
    // Many a changed last digit is as good as the old one; offsets and lengths are not.
    EXPECT_GT(rejected_mutants(std::as_bytes(std::span(payload.data(), payload.size()))), 3000);
}

TEST(TemplateFuzz, SoDoesThatOfAWall) {
    std::ifstream file(WALL_OF_THE_CORPUS, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto bytes = std::as_bytes(std::span(text));
    ASSERT_TRUE(fuzz::reads_template(bytes));
    EXPECT_GT(rejected_mutants(bytes.subspan(template_header_size)), 3000);
}

}  // namespace
}  // namespace dem
