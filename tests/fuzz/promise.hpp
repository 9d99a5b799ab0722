// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/error.hpp"
#include "common/math/types.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// What every reader promises whatever bytes it is given. A broken promise ends the program as a
/// crash does: a fuzzer keeps the input, a test fails.
namespace dem::fuzz {

using Bytes = std::span<const std::byte>;

inline std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Says which promise is broken and aborts unless it holds.
void promise(bool holds, std::string_view what);

/// What is said to the user is one line of text without control characters, no longer than a person
/// reads.
void check_line(std::string_view line);

/// A message is such a line, begins with the place of what is wrong (one of `places`) and says what
/// was expected.
void check_message(std::string_view thrown, std::span<const std::string> places);

/// What stands in targets/NAME.cpp: reads a whole file and looks at all that it holds. Whether the
/// bytes were accepted.
bool reads_profile(Bytes bytes);
bool reads_template(Bytes bytes);

/// Runs a reader, of which nothing but an Error with such a message may come. Whether it accepted
/// what it read.
template <class Read>
bool accepts(std::span<const std::string> places, const Read& read) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        check_message(error.what(), places);
        return false;
    }
}

void promise_finite(double value, std::string_view what);
void promise_finite(const Vec3& value, std::string_view what);
void promise_positive(double value, std::string_view what);

/// A folder in memory for readers of files, gone with the program.
const std::string& scratch_folder();

}  // namespace dem::fuzz

/// Every target reads one input and returns 0; fuzzers and tests/fuzz/replay.cpp call it.
extern "C" int LLVMFuzzerTestOneInput(const std::byte* data, std::size_t size);
