// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/case_lines.hpp"

#include "common/file_hash.hpp"
#include "common/format.hpp"
#include "formats/memory_map.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>

namespace dem::runtime {

namespace {

/// Keys of [run] that change no bit of any state on the way.
constexpr std::array<std::string_view, 5> free_keys = {"end_time", "stop", "overlap_limit",
                                                       "threads", "skin"};
/// Keys whose value is the path of a file, relative to the case file.
constexpr std::array<std::string_view, 2> file_keys = {"template", "file"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& keys, std::string_view key) {
    return std::ranges::find(keys, key) != keys.end();
}

/// Hashes of files, each read once however many sections name it.
class ContentHashes {
  public:
    const std::string& of(const std::filesystem::path& path) {
        const auto [entry, is_new] = texts_.try_emplace(path);
        if (is_new)
            entry->second =
                format("%016llx",
                       static_cast<unsigned long long>(file_hash(MemoryMap(path, "file").bytes())));
        return entry->second;
    }

  private:
    std::map<std::filesystem::path, std::string> texts_;
};

}  // namespace

std::vector<std::string> case_lines(const CaseFile& file) {
    const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
    std::vector<std::string> lines;
    ContentHashes hashes;
    for (const CaseSection& section : file.sections) {
        if (section.name == "output" || section.name.starts_with("measure.")) continue;
        const std::string name = "[" + section.name + "] ";
        for (const CaseEntry& entry : section.entries) {
            if (section.name == "run" && is_one_of(free_keys, entry.key)) continue;
            if (is_one_of(file_keys, entry.key)) {
                lines.push_back(name + entry.key + " of content " +
                                hashes.of(folder / entry.value));
            } else {
                lines.push_back(name + entry.key + " = " + entry.value);
            }
        }
    }
    return lines;
}

}  // namespace dem::runtime
