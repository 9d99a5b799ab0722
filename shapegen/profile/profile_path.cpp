// SPDX-License-Identifier: BSD-3-Clause
#include "shapegen/profile/profile_path.hpp"

#include "common/error.hpp"
#include "common/text.hpp"
#include "common/units.hpp"
#include "shapegen/profile/arcs.hpp"
#include "shapegen/profile/profile_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dem::shapegen {
namespace {

bool is_unit(std::string_view word) {
    return word == "m" || word == "mm" || word == "um" || word == "cm" || word == "in";
}

/// The words of one command, read one after the other.
class CommandWords {
  public:
    CommandWords(const ProfileText& text, const ProfileText::Statement& statement)
        : text_(text), statement_(statement), rest_(statement.text) {}

    bool is_empty() const { return rest_.empty(); }
    std::size_t line() const { return statement_.line; }
    std::string place() const { return text_.place(statement_.line); }

    std::string_view word() {
        const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
        const std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(end);
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
        return result;
    }

    /// `what` goes into the message when nothing is left.
    double length(const char* what) {
        if (is_empty()) fail(std::string("ends here, expected ") + what);
        const char* begin = rest_.data();
        std::string_view number = word();
        CommandWords ahead = *this;
        if (!is_empty() && is_unit(ahead.word())) {  // "5.6 mm"
            const std::string_view unit = word();
            number = {begin, static_cast<std::size_t>(unit.data() + unit.size() - begin)};
        }
        return text_.length(number, statement_.line);
    }

    double positive_length(const char* what) {
        const double value = length(what);
        if (!(value > 0.0)) fail(std::string("has ") + what + " <= 0, expected it above zero");
        return value;
    }

    Vec2 point() {
        const double r = length("r of a point");
        if (r < 0.0) fail("has a negative radius, expected points 'r z' with r >= 0");
        return {r, length("z of a point")};
    }

    bool take(std::string_view expected) {
        CommandWords ahead = *this;
        if (is_empty() || ahead.word() != expected) return false;
        word();
        return true;
    }

    void expect_end(const std::vector<std::string>& expected) {
        if (is_empty()) return;
        const std::string_view found = word();
        fail("continues with " + in_quotes(found) + ", expected " +
             (expected.empty() ? "its end" : joined(expected) + " or its end") +
             suggestion(found, expected));
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw Error(place(), in_quotes(statement_.text) + " " + message);
    }

  private:
    const ProfileText& text_;
    const ProfileText::Statement& statement_;
    std::string_view rest_;
};

class PathBuilder {
  public:
    void add_command(const std::string& command, CommandWords& words) {
        if (command == "start") {
            start(words);
        } else {
            if (!has_start_) words.fail("comes first, expected 'start r z' before it");
            add_segment(command, words);
        }
    }

    ProfileDraft take(const ProfileText& text) {
        if (pending_fillet_)
            throw Error(text.place(fillet_line_),
                        "the fillet ends the path, expected a line or an arc after it");
        if (draft_.segments.empty())
            throw Error(text.place(text.statements.back().line),
                        "the path ends at its start, expected a line, an arc or a curve after it");
        return std::move(draft_);
    }

  private:
    void start(CommandWords& words) {
        if (has_start_) words.fail("starts again, expected one 'start'");
        has_start_ = true;
        at_ = words.point();
        words.expect_end({});
    }

    void add_segment(const std::string& command, CommandWords& words) {
        if (command == "line") {
            add_lines(words);
        } else if (command == "arc") {
            add_arc(words);
        } else if (command == "ellipse_arc") {
            add_ellipse_arc(words);
        } else if (command == "curve") {
            add_curve(words);
        } else if (command == "bezier") {
            add_bezier(words);
        } else {
            announce_fillet(words);
        }
    }

    void add_lines(CommandWords& words) {
        do {
            const Vec2 to = words.point();
            if (to == at_) words.fail("goes nowhere, expected a point other than the one before");
            append(LineSegment{at_, to}, words);
            at_ = to;
        } while (!words.is_empty());
    }

    void add_arc(CommandWords& words) {
        const Vec2 to = words.point();
        if (words.take("through")) {
            const Vec2 middle = words.point();
            words.expect_end({});
            const auto arc = arc_through(at_, middle, to);
            if (!arc) words.fail("has its three points on a line, expected an arc");
            append(*arc, words);
        } else if (words.take("radius")) {
            const double radius = words.positive_length("the radius");
            append_arc(to, radius, radius, words);
        } else {
            words.expect_end({"radius", "through"});
            words.fail("ends here, expected 'radius a' or 'through r z'");
        }
        at_ = to;
    }

    void add_ellipse_arc(CommandWords& words) {
        const Vec2 to = words.point();
        if (!words.take("semi_axes")) {
            words.expect_end({"semi_axes"});
            words.fail("ends here, expected 'semi_axes a b'");
        }
        const double a = words.positive_length("the semi-axis along r");
        const double b = words.positive_length("the semi-axis along z");
        append_arc(to, a, b, words);
        at_ = to;
    }

    void append_arc(const Vec2& to, double a, double b, CommandWords& words) {
        ArcSense sense;
        while (true) {
            if (words.take("right")) {
                sense.turns_left = false;
            } else if (words.take("large")) {
                sense.is_large = true;
            } else if (!words.take("left")) {
                break;
            }
        }
        words.expect_end({"left", "right", "large"});
        const auto arc = arc_between(at_, to, a, b, sense);
        if (!arc)
            words.fail(
                "is too small to reach its end, expected a radius of at least half the "
                "distance of its ends");
        append(*arc, words);
    }

    void add_curve(CommandWords& words) {
        std::vector<Vec2> points{at_};
        while (!words.is_empty()) {
            const Vec2 point = words.point();
            if (point == points.back())
                words.fail("has the same point twice in a row, expected different ones");
            points.push_back(point);
        }
        if (points.size() < 3)
            words.fail("has one point, expected at least two ('line' goes straight to one)");
        // A smooth body meets its axis squarely.
        std::optional<Vec2> first;
        std::optional<Vec2> last;
        if (points.front().x() == 0.0) first = Vec2(1.0, 0.0);
        if (points.back().x() == 0.0) last = Vec2(-1.0, 0.0);
        for (const ProfileSegment& segment : cubic_spline(points, first, last))
            append(segment, words);
        at_ = points.back();
    }

    void add_bezier(CommandWords& words) {
        const Vec2 first = words.point();
        const Vec2 second = words.point();
        const Vec2 to = words.point();
        words.expect_end({});
        if (first == at_ || second == to)
            words.fail("has a control point on its end, expected it to give the direction there");
        append(cubic_bezier({at_, first, second, to}), words);
        at_ = to;
    }

    void announce_fillet(CommandWords& words) {
        const double radius = words.positive_length("the radius");
        words.expect_end({});
        if (draft_.segments.empty() || pending_fillet_)
            words.fail("has nothing to round, expected a line or an arc before it");
        pending_fillet_ = radius;
        fillet_line_ = words.line();
        fillet_place_ = words.place();
    }

    void append(const ProfileSegment& segment, const CommandWords& words) {
        if (!pending_fillet_) {
            draft_.append(segment, words.place());
            return;
        }
        const auto rounded = fillet(draft_.segments.back(), segment, *pending_fillet_);
        if (!rounded)
            throw Error(fillet_place_,
                        "no such fillet fits here, expected a radius small enough "
                        "for the lines or circular arcs before and after it");
        pending_fillet_.reset();
        draft_.segments.back() = rounded->before;
        draft_.append(rounded->arc, fillet_place_);
        draft_.append(rounded->after, words.place());
    }

    ProfileDraft draft_;
    Vec2 at_ = Vec2::Zero();
    bool has_start_ = false;
    std::optional<double> pending_fillet_;
    std::size_t fillet_line_ = 0;
    std::string fillet_place_;
};

}  // namespace

const std::vector<std::string>& path_commands() {
    static const std::vector<std::string> commands{"start", "line",   "arc",   "ellipse_arc",
                                                   "curve", "bezier", "fillet"};
    return commands;
}

bool is_path_command(std::string_view word) {
    return std::find(path_commands().begin(), path_commands().end(), word) != path_commands().end();
}

ProfileDraft parse_path(const ProfileText& text) {
    PathBuilder builder;
    for (const ProfileText::Statement& statement : text.statements) {
        CommandWords words(text, statement);
        const std::string command(words.word());
        if (!is_path_command(command))
            throw Error(text.place(statement.line),
                        "unknown command " + in_quotes(command) +
                            ", expected start, line, arc, ellipse_arc, curve, bezier or fillet" +
                            suggestion(command, path_commands()));
        builder.add_command(command, words);
    }
    return builder.take(text);
}

}  // namespace dem::shapegen
