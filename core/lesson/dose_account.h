// SPDX-License-Identifier: GPL-3.0-or-later
// Where the drug of a play has gone: what was injected, what left through the ends of the vessels,
// and through whose. Delivered is delivered in the target plus elsewhere; reflux is the part of it
// that left through vessels which do not begin at the catheter's tip.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/flow/injection.h"
#include "core/lesson/target_region.h"
#include "core/scene/frame.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// In g.
struct Dose {
    double injected_g = 0.0;
    double delivered_g = 0.0;
    double target_g = 0.0;
    double reflux_g = 0.0;
    double elsewhere_g() const { return delivered_g - target_g; }
};

// One injection over time, as core/flow computes it at rest (as all of the window's curves), linear
// between samples.
class DoseCurve {
  public:
    // Costs a tenth of a second for a drug that flows like blood, seconds for another. Throws
    // InputError where nothing can flow.
    DoseCurve(const VesselTree& tree, const InjectionOptions& options, double end_s,
              const std::optional<TargetRegion>& target);
    // Clamped to the run.
    Dose at(double time_s) const;

  private:
    std::vector<double> time_s_;
    std::vector<Dose> dose_;
};

// Of all injections of a play: one that is replaced or removed counts as far as it went.
class DoseAccount {
  public:
    DoseAccount(const VesselTree& tree, const std::optional<TargetRegion>& target)
        : tree_(tree), target_(target) {}

    void see(const DrugView& drug);
    Dose total() const;

  private:
    const VesselTree& tree_;
    std::optional<TargetRegion> target_;
    std::shared_ptr<const InjectionOptions> followed_;
    std::optional<DoseCurve> curve_;
    Dose past_, present_;
};

}  // namespace hepatica
