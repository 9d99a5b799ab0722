// SPDX-License-Identifier: BSD-3-Clause
// Prints a sum of bits of the C library's functions: it differs where the library has chosen other
// functions for the processor.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

int main() {
    std::uint64_t sum = 0;
    for (int n = 1; n < 10'000; ++n) {
        for (const double value : {std::sin(0.37 * n), std::exp(0.011 * n), std::log(0.7 * n)}) {
            sum = 3 * sum + std::bit_cast<std::uint64_t>(value);
        }
    }
    std::printf("%llu\n", static_cast<unsigned long long>(sum));
    return 0;
}
