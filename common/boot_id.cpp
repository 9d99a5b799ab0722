// SPDX-License-Identifier: BSD-3-Clause
#include "common/boot_id.hpp"

#include "common/state_hash.hpp"

#include <fstream>
#include <span>
#include <string>

namespace dem {

std::uint64_t boot_id() {
    std::ifstream in("/proc/sys/kernel/random/boot_id");
    std::string text;
    if (!std::getline(in, text)) return 0;
    StateHash hash;
    hash.add(std::span<const char>(text));
    return hash.value();
}

}  // namespace dem
