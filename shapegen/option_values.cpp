// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/option_values.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"

namespace dem {

namespace po = boost::program_options;

namespace {

/// "0.95" or "95%".
std::optional<double> fraction(std::string_view words) {
    const bool is_percentage = words.ends_with('%');
    if (is_percentage) words.remove_suffix(1);
    const auto value = finite_number(words);
    return value && is_percentage ? *value / 100.0 : value;
}

}  // namespace

po::typed_value<std::string>* text(const char* name) {
    return po::value<std::string>()->value_name(name);
}

bool is_given(const po::variables_map& values, const std::string& option) {
    return values.count(option) != 0 && !values[option].defaulted();
}

double fraction_option(const po::variables_map& values, const std::string& option, double above,
                       double below, const std::string& expected) {
    const auto words = values[option].as<std::string>();
    const auto value = fraction(words);
    if (!value || !(*value > above && *value < below))
        throw UsageError("--" + option, "found " + in_quotes(words) + ", expected " + expected);
    return *value;
}

std::int64_t whole_number(const po::variables_map& values, const std::string& option,
                          std::int64_t least, std::int64_t most) {
    const auto words = values[option].as<std::string>();
    const auto found = dem::whole_number(words);
    if (!found || *found < static_cast<std::uint64_t>(least) ||
        *found > static_cast<std::uint64_t>(most))
        throw UsageError("--" + option, "found " + in_quotes(words) +
                                            ", expected a whole number "
                                            "from " +
                                            std::to_string(least) + " to " + std::to_string(most));
    return static_cast<std::int64_t>(*found);
}

double length_unit_option(const po::variables_map& values, const std::string& option) {
    try {
        return unit_factor(values[option].as<std::string>(), Dimension::length);
    } catch (const Error& error) {
        throw UsageError("--" + option, error.what());
    }
}

std::filesystem::path template_output(const po::variables_map& values) {
    std::filesystem::path output = values["output"].as<std::string>();
    if (output.extension() != ".tpl")
        throw UsageError(
            "-o", "found " + in_quotes(output.string()) + ", expected a name that ends in .tpl");
    return output;
}

}  // namespace dem
