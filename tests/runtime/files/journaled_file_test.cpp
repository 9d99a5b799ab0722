// SPDX-License-Identifier: BSD-3-Clause
// The calls of the system by which a journaled file reaches the disk are replaced here by ones that
// note what they do, so that the disk can be put into every state that a kill or a power cut
// leaves, and so is what tells whether the machine was started again.
#include "runtime/files/journaled_file.hpp"

#include "common/boot_id.hpp"
#include "common/error.hpp"
#include "common/random.hpp"
#include "tests/formats/temporary_folder.hpp"

#include <algorithm>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace dem::runtime {
namespace {

using Bytes = std::string;

/// One call that changes a file, or that waits for the disk.
struct Call {
    enum class Kind { write, cut, sync };
    Kind kind;
    bool is_journal;
    std::size_t offset;  ///< of a write; of a cut the size that is left
    Bytes bytes;
};

struct Disk {
    Bytes file, journal;
    Bytes& of(const Call& call) { return call.is_journal ? journal : file; }

    void make(const Call& call) {
        Bytes& content = of(call);
        if (call.kind == Call::Kind::cut) content.resize(call.offset);
        if (call.kind != Call::Kind::write) return;
        content.resize(std::max(content.size(), call.offset + call.bytes.size()));
        content.replace(call.offset, call.bytes.size(), call.bytes);
    }
};

std::uint64_t boot = 1;
std::vector<Call> calls;
bool is_noting = false;

void note(Call::Kind kind, int descriptor, std::size_t offset, Bytes bytes) {
    const auto link = "/proc/self/fd/" + std::to_string(descriptor);
    const auto name = std::filesystem::read_symlink(link).filename();
    if (!is_noting || (name != "data" && name != "data.journal")) return;
    calls.push_back({kind, name == "data.journal", offset, std::move(bytes)});
}

}  // namespace
}  // namespace dem::runtime

std::uint64_t dem::boot_id() {
    return dem::runtime::boot;
}

extern "C" {
ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t offset) {
    dem::runtime::note(dem::runtime::Call::Kind::write, descriptor,
                       static_cast<std::size_t>(offset), {static_cast<const char*>(bytes), count});
    return syscall(SYS_pwrite64, descriptor, bytes, count, offset);
}
int ftruncate(int descriptor, off_t size) noexcept {
    dem::runtime::note(dem::runtime::Call::Kind::cut, descriptor, static_cast<std::size_t>(size),
                       {});
    return static_cast<int>(syscall(SYS_ftruncate, descriptor, size));
}
int fsync(int descriptor) {
    dem::runtime::note(dem::runtime::Call::Kind::sync, descriptor, 0, {});
    return 0;
}
}

namespace dem::runtime {
namespace {

std::span<const std::byte> bytes_of(const Bytes& text) {
    return std::as_bytes(std::span(text));
}

std::size_t below(Random& random, std::size_t limit) {
    return random.next() % limit;
}

Bytes random_bytes(Random& random, std::size_t count) {
    Bytes bytes(count, '\0');
    for (char& c : bytes) c = static_cast<char>(1 + below(random, 255));
    return bytes;
}

class Journaled : public TemporaryFolder {
  protected:
    const std::filesystem::path path_ = folder_ / "data";
    Random random_{1, 1};
    const Bytes beginning_ = random_bytes(random_, 1300);

    Journaled() { write("data", beginning_); }
    ~Journaled() override { is_noting = false; }

    void put(const Disk& disk) const {
        // In place: it must stay the same file.
        std::fstream(path_, std::ios::in | std::ios::out | std::ios::binary) << disk.file;
        std::filesystem::resize_file(path_, disk.file.size());
        std::filesystem::remove(path_.string() + ".journal");
        if (!disk.journal.empty()) write("data.journal", disk.journal);
    }
    /// What the file is after it was opened and closed again.
    Bytes opened(const Disk& disk) const {
        put(disk);
        { const JournaledFile file(path_); }
        EXPECT_FALSE(std::filesystem::exists(path_.string() + ".journal"));
        return text("data");
    }
};

/// Additions of every sort, with the content of the file after each and the calls made by then.
struct Story {
    std::vector<Bytes> content;
    std::vector<std::size_t> calls_made;
    std::vector<std::size_t> secured;  ///< the calls after which `secure` had been called
};

Story tell(const std::filesystem::path& path, const Bytes& beginning, std::uint64_t seed) {
    Random random(seed, 0);
    Story story{{beginning}, {0}, {}};
    calls.clear();
    is_noting = true;
    JournaledFile file(path);
    for (int n = 0; n < 12; ++n) {
        Bytes content = story.content.back();
        const auto change = [&](std::size_t offset, const Bytes& bytes) {
            content.resize(std::max(content.size(), offset + bytes.size()));
            content.replace(offset, bytes.size(), bytes);
            file.write(offset, bytes_of(bytes));
        };
        const auto some = [&](std::size_t most) {
            return random_bytes(random, 1 + below(random, most));
        };
        if (n % 5 == 4) {
            content.resize(content.size() - below(random, content.size() / 3));
            file.resize(content.size());
        } else {
            change(content.size(), some(3000));
            file.resize(content.size());
        }
        for (std::size_t k = below(random, 4); k > 0; --k) {
            const Bytes bytes = some(std::min<std::size_t>(700, content.size()));
            change(below(random, content.size() - bytes.size() + 1), bytes);
        }
        Bytes found(content.size(), '\0');
        file.read(0, std::as_writable_bytes(std::span(found)));
        EXPECT_TRUE(found == content);
        file.commit();
        story.content.push_back(content);
        story.calls_made.push_back(calls.size());
        if (n % 4 == 3) {
            file.secure();
            story.secured.push_back(calls.size());
        }
    }
    is_noting = false;
    return story;
}

/// Which of the contents a file is; -1: none. Bytes behind the end do no harm, but are only left
/// where the journal was lost.
int version_of(const Story& story, const Bytes& content, bool has_journal) {
    for (std::size_t k = story.content.size(); k-- > 0;) {
        const Bytes& version = story.content[k];
        if (content.starts_with(version) && (!has_journal || content == version)) {
            return static_cast<int>(k);
        }
    }
    return -1;
}

TEST_F(Journaled, AKillAtAnyMomentLeavesTheFileAfterAnAddition) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        write("data", beginning_);
        const Story story = tell(path_, beginning_, seed);
        const std::vector<Call> all = calls;
        for (std::size_t count = 0; count <= all.size(); ++count) {
            Disk disk{beginning_, {}};
            for (std::size_t k = 0; k < count; ++k) disk.make(all[k]);
            std::size_t done = 0;
            while (done + 1 < story.calls_made.size() && story.calls_made[done + 1] <= count)
                ++done;
            // Torn within the next call, too, at the end of one of its pages.
            const std::size_t torn = count < all.size() ? all[count].bytes.size() : 0;
            for (std::size_t part = 0; part <= torn; part += page_bytes) {
                Disk now = disk;
                if (part > 0) {
                    Call cut = all[count];
                    cut.bytes.resize(part);
                    now.make(cut);
                }
                const int version = version_of(story, opened(now), !now.journal.empty());
                ASSERT_GE(version, static_cast<int>(done)) << "seed " << seed << " call " << count;
                ASSERT_LE(version, static_cast<int>(done) + 1);
            }
        }
    }
}

TEST_F(Journaled, APowerCutTakesTheFileBackToAnAdditionThatTheDiskHas) {
    Random random(7, 0);
    for (const std::uint64_t seed : {4U, 5U, 6U}) {
        write("data", beginning_);
        const Story story = tell(path_, beginning_, seed);
        const std::vector<Call> all = calls;
        for (int trial = 0; trial < 300; ++trial) {
            const std::size_t count = below(random, all.size() + 1);
            Disk disk{beginning_, {}};
            std::size_t last_sync[2] = {0, 0};
            for (std::size_t k = 0; k < count; ++k) {
                if (all[k].kind == Call::Kind::sync) last_sync[all[k].is_journal ? 1 : 0] = k;
            }
            const double lost_share = random.uniform();
            for (std::size_t k = 0; k < count; ++k) {
                const Call& call = all[k];
                if (k < last_sync[call.is_journal ? 1 : 0]) {
                    disk.make(call);
                    continue;
                }
                // Every sector of a write by itself.
                for (std::size_t at = 0; at == 0 || at < call.bytes.size();) {
                    const std::size_t next =
                        (call.offset + at) / page_bytes * page_bytes + page_bytes - call.offset;
                    Call part = call;
                    part.bytes = at < call.bytes.size() ? call.bytes.substr(at, next - at) : "";
                    if (call.kind == Call::Kind::write) part.offset += at;
                    if (random.uniform() >= lost_share) disk.make(part);
                    at = next;
                }
            }
            std::size_t secured = 0;
            for (std::size_t k = 0; k < story.calls_made.size(); ++k) {
                for (const std::size_t call : story.secured) {
                    if (call <= count && story.calls_made[k] <= call) secured = k;
                }
            }
            boot = 2;
            const int version = version_of(story, opened(disk), false);
            boot = 1;
            ASSERT_GE(version, static_cast<int>(secured))
                << "seed " << seed << " trial " << trial << " after call " << count;
        }
    }
}

TEST_F(Journaled, AnAdditionThatIsNotCommittedIsDropped) {
    {
        JournaledFile file(path_);
        file.write(100, bytes_of("changed"));
        file.write(5000, bytes_of("new"));
        file.resize(5003);
        EXPECT_EQ(file.size(), 5003U);
    }
    EXPECT_TRUE(text("data") == beginning_);
}

TEST_F(Journaled, AFullDiskIsToldByCommitAndLeavesTheFileAsItWas) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    {
        JournaledFile file(path_);
        rlimit small = before;
        small.rlim_cur = 10000;
        setrlimit(RLIMIT_FSIZE, &small);
        const Bytes large(20000, 'x');
        file.write(1300, bytes_of(large));
        file.write(0, bytes_of("changed"));
        file.resize(21300);
        Bytes found(20000, '\0');
        file.read(1300, std::as_writable_bytes(std::span(found)));
        EXPECT_TRUE(found == large) << "the writer sees what it wrote";
        EXPECT_EQ(message_of<Error>([&] { file.commit(); }),
                  path_.string() + ": cannot write: File too large");
        setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_TRUE(text("data") == beginning_);
        file.write(1300, bytes_of("more"));
        file.resize(1304);
        file.commit();
    }
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(text("data") == beginning_ + "more");
}

TEST_F(Journaled, AJournalOfAnotherFileIsLeftAlone) {
    Disk disk{beginning_, {}};
    tell(path_, beginning_, 8);
    for (const Call& call : calls) {
        if (call.is_journal) disk.make(call);
    }
    disk.file = random_bytes(random_, 100000);
    EXPECT_TRUE(opened(disk) == disk.file);
}

TEST_F(Journaled, AFileThatWasReplacedMeanwhileIsAnError) {
    JournaledFile file(path_);
    std::filesystem::rename(path_, folder_ / "elsewhere");
    write("data", "of somebody else");
    file.write(0, bytes_of("changed"));
    EXPECT_NE(message_of<Error>([&] { file.commit(); }).find("was removed or replaced"),
              std::string::npos);
    EXPECT_EQ(text("data"), "of somebody else");
    EXPECT_TRUE(text("elsewhere") == beginning_);
}

}  // namespace
}  // namespace dem::runtime
