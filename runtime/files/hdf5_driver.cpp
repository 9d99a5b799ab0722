// SPDX-License-Identifier: BSD-3-Clause
// A virtual file driver: the functions by which HDF5 reaches a file, here those of JournaledFile.
#include "runtime/files/hdf5_driver.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <span>

namespace dem::runtime {

namespace {

/// What HDF5 carries around as the settings of the driver.
struct Settings {
    JournaledFile* file;
};

/// What HDF5 takes for an open file: its own part must come first.
struct OpenFile {
    H5FD_t common;
    JournaledFile* file;
    haddr_t allocated;  ///< end of what HDF5 has given out
};

OpenFile& of(H5FD_t* file) {
    return *reinterpret_cast<OpenFile*>(file);
}
const OpenFile& of(const H5FD_t* file) {
    return *reinterpret_cast<const OpenFile*>(file);
}

H5FD_t* open_file(const char*, unsigned flags, hid_t access, haddr_t) {
    const auto* settings = static_cast<const Settings*>(H5Pget_driver_info(access));
    if (settings == nullptr) return nullptr;
    if ((flags & H5F_ACC_TRUNC) != 0) settings->file->resize(0);
    return &std::make_unique<OpenFile>(OpenFile{{}, settings->file, 0}).release()->common;
}

herr_t close_file(H5FD_t* file) {
    const std::unique_ptr<OpenFile> owned(&of(file));
    return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
    if (of(a).file == of(b).file) return 0;
    return of(a).file < of(b).file ? -1 : 1;
}

// What HDF5 does with files of its own standard driver, so that it lays them out alike.
herr_t query(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

haddr_t allocated_end(const H5FD_t* file, H5FD_mem_t) {
    return of(file).allocated;
}

herr_t set_allocated_end(H5FD_t* file, H5FD_mem_t, haddr_t end) {
    of(file).allocated = end;
    return 0;
}

haddr_t file_end(const H5FD_t* file, H5FD_mem_t) {
    return of(file).file->size();
}

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size, void* buffer) {
    of(file).file->read(offset, {static_cast<std::byte*>(buffer), size});
    return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size,
             const void* buffer) {
    of(file).file->write(offset, {static_cast<const std::byte*>(buffer), size});
    return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
    of(file).file->resize(of(file).allocated);
    return 0;
}

H5FD_class_t driver_class() {
    H5FD_class_t functions{};
    functions.name = "journaled";
    functions.maxaddr = std::numeric_limits<std::int64_t>::max();
    functions.fc_degree = H5F_CLOSE_WEAK;
    functions.fapl_size = sizeof(Settings);
    functions.open = open_file;
    functions.close = close_file;
    functions.cmp = compare;
    functions.query = query;
    functions.get_eoa = allocated_end;
    functions.set_eoa = set_allocated_end;
    functions.get_eof = file_end;
    functions.read = read;
    functions.write = write;
    functions.truncate = truncate;
    // One list of free space per kind of allocation, as the standard driver has.
    const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(kinds), std::end(kinds), functions.fl_map);
    return functions;
}

hid_t driver() {
    static const H5FD_class_t functions = driver_class();
    static const hid_t id = H5FDregister(&functions);
    return id;
}

}  // namespace

herr_t use_journaled_file(hid_t access, JournaledFile& file) {
    const Settings settings{&file};
    return H5Pset_driver(access, driver(), &settings);
}

}  // namespace dem::runtime
