// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace dem {

/// Bad input or environment. The message is one line: where, what was found, what was expected.
/// `main` prints it as `PROGRAM: error: MESSAGE` and returns 1.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
    Error(const std::string& where, const std::string& message)
        : std::runtime_error(where + ": " + message) {}
};

/// Wrong command line: `main` prints the message and returns 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

}  // namespace dem

/// A promise of our own code, checked in debug builds only. Bad input is never an assertion.
#ifdef DEM_ASSERTIONS
#include <cstdio>
#include <cstdlib>
#define DEM_ASSERT(condition)                                                                    \
    do {                                                                                         \
        if (!(condition)) {                                                                      \
            std::fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                        \
        }                                                                                        \
    } while (false)
#else
#define DEM_ASSERT(condition) static_cast<void>(0)
#endif
