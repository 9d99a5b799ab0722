// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace dem {

/// Cores that this program may use, at least one: those of its affinity mask (taskset, batch
/// systems), and no more than the processor time of its control group makes up (containers).
int available_cores();

}  // namespace dem
