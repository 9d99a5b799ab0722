// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/contact/law/contact_law.hpp"

namespace dem::test {

using namespace runtime;

/// Memory of a pair that has a history and no cache.
inline Memory<PointHistory, NoCache> memory_of(PointHistory& history) {
    static NoCache none;
    return {history, none};
}

}  // namespace dem::test
