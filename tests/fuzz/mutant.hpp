// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/random.hpp"

#include <string>

namespace dem::fuzz {

/// A file with a few changes of a few bytes, as disks, editors and programs with faults make them.
std::string mutant(std::string bytes, Random& random);

}  // namespace dem::fuzz
