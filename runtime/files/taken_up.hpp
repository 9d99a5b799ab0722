// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/error.hpp"
#include "formats/file_kind.hpp"

#include <exception>
#include <filesystem>
#include <string>

namespace dem::runtime {

/// Calls `take_up`, which goes on with the file of an earlier run. Whatever is wrong with that
/// becomes an Error that names the way out. `what` the file should hold: "frames".
template <class TakeUp>
void take_up_or_say_how(const std::filesystem::path& path, const std::string& what,
                        const TakeUp& take_up) {
    const std::string expected = ", expected the " + what +
                                 " before the checkpoint; move the file away and --resume begins "
                                 "a new one";
    if (const std::string found = no_file_at(path); !found.empty()) {
        throw Error(path.string(), found + expected);
    }
    try {
        take_up();
    } catch (const Error& error) {
        throw Error(error.what() + expected);
    } catch (const std::exception&) {  // a size that no memory holds
        throw Error(path.string(), "cannot be read" + expected);
    }
}

}  // namespace dem::runtime
