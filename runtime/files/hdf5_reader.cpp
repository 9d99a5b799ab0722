// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/hdf5_reader.hpp"

#include "common/error.hpp"
#include "runtime/files/hdf5_handle.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

using Handle = Hdf5Handle;

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path) {
    silence_hdf5();
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access, false, true);
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    if (file_ < 0) throw Error(path.string(), "cannot open: " + hdf5_reason());
}

Hdf5Reader::~Hdf5Reader() {
    H5Fclose(file_);
}

void Hdf5Reader::fail(const std::string& what) const {
    throw Error(path_.string(), "cannot read " + what + ": " + hdf5_reason());
}

std::vector<std::string> Hdf5Reader::members(const std::string& group) const {
    const Handle handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* target) -> herr_t {
        static_cast<std::vector<std::string>*>(target)->emplace_back(name);
        return 0;
    };
    if (!handle.is_valid() ||
        H5Literate(handle, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add, &names) < 0) {
        fail(group);
    }
    std::ranges::sort(names);
    return names;
}

std::string Hdf5Reader::text(const std::string& object, const std::string& attribute) const {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    const Handle handle(
        H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    char* value = nullptr;
    if (!handle.is_valid() || H5Aread(handle, type, &value) < 0) {
        fail(attribute + " of " + object);
    }
    std::string text = value == nullptr ? "" : value;
    H5free_memory(value);
    return text;
}

std::uint64_t Hdf5Reader::number(const std::string& object, const std::string& attribute) const {
    const Handle handle(
        H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    std::uint64_t value = 0;
    if (!handle.is_valid() || H5Aread(handle, H5T_NATIVE_UINT64, &value) < 0) {
        fail(attribute + " of " + object);
    }
    return value;
}

std::uint64_t Hdf5Reader::size(const std::string& table) const {
    const Handle data(H5Dopen2(file_, table.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(data), H5Sclose);
    const hssize_t size = H5Sget_simple_extent_npoints(space);
    if (size < 0) fail(table);
    return static_cast<std::uint64_t>(size);
}

std::vector<std::byte> Hdf5Reader::content(const std::string& table) const {
    const Handle data(H5Dopen2(file_, table.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle type(H5Dget_type(data), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) fail(table);
    std::vector<std::byte> bytes(size(table) * H5Tget_size(type));
    if (!bytes.empty() && H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) {
        fail(table);
    }
    return bytes;
}

PlainValues Hdf5Reader::plain(const std::string& name) const {
    const Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle type(H5Dget_type(data), H5Tclose);
    if (H5Tget_class(type) != H5T_OPAQUE) fail(name);
    PlainValues values;
    char* tag = H5Tget_tag(type);
    values.type = tag == nullptr ? "" : tag;
    H5free_memory(tag);
    values.value_bytes = H5Tget_size(type);
    values.bytes.resize(size(name) * values.value_bytes);
    if (!values.bytes.empty() &&
        H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.bytes.data()) < 0) {
        fail(name);
    }
    return values;
}

}  // namespace dem::runtime
