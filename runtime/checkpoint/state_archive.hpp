// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/error.hpp"
#include "common/math/types.hpp"
#include "common/text.hpp"
#include "runtime/files/checkpoint_file.hpp"

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// What is written into a checkpoint and read back. A class lists its state once, as calls of
/// `visit(name, member)`; with a StateWriter they save it, with a StateReader they restore it.
namespace dem::runtime {

/// Whether the bytes of a value are all there is to it, none of them padding: equal runs write
/// equal files (tests/cli/equal_files_test.cpp sees padding, the compiler does not tell). Eigen's
/// small types are arrays, too, but do not say so.
template <class T>
inline constexpr bool is_plain = std::is_trivially_copyable_v<T>;
template <>
inline constexpr bool is_plain<Vec3> = true;
template <>
inline constexpr bool is_plain<Quat> = true;

/// What a checkpoint says about the type of a value beside its size.
template <class T>
constexpr std::string_view plain_word() {
    if (std::is_floating_point_v<T>) return "real";
    return std::is_integral_v<T> || std::is_enum_v<T> ? "integer" : "record";
}

class StateWriter {
  public:
    template <class T>
    void operator()(const std::string& name, const std::vector<T>& values) {
        add(name, values.data(), values.size());
    }
    template <class T>
    void operator()(const std::string& name, const T& value) {
        add(name, &value, 1);
    }

    Checkpoint take() { return std::move(checkpoint_); }

  private:
    template <class T>
    void add(const std::string& name, const T* values, std::size_t count) {
        static_assert(is_plain<T>);
        const auto* first = reinterpret_cast<const std::byte*>(values);
        PlainValues stored{std::string(plain_word<T>()), sizeof(T), {}};
        if (count > 0) stored.bytes.assign(first, first + count * sizeof(T));
        const bool is_new = checkpoint_.emplace(name, std::move(stored)).second;
        DEM_ASSERT(is_new);
        static_cast<void>(is_new);
    }

    Checkpoint checkpoint_;
};

/// Throws Error naming the file for what is missing, of another type, or left over.
class StateReader {
  public:
    StateReader(Checkpoint checkpoint, std::string where)
        : checkpoint_(std::move(checkpoint)), where_(std::move(where)) {}

    bool has(const std::string& name) const { return checkpoint_.contains(name); }

    template <class T>
    void operator()(const std::string& name, std::vector<T>& values) {
        const PlainValues stored = take<T>(name);
        values.resize(stored.bytes.size() / sizeof(T));
        copy(stored, values.data());
    }
    template <class T>
    void operator()(const std::string& name, T& value) {
        const PlainValues stored = take<T>(name);
        if (stored.bytes.size() != sizeof(T)) fail("holds no single " + in_quotes(name));
        copy(stored, &value);
    }

    /// Everything must have been asked for: the rest is state that this program does not have.
    void finish() const {
        if (!checkpoint_.empty()) {
            fail("holds " + in_quotes(checkpoint_.begin()->first) +
                 ", which this program does not know");
        }
    }

    [[noreturn]] void fail(const std::string& found) const {
        throw Error(where_, found + ", expected a checkpoint of this program and case");
    }

  private:
    template <class T>
    PlainValues take(const std::string& name) {
        static_assert(is_plain<T>);
        const auto entry = checkpoint_.extract(name);
        if (entry.empty()) fail("holds no " + in_quotes(name));
        const PlainValues& stored = entry.mapped();
        if (stored.type != plain_word<T>() || stored.value_bytes != sizeof(T)) {
            fail("holds " + in_quotes(name) + " of another type");
        }
        return stored;
    }
    template <class T>
    static void copy(const PlainValues& stored, T* values) {
        if (stored.bytes.empty()) return;
        std::memcpy(static_cast<void*>(values), stored.bytes.data(), stored.bytes.size());
    }

    Checkpoint checkpoint_;
    std::string where_;
};

}  // namespace dem::runtime
