// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/shape_parameters.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "common/units.hpp"

#include <algorithm>

namespace dem::shapegen {

double ShapeParameters::length(std::string_view name) const {
    const auto& [value, line] = setting(name, "a length");
    const double result = text_.length(value, line);
    if (!(result > 0.0)) fail(name, "a length above zero");
    if (result < least_length || result > most_length) fail(name, "a length from 1e-12 to 1e6 m");
    return result;
}

double ShapeParameters::length_or_zero(std::string_view name) const {
    const auto& [value, line] = setting(name, "a length");
    const double result = text_.length(value, line);
    if (!(result >= 0.0)) fail(name, "a length that is not negative");
    return result > 0.0 ? length(name) : 0.0;
}

double ShapeParameters::radius() const {
    if (has("radius") && has("diameter")) fail("diameter", "either 'radius' or 'diameter'");
    return has("diameter") ? 0.5 * length("diameter") : length("radius");
}

double ShapeParameters::number(std::string_view name) const {
    const auto& [value, line] = setting(name, "a number");
    try {
        return parse_quantity(value, Dimension::none);
    } catch (const Error& problem) {
        throw Error(text_.place(line), problem.what());
    }
}

void ShapeParameters::fail(std::string_view name, const std::string& expected) const {
    const auto& [value, line] = text_.settings.find(name)->second;
    throw Error(text_.place(line),
                "found " + std::string(name) + " = " + in_quotes(value) + ", expected " + expected);
}

const ProfileText::Setting& ShapeParameters::setting(std::string_view name,
                                                     const char* expected) const {
    const auto found = text_.settings.find(name);
    if (found != text_.settings.end()) return found->second;
    const auto& shape = text_.settings.find("shape")->second;
    throw Error(text_.place(shape.line), in_quotes(name) + " is missing, expected " + expected +
                                             " for shape " + in_quotes(shape.value));
}

void check_parameters(const ProfileText& text, const std::vector<std::string>& known) {
    for (const auto& [name, setting] : text.settings) {
        if (name == "units" || name == "shape") continue;
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const auto& shape = text.settings.find("shape")->second.value;
        throw Error(text.place(setting.line), "unknown parameter " + in_quotes(name) +
                                                  " of shape " + in_quotes(shape) + ", expected " +
                                                  (known.empty() ? "none" : joined(known)) +
                                                  suggestion(name, known));
    }
}

void fail_on_shape(const ProfileText& text, const std::vector<std::string>& known) {
    const auto& [value, line] = text.settings.find("shape")->second;
    throw Error(text.place(line), "unknown shape " + in_quotes(value) + ", expected one of " +
                                      joined(known) + suggestion(value, known));
}

}  // namespace dem::shapegen
