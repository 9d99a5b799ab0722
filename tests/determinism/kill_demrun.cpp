// SPDX-License-Identifier: BSD-3-Clause
// usage: kill_demrun [KILLS [SEED [END_TIME]]]
// Kills runs of demrun (kill -9) at random moments, resumes each with another number of threads,
// and compares: after every kill each frame that the run had written is in frames.h5 with the bits
// of an uninterrupted run, and in the end so are final.csv, history.csv, the index and every data
// set.
#include "common/error.hpp"
#include "common/progress.hpp"
#include "common/random.hpp"
#include "common/state_hash.hpp"
#include "runtime/files/hdf5_reader.hpp"
#include "runtime/files/journaled_file.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dem::runtime {
namespace {

namespace fs = std::filesystem;

constexpr double frames_every = 1e-3;  // [s]
// Bodies that come in while others lie already; frames and checkpoints take most of the time.
const char* const pour =
    "[run]\nend_time = 0.35 s\ngravity = 0 0 -9.81\n"
    "[material.m]\ndensity = 1200\nyoungs_modulus = 5 MPa\npoissons_ratio = 0.3\n"
    "[contact]\nrestitution = 0.5\nfriction = 0.4\n"
    "[particles.balls]\nradius = 4 mm\nmaterial = m\ncount = 40\ninsert = batches\nbatch = 8\n"
    "every = 50 ms\nregion = box -14 -14 30 14 14 55 mm\n"
    "[wall.room]\nshape = box\nlower = -15 -15 0 mm\nupper = 15 15 80 mm\nopen = top\n"
    "material = m\n"
    "[output]\nframes_every = 1 ms\nhistory_every = 0.7 ms\ncheckpoint_every = 10 ms\n"
    "surfaces = yes\ncontacts = yes\npicture = no\n"
    "[measure.height]\nkind = fill_height\nevery = 3 ms\n";

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Every data set and frame of a file of frames with a hash of what it holds. Of surfaces the
/// frames alone: a resumed run writes triangles that it could share with earlier frames once more.
using Fingerprint = std::map<std::string, std::uint64_t>;

std::uint64_t hash_of(std::span<const std::byte> bytes) {
    StateHash hash;
    hash.add_bytes(bytes);
    return hash.value();
}

Fingerprint fingerprint(const fs::path& path) {
    const Hdf5Reader file(path);
    const bool is_surfaces = path.filename() == "surfaces.h5";
    Fingerprint found;
    const auto add_tables = [&](const std::string& group) {
        for (const std::string& name : file.members(group)) {
            found[group + name] = hash_of(file.content(group + name));
        }
    };
    for (const std::string& frame : file.members("/frames")) {
        const std::string group = "/frames/" + frame + "/";
        add_tables(group);
        if (is_surfaces) continue;
        const std::string entry = file.text(group, "xdmf");
        found[group + "entry"] = hash_of(std::as_bytes(std::span(entry)));
    }
    if (path.filename() == "frames.h5") add_tables("/points/");
    return found;
}

std::size_t frames_in(const Fingerprint& found) {
    return static_cast<std::size_t>(std::ranges::count_if(
        found, [](const auto& entry) { return entry.first.ends_with("/entry"); }));
}

/// Frames that were complete when the last whole row of history.csv was written.
std::size_t frames_due(const fs::path& folder) {
    std::string text = content(folder / "history.csv");
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n'));
    const std::size_t start = text.rfind('\n');
    if (start == std::string::npos) return 0;
    return 1 + static_cast<std::size_t>(std::stod(text.substr(start + 1)) / frames_every + 1e-6);
}

class KillTest {
  public:
    KillTest(std::string demrun, std::uint64_t seed, const std::string& end_time)
        : demrun_(std::move(demrun)),
          end_time_("run.end_time=" + end_time),
          random_(seed, 0),
          folder_(fs::temp_directory_path() / ("kill-demrun-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "pour.ini") << pour;
        const double start = Progress::steady_seconds();
        const pid_t run = begin("whole", 1);
        int status = 0;
        waitpid(run, &status, 0);
        duration_ = Progress::steady_seconds() - start;
        if (status != 0) throw Error("the uninterrupted run failed");
        for (const char* name : {"frames.h5", "surfaces.h5", "contacts.h5"}) {
            expected_[name] = fingerprint(folder_ / "whole" / name);
        }
    }
    ~KillTest() { fs::remove_all(folder_); }
    KillTest(const KillTest&) = delete;
    KillTest& operator=(const KillTest&) = delete;

    void run(int kills) {
        while (kills_ < kills) {
            const bool is_over = live();
            if (is_over) compare_end();
            // Nothing to resume from: a run that was killed before its first checkpoint.
            if (is_over || !fs::exists(folder_ / "parts/checkpoint.h5")) {
                fs::remove_all(folder_ / "parts");
            }
        }
        // The last one to its end.
        int status = 0;
        waitpid(begin("parts", 2), &status, 0);
        expect(status == 0, "the last run failed");
        compare_end();
    }

    int report() const {
        std::printf(
            "%d kills, %d of them while a frame was replaced in place and mended; %d runs to their "
            "end; %zu frames compared after kills; uninterrupted run %.2f s with %zu frames: %d "
            "differences\n",
            kills_, torn_, ends_, compared_, duration_, frames_in(expected_.at("frames.h5")),
            failures_);
        return failures_ == 0 ? 0 : 1;
    }

  private:
    void expect(bool holds, const std::string& claim) {
        if (holds) return;
        ++failures_;
        std::fprintf(stderr, "kill %d: %s\n", kills_, claim.c_str());
    }

    pid_t begin(const std::string& out, int threads) const {
        const std::string count = std::to_string(threads);
        std::vector<const char*> words = {demrun_.c_str(), "pour.ini",  "--quiet",
                                          "--out",         out.c_str(), "--threads",
                                          count.c_str(),   "--set",     end_time_.c_str()};
        if (fs::exists(folder_ / out / "checkpoint.h5")) words.push_back("--resume");
        words.push_back(nullptr);
        const pid_t child = fork();
        if (child != 0) return child;
        if (chdir(folder_.c_str()) == 0) execv(demrun_.c_str(), const_cast<char**>(words.data()));
        _exit(127);
    }

    /// Lets a run go on for a random time and kills it. True when it ended before.
    bool live() {
        const pid_t run = begin("parts", 1 + static_cast<int>(random_.next() % 3));
        const double end = Progress::steady_seconds() + random_.uniform(0.0, 0.7 * duration_);
        int status = 0;
        while (waitpid(run, &status, WNOHANG) == 0) {
            if (Progress::steady_seconds() < end) {
                std::this_thread::sleep_for(std::chrono::microseconds(200));
                continue;
            }
            kill(run, SIGKILL);
            waitpid(run, &status, 0);
            break;
        }
        if (WIFEXITED(status)) {
            expect(WEXITSTATUS(status) == 0, "a resumed run failed");
            return true;
        }
        ++kills_;
        compare_frames();
        return false;
    }

    Fingerprint found_after_kill(const fs::path& path) {
        try {
            return fingerprint(path);
        } catch (const Error&) {
            ++torn_;
        }
        { const JournaledFile mended(path); }
        try {
            return fingerprint(path);
        } catch (const Error& error) {
            expect(false, error.what());
        }
        return {};
    }

    void compare_frames() {
        for (const auto& [name, expected] : expected_) {
            const fs::path path = folder_ / "parts" / name;
            if (!fs::exists(path)) continue;
            const Fingerprint found = found_after_kill(path);
            for (const auto& [table, hash] : found) {
                const auto same = expected.find(table);
                expect(same != expected.end() && same->second == hash, name + table + " differs");
            }
            compared_ += frames_in(found);
            expect(name != "frames.h5" || frames_in(found) >= frames_due(folder_ / "parts"),
                   "a frame is missing");
        }
    }

    void compare_end() {
        ++ends_;
        for (const char* name : {"final.csv", "history.csv", "frames.xdmf"}) {
            expect(content(folder_ / "parts" / name) == content(folder_ / "whole" / name),
                   std::string(name) + " differs");
        }
        expect(fingerprint(folder_ / "parts/frames.h5") == expected_["frames.h5"],
               "frames.h5 differs");
        for (const auto& entry : fs::directory_iterator(folder_ / "parts")) {
            const std::string name = entry.path().filename();
            expect(!name.ends_with(".journal"), name + " is left");
        }
    }

    std::string demrun_;
    std::string end_time_;
    Random random_;
    fs::path folder_;
    double duration_ = 0.0;
    std::map<std::string, Fingerprint> expected_;
    int kills_ = 0;
    int torn_ = 0;
    int ends_ = 0;
    int failures_ = 0;
    std::size_t compared_ = 0;
};

}  // namespace
}  // namespace dem::runtime

int main(int argc, char** argv) {
    const int kills = argc > 1 ? std::stoi(argv[1]) : 100;
    const std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : 1;
    const std::string end_time = argc > 3 ? argv[3] : "0.35";
    try {
        dem::runtime::KillTest test(DEM_BINARY_DIR "/bin/demrun", seed, end_time);
        test.run(kills);
        return test.report();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kill_demrun: %s\n", error.what());
        return 1;
    }
}
