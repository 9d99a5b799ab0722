// SPDX-License-Identifier: BSD-3-Clause
// [motion.NAME] and [motion.NAME.PIECE].
#include "common/error.hpp"
#include "common/text.hpp"
#include "runtime/case/pose_rows.hpp"
#include "runtime/case/scene_sections.hpp"
#include "runtime/walls/pose_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace dem::runtime {

namespace {

/// What the words of a wall's own `motion` mean there.
constexpr std::array<std::string_view, 4> words_of_walls = {"none", "translate", "rotate",
                                                            "oscillate"};

/// So many motions may lie within one another; every one costs time in every step.
constexpr std::size_t deepest = 16;

/// "up" of "motion.lift.up".
std::string piece_name(const std::string& section) {
    return section.substr(section.rfind('.') + 1);
}
/// "lift" of "motion.lift.up".
std::string motion_name(const std::string& section) {
    const std::string name = own_name(section);
    return name.substr(0, name.find('.'));
}

Error later_than(const Values& values, const char* key, const std::string& expected) {
    return {values.where(key), "found " + in_quotes(values.text(key)) + ", expected " + expected};
}

void read_ramp(const Values& values, MotionPiece& piece) {
    piece.ramp = values.number("ramp");
    piece.is_ramp_smooth = values.word("ramp_shape") == "smooth";
    for (const char* key : {"ramp_shape", "initial_velocity", "initial_rate"}) {
        if (piece.ramp > 0.0 || !values.has(key)) continue;
        throw Error(values.where(key), "found without a ramp, expected 'ramp' in [" +
                                           values.section_name() + "], the time it takes");
    }
    if (piece.ramp <= piece.until - piece.from) return;
    throw later_than(values, "ramp", "no more than the piece lasts, from 'from' until 'until'");
}

/// A piece but for its table.
MotionPiece read_piece(const Values& values) {
    MotionPiece piece;
    piece.kind = values.choice<MotionPiece::Kind>("kind");
    piece.from = values.optional_number("from").value_or(0.0);
    piece.until = values.optional_number("until").value_or(piece.until);
    if (!(piece.until > piece.from))
        throw later_than(values, "until", "later than from = " + in_quotes(values.text("from")));
    switch (piece.kind) {
        case MotionPiece::Kind::translate:
            piece.velocity = values.vector("velocity");
            piece.initial_velocity = values.vector("initial_velocity");
            break;
        case MotionPiece::Kind::rotate:
            piece.rate = values.number("rate");
            piece.initial_rate = values.number("initial_rate");
            piece.axis = values.direction("axis");
            piece.point = values.vector("point");
            break;
        case MotionPiece::Kind::oscillate:
            piece.axis = values.direction("direction");
            piece.amplitude = values.number("amplitude");
            piece.frequency = values.number("frequency");
            break;
        case MotionPiece::Kind::table:
            break;
    }
    read_ramp(values, piece);
    return piece;
}

MotionPiece read_table(const Values& values, const std::filesystem::path& folder) {
    const std::string path = (folder / values.text("file")).lexically_normal().string();
    if (!std::filesystem::exists(path)) {
        throw Error(values.where("file"),
                    "no such file " + in_quotes(path) + ", expected a table of poses");
    }
    MotionPiece piece;
    piece.kind = MotionPiece::Kind::table;
    piece.table = std::make_shared<const PoseTable>(read_pose_rows(path));
    piece.from = piece.table->from();
    piece.until = piece.table->until();
    return piece;
}

/// Pieces in the order of the file, which must be that of time.
std::vector<MotionPiece> read_pieces(const std::vector<Values>& sections, const std::string& name) {
    std::vector<MotionPiece> pieces;
    std::string before;
    for (const Values& values : sections) {
        if (motion_name(values.section_name()) != name) continue;
        if (values.word("kind") == "list" || values.word("kind") == "table") {
            throw Error(values.has("kind") ? values.where("kind") : values.section_where(),
                        "found " + in_quotes(values.word("kind")) +
                            " in a piece of a list, expected kind = translate, rotate or "
                            "oscillate");
        }
        if (values.text("from") == "settled")
            throw later_than(values, "from",
                             "a time; 'settled' belongs into [motion." + name + "]");
        const MotionPiece piece = read_piece(values);
        if (!pieces.empty() && piece.from < pieces.back().until) {
            throw Error(values.has("from") ? values.where("from") : values.section_where(),
                        "found from = " + in_quotes(values.text("from")) +
                            " before the end of the piece " + in_quotes(before) +
                            ", expected pieces in the order of time, each 'from' the 'until' of "
                            "the one before or later");
        }
        pieces.push_back(piece);
        before = piece_name(values.section_name());
    }
    return pieces;
}

class MotionReader {
  public:
    MotionReader(const MotionSections& sections, std::filesystem::path folder)
        : sections_(sections), folder_(std::move(folder)) {}

    void read_all(Scene& scene) {
        for (const Values& piece : sections_.pieces) {
            const std::string name = motion_name(piece.section_name());
            if (find(name) != nullptr) continue;
            throw Error(piece.section_where(), "[" + piece.section_name() +
                                                   "] is a piece of no motion, expected a section "
                                                   "[motion." +
                                                   name + "]" + suggestion(name, names()));
        }
        for (const Values& head : sections_.heads) scene.motions.push_back(*motion(head));
    }

  private:
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const Values& head : sections_.heads) all.push_back(own_name(head.section_name()));
        return all;
    }

    const Values* find(const std::string& name) const {
        const auto found = std::ranges::find_if(sections_.heads, [&](const Values& head) {
            return own_name(head.section_name()) == name;
        });
        return found == sections_.heads.end() ? nullptr : &*found;
    }

    /// Each is made once; `open_` are those on the way to it.
    std::shared_ptr<const Motion> motion(const Values& head) {
        const std::string name = own_name(head.section_name());
        const auto done = made_.find(name);
        if (done != made_.end()) return done->second;
        open_.push_back(name);
        auto made = std::make_shared<Motion>(read(head, name));
        if (head.has("within")) made->within = outer(head);
        open_.pop_back();
        made_[name] = made;
        return made;
    }

    std::shared_ptr<const Motion> outer(const Values& head) {
        const std::string name = head.text("within");
        const Values* section = find(name);
        if (section == nullptr) {
            throw Error(head.where("within"),
                        "no motion " + in_quotes(name) + suggestion_or_all(name, names()));
        }
        const auto circle = std::ranges::find(open_, name);
        if (circle != open_.end()) {
            std::string way;
            for (auto inner = circle; inner != open_.end(); ++inner)
                way += in_quotes(*inner) + " is within ";
            throw Error(head.where("within"), way + in_quotes(name) + ", expected no circle");
        }
        std::shared_ptr<const Motion> made;
        if (open_.size() <= deepest) made = motion(*section);
        std::size_t depth = 0;
        for (const Motion* m = made.get(); m != nullptr; m = m->within.get()) ++depth;
        if (made && depth < deepest) return made;
        throw Error(head.where("within"), "motions lie within one another more than " +
                                              std::to_string(deepest) + " deep, expected less");
    }

    Motion read(const Values& head, const std::string& name) const {
        Motion motion;
        motion.name = name;
        motion.where = head.section_where();
        if (std::ranges::find(words_of_walls, name) != words_of_walls.end()) {
            throw Error(motion.where, "found the name " + in_quotes(name) +
                                          ", which means something else in 'motion' of a wall, "
                                          "expected another one");
        }
        motion.pieces = read_pieces(sections_.pieces, name);
        const std::string_view kind = head.word("kind");
        if (kind != "list" && !motion.pieces.empty()) {
            throw Error(head.where("kind"), "found " + in_quotes(kind) + " beside pieces [motion." +
                                                name + ".PIECE], expected one of them");
        }
        motion.from_settled = head.text("from") == "settled";
        const bool has_own_time = kind == "list" || kind == "table";
        if (has_own_time) motion.start = head.optional_number("from").value_or(0.0);
        if (kind == "table") {
            motion.pieces.push_back(read_table(head, folder_));
        } else if (kind != "list") {
            motion.pieces.push_back(read_piece(head));
        } else if (motion.pieces.empty() && !head.has("within")) {
            throw Error(motion.where,
                        "no 'kind' and no [motion." + name + ".PIECE], expected one of them");
        }
        motion.period = head.optional_number("repeat").value_or(motion.period);
        check_period(head, motion);
        return motion;
    }

    static void check_period(const Values& head, const Motion& motion) {
        if (std::isinf(motion.period)) return;
        if (motion.pieces.empty() || std::isinf(motion.pieces.back().until)) {
            throw Error(head.where("repeat"),
                        "found a motion without end, expected 'until' of the "
                        "last piece for one that repeats");
        }
        if (motion.pieces.back().until <= motion.period) return;
        throw later_than(head, "repeat", "no less than the 'until' of the last piece");
    }

    const MotionSections& sections_;
    std::filesystem::path folder_;
    std::map<std::string, std::shared_ptr<const Motion>> made_;
    std::vector<std::string> open_;
};

}  // namespace

void read_motions(const MotionSections& sections, const std::filesystem::path& folder,
                  Scene& scene) {
    MotionReader(sections, folder).read_all(scene);
}

const Motion& motion_of_name(const Scene& scene, const std::string& name,
                             const std::string& where) {
    std::vector<std::string> names(words_of_walls.begin(), words_of_walls.end());
    for (const Motion& motion : scene.motions) {
        if (motion.name == name) return motion;
        names.push_back(motion.name);
    }
    throw Error(where, "unknown choice " + in_quotes(name) + suggestion_or_all(name, names));
}

}  // namespace dem::runtime
