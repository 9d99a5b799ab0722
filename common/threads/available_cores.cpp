// SPDX-License-Identifier: BSD-3-Clause
#include "common/threads/available_cores.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <sched.h>

namespace dem {

namespace {

int cores_of_affinity() {
    cpu_set_t set;
    CPU_ZERO(&set);
    // Fails on machines of more than 1024 cores.
    if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
    return static_cast<int>(std::thread::hardware_concurrency());
}

/// The folder of this process below that of all groups (version 2; in a container: "/").
std::string control_group() {
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::")) return line.substr(3);
    return "/";
}

/// Cores that the quota of a group and of those around it makes up; `most` without one.
double cores_of_quota(double most) {
    const std::filesystem::path root = "/sys/fs/cgroup";
    for (std::filesystem::path group = control_group();; group = group.parent_path()) {
        std::ifstream limit(root / group.relative_path() / "cpu.max");
        double quota = 0.0;  // [us] of every period; the file says "max" where there is none
        double period = 0.0;
        if (limit >> quota >> period && period > 0.0) most = std::min(most, quota / period);
        if (!group.has_relative_path()) return most;
    }
}

}  // namespace

int available_cores() {
    const double cores = cores_of_quota(cores_of_affinity());
    return std::max(1, static_cast<int>(std::ceil(cores)));
}

}  // namespace dem
