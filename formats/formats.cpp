// SPDX-License-Identifier: BSD-3-Clause
#include "common/shapes/profile.hpp"
#include "runtime/contact/touch.hpp"
#include "runtime/scene.hpp"
