// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace dem {

/// Decides from measured steps how many threads work on the next one. Begins with one thread and
/// tries the next larger and the next smaller team in turn, one every quarter of a second, for 20
/// ms at a time. A team that is clearly faster several times in a row is kept, and the next one in
/// its direction is tried at once. A trial that goes wrong is cut off, and the next one waits until
/// what it cost is 3 % of the time. So neighbors that come or go are noticed within half a second.
class TeamSize {
  public:
    explicit TeamSize(int most);

    int most() const { return sizes_.back(); }
    int next() const { return sizes_[is_trying_ ? tried() : kept_]; }
    /// Wall time of a step with the threads of `next` [s].
    void step_took(double seconds);

  private:
    struct Block {
        double time = 0.0;  ///< [s]
        double steps = 0.0;
        double mean() const { return time / steps; }
    };
    enum class Way : int { smaller = -1, larger = 1 };

    std::size_t tried() const { return kept_ + static_cast<std::size_t>(way_); }
    bool can_go(Way way) const;
    void end_block();
    void begin_trial();
    void look_at_trial();
    void keep_tried();
    void give_up_trial();

    std::vector<int> sizes_;  ///< 1, 2, 3, 4, 6, 8, 12, ... and the most there may be
    std::size_t kept_ = 0;    ///< index of the present size
    Way way_ = Way::larger;
    bool is_trying_ = false;
    int wins_ = 0;              ///< of the size that is tried
    Block block_;               ///< that is under way
    double mean_ = 0.0;         ///< step of the present size in its last block [s]
    double until_trial_ = 0.0;  ///< [s]
    double trial_cost_ = 0.0;   ///< of the tries of one size so far [s]
};

}  // namespace dem
