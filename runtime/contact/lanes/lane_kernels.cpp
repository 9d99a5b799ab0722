// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/lanes/lane_kernels.hpp"

#include "runtime/contact/lanes/lane_widths.hpp"

namespace dem::runtime {

int widest_lanes() {
#if defined(__x86_64__)
    // What x86-64-v3 and x86-64-v4 stand for, in words that GCC 12 and Clang 14 both know.
    __builtin_cpu_init();
    const bool has_v3 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                        __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
    const bool has_v4 =
        has_v3 && __builtin_cpu_supports("avx512f") != 0 &&
        __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
        __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
    if (has_v4) return 8;
    if (has_v3) return 4;
#endif
    return 2;
}

const LaneKernels* lane_kernels(int width) {
    static const LaneKernels none;
    if (width > widest_lanes()) return nullptr;
    switch (width) {
#if defined(__x86_64__)
        case 8:
            return &lane_kernels_8();
        case 4:
            return &lane_kernels_4();
#endif
        case 2:
            return &lane_kernels_2();
        case 1:
            return &none;
        default:
            return nullptr;
    }
}

}  // namespace dem::runtime
