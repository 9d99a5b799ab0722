// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

/// The one way in which loops run in parallel (docs/threads.md). A leaf function hands its loop to
/// `share_loop` or `share_each`; whoever calls it decides beforehand which team is in force.
namespace dem {

/// Elements begin .. end - 1 of a loop, done by one thread of a team.
struct LoopPart {
    std::size_t begin, end;
    std::size_t worker;  ///< 0: the thread that called; below team_size_in_force()
};

/// A thread and its helpers. The caller of a loop works on all of it; helpers that are awake take
/// parts off it. The caller never waits for a helper to come, only for parts that have been begun,
/// so a helper that the machine gives no core costs next to nothing. Any thread may get any part:
/// results go to slots of their own, and what is added up is added in a fixed order afterwards.
class ThreadTeam {
  public:
    /// `most`: threads, the caller among them; 0: as many as there are cores. Helpers are started
    /// when they are needed first.
    explicit ThreadTeam(int most);
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;
    ~ThreadTeam();

    int most() const { return static_cast<int>(workers_.size()); }
    /// How many threads take part from the next loop on, 1 .. most().
    void use(int threads);
    /// Every loop is shared in single elements: for tests.
    void share_everything() { shares_everything_ = true; }

    /// Loops of the thread that makes it are shared with a team for as long as it lives.
    class InForce {
      public:
        explicit InForce(ThreadTeam* team);  ///< none: they are not shared
        InForce(const InForce&) = delete;
        InForce& operator=(const InForce&) = delete;
        ~InForce();

      private:
        ThreadTeam* before_;
    };
    /// The team in force on this thread, or none.
    static ThreadTeam* in_force();

    using Work = void (*)(const void* context, const LoopPart& part);
    /// What share_loop does where a team is in force.
    void share(std::size_t count, std::size_t grain, Work work, const void* context);

  private:
    /// Threads write to these at the same time: a cache line each.
    struct alignas(64) Share {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };
    struct alignas(64) Worker {
        std::mutex mutex;
        std::condition_variable is_called;
        std::atomic<bool> is_asleep{false};
        std::exception_ptr error;
        std::size_t error_at = 0;  ///< begin of the part that failed
    };
    struct Loop {
        Work work = nullptr;
        const void* context = nullptr;
        std::size_t chunk = 0;
        std::size_t threads = 0;
    };

    void start_helpers();
    void open(std::size_t count, std::size_t grain);
    void close();
    void work_on_parts(std::size_t worker);
    void work_on(std::size_t worker, const LoopPart& part);
    void rethrow_first_error();
    void help(std::size_t worker);
    bool is_wanted(std::size_t worker, std::uint32_t door, std::uint32_t seen) const;
    std::uint32_t await_loop(std::size_t worker, std::uint32_t seen);
    void sleep(std::size_t worker, std::uint32_t seen);

    std::atomic<std::size_t> used_;
    bool shares_everything_ = false;
    Loop loop_;  ///< written by the caller while the door is closed and nobody is inside
    std::vector<Share> shares_;
    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<std::thread> helpers_;
    std::atomic<bool> is_over_{false};
    /// Number of the loop, a bit that says that it is over, and how many helpers are inside.
    alignas(64) std::atomic<std::uint32_t> door_;
    std::mutex door_mutex_;
    std::condition_variable is_empty_;
};

/// Room for results of one thread each: as many as there may be threads in a loop.
std::size_t team_size_in_force();

/// Calls work(part) for parts that together are the elements 0 .. count - 1, in any order, on the
/// threads of the team in force; in one part on this thread if there is none. `grain`: elements
/// that take a few microseconds, less is not worth sharing. An exception thrown by an element is
/// rethrown here after the loop, the one of the lowest element if there are several.
template <class Work>
void share_loop(std::size_t count, std::size_t grain, const Work& work) {
    ThreadTeam* const team = ThreadTeam::in_force();
    if (team == nullptr) {
        if (count > 0) work(LoopPart{0, count, 0});
        return;
    }
    team->share(
        count, grain,
        [](const void* context, const LoopPart& part) {
            (*static_cast<const Work*>(context))(part);
        },
        &work);
}

/// Calls body(k) for the elements 0 .. count - 1 in the manner of share_loop.
template <class Body>
void share_each(std::size_t count, std::size_t grain, const Body& body) {
    share_loop(count, grain, [&](const LoopPart& part) {
        for (std::size_t k = part.begin; k < part.end; ++k) body(k);
    });
}

}  // namespace dem
