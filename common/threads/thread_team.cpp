// SPDX-License-Identifier: BSD-3-Clause
// How a loop is shared. Its elements are cut into one share per thread, its share into parts. A
// thread takes parts off its own share, then off the others', by adding to the share's counter. So
// on an idle machine every thread comes back to the same elements step by step, and what a thread
// without a core has not begun is done by the others.
//
// The door tells helpers which loop is open and the caller how many of them are inside:
//
//     caller: describe the loop, open the door, work, close the door, wait until it is empty
//     helper: wait for a loop that it has not seen, enter if it is open, work, leave
//
// Entering is a compare-and-swap on the word that also holds the number of the loop and whether it
// is over: nobody enters a loop that is over, so the description may be written anew.
#include "common/threads/thread_team.hpp"

#include "common/error.hpp"
#include "common/threads/available_cores.hpp"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace dem {

namespace {

thread_local ThreadTeam* team_in_force = nullptr;

constexpr std::uint32_t one_loop = 1U << 16;
constexpr std::uint32_t is_closed = 1U << 15;
constexpr std::uint32_t inside = is_closed - 1;

/// Parts of a share. Many, so that little remains to be waited for; the loops of a step are
/// counted in microseconds, so not too many.
constexpr std::size_t parts_per_share = 16;
/// A part is at most so many grains, some 100 us: a caller that waits for the last one should not
/// wait long even where loops are.
constexpr std::size_t most_grains = 32;

/// A helper looks for the next loop of a step for some 5 us without letting go of its core, then
/// lets any other program have the core first, then sleeps until it is called: a call costs the
/// caller a few microseconds, and the helper comes tens of microseconds later.
constexpr int spins_for_loop = 5;
constexpr int yields_for_loop = 200;
/// The caller waits so long without letting go of its core for parts that have been begun: longer
/// than such a part takes unless its helper has lost its core. It does not yield, which on some
/// kernels gives up the whole time slice to other programs, but sleeps until it is called.
constexpr int spins_for_helpers = 100;

/// About a microsecond in which the other hardware thread of the core is not disturbed.
void pause() {
    for (int k = 0; k < 32; ++k) {
#if defined(__x86_64__)
        _mm_pause();
#else
        std::atomic_signal_fence(std::memory_order_seq_cst);
#endif
    }
}

bool is_same_loop(std::uint32_t door, std::uint32_t seen) {
    return door / one_loop == seen / one_loop;
}

}  // namespace

ThreadTeam::InForce::InForce(ThreadTeam* team) : before_(team_in_force) {
    team_in_force = team;
}

ThreadTeam::InForce::~InForce() {
    team_in_force = before_;
}

ThreadTeam* ThreadTeam::in_force() {
    return team_in_force;
}

std::size_t team_size_in_force() {
    return team_in_force == nullptr ? 1 : static_cast<std::size_t>(team_in_force->most());
}

ThreadTeam::ThreadTeam(int most) : door_(is_closed) {
    const auto size = static_cast<std::size_t>(most > 0 ? most : available_cores());
    used_ = size;
    shares_ = std::vector<Share>(size);
    for (std::size_t k = 0; k < size; ++k) workers_.push_back(std::make_unique<Worker>());
}

ThreadTeam::~ThreadTeam() {
    is_over_ = true;
    door_ += one_loop;
    for (const auto& worker : workers_) {
        const std::lock_guard lock(worker->mutex);
        worker->is_asleep = false;
        worker->is_called.notify_one();
    }
    for (std::thread& helper : helpers_) helper.join();
}

void ThreadTeam::use(int threads) {
    used_ = static_cast<std::size_t>(std::clamp(threads, 1, most()));
}

void ThreadTeam::share(std::size_t count, std::size_t grain, Work work, const void* context) {
    const InForce alone(nullptr);  // loops within this one are not shared
    const std::size_t least = shares_everything_ ? 1 : grain;
    if (count <= least || used_.load(std::memory_order_relaxed) == 1) {
        if (count > 0) work(context, LoopPart{0, count, 0});
        return;
    }
    loop_.work = work;
    loop_.context = context;
    start_helpers();
    open(count, least);
    work_on_parts(0);
    close();
    rethrow_first_error();
}

void ThreadTeam::start_helpers() {
    while (helpers_.size() + 1 < used_) {
        const std::size_t worker = helpers_.size() + 1;
        helpers_.emplace_back([this, worker] { help(worker); });
    }
}

void ThreadTeam::open(std::size_t count, std::size_t grain) {
    const std::size_t threads = used_.load(std::memory_order_relaxed);
    loop_.threads = threads;
    loop_.chunk = std::clamp(count / threads / parts_per_share, grain, grain * most_grains);
    for (std::size_t k = 0; k < threads; ++k) {
        shares_[k].next.store(count * k / threads, std::memory_order_relaxed);
        shares_[k].end = count * (k + 1) / threads;
    }
    // Not weaker: a helper that falls asleep first says so and then looks at the door.
    door_.store((door_.load(std::memory_order_relaxed) & ~(one_loop - 1)) + one_loop);
    for (std::size_t k = 1; k < threads; ++k) {
        Worker& worker = *workers_[k];
        if (!worker.is_asleep.load()) continue;
        const std::lock_guard lock(worker.mutex);
        worker.is_asleep = false;
        worker.is_called.notify_one();
    }
}

void ThreadTeam::close() {
    std::uint32_t door = door_.fetch_or(is_closed, std::memory_order_acq_rel);
    for (int k = 0; k < spins_for_helpers && (door & inside) != 0; ++k) {
        pause();
        door = door_.load(std::memory_order_acquire);
    }
    if ((door & inside) == 0) return;
    std::unique_lock lock(door_mutex_);
    is_empty_.wait(lock, [&] { return (door_.load(std::memory_order_acquire) & inside) == 0; });
}

void ThreadTeam::work_on_parts(std::size_t worker) {
    for (std::size_t k = 0; k < loop_.threads; ++k) {
        Share& share = shares_[(worker + k) % loop_.threads];
        // Looked at before it is added to, so that counters of finished shares stay in all caches.
        while (share.next.load(std::memory_order_relaxed) < share.end) {
            const std::size_t begin = share.next.fetch_add(loop_.chunk, std::memory_order_relaxed);
            if (begin >= share.end) break;
            work_on(worker, {begin, std::min(begin + loop_.chunk, share.end), worker});
        }
    }
}

void ThreadTeam::work_on(std::size_t worker, const LoopPart& part) {
    try {
        loop_.work(loop_.context, part);
    } catch (...) {
        Worker& w = *workers_[worker];
        if (w.error && w.error_at < part.begin) return;
        w.error = std::current_exception();
        w.error_at = part.begin;
    }
}

void ThreadTeam::rethrow_first_error() {
    std::exception_ptr first;
    std::size_t first_at = 0;
    for (std::size_t k = 0; k < loop_.threads; ++k) {
        Worker& worker = *workers_[k];
        if (worker.error && (!first || worker.error_at < first_at)) {
            first = worker.error;
            first_at = worker.error_at;
        }
        worker.error = nullptr;
    }
    if (first) std::rethrow_exception(first);
}

void ThreadTeam::help(std::size_t worker) {
    std::uint32_t seen = is_closed;
    while (true) {
        std::uint32_t door = await_loop(worker, seen);
        if (is_over_) return;
        seen = door;
        bool is_in = false;
        while (!is_in && (door & is_closed) == 0 && is_same_loop(door, seen))
            is_in = door_.compare_exchange_weak(door, door + 1, std::memory_order_acq_rel);
        if (!is_in) continue;
        if (worker < loop_.threads) work_on_parts(worker);
        // The last one out of a loop that is over calls its caller, who may have fallen asleep.
        door = door_.fetch_sub(1, std::memory_order_acq_rel) - 1;
        if ((door & is_closed) == 0 || (door & inside) != 0) continue;
        const std::lock_guard lock(door_mutex_);
        is_empty_.notify_one();
    }
}

/// Whether there is a loop that the worker has not seen and is to take part in.
bool ThreadTeam::is_wanted(std::size_t worker, std::uint32_t door, std::uint32_t seen) const {
    return !is_same_loop(door, seen) && (worker < used_ || is_over_);
}

std::uint32_t ThreadTeam::await_loop(std::size_t worker, std::uint32_t seen) {
    while (true) {
        for (int k = 0; k < spins_for_loop + yields_for_loop; ++k) {
            const std::uint32_t door = door_.load(std::memory_order_acquire);
            if (is_wanted(worker, door, seen)) return door;
            if (k < spins_for_loop) {
                pause();
            } else {
                std::this_thread::yield();
            }
        }
        sleep(worker, seen);
    }
}

void ThreadTeam::sleep(std::size_t worker, std::uint32_t seen) {
    Worker& self = *workers_[worker];
    std::unique_lock lock(self.mutex);
    self.is_asleep = true;
    if (is_wanted(worker, door_, seen)) {
        self.is_asleep = false;
        return;
    }
    self.is_called.wait(lock, [&] { return !self.is_asleep; });
}

}  // namespace dem
