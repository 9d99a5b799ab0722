// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/values.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "runtime/domain.hpp"

#include <algorithm>
#include <cmath>

namespace dem::runtime {

namespace {

std::vector<std::string> strings(const std::vector<std::string_view>& views) {
    return {views.begin(), views.end()};
}

bool contains(std::string_view words, std::string_view word) {
    const auto all = split(words, ' ');
    return std::find(all.begin(), all.end(), word) != all.end();
}

std::vector<std::string_view> blank_separated(std::string_view text) {
    std::vector<std::string_view> words;
    for (const std::string_view piece : split(text, ' ')) {
        for (const std::string_view word : split(piece, '\t')) words.push_back(word);
    }
    return words;
}

/// Where the known keys of other sections hold `key`: "; it belongs in [contact]".
std::string other_section(std::string_view key) {
    for (const SectionKind& kind : section_kinds()) {
        if (kind.find(key) != nullptr) {
            return ", it belongs in [" + std::string(kind.pattern) + "]";
        }
    }
    return "";
}

}  // namespace

std::vector<double> parse_quantities(std::string_view text, Dimension dimension) {
    std::vector<double> values;
    std::size_t without_unit = 0;  // the last ones of `values`
    bool any_unit = false;
    const auto apply = [&](std::string_view unit) {
        const double factor = unit_factor(unit, dimension);
        for (std::size_t k = values.size() - without_unit; k < values.size(); ++k) {
            values[k] *= factor;
        }
        without_unit = 0;
        any_unit = true;
    };
    for (const std::string_view word : blank_separated(text)) {
        const bool is_number =
            word != "1/s" &&
            std::string_view("+-.0123456789").find(word.front()) != std::string_view::npos;
        if (!is_number && without_unit > 0 && !word.starts_with("nan") &&
            !word.starts_with("inf")) {
            apply(word);
            continue;
        }
        const NumberAhead number = number_ahead(word);
        // Anything odd (NaN, too large, no number) gets the message of the single quantity.
        if (!number.is_finite()) parse_quantity(word, dimension);
        values.push_back(number.value);
        ++without_unit;
        if (!number.rest.empty()) apply(number.rest);
    }
    if (any_unit && without_unit > 0) {
        throw Error("found " + in_quotes(text) +
                    ", expected a unit after every number or after none");
    }
    return values;
}

Region parse_region(std::string_view text) {
    const auto words = blank_separated(text);
    const std::string_view shape = words.front();
    if (shape != "box" && shape != "cylinder") {
        throw Error("found " + in_quotes(shape) +
                    ", expected a region: 'box x y z  x y z' or 'cylinder x "
                    "y z  x y z  radius', with units");
    }
    const std::size_t expected = shape == "box" ? 6 : 7;
    const auto v = parse_quantities(text.substr(shape.size()), Dimension::length);
    if (v.size() != expected) {
        throw Error("found " + std::to_string(v.size()) + " numbers after " + in_quotes(shape) +
                    ", expected " + std::to_string(expected));
    }
    for (const double length : v) {
        if (std::abs(length) <= farthest_coordinate) continue;
        throw Error(
            "found a coordinate beyond 1e6 m, expected the region within 1e6 m of the "
            "origin");
    }
    const Vec3 first(v[0], v[1], v[2]);
    const Vec3 second(v[3], v[4], v[5]);
    if (shape == "box") {
        if (!(first.array() < second.array()).all()) {
            throw Error(
                "found a second corner that is not above the first, expected x, y and z above "
                "those "
                "of the first");
        }
        return BoxRegion{{first, second}};
    }
    if (first == second)
        throw Error("found the same point for both ends of the axis, expected a length");
    if (!(v[6] > 0.0)) throw Error("found a radius of the cylinder <= 0, expected > 0");
    return CylinderRegion{first, second, v[6]};
}

Values::Values(const CaseSection& section, const SectionKind& kind)
    : section_(section), kind_(kind) {
    // A choice that is still to come brings keys of its own, which are not to blame.
    for (const CaseEntry& entry : section_.entries) {
        const Key* key = kind_.find(entry.key);
        if (key != nullptr && contains(key->later, entry.value)) choice_index(entry.key);
    }
    for (const CaseEntry& entry : section_.entries) check_key(entry);
    for (const Key& key : kind_.keys) {
        if (!key.required || has(key.name) || !applies(key)) continue;
        throw Error(section_.where, "no " + in_quotes(key.name) + " in [" + section_.name +
                                        "], it is required" +
                                        (key.when.empty() ? "" : " for " + std::string(key.when)));
    }
}

void Values::check_key(const CaseEntry& entry) const {
    const Key* key = kind_.find(entry.key);
    if (key == nullptr) {
        std::vector<std::string> known;
        for (const Key& k : kind_.keys) known.emplace_back(k.name);
        const std::string elsewhere = other_section(entry.key);
        throw Error(entry.where,
                    "unknown key " + in_quotes(entry.key) + " in [" + section_.name + "]" +
                        (elsewhere.empty() ? suggestion_or_all(entry.key, known) : elsewhere));
    }
    if (key->later == key->name) {
        throw Error(entry.where,
                    in_quotes(entry.key) + " is not in this version, expected no such key");
    }
    if (!applies(*key)) {
        const std::string_view control = split(key->when, '=')[0];
        throw Error(entry.where, "key " + in_quotes(entry.key) + " has no meaning for " +
                                     std::string(control) + " = " + std::string(word(control)) +
                                     ", it needs " + std::string(key->when));
    }
}

bool Values::applies(const Key& key) const {
    if (key.when.empty()) return true;
    const auto condition = split(key.when, '=');
    const auto choices = split(condition[1], '|');
    return std::find(choices.begin(), choices.end(), word(condition[0])) != choices.end();
}

const Key& Values::key_of(std::string_view key) const {
    const Key* found = kind_.find(key);
    DEM_ASSERT(found != nullptr);
    return *found;
}

std::string Values::where(std::string_view key) const {
    const CaseEntry* entry = section_.find(key);
    if (entry == nullptr) return section_.where;
    return entry->where.starts_with("--set") ? entry->where : entry->where + ": " + entry->key;
}

std::string Values::text(std::string_view key) const {
    const CaseEntry* entry = section_.find(key);
    return entry != nullptr ? entry->value : std::string(key_of(key).standard);
}

std::string_view Values::word(std::string_view key) const {
    const auto words = split(key_of(key).words, ' ');
    const std::size_t index = choice_index(key);
    return index < words.size() ? words[index] : std::string_view(section_.find(key)->value);
}

std::size_t Values::choice_index(std::string_view key) const {
    const Key& k = key_of(key);
    const std::string value = text(key);
    const auto words = split(k.words, ' ');
    const auto found = std::find(words.begin(), words.end(), value);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    if (value.empty()) {
        throw Error(section_.where,
                    "no " + in_quotes(key) + " in [" + section_.name + "], it is required");
    }
    if (!k.names.empty()) return words.size();
    if (contains(k.later, value)) {
        throw Error(where(key), in_quotes(value) + " is not in this version" +
                                    suggestion_or_all("", strings(words)));
    }
    throw Error(where(key),
                "unknown choice " + in_quotes(value) + suggestion_or_all(value, strings(words)));
}

void Values::check_range(const Key& key, double value) const {
    if (key.range.contains(value)) return;
    throw Error(where(key.name),
                "found " + in_quotes(text(key.name)) + ", expected " + range_text(key.range));
}

double Values::number(std::string_view key) const {
    const Key& k = key_of(key);
    double value = 0.0;
    try {
        value = parse_quantity(text(key), k.dimension);
    } catch (const Error& error) {
        throw Error(where(key), error.what());
    }
    check_range(k, value);
    return value;
}

std::optional<double> Values::radius() const {
    if (has("radius") && has("diameter"))
        throw Error(where("diameter"), "found beside 'radius', expected one of them");
    if (has("diameter")) return 0.5 * number("diameter");
    return optional_number("radius");
}

std::optional<double> Values::optional_number(std::string_view key) const {
    const std::string value = text(key);
    if (value.empty() || contains(key_of(key).words, value)) return std::nullopt;
    return number(key);
}

std::uint64_t Values::count(std::string_view key) const {
    const Range& range = key_of(key).range;
    const std::string value = text(key);
    const auto n = whole_number(value);
    if (!n || !range.contains(static_cast<double>(*n))) {
        throw Error(where(key),
                    "found " + in_quotes(value) + ", expected a whole number " + range_text(range));
    }
    return *n;
}

bool Values::yes_no(std::string_view key) const {
    const std::string value = text(key);
    if (value != "yes" && value != "no") {
        throw Error(where(key), "found " + in_quotes(value) + ", expected yes or no");
    }
    return value == "yes";
}

Vec3 Values::vector(std::string_view key) const {
    std::vector<double> v;
    try {
        v = parse_quantities(text(key), key_of(key).dimension);
    } catch (const Error& error) {
        throw Error(where(key), error.what());
    }
    if (v.size() != 3) {
        throw Error(where(key), "found " + in_quotes(text(key)) + ", expected three numbers x y z");
    }
    return {v[0], v[1], v[2]};
}

std::optional<Vec3> Values::optional_vector(std::string_view key) const {
    const std::string value = text(key);
    if (value.empty() || contains(key_of(key).words, value)) return std::nullopt;
    return vector(key);
}

Vec3 Values::direction(std::string_view key) const {
    const Vec3 v = vector(key);
    const double length = v.stableNorm();
    if (!(length > 0.0)) throw Error(where(key), "found a zero vector, expected a direction");
    return v / length;
}

std::optional<Quat> Values::optional_orientation(std::string_view key) const {
    const std::string value = text(key);
    if (contains(key_of(key).words, value)) return std::nullopt;
    std::vector<double> v;
    try {
        v = parse_quantities(value, Dimension::none);
    } catch (const Error&) {
        v.clear();
    }
    const Quat q = v.size() == 4 ? Quat(v[0], v[1], v[2], v[3]) : Quat(0.0, 0.0, 0.0, 0.0);
    if (v.size() != 4 || !(q.norm() > 0.0)) {
        const std::string word(key_of(key).words);
        throw Error(where(key), "found " + in_quotes(value) + ", expected " +
                                    (word.empty() ? "" : in_quotes(word) + " or ") +
                                    "a quaternion w x y z");
    }
    return q.normalized();
}

Region Values::region(std::string_view key) const {
    try {
        return parse_region(text(key));
    } catch (const Error& error) {
        throw Error(where(key), error.what());
    }
}

}  // namespace dem::runtime
