// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrator/body_lanes.hpp"

#include "runtime/integrator/body_widths.hpp"

namespace dem::runtime {

const BodyKernels& body_kernels(int width) {
    static const BodyKernels none;
    switch (width) {
#if defined(__x86_64__)
        case 8:
            return body_kernels_8();
        case 4:
            return body_kernels_4();
#endif
        case 2:
            return body_kernels_2();
        default:
            return none;
    }
}

}  // namespace dem::runtime
