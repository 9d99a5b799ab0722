// SPDX-License-Identifier: BSD-3-Clause
#include "common/atomic_file.hpp"

#include "common/error.hpp"

#include <csignal>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dem {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    AtomicFileTest() {
        folder_ = fs::temp_directory_path() / ("dem-atomic-file-" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    ~AtomicFileTest() override { fs::remove_all(folder_); }

    static std::string content(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    long files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    fs::path folder_;
};

TEST_F(AtomicFileTest, TheFileHasItsNameOnlyAfterCommitAndThenAllOfItsContent) {
    const fs::path path = folder_ / "a.csv";
    const std::string block(100000, 'x');
    {
        AtomicFile file(path);
        for (int i = 0; i < 7; ++i) file.write(block);
        EXPECT_FALSE(fs::exists(path));
        file.commit();
    }
    EXPECT_EQ(content(path).size(), 700000U);
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, AFailureLeavesTheOldFileAndNothingElse) {
    const fs::path path = folder_ / "a.csv";
    write_file(path, "old");
    try {
        AtomicFile file(path);
        file.write("half of the new");
        throw Error("no");
    } catch (const Error&) {
    }
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, APipeOrDeviceIsNotReplacedByAFile) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(AtomicFile{pipe}, Error);
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, TwoWritersOfOneFileDoNotMix) {
    const fs::path path = folder_ / "a.csv";
    AtomicFile first(path);
    AtomicFile second(path);
    first.write("first");
    second.write("second");
    first.commit();
    second.commit();
    EXPECT_EQ(content(path), "second");
}

TEST_F(AtomicFileTest, AFolderThatDoesNotExistOrAFolderInPlaceOfTheFileIsNamed) {
    const fs::path missing = folder_ / "none" / "a.csv";
    try {
        write_file(missing, "x");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.what(), missing.string() +
                                ": cannot create: No such file or directory, expected a folder in "
                                "which files can be made");
    }
    EXPECT_THROW(write_file(folder_, "x"), Error);
}

TEST_F(AtomicFileTest, AWriteThatFailsIsAnErrorAndLeavesNothing) {
    // A limit on the size of files stands in for the end of a disk: both make write() fail.
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{4096, limit.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_NO_THROW(write_file(folder_ / "fits", std::string(4096, 'x')));
    EXPECT_THROW(write_file(folder_ / "small", std::string(5000, 'x')), Error);
    EXPECT_THROW(write_file(folder_ / "large", std::string(1000000, 'x')), Error);
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace dem
