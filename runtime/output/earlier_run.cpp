// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/output/earlier_run.hpp"

#include "common/error.hpp"
#include "formats/file_kind.hpp"
#include "runtime/files/journaled_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <vector>

namespace dem::runtime {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> outputs = {
    "frames.h5",     "frames.xdmf",      "surfaces.h5",        "surfaces.xdmf", "contacts.h5",
    "contacts.xdmf", "wall_contacts.h5", "wall_contacts.xdmf", "history.csv",   "final.csv",
    "final.png",     "checkpoint.h5",    "summary.json"};

bool is_remains(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::size_t mark = name.find(".part-");
    if (mark == std::string::npos) return false;
    std::string_view whole = std::string_view(name).substr(0, mark);
    if (whole.ends_with(".journal")) whole.remove_suffix(std::string_view(".journal").size());
    return std::ranges::find(outputs, whole) != outputs.end();
}

}  // namespace

std::string earlier_results(const fs::path& folder) {
    std::error_code ignored;
    const auto has = [&](std::string_view name) { return fs::exists(folder / name, ignored); };
    if (std::ranges::none_of(outputs, has)) return "";
    const std::string found = has("summary.json")    ? "holds the results of a run"
                              : has("checkpoint.h5") ? "holds a run that has not ended"
                                                     : "holds a run without an end or a checkpoint";
    return found + ", expected another folder (--out), " +
           (has("checkpoint.h5") ? "--resume to go on with it, " : "") +
           "or --force to write over it";
}

void require_files(const fs::path& folder) {
    std::error_code ignored;
    for (const std::string_view name : outputs) {
        const fs::path path = folder / name;
        if (!fs::exists(path, ignored)) continue;
        const std::string found = no_file_at(path);
        if (!found.empty())
            throw Error(path.string(), found + ", expected a file of results or nothing");
    }
}

void mend_frames(const fs::path& folder) {
    for (const char* name : {"frames.h5", "surfaces.h5", "contacts.h5", "wall_contacts.h5"}) {
        const fs::path path = folder / name;
        if (no_file_at(path).empty()) const JournaledFile mended(path);
    }
}

void remove_remains(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> remains;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (is_remains(entry.path())) remains.push_back(entry.path());
    }
    for (const fs::path& path : remains) fs::remove(path, ignored);
}

}  // namespace dem::runtime
