// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

int main(int argc, char** /*argv*/) {
    return std::cos(static_cast<double>(argc)) > 0.0 ? 0 : 1;
}
