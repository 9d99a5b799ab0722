// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/integrator/body_lanes.hpp"

/// Made by body_width.cpp, which is compiled once for each.
namespace dem::runtime {

const BodyKernels& body_kernels_2();
const BodyKernels& body_kernels_4();  ///< for processors with AVX2
const BodyKernels& body_kernels_8();  ///< for processors with AVX-512

}  // namespace dem::runtime
