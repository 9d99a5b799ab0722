// SPDX-License-Identifier: BSD-3-Clause
// HDF5 files of the version 1.8 tolerate bytes behind their end. There stands one line with the
// checksum of all before it, looked at before HDF5 sees the file: it trusts what it reads.
#include "runtime/files/checkpoint_file.hpp"

#include "common/atomic_file.hpp"
#include "common/error.hpp"
#include "common/file_hash.hpp"
#include "formats/memory_map.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "runtime/files/hdf5_reader.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <system_error>

namespace dem::runtime {

namespace {

constexpr std::uint64_t checkpoint_layout = 2;  // raised when a reader would have to change
constexpr const char* checkpoint_kind = "checkpoint that demrun wrote";
constexpr std::string_view trailer_mark = "ShapeDEM checkpoint ";

/// The line behind the file: its mark and 16 hexadecimal digits.
std::string trailer(std::span<const std::byte> content) {
    char digits[18];
    std::snprintf(digits, sizeof digits, "%016llx\n",
                  static_cast<unsigned long long>(file_hash(content)));
    return std::string(trailer_mark) + digits;
}

void append_trailer(const PendingFile& file) {
    const std::string line = trailer(MemoryMap(file.temporary_path(), checkpoint_kind).bytes());
    errno = 0;
    std::ofstream out(file.temporary_path(), std::ios::binary | std::ios::app);
    out << line << std::flush;
    if (!out) {
        throw Error(file.final_path().string(),
                    "cannot write: " + std::generic_category().message(errno == 0 ? EIO : errno));
    }
}

void check_trailer(const std::filesystem::path& path) {
    const MemoryMap file(path, checkpoint_kind);
    constexpr std::size_t size = trailer_mark.size() + 17;
    const auto bytes = file.bytes();
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (bytes.size() < size || !text.substr(text.size() - size).starts_with(trailer_mark)) {
        throw Error(path.string(),
                    "is no checkpoint or is cut short, expected one that demrun wrote");
    }
    if (text.substr(text.size() - size) != trailer(bytes.first(bytes.size() - size))) {
        throw Error(path.string(),
                    "is damaged: found another checksum than its own, expected a checkpoint that "
                    "demrun wrote");
    }
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    PendingFile pending(path);
    {
        JournaledFile disk(pending);
        Hdf5File file(disk);
        file.describe("/", "layout", checkpoint_layout);
        file.describe("/", "program", std::string_view("ShapeDEM " DEM_VERSION));
        file.make_group("/state");
        for (const auto& [name, values] : checkpoint) file.write_plain("/state/" + name, values);
        file.close();
    }
    append_trailer(pending);
    pending.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
    check_trailer(path);
    const Hdf5Reader file(path);
    const std::string program = file.text("/", "program");
    if (file.number("/", "layout") != checkpoint_layout || program != "ShapeDEM " DEM_VERSION) {
        throw Error(path.string(),
                    "was written by " + program + ", expected ShapeDEM " DEM_VERSION);
    }
    Checkpoint checkpoint;
    for (const std::string& name : file.members("/state")) {
        checkpoint[name] = file.plain("/state/" + name);
    }
    return checkpoint;
}

}  // namespace dem::runtime
