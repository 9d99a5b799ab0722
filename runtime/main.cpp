// SPDX-License-Identifier: BSD-3-Clause
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/signals.hpp"
#include "common/text.hpp"
#include "common/threads/thread_team.hpp"
#include "runtime/case/key.hpp"
#include "runtime/case/read_scene.hpp"
#include "runtime/case/scene_summary.hpp"
#include "runtime/lane_width.hpp"
#include "runtime/output/earlier_run.hpp"
#include "runtime/run.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

namespace dem::runtime {
namespace {

namespace po = boost::program_options;

struct CommandLine {
    std::string case_path;
    std::optional<std::string> directory;
    std::optional<int> threads;
    std::vector<std::string> overrides;
    bool resume = false;
    bool force = false;
    bool check = false;
    bool quiet = false;
};

po::options_description options() {
    po::options_description visible("options");
    auto add = visible.add_options();
    add("out", po::value<std::string>()->value_name("DIR"),
        "folder for the results (default: the case's name)");
    add("threads", po::value<std::string>()->value_name("N"),
        "at most so many; 0: every core; never changes a result");
    add("set", po::value<std::vector<std::string>>()->value_name("SECTION.KEY=VALUE"),
        "set a value over the case file; may be repeated, the last one counts");
    add("resume", "go on from the checkpoint in the folder of the results");
    add("force", "write over the results of an earlier run in the folder");
    add("check", "read and check everything, describe the scene, run nothing");
    add("keys", "list everything a case file may say (Markdown)");
    add("quiet", "no progress");
    add("version", "print the version");
    add("help,h", "print this");
    return visible;
}

/// "run.end_time=3" and "s" where `--set run.end_time=3 s` was written without quotes.
std::optional<std::string> unquoted_override(const std::vector<std::string>& words) {
    for (std::size_t k = 1; k + 1 < words.size(); ++k) {
        const bool is_override =
            words[k].starts_with("--set=") ||
            (words[k - 1] == "--set" && words[k].find('=') != std::string::npos);
        const std::string& next = words[k + 1];
        if (!is_override || next.starts_with("--") || next.ends_with(".ini")) continue;
        const std::string value = words[k].substr(words[k].starts_with("--set=") ? 6 : 0);
        std::string whole = value;
        whole.append(" ").append(next);
        return "found " + in_quotes(next) + " after " + in_quotes(value) +
               ", expected quotes around a value with blanks: --set " + in_quotes(whole);
    }
    return std::nullopt;
}

po::variables_map parse(int argc, char** argv) {
    po::options_description all = options();
    all.add_options()("case", po::value<std::string>());
    po::positional_options_description positional;
    positional.add("case", 1);
    // No guessing: a shortened name would change its meaning when an option is added.
    const int style =
        po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::variables_map values;
    try {
        po::store(po::command_line_parser(argc, argv)
                      .options(all)
                      .positional(positional)
                      .style(style)
                      .run(),
                  values);
    } catch (const po::error& error) {
        const auto unquoted = unquoted_override({argv, argv + argc});
        if (unquoted) throw UsageError("--set", *unquoted);
        throw UsageError(std::string(error.what()) + ", expected what --help lists");
    }
    return values;
}

int threads(const std::string& words) {
    const auto number = whole_number(words);
    if (number && *number <= 4096) return static_cast<int>(*number);
    throw UsageError("--threads: found " + in_quotes(words) +
                     ", expected a whole number from 0 to 4096");
}

CommandLine command_line(const po::variables_map& values) {
    CommandLine line;
    if (values.count("case") == 0) throw UsageError("no case file given, expected case.ini");
    line.case_path = values["case"].as<std::string>();
    if (values.count("out") != 0) line.directory = values["out"].as<std::string>();
    if (values.count("out") != 0 && line.directory->empty()) {
        throw UsageError("--out: found nothing, expected a folder");
    }
    if (values.count("threads") != 0) line.threads = threads(values["threads"].as<std::string>());
    if (values.count("set") != 0) line.overrides = values["set"].as<std::vector<std::string>>();
    line.resume = values.count("resume") != 0;
    line.force = values.count("force") != 0;
    if (line.resume && line.force) {
        throw UsageError("found --resume and --force, expected at most one of them");
    }
    line.check = values.count("check") != 0;
    line.quiet = values.count("quiet") != 0;
    return line;
}

Scene scene_of(const CommandLine& line) {
    ThreadTeam team(line.threads.value_or(0));
    const ThreadTeam::InForce together(&team);
    CaseFile file = read_case_file(line.case_path);
    for (const std::string& assignment : line.overrides) override_value(file, assignment);
    Scene scene = read_scene(file);
    if (line.threads) scene.run.threads = *line.threads;
    scene.run.lanes = lane_width();
    scene.output.directory =
        line.directory.value_or(std::filesystem::path(line.case_path).stem().string());
    return scene;
}

void report(const RunResult& result, const std::string& directory) {
    if (result.end == RunResult::End::interrupted) {
        std::cerr << "demrun: interrupted at " << result.time
                  << " s; what was computed is kept, --resume goes on from here\n";
    }
    if (result.was_finished) {
        std::cout << directory << ": the run is finished, " << result.particles
                  << " particles after " << result.steps << " steps at " << result.time
                  << " s; its files stay as they are, unread\n";
        return;
    }
    std::cout << result.particles << " particles, ";
    if (result.removed > 0) std::cout << result.removed << " more were taken out, ";
    std::cout << result.steps << " steps to " << result.time << " s in "
              << format_duration(result.wall_time) << " (" << result.microseconds_per_particle_step
              << " us per particle and step)\nresults in " << directory << "\n";
    if (!std::isinf(result.settled))
        std::cout << "the bodies had settled at " << result.settled << " s, when motions began\n";
    if (result.core_overlaps > 0) {
        std::cerr << "demrun: warning: in " << result.core_overlaps
                  << " contacts convex bodies overlapped by more than their roundings, where the "
                     "direction of the force may jump; a stiffer material or a larger rounding "
                     "avoids it\n";
    }
    if (result.has_waiting_motion)
        std::cerr << "demrun: warning: the bodies had not settled by " << result.time
                  << " s, and no motion with from = settled has begun\n";
}

/// One line per group of which bodies are missing. Returns whether a region could not hold what the
/// case wanted in it; bodies that were not due yet are what the user asked for.
bool report_missing(const RunResult& result) {
    const bool is_interrupted = result.end == RunResult::End::interrupted;
    bool failed = false;
    for (const MissingBodies& group : result.missing) {
        if (is_interrupted && group.crowded_out == 0) continue;
        const bool is_error = !is_interrupted && group.crowded_out > 0;
        std::cerr << "demrun: " << (is_error ? "error: " : "warning: ");
        if (group.crowded_out > 0) {
            std::cerr << crowding(group) << "\n";
        } else {
            std::cerr << group.where << ": [particles." << group.group << "]: " << group.placed
                      << " of " << group.count << " bodies were placed, the others were not due by "
                      << result.time << " s\n";
        }
        failed = failed || is_error;
    }
    return failed;
}

/// The exit code.
int run(const CommandLine& line) {
    Scene scene = scene_of(line);
    if (line.check) {
        std::optional<double> resumed_at;
        if (line.resume) resumed_at = check_resume(scene);
        std::cout << check_scene(scene, resumed_at);
        const std::string& folder = scene.output.directory;
        const std::string results = earlier_results(folder);
        if (!line.resume && !line.force && !results.empty())
            std::cout << "warning: the run would be refused: " << folder << " " << results << "\n";
        return 0;
    }
    note_stop_signals();
    survive_failing_writes();
    const std::string directory = scene.output.directory;
    Progress progress(std::cerr, Progress::stderr_style(line.quiet), "demrun", scene.run.end_time);
    RunOptions run_options;
    run_options.progress = &progress;
    run_options.stop_signal = &stop_signal();
    run_options.resume = line.resume;
    run_options.force = line.force;
    const RunResult result = run(std::move(scene), run_options);
    if (!line.quiet) report(result, directory);
    return report_missing(result) ? 1 : 0;
}

/// The exit code.
int obey(const po::variables_map& values) {
    int code = 0;
    if (values.count("help") != 0) {
        std::cout << "demrun CASE.ini [options]: runs a case (docs/case-file.md)\n" << options();
    } else if (values.count("version") != 0) {
        std::cout << "demrun " DEM_VERSION "\n";
    } else if (values.count("keys") != 0) {
        std::cout << describe_keys();
    } else {
        code = run(command_line(values));
    }
    std::cout.flush();
    if (!std::cout) throw Error("standard output", "could not be written");
    return code;
}

int fail(const std::string& message, int code) {
    std::cerr << "demrun: error: " << readable(message) << "\n";
    return code;
}

/// The exit code.
int obey(int argc, char** argv) {
    try {
        return obey(parse(argc, argv));
    } catch (const UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory for this case, expected fewer bodies or smaller templates",
                    1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}

}  // namespace
}  // namespace dem::runtime

int main(int argc, char** argv) {
    dem::open_standard_streams();
    const int code = dem::runtime::obey(argc, argv);
    // Whatever was written: who asked for the end must see that it came.
    if (dem::stop_signal() != 0) dem::end_by_signal(dem::stop_signal());
    return code;
}
