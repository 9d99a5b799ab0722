// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/hdf5_handle.hpp"

#include <algorithm>
#include <string_view>

namespace dem::runtime {

std::string hdf5_reason() {
    std::string text;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned depth, const H5E_error2_t* error, void* target) -> herr_t {
            auto& found = *static_cast<std::string*>(target);
            const std::string description = error->desc == nullptr ? "" : error->desc;
            constexpr std::string_view mark = "error message = '";
            const std::size_t start = description.find(mark);
            if (start != std::string::npos) {
                const std::size_t first = start + mark.size();
                found = description.substr(first, description.find('\'', first) - first);
            } else if (depth == 0) {
                found = description;
            }
            return 0;
        },
        &text);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "unknown reason" : text;
}

void silence_hdf5() {
    // What HDF5 could not close, a damaged file, it would try to close again at the end of the
    // program, through a driver that is gone.
    static const herr_t ends_without_hdf5 = H5dont_atexit();
    static_cast<void>(ends_without_hdf5);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace dem::runtime
