// SPDX-License-Identifier: BSD-3-Clause
#include "common/signals.hpp"

#include <csignal>

namespace dem {

bool is_heeded(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_IGN;
}

void survive_file_size_limit() {
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace dem
