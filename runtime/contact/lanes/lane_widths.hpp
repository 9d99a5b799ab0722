// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/lanes/lane_kernels.hpp"

/// Made by lane_width.cpp, which is compiled once for each.
namespace dem::runtime {

const LaneKernels& lane_kernels_2();
const LaneKernels& lane_kernels_4();  ///< for processors with AVX2
const LaneKernels& lane_kernels_8();  ///< for processors with AVX-512

}  // namespace dem::runtime
