// SPDX-License-Identifier: BSD-3-Clause
// Every fenced code block of README.md, CONTRIBUTING.md and docs is what it says. The word behind
// the fence tells what becomes of it, and a name behind the word which file a reader makes of it:
//
//   ini FILE       a case, which demrun --check accepts; blocks with the same FILE are joined
//   profile FILE   cooked by shapegen
//   convex FILE    cooked by shapegen
//   sh             run line by line in a folder with these files and those of `what_readers_have`;
//                  runs last two milliseconds, clumps are coarse
//   console        `$ command` lines are run, and the lines below are among what they print; a
//                  line "..." stands for any
//   python         parsed
//   text           nothing to run: what programs print, figures
#include "tests/cli/program.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

const fs::path source = DEM_SOURCE_DIR;

struct Block {
    std::string language, file, text;
    std::size_t line = 0;
};

std::vector<Block> code_blocks(const fs::path& page) {
    std::vector<Block> blocks;
    std::ifstream stream(page);
    bool inside = false;
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.starts_with("```")) {
            inside = !inside;
            if (!inside) continue;
            blocks.emplace_back();
            blocks.back().line = number;
            std::istringstream(line.substr(3)) >> blocks.back().language >> blocks.back().file;
        } else if (inside) {
            blocks.back().text += line + "\n";
        }
    }
    return blocks;
}

std::vector<std::string> pages_with_blocks() {
    std::vector<std::string> pages = {"README.md", "CONTRIBUTING.md"};
    for (const auto& entry : fs::recursive_directory_iterator(source / "docs")) {
        if (entry.path().extension() != ".md") continue;
        pages.push_back(fs::relative(entry.path(), source).string());
    }
    std::erase_if(pages, [](const auto& page) { return code_blocks(source / page).empty(); });
    std::ranges::sort(pages);
    return pages;
}

const char* const shell_settings =
    "set -euo pipefail\n"
    "bin='" DEM_BINARY_DIR
    "/bin'\n"
    "demrun() {\n"
    "  case \"$*\" in *--check*) ;; *) set -- \"$@\" --set run.end_time=2ms;; esac\n"
    "  \"$bin/demrun\" \"$@\"\n"
    "}\n"
    "shapegen() {\n"
    "  case \"$*\" in *--clump*) set -- \"$@\" --resolution 24;; esac\n"
    "  \"$bin/shapegen\" \"$@\"\n"
    "}\n";

class Page : public testing::TestWithParam<std::string> {
  protected:
    Page() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        fs::create_directory_symlink(source / "data", folder_ / "data");
    }
    ~Page() override { fs::remove_all(folder_); }

    void make_files() {
        std::map<std::string, std::string> files;
        for (const Block& block : blocks_) files[block.file] += block.text;
        files.erase("");
        for (const auto& [name, text] : files) {
            fs::create_directories((folder_ / name).parent_path());
            std::ofstream(folder_ / name) << text;
        }
    }

    /// Files of commands that stand for any file of the reader, and scripts that would take
    /// minutes.
    void make_what_readers_have() const {
        fs::copy_file(source / "data/profiles/tablet.profile", folder_ / "tablet.profile",
                      fs::copy_options::skip_existing);
        for (const char* mesh : {"hopper.obj", "baffle.obj"})
            fs::copy_file(source / "data/meshes" / mesh, folder_ / mesh,
                          fs::copy_options::skip_existing);
        expect_success("'" DEM_BINARY_DIR
                       "/bin/shapegen' tablet.profile --quiet -o rock.tpl && '" DEM_BINARY_DIR
                       "/bin/shapegen' export rock.tpl -o rock.stl && "
                       "cp rock.stl bunny.stl",
                       "what readers have");
        for (const Block& block : code_blocks(source / "docs/case-file.md")) {
            if (block.file == "case.ini") std::ofstream(folder_ / "case.ini") << block.text;
        }
        for (const char* script : {"run-demo", "run-tests"}) {
            expect_success("bash -n '" DEM_SOURCE_DIR "/" + std::string(script) + "'", script);
            std::ofstream(folder_ / script) << "#!/bin/sh\n";
            fs::permissions(folder_ / script, fs::perms::owner_all);
        }
    }

    Outcome expect_success(const std::string& command, const std::string& place) const {
        Outcome outcome = run_command("{ " + command + "\n}", folder_);
        EXPECT_EQ(outcome.code, 0) << place << ":\n"
                                   << command << '\n'
                                   << outcome.output << outcome.errors;
        return outcome;
    }

    void run_shell(const std::string& text, const std::string& place) const {
        std::ofstream(folder_ / "block.sh") << shell_settings << text;
        expect_success("bash block.sh", place);
    }

    void run_console(const std::string& text, const std::string& place) const {
        std::istringstream lines(text);
        std::string printed = "\n";
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("$ ")) {
                std::ofstream(folder_ / "block.sh") << shell_settings << line.substr(2);
                printed = "\n" + expect_success("bash block.sh 2>&1", place).output;
            } else if (line != "...") {
                EXPECT_NE(printed.find("\n" + line + "\n"), std::string::npos)
                    << place << ": '" << line << "' is not among the lines of" << printed;
            }
        }
    }

    void run_block(const Block& block) const {
        const std::string place = GetParam() + ":" + std::to_string(block.line);
        const std::string& language = block.language;
        if (language == "sh") {
            run_shell(block.text, place);
        } else if (language == "console") {
            run_console(block.text, place);
        } else if (language == "profile" || language == "convex") {
            ASSERT_NE(block.file, "") << place << ": a name, expected for shapegen";
            run_shell("shapegen '" + block.file + "' -o block.tpl", place);
        } else if (language == "python") {
            std::ofstream(folder_ / "block.py") << block.text;
            run_shell("python3 -c 'import ast; ast.parse(open(\"block.py\").read())'", place);
        } else {
            EXPECT_TRUE(language == "ini" || language == "text")
                << place << ": found '" << language
                << "', expected ini, profile, convex, sh, console, python or text";
        }
    }

    const std::vector<Block> blocks_ = code_blocks(source / GetParam());
    const fs::path folder_ = fs::temp_directory_path() / ("dem-docs-" + std::to_string(getpid()));
};

TEST_P(Page, EveryCodeBlockIsWhatItSays) {
    make_files();
    const auto is_shell = [](const Block& block) { return block.language == "sh"; };
    if (std::ranges::any_of(blocks_, is_shell)) make_what_readers_have();
    for (const Block& block : blocks_) run_block(block);
    std::set<std::string> cases;
    for (const Block& block : blocks_) {
        if (block.language == "ini") cases.insert(block.file);
    }
    for (const std::string& name : cases) {
        run_shell("demrun '" + name + "' --check", GetParam() + ": " + name);
    }
}

INSTANTIATE_TEST_SUITE_P(Docs, Page, testing::ValuesIn(pages_with_blocks()),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             std::ranges::replace_if(
                                 name, [](char c) { return !std::isalnum(c); }, '_');
                             return name;
                         });

TEST(FirstExample, RunsToItsEnd) {
    const fs::path folder = fs::temp_directory_path() / ("dem-example-" + std::to_string(getpid()));
    fs::create_directories(folder);
    for (const Block& block : code_blocks(source / "docs/case-file.md")) {
        if (block.file == "case.ini") std::ofstream(folder / "case.ini") << block.text;
    }
    const Outcome outcome = run_command(program("demrun") + " case.ini --quiet", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_NE(content(folder / "case/summary.json").find("\"end\": \"end_time\""),
              std::string::npos);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace dem
