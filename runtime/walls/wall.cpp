// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/walls/wall.hpp"
