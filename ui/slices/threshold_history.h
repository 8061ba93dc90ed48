// SPDX-License-Identifier: GPL-3.0-or-later
// Remembers the threshold that a case's present vessels were made by, and what they would be at the
// usual threshold. Thus a threshold means the same before and after a rebuild, and the usual one
// leads back. No widgets; not thread-safe.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/reconstruction/vessel_preview.h"

namespace hepatica {

class ThresholdHistory {
  public:
    // The vessels of another CT, taken to be made by the usual threshold.
    void begin(const Mask& vessels);
    // The vessels are now these: rebuilt as announced by rebuild(), as in a remembered state, or
    // changed by hand, which then holds for all thresholds. True if changed by hand.
    bool follow(const Mask& vessels);
    // Announces that the vessels will be rebuilt from this mask, made by this choice.
    void rebuild(const ThresholdChoice& choice, Mask vessels);
    void forget() { *this = {}; }

    bool empty() const { return now_.usual == nullptr; }
    // The present vessels' choice, and below their mask at the usual threshold. Neither if empty().
    const ThresholdChoice& choice() const { return now_.choice; }
    const std::shared_ptr<const Mask>& usual() const { return now_.usual; }

  private:
    struct State {
        std::size_t fingerprint = 0;  // hash of the vessels' voxels
        ThresholdChoice choice;
        std::shared_ptr<const Mask> usual;
    };
    static constexpr std::size_t most_states = 8;  // remembered at most

    bool is_rebuilt(const Mask& vessels) const;
    std::shared_ptr<const Mask> usual_with_changes(std::shared_ptr<const Mask> vessels) const;
    void stand(State state, std::shared_ptr<const Mask> vessels);

    State now_;
    std::shared_ptr<const Mask> vessels_;  // the present ones
    std::vector<State> before_;
    ThresholdChoice wanted_;
    std::shared_ptr<const Mask> wanted_vessels_;  // null: no rebuild announced
};

}  // namespace hepatica
