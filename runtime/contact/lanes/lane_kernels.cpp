// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact/lanes/lane_kernels.hpp"

#include "runtime/contact/lanes/lane_widths.hpp"

namespace dem::runtime {

int widest_lanes() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("x86-64-v4") != 0) return 8;
    if (__builtin_cpu_supports("x86-64-v3") != 0) return 4;
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
