// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapegen/profile/profile_text.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Shapes given by `shape = NAME` and settings with their dimensions: what `.profile` and `.convex`
/// files have in common.
namespace dem::shapegen {

/// No body is smaller or larger, and no point farther away [m].
inline constexpr double least_length = 1e-12;
inline constexpr double most_length = 1e6;

/// The settings of a named shape, by name, with their places for messages. Every function throws
/// Error(file:line, ...) for a value that is missing or not what the function is named after.
class ShapeParameters {
  public:
    explicit ShapeParameters(const ProfileText& text) : text_(text) {}

    const ProfileText& text() const { return text_; }
    bool has(std::string_view name) const { return text_.settings.contains(name); }
    double length(std::string_view name) const;          ///< above zero [m]
    double length_or_zero(std::string_view name) const;  ///< [m]
    double radius() const;                               ///< `radius`, or half of `diameter` [m]
    double number(std::string_view name) const;

    /// "found 'name = value', expected ...".
    [[noreturn]] void fail(std::string_view name, const std::string& expected) const;

  private:
    const ProfileText::Setting& setting(std::string_view name, const char* expected) const;

    const ProfileText& text_;
};

/// Throws Error for a setting that is none of `known`, `shape` or `units`.
void check_parameters(const ProfileText& text, const std::vector<std::string>& known);

[[noreturn]] void fail_on_shape(const ProfileText& text, const std::vector<std::string>& known);

/// The entry whose `name` is the value of `shape`, which must be set. Throws Error that names all
/// entries.
template <class Named>
const Named& find_named(const ProfileText& text, const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& candidate : all) {
        if (candidate.name == text.settings.find("shape")->second.value) return candidate;
        names.push_back(candidate.name);
    }
    fail_on_shape(text, names);
}

}  // namespace dem::shapegen
