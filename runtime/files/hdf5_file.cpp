// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/hdf5_file.hpp"

#include "common/error.hpp"
#include "runtime/files/hdf5_driver.hpp"
#include "runtime/files/hdf5_handle.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace dem::runtime {

namespace {

using Handle = Hdf5Handle;

// Smaller tables gain less from compression than its index costs.
constexpr std::size_t chunked_from = std::size_t{1} << 14;
constexpr std::size_t chunk_bytes = std::size_t{1} << 18;
constexpr unsigned deflate_level = 1;  // 4 takes twice as long and saves 1 % of doubles

/// Settings of a new file, group or table (H5P_..._CREATE) without the time at which it is made:
/// equal runs write equal files.
struct Untimed : Handle {
    explicit Untimed(hid_t kind) : Handle(H5Pcreate(kind), H5Pclose) {
        H5Pset_obj_track_times(*this, false);
    }
};

}  // namespace

Hdf5File::Hdf5File(JournaledFile& disk) : disk_(disk) {
    silence_hdf5();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    if (H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18) < 0 ||
        use_journaled_file(access, disk) < 0) {
        fail("set up");
    }
    const std::string name = disk.path().string();
    if (disk.size() == 0) {
        file_ = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, Untimed(H5P_FILE_CREATE), access);
        if (file_ < 0) fail("create");
    } else {
        file_ = H5Fopen(name.c_str(), H5F_ACC_RDWR, access);
        if (file_ < 0) fail("open");
    }
}

Hdf5File::~Hdf5File() {
    if (file_ < 0) return;
    H5Fclose(file_);
    disk_.discard();
}

void Hdf5File::close() {
    if (H5Fclose(std::exchange(file_, H5I_INVALID_HID)) < 0) {
        disk_.discard();
        fail("write");
    }
    disk_.commit();
}

void Hdf5File::fail(const std::string& action) const {
    throw Error(disk_.path().string(), "cannot " + action + ": " + hdf5_reason());
}

void Hdf5File::make_group(const std::string& name) {
    const Handle group(
        H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, Untimed(H5P_GROUP_CREATE), H5P_DEFAULT),
        H5Gclose);
    if (!group.is_valid()) fail("write " + name);
}

void Hdf5File::write_table(const std::string& name, const void* values, std::size_t rows,
                           std::size_t columns, Types types) {
    const std::array<hsize_t, 2> size = {rows, columns};
    const int rank = columns == 1 ? 1 : 2;
    const Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
    const Untimed layout(H5P_DATASET_CREATE);
    const std::size_t row_bytes = columns * H5Tget_size(types.in_file);
    if (rows * row_bytes >= chunked_from) {
        const std::array<hsize_t, 2> chunk = {
            std::min<hsize_t>(rows, std::max<hsize_t>(1, chunk_bytes / row_bytes)), columns};
        H5Pset_chunk(layout, rank, chunk.data());
        H5Pset_shuffle(layout);
        H5Pset_deflate(layout, deflate_level);
    }
    const Handle table(
        H5Dcreate2(file_, name.c_str(), types.in_file, space, H5P_DEFAULT, layout, H5P_DEFAULT),
        H5Dclose);
    if (!table.is_valid() ||
        (rows > 0 && H5Dwrite(table, types.in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)) {
        fail("write " + name);
    }
}

void Hdf5File::write(const std::string& name, std::span<const double> values, std::size_t columns) {
    write_table(name, values.data(), values.size() / columns, columns,
                {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE});
}
void Hdf5File::write(const std::string& name, std::span<const float> values, std::size_t columns) {
    write_table(name, values.data(), values.size() / columns, columns,
                {H5T_NATIVE_FLOAT, H5T_IEEE_F32LE});
}
void Hdf5File::write(const std::string& name, std::span<const std::uint32_t> values,
                     std::size_t columns) {
    write_table(name, values.data(), values.size() / columns, columns,
                {H5T_NATIVE_UINT32, H5T_STD_U32LE});
}
void Hdf5File::write(const std::string& name, std::span<const std::uint64_t> values,
                     std::size_t columns) {
    write_table(name, values.data(), values.size() / columns, columns,
                {H5T_NATIVE_UINT64, H5T_STD_U64LE});
}

void Hdf5File::write(const std::string& name, std::span<const std::string> values) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    std::vector<const char*> pointers;
    for (const std::string& value : values) pointers.push_back(value.c_str());
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle table(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT,
                                  Untimed(H5P_DATASET_CREATE), H5P_DEFAULT),
                       H5Dclose);
    if (!table.is_valid() ||
        (size > 0 && H5Dwrite(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) < 0)) {
        fail("write " + name);
    }
}

void Hdf5File::write_plain(const std::string& name, const PlainValues& values) {
    const Handle type(H5Tcreate(H5T_OPAQUE, values.value_bytes), H5Tclose);
    H5Tset_tag(type, values.type.c_str());
    // Not compressed: states are random but for their first bits, and a run waits meanwhile.
    const hsize_t size = values.bytes.size() / values.value_bytes;
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle table(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT,
                                  Untimed(H5P_DATASET_CREATE), H5P_DEFAULT),
                       H5Dclose);
    if (!table.is_valid() || (size > 0 && H5Dwrite(table, type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                                   values.bytes.data()) < 0)) {
        fail("write " + name);
    }
}

void Hdf5File::erase(const std::string& name) {
    if (H5Ldelete(file_, name.c_str(), H5P_DEFAULT) < 0) fail("erase " + name);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               const void* value, Types types) {
    const Handle target(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(
        H5Acreate2(target, name.c_str(), types.in_file, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.is_valid() || H5Awrite(attribute, types.in_memory, value) < 0) {
        fail("write " + name + " of " + object);
    }
}

void Hdf5File::describe(const std::string& object, const std::string& name, double value) {
    write_attribute(object, name, &value, {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE});
}
void Hdf5File::describe(const std::string& object, const std::string& name, std::uint64_t value) {
    write_attribute(object, name, &value, {H5T_NATIVE_UINT64, H5T_STD_U64LE});
}
void Hdf5File::describe(const std::string& object, const std::string& name,
                        std::string_view value) {
    // Of variable length, which h5py returns as text and not as bytes.
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    const std::string text(value);
    const char* pointer = text.c_str();
    write_attribute(object, name, &pointer, {type, type});
}

}  // namespace dem::runtime
