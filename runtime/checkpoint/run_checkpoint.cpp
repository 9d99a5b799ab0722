// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/checkpoint/run_checkpoint.hpp"

#include "common/text.hpp"
#include "runtime/checkpoint/state_archive.hpp"

#include <algorithm>

namespace dem::runtime {

namespace {

std::vector<char> text_of(const std::vector<std::string>& lines) {
    std::vector<char> text;
    for (const std::string& line : lines) {
        text.insert(text.end(), line.begin(), line.end());
        text.push_back('\n');
    }
    return text;
}

std::vector<std::string> lines_of(const std::vector<char>& text) {
    std::vector<std::string> lines;
    for (auto begin = text.begin(); begin != text.end();) {
        const auto end = std::find(begin, text.end(), '\n');
        lines.emplace_back(begin, end);
        begin = end == text.end() ? end : end + 1;
    }
    return lines;
}

/// Whether line k of `lines` is one that `others` do not have from there on.
bool is_extra(const std::vector<std::string>& lines, const std::vector<std::string>& others,
              std::size_t k) {
    if (k >= lines.size()) return false;
    if (k >= others.size()) return true;
    const auto from = lines.begin() + static_cast<std::ptrdiff_t>(k);
    return std::find(from, lines.end(), others[k]) != lines.end();
}

/// How two cases differ, whose lines are the same before line k.
std::string difference(const std::vector<std::string>& before, const std::vector<std::string>& now,
                       std::size_t k) {
    if (is_extra(now, before, k))
        return "was made without " + in_quotes(now[k]) + ", which the case now has";
    if (is_extra(before, now, k))
        return "was made with " + in_quotes(before[k]) + ", which the case no longer has";
    return "was made with " + in_quotes(before[k]) + " where the case now has " + in_quotes(now[k]);
}

void check_case(const std::string& where, const std::vector<std::string>& before,
                const std::vector<std::string>& now) {
    const std::size_t common = std::min(before.size(), now.size());
    const auto first = std::mismatch(
        before.begin(), before.begin() + static_cast<std::ptrdiff_t>(common), now.begin());
    const auto k = static_cast<std::size_t>(first.first - before.begin());
    if (k == before.size() && k == now.size()) return;
    throw Error(where, difference(before, now, k) +
                           ", expected no change but of end_time, stop, overlap_limit, threads, "
                           "skin and [output]");
}

}  // namespace

void save_checkpoint(const std::filesystem::path& path, const Simulation& simulation,
                     const AtRest& at_rest, const OutputProgress& outputs) {
    StateWriter writer;
    writer("case", text_of(simulation.scene().case_lines));
    writer("time_step", simulation.time_step());
    OutputProgress::visit_state(outputs, writer);
    AtRest::visit_state(at_rest, writer);
    simulation.save(writer);
    write_checkpoint(path, writer.take());
}

OutputProgress load_checkpoint(const std::filesystem::path& path, Simulation& simulation,
                               AtRest& at_rest) {
    StateReader reader(read_checkpoint(path), path.string());
    std::vector<char> text;
    reader("case", text);
    check_case(path.string(), lines_of(text), simulation.scene().case_lines);
    double time_step = 0.0;
    reader("time_step", time_step);
    if (time_step != simulation.time_step()) reader.fail("was made with another time step");
    OutputProgress outputs;
    OutputProgress::visit_state(outputs, reader);
    if (outputs.row_outflow.size() > simulation.outlets().names().size())
        reader.fail("holds rows of other outlets");
    AtRest::visit_state(at_rest, reader);
    simulation.load(reader);
    reader.finish();
    return outputs;
}

}  // namespace dem::runtime
