// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/files/checkpoint_file.hpp"

#include "common/error.hpp"
#include "runtime/files/hdf5_file.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <csignal>

#include <sys/resource.h>

namespace dem::runtime {
namespace {

class CheckpointFile : public TemporaryFolder {
  protected:
    static Checkpoint sample(std::size_t count) {
        Checkpoint checkpoint;
        checkpoint["particles.position"] = {"vector", 24, std::vector<std::byte>(24 * count)};
        for (std::size_t k = 0; k < 24 * count; ++k) {
            checkpoint["particles.position"].bytes[k] = static_cast<std::byte>(k * 37 % 251);
        }
        checkpoint["contacts.none"] = {"history", 72, {}};
        checkpoint["steps"] = {"m", 8, std::vector<std::byte>(8, std::byte{7})};
        return checkpoint;
    }
    std::string read_message() const {
        return message_of<Error>([&] { read_checkpoint(path_); });
    }

    std::filesystem::path path_ = folder_ / "checkpoint.h5";
};

TEST_F(CheckpointFile, GivesBackEveryByteAndType) {
    const Checkpoint written = sample(5000);
    write_checkpoint(path_, written);
    const Checkpoint read = read_checkpoint(path_);
    ASSERT_EQ(read.size(), written.size());
    for (const auto& [name, values] : written) {
        ASSERT_TRUE(read.contains(name)) << name;
        EXPECT_EQ(read.at(name).type, values.type);
        EXPECT_EQ(read.at(name).value_bytes, values.value_bytes);
        EXPECT_EQ(read.at(name).bytes, values.bytes);
    }
}

TEST_F(CheckpointFile, AnyByteChangedOrCutOffIsAnError) {
    write_checkpoint(path_, sample(3));
    const std::string whole = text("checkpoint.h5");
    for (std::size_t k = 0; k < whole.size(); k += k + 200 < whole.size() ? 17 : 1) {
        std::string changed = whole;
        changed[k] = static_cast<char>(changed[k] ^ 0x10);
        write("checkpoint.h5", changed);
        EXPECT_NE(read_message(), "") << "byte " << k;
        write("checkpoint.h5", std::string_view(whole).substr(0, k));
        EXPECT_NE(read_message(), "") << "cut at " << k;
    }
    write("checkpoint.h5", whole);
    EXPECT_EQ(read_message(), "");
}

TEST_F(CheckpointFile, AnotherFileIsNamedAsSuch) {
    EXPECT_EQ(read_message().find(path_.string()), 0U) << "missing";
    write("checkpoint.h5", "no checkpoint");
    EXPECT_EQ(
        read_message(),
        path_.string() + ": is no checkpoint or is cut short, expected one that demrun wrote");
    {
        PendingFile pending(path_);
        JournaledFile disk(pending);
        Hdf5File(disk).close();
        pending.commit();
    }
    EXPECT_EQ(
        read_message(),
        path_.string() + ": is no checkpoint or is cut short, expected one that demrun wrote");
}

TEST_F(CheckpointFile, AFullDiskKeepsTheOneBefore) {
    write_checkpoint(path_, sample(10));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 100000;
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = message_of<Error>([&] { write_checkpoint(path_, sample(100000)); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_NE(message.find("File too large"), std::string::npos) << message;
    EXPECT_EQ(read_checkpoint(path_).at("particles.position").bytes.size(), 240U);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "no remains";
}

}  // namespace
}  // namespace dem::runtime
