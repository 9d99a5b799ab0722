// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegen/command_line/option_values.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "shapegen/command_line/option_text.hpp"
#include "shapegen/import/mesh_file.hpp"

#include <algorithm>
#include <optional>

namespace dem::shapegen {

namespace {

namespace po = boost::program_options;
using Words = std::vector<std::string>;

/// What Boost says, as one line of ours; a misspelt option gets the nearest known one.
[[noreturn]] void refuse_line(const po::error& error, const CommandOptions& command) {
    if (const auto* unknown = dynamic_cast<const po::unknown_option*>(&error)) {
        Words names;
        for (const OptionGroup& group : command.groups)
            for (const Option& option : group.options) names.emplace_back(option.name);
        std::string word = unknown->get_option_name();
        word.erase(0, word.find_first_not_of('-'));
        const std::string nearest = nearest_word(word, names);
        throw UsageError(
            "command line",
            "unknown option " + in_quotes("--" + word) + ", " +
                (nearest.empty() ? "see --help" : "did you mean '--" + nearest + "'?"));
    }
    throw UsageError("command line", std::string(error.what()) + ", see --help");
}

std::string place(std::string_view option) {
    return "--" + std::string(option);
}

/// "0.95" or "95%".
std::optional<double> as_fraction(std::string_view words) {
    const bool is_percentage = words.ends_with('%');
    if (is_percentage) words.remove_suffix(1);
    const auto value = finite_number(words);
    return value && is_percentage ? *value / 100.0 : value;
}

}  // namespace

OptionValues::OptionValues(const CommandOptions& command, std::span<const std::string> words)
    : command_(command) {
    po::options_description all;
    for (const OptionGroup& group : command.groups) all.add(described(group));
    all.add_options()("input", po::value<Words>()->value_name("FILE"));
    po::positional_options_description positional;
    positional.add("input", -1);
    try {
        using namespace po::command_line_style;
        // Abbreviated options would change their meaning when an option is added.
        po::store(po::command_line_parser(Words(words.begin(), words.end()))
                      .options(all)
                      .positional(positional)
                      .style(unix_style & ~allow_guessing)
                      .run(),
                  values_);
        po::notify(values_);
    } catch (const po::error& error) {
        refuse_line(error, command);
    }
}

void OptionValues::check(std::string_view implied, const std::filesystem::path& input) const {
    const auto is_there = [&](const std::string& other) {
        return other == implied || given(other);
    };
    for (const OptionGroup& group : command_.groups) {
        for (const Option& option : group.options) {
            if (!given(option.name)) {
                if (!option.required) continue;
                const std::string form =
                    (option.letter == '\0' ? place(option.name)
                                           : std::string("-") + option.letter) +
                    ' ' + std::string(option.value);
                throw UsageError("command line", "found no " + place(option.name) + ", expected " +
                                                     form + ", see --help");
            }
            for (const std::string& other : words_of(option.excludes.names)) {
                if (other == option.name || !given(other)) continue;
                if (option.excludes.words.empty())
                    throw UsageError("command line", "found " + place(option.name) + " and " +
                                                         place(other) + ", expected one of them");
                throw UsageError(place(option.name), "found it with " + place(other) + ", " +
                                                         std::string(option.excludes.words));
            }
            const Words needed = words_of(option.needs.names);
            if (!needed.empty() && std::ranges::none_of(needed, is_there))
                throw UsageError(place(option.name), "found it " + std::string(option.needs.words));
            if (option.for_meshes && !is_mesh_file(input))
                throw UsageError(place(option.name), "found it with " + input.string() +
                                                         ", expected it with a mesh (" +
                                                         mesh_extensions() + ")");
        }
    }
}

std::string OptionValues::input(const std::string& expected) const {
    const auto found = given("input") ? values_["input"].as<Words>() : Words{};
    if (found.empty())
        throw UsageError("command line", "found no input, expected " + expected + ", see --help");
    if (found.size() > 1)
        throw UsageError("command line", "found a second input " + in_quotes(found[1]) +
                                             ", expected one: " + expected + ", see --help");
    return found.front();
}

bool OptionValues::given(std::string_view option) const {
    const std::string name(option);
    return values_.count(name) != 0 && !values_[name].defaulted();
}

std::string OptionValues::text(std::string_view option) const {
    return values_[std::string(option)].as<std::string>();
}

void OptionValues::refuse(std::string_view option) const {
    throw UsageError(place(option), "found " + in_quotes(text(option)) + ", expected " +
                                        expected_value(*command_.find(option)));
}

std::string OptionValues::choice(std::string_view option) const {
    const Words words = words_of(command_.find(option)->words);
    std::string found = text(option);
    if (std::ranges::find(words, found) == words.end()) refuse(option);
    return found;
}

std::int64_t OptionValues::count(std::string_view option) const {
    const Option& declared = *command_.find(option);
    const auto found = whole_number(text(option));
    if (!found || *found < static_cast<std::uint64_t>(declared.range.low) ||
        *found > static_cast<std::uint64_t>(largest_count(declared)))
        refuse(option);
    return static_cast<std::int64_t>(*found);
}

double OptionValues::number(std::string_view option) const {
    const auto found = finite_number(text(option));
    if (!found || !command_.find(option)->range.contains(*found)) refuse(option);
    return *found;
}

double OptionValues::fraction(std::string_view option) const {
    const Option& declared = *command_.find(option);
    const std::string words = text(option);
    const auto found = as_fraction(words);
    const bool has_form = declared.type != OptionType::percents || words.ends_with('%');
    if (!found || !has_form || !declared.range.contains(*found)) refuse(option);
    return *found;
}

double OptionValues::quantity(std::string_view option) const {
    const Option& declared = *command_.find(option);
    double found = 0.0;
    try {
        found = parse_quantity(text(option), declared.dimension);
    } catch (const Error& error) {
        throw UsageError(place(option), error.what());
    }
    if (!declared.range.contains(found)) refuse(option);
    return found;
}

double OptionValues::length_unit(std::string_view option) const {
    try {
        return unit_factor(text(option), Dimension::length);
    } catch (const Error& error) {
        throw UsageError(place(option), error.what());
    }
}

std::filesystem::path OptionValues::template_output() const {
    std::filesystem::path output = text("output");
    if (output.extension() != ".tpl")
        throw UsageError(
            "-o", "found " + in_quotes(output.string()) + ", expected a name that ends in .tpl");
    return output;
}

}  // namespace dem::shapegen
