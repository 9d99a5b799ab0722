// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/frame_series.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "runtime/files/taken_up.hpp"

#include <vector>

namespace dem::runtime {

namespace {

/// Throws Error unless the frame, with its entry in the index, is as it was written.
void check_frame_of(const std::filesystem::path& path, const Hdf5Reader& file,
                    const std::string& group, std::span<const char* const> tables) {
    PartsHash hash;
    for (const char* name : tables) hash.add(file.content(group + "/" + name));
    hash.add(file.text(group, "xdmf"));
    if (hash.value() == file.number(group, "hash")) return;
    throw Error(path.string(), "holds " + group + " that was changed after it was written");
}

}  // namespace

FrameSeries::FrameSeries(const std::filesystem::path& directory, const Film& film,
                         std::uint64_t frames)
    : path_(directory / (film.name + ".h5")), index_(directory / (film.name + ".xdmf"), film.name) {
    if (frames > 0 && std::filesystem::exists(path_)) {
        take_up_or_say_how(path_, film.name, [&] { take_up(film, frames); });
        return;
    }
    begin(film);
}

void FrameSeries::begin(const Film& film) {
    index_.begin({});
    PendingFile pending(path_);
    {
        JournaledFile disk(pending);
        Hdf5File file(disk);
        film.write_beginning(file);
        file.make_group("/frames");
        file.close();
    }
    JournaledFile::forget(path_);
    pending.commit();
    disk_ = std::make_unique<JournaledFile>(path_);
}

void FrameSeries::take_up(const Film& film, std::uint64_t frames) {
    disk_ = std::make_unique<JournaledFile>(path_);
    std::vector<std::string> entries;
    std::vector<std::string> later;
    {
        const Hdf5Reader reader(path_);
        for (const std::string& name : reader.members("/frames")) {
            const std::string group = "/frames/" + name;
            const auto number = whole_number(name);
            if (!number)
                throw Error(path_.string(), "holds " + in_quotes(name) + " where numbers were");
            if (*number >= frames) {
                later.push_back(group);
                continue;
            }
            check_frame_of(path_, reader, group, film.tables);
            entries.push_back(reader.text(group, "xdmf"));
        }
    }
    index_.begin(entries);
    if (later.empty()) return;
    Hdf5File file(*disk_);
    for (const std::string& name : later) file.erase(name);
    file.close();
}

void FrameSeries::append(const std::string& frame_name,
                         const std::function<XdmfGrid(FrameTables&)>& write_tables) {
    Hdf5File file(*disk_);
    FrameTables tables(file, "/frames/" + frame_name + "/");
    const XdmfGrid grid = write_tables(tables);
    const std::string entry = index_.entry(grid);
    file.describe(tables.group(), "time", grid.time);
    file.describe(tables.group(), "count", std::uint64_t{grid.cells.rows});
    file.describe(tables.group(), "hash", tables.hash(entry));
    file.describe(tables.group(), "xdmf", entry);
    file.close();
    index_.append(entry);
}

}  // namespace dem::runtime
