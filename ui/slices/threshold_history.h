// SPDX-License-Identifier: GPL-3.0-or-later
// By which threshold the vessels that a case has now were made, and what they would be by the usual
// one: so that a threshold means the same before and after the vessels were made anew by it, and
// the usual one leads back. No widget; not thread-safe.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/reconstruction/vessel_preview.h"

namespace hepatica {

class ThresholdHistory {
  public:
    // The vessels of another CT: these are by the usual threshold.
    void begin(const Mask& vessels);
    // The vessels are these now: made anew as rebuild() said, as they were once before, or changed
    // by hand, which holds for all thresholds. True where they were changed by hand.
    bool follow(const Mask& vessels);
    // They shall be made anew of these, which this choice has brought.
    void rebuild(const ThresholdChoice& choice, Mask vessels);
    void forget() { *this = {}; }

    bool empty() const { return now_.usual == nullptr; }
    // Of the vessels as they are now. Unless empty:
    const ThresholdChoice& choice() const { return now_.choice; }
    // What they are by the usual threshold.
    const std::shared_ptr<const Mask>& usual() const { return now_.usual; }

  private:
    struct State {
        std::size_t fingerprint = 0;  // of the vessels
        ThresholdChoice choice;
        std::shared_ptr<const Mask> usual;
    };
    static constexpr std::size_t most_states = 8;  // that are remembered

    bool is_rebuilt(const Mask& vessels) const;
    std::shared_ptr<const Mask> usual_with_changes(std::shared_ptr<const Mask> vessels) const;
    void stand(State state, std::shared_ptr<const Mask> vessels);

    State now_;
    std::shared_ptr<const Mask> vessels_;  // now
    std::vector<State> before_;
    ThresholdChoice wanted_;
    std::shared_ptr<const Mask> wanted_vessels_;  // null: nothing is being made anew
};

}  // namespace hepatica
