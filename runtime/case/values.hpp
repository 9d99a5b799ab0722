// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/math/types.hpp"
#include "runtime/case/case_file.hpp"
#include "runtime/case/key.hpp"
#include "runtime/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace dem::runtime {

/// Numbers with units: a unit stands for all numbers since the one before it, so that
/// "0 0 100 mm 20 cm" is two quantities of a vector and a number. Either every number has a unit or
/// none has (SI). Throws Error as parse_quantity does.
std::vector<double> parse_quantities(std::string_view text, Dimension dimension);

/// "box x y z  x y z" (lower and upper corner) or "cylinder x y z  x y z  r" (ends of the axis,
/// radius), with units. Throws Error.
Region parse_region(std::string_view text);

/// The values of one section, checked against what such a section may say. The constructor throws
/// Error for a key that is unknown or belongs to another choice, and for a missing one; the
/// readers for a value that is no such value or out of range. Every message has its line.
class Values {
  public:
    Values(const CaseSection& section, const SectionKind& kind);

    /// Whether the file gives the key.
    bool has(std::string_view key) const { return section_.find(key) != nullptr; }

    // Value of a key, or its default. The key must be one of the section's table.
    double number(std::string_view key) const;
    std::uint64_t count(std::string_view key) const;
    bool yes_no(std::string_view key) const;
    Vec3 vector(std::string_view key) const;
    Region region(std::string_view key) const;
    std::string text(std::string_view key) const;
    /// Enum whose values have the order of the key's words.
    template <class E>
    E choice(std::string_view key) const {
        return static_cast<E>(choice_index(key));
    }
    std::size_t choice_index(std::string_view key) const;  ///< of a name: the number of words

    // The same where a word ("auto") or nothing at all may stand instead: nullopt.
    std::optional<double> optional_number(std::string_view key) const;
    std::optional<Vec3> optional_vector(std::string_view key) const;
    /// `radius`, or half of `diameter` where the section says that [m].
    std::optional<double> radius() const;
    std::optional<Quat> optional_orientation(std::string_view key) const;

    /// A vector that must not be zero, normalized.
    Vec3 direction(std::string_view key) const;

    /// "case.ini:12: friction" for a key the file gives, else the section's line.
    std::string where(std::string_view key) const;
    const std::string& section_where() const { return section_.where; }
    const std::string& section_name() const { return section_.name; }

    /// The choice the section makes (or gets by default) for a key, as a word or a name.
    std::string_view word(std::string_view key) const;

  private:
    const Key& key_of(std::string_view key) const;
    bool applies(const Key& key) const;
    void check_key(const CaseEntry& entry) const;
    void check_range(const Key& key, double value) const;

    const CaseSection& section_;
    const SectionKind& kind_;
};

}  // namespace dem::runtime
