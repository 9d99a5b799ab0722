// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/contact_law/contact_point.hpp"
