// SPDX-License-Identifier: GPL-3.0-or-later
// The quality dial of a session and the setting of it that the deforming body uses: turned by hand,
// given exactly, or chosen automatically by the cost of frames (see QualityGovernor).
#pragma once

#include <cstddef>
#include <optional>

#include "core/deform/stepper/quality_dial.h"
#include "core/scene/frame.h"
#include "core/session/quality_governor.h"

namespace hepatica {

class DeformPart;

// Not thread-safe.
class DialInUse {
  public:
    explicit DialInUse(QualityDial dial);

    bool automatic() const { return automatic_; }
    // 0 fastest to 1 most accurate; none where the setting in use is not on the dial.
    std::optional<double> quality() const;

    // Finds the part's setting on the dial, after it was changed by others.
    void follow(const DeformPart& deform);
    void set_automatic(bool automatic) { automatic_ = automatic; }

    // Uses another dial of the same body. Where the setting in use came from the old dial and is
    // not on the new one, it is replaced: by the choice of automatic quality, or by the setting at
    // the same position of the dial. Returns whether it was. `deform` is null in a scene without.
    bool take(QualityDial dial, DeformPart* deform, double budget_ms);
    // Ends automatic quality. `quality` from 0 to 1.
    void turn(double quality, DeformPart& deform);
    // Begins automatic quality with the most accurate setting that fits the budget, whatever frames
    // cost when it was automatic before.
    void turn_automatically(double budget_ms, DeformPart& deform);
    // After a change of the body: what its steps cost before, and which settings were too slow,
    // says nothing of it any more.
    void forget_costs();
    // Automatic quality after a step at this cost: returns whether it chose another setting.
    bool govern(double step_ms, double budget_ms, DeformPart* deform);

    void fill(FrameStatistics& statistics) const;

  private:
    void use(std::size_t point, DeformPart& deform);

    QualityDial dial_;
    QualityGovernor governor_;
    std::optional<std::size_t> point_;  // index of the setting in use on the dial
    bool automatic_ = false;
};

}  // namespace hepatica
