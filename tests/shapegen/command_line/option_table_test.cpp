// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/error.hpp"
#include "shapegen/command_line/command_line.hpp"
#include "shapegen/command_line/option_text.hpp"
#include "shapegen/command_line/option_values.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dem::shapegen {
namespace {

using Words = std::vector<std::string>;

const std::vector<const CommandOptions*> commands{&cook_command, &generate_command,
                                                  &inspect_command, &export_command};

template <class Visit>
void visit_options(const Visit& visit) {
    for (const CommandOptions* command : commands)
        for (const OptionGroup& group : command->groups)
            for (const Option& option : group.options) visit(*command, option);
}

/// What the option says of a command line that is wrong.
std::string refusal(const Words& words) {
    std::vector<const char*> arguments{"shapegen"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    try {
        parse_command_line(arguments);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(OptionTable, TheHelpAndTheManualHaveEveryOptionAndItsDefault) {
    const std::string help = help_text();
    std::string manual = man_page();
    std::erase(manual, '\\');  // of roff's minus signs
    visit_options([&](const CommandOptions&, const Option& option) {
        const std::string name = "--" + std::string(option.name);
        EXPECT_NE(help.find(name), std::string::npos) << name;
        EXPECT_NE(manual.find(name), std::string::npos) << name;
        EXPECT_NE(manual.find(option.help), std::string::npos) << name;
        if (option.standard.empty()) return;
        EXPECT_NE(help.find("(=" + std::string(option.standard) + ")"), std::string::npos) << name;
        EXPECT_NE(manual.find("Default: " + std::string(option.standard)), std::string::npos)
            << name;
    });
}

TEST(OptionTable, NamesAreUniqueAndThoseOfOtherOptionsExist) {
    visit_options([&](const CommandOptions& command, const Option& option) {
        EXPECT_EQ(command.find(option.name), &option) << option.name;
        for (const std::string_view names : {option.needs.names, option.excludes.names})
            for (const std::string& other : words_of(names))
                EXPECT_NE(command.find(other), nullptr) << option.name << ' ' << other;
        EXPECT_EQ(option.needs.names.empty(), option.needs.words.empty()) << option.name;
    });
}

TEST(OptionTable, EveryOptionWithAValueSaysWhatIsExpectedAndTakesItsOwnDefault) {
    for (const CommandOptions* command : commands) {
        const OptionValues defaults(*command, Words{});
        for (const OptionGroup& group : command->groups) {
            for (const Option& option : group.options) {
                EXPECT_EQ(option.type == OptionType::flag, option.value.empty()) << option.name;
                if (option.type != OptionType::flag && option.type != OptionType::text) {
                    EXPECT_FALSE(expected_value(option).empty()) << option.name;
                }
                if (option.standard.empty()) continue;
                EXPECT_FALSE(defaults.given(option.name));
                switch (option.type) {
                    case OptionType::count:
                        EXPECT_GE(defaults.count(option.name), 0);
                        break;
                    case OptionType::number:
                        EXPECT_GT(defaults.number(option.name), 0.0);
                        break;
                    case OptionType::fraction:
                        EXPECT_GE(defaults.fraction(option.name), 0.0);
                        break;
                    case OptionType::quantity:
                        EXPECT_GT(defaults.quantity(option.name), 0.0);
                        break;
                    case OptionType::choice:
                        EXPECT_FALSE(defaults.choice(option.name).empty());
                        break;
                    default:
                        ADD_FAILURE() << option.name << " has a default that nobody reads";
                }
            }
        }
    }
}

TEST(OptionTable, EveryOptionIsRefusedWithoutWhatItNeedsAndWithWhatItExcludes) {
    const auto spelled = [](const Option& option) {
        Words words{"--" + std::string(option.name)};
        if (option.type != OptionType::flag) words.emplace_back("1");
        return words;
    };
    const auto joined = [](Words words, const Words& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    int needing = 0;
    for (const OptionGroup& group : cook_command.groups) {
        for (const Option& option : group.options) {
            const Words alone = joined({"x.off"}, spelled(option));
            if (!option.needs.names.empty()) {
                ++needing;
                const bool is_of_convex = option.needs.names == "convex";
                const Words mode = is_of_convex ? Words{"--sr"} : Words{"--convex"};
                EXPECT_EQ(refusal(joined(alone, mode)), "--" + std::string(option.name) +
                                                            ": found it " +
                                                            std::string(option.needs.words));
            }
            for (const std::string& other : words_of(option.excludes.names)) {
                if (other == option.name) continue;
                const Words both = joined(alone, spelled(*cook_command.find(other)));
                EXPECT_NE(refusal(both).find("expected one of them"), std::string::npos)
                    << option.name << ' ' << other;
            }
            if (option.for_meshes) {
                EXPECT_NE(refusal(joined({"x.profile", "--convex"}, spelled(option)))
                              .find("expected it with a mesh ("),
                          std::string::npos)
                    << option.name;
            }
        }
    }
    EXPECT_GE(needing, 12);
}

TEST(OptionTable, NodesAndCellsAreRefusedForAnExactSphereWhichHasNone) {
    for (const std::string option : {"nodes", "base-cells", "interface-cells", "corner-cells"}) {
        EXPECT_EQ(
            refusal({"x.profile", "--sphere", "--" + option, "200"}),
            "--" + option + ": found it with a shape of another kind, expected it with --sr only");
    }
}

}  // namespace
}  // namespace dem::shapegen
