// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/case/key.hpp"

#include "common/text.hpp"

#include <cmath>
#include <sstream>

namespace dem::runtime {

namespace {

bool is_placeholder(std::string_view word) {
    return word.front() >= 'A' && word.front() <= 'Z';
}

std::string_view si_unit(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return "";
        case Dimension::length:
            return "m";
        case Dimension::time:
            return "s";
        case Dimension::velocity:
            return "m/s";
        case Dimension::acceleration:
            return "m/s^2";
        case Dimension::angular_velocity:
            return "rad/s";
        case Dimension::angle:
            return "rad";
        case Dimension::density:
            return "kg/m^3";
        case Dimension::pressure:
            return "Pa";
        case Dimension::stiffness:
            return "N/m";
        case Dimension::frequency:
            return "Hz";
    }
    return "";
}

/// "a b" -> "a, b"
std::string listed(std::string_view words) {
    const auto parts = split(words, ' ');
    return joined(std::vector<std::string>(parts.begin(), parts.end()));
}

std::string number_text(double x) {
    std::ostringstream text;
    text << x;
    return text.str();
}

std::string value_text(const Key& key) {
    switch (key.type) {
        case ValueType::yes_no:
            return "yes, no";
        case ValueType::choice:
            return listed(key.words) +
                   (key.names.empty() ? "" : ", or NAME of [" + std::string(key.names) + ".NAME]");
        case ValueType::vector:
            return "x y z";
        case ValueType::orientation:
            return "w x y z";
        case ValueType::region:
            return "region";
        case ValueType::text:
            return "text";
        case ValueType::count:
            return "whole number, " + range_text(key.range);
        case ValueType::number:
            return std::isfinite(key.range.low) ? "number, " + range_text(key.range) : "number";
    }
    return "";
}

void describe(const SectionKind& kind, std::ostringstream& out) {
    out << "### [" << kind.pattern << "]\n\n" << kind.doc << "\n\n";
    out << "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
    for (const Key& key : kind.keys) {
        out << "| `" << key.name << "` | " << value_text(key) << " | " << si_unit(key.dimension)
            << " | ";
        if (key.required) {
            out << "required";
        } else if (!key.standard.empty()) {
            out << "`" << key.standard << "`";
        }
        out << " | ";
        if (!key.when.empty()) {
            const auto parts = split(key.when, '=');
            std::string choices(parts[1]);
            for (char& c : choices) c = c == '|' ? ' ' : c;
            out << "(" << parts[0] << " = " << listed(choices) << ") ";
        }
        out << key.doc << " |\n";
    }
    out << "\n";
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        if (end > 0) pieces.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return pieces;
}

const Key* SectionKind::find(std::string_view key) const {
    for (const Key& k : keys) {
        if (k.name == key) return &k;
    }
    return nullptr;
}

const SectionKind* section_kind(std::string_view section) {
    const auto name = split(section, '.');
    for (const SectionKind& kind : section_kinds()) {
        const auto pattern = split(kind.pattern, '.');
        bool same = pattern.size() == name.size();
        for (std::size_t k = 0; same && k < name.size(); ++k) {
            same = is_placeholder(pattern[k]) || pattern[k] == name[k];
        }
        if (same) return &kind;
    }
    return nullptr;
}

std::string range_text(const Range& range) {
    const bool low = std::isfinite(range.low);
    const bool high = std::isfinite(range.high);
    std::string above = range.low_allowed ? ">= " : "> ";
    above += number_text(range.low);
    std::string below = range.high_allowed ? "<= " : "< ";
    below += number_text(range.high);
    if (low && high) return above + " and " + below;
    return low ? above : high ? below : "";
}

std::string describe_keys() {
    std::ostringstream out;
    for (const SectionKind& kind : section_kinds()) {
        if (kind.pattern == "contact.A.B") {
            out << "### [contact.A.B]\n\nThe keys of [contact], for the materials A and B only, in "
                   "either order; what is not given here is taken from [contact].\n\n";
        } else if (kind.pattern == "motion.NAME.PIECE") {
            out << "### [motion.NAME.PIECE]\n\nA piece of the list [motion.NAME], in the order of "
                   "time: "
                   "the keys of [motion.NAME] for `kind` = translate, rotate or oscillate.\n\n";
        } else {
            describe(kind, out);
        }
    }
    return out.str();
}

}  // namespace dem::runtime
