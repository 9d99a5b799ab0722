// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/error.hpp"
#include "shapegen/command_line.hpp"
#include "shapegen/run_command.hpp"

#include <exception>
#include <iostream>

namespace {

int fail(const std::exception& error, int code) {
    std::cerr << "shapegen: error: " << error.what() << '\n';
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::span<const char* const> arguments(argv, static_cast<std::size_t>(argc));
        dem::run_command(dem::parse_command_line(arguments), std::cout);
        std::cout.flush();
        if (!std::cout) throw dem::Error("standard output", "could not be written");
        return 0;
    } catch (const dem::UsageError& error) {
        return fail(error, 2);
    } catch (const std::exception& error) {
        return fail(error, 1);
    }
}
