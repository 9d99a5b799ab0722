// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace dem::shapegen {

struct ChildLimits {
    unsigned seconds = 0;   ///< of processor time; ten times as many of the clock
    std::size_t bytes = 0;  ///< of memory beside what this process has
};

/// What `work` returns, worked out in a child process: whatever a library does there, crash, hang
/// or take all memory, this process goes on. Throws the Error that `work` throws, and one that says
/// how the child ended where it gave no answer.
std::string in_child_process(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace dem::shapegen
