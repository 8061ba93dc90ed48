// SPDX-License-Identifier: GPL-3.0-or-later
// Mass balance of the drug in a play: injected, delivered through the outlets of the vessels, and
// delivered through which outlets. Delivered = target + elsewhere. Reflux is what left through
// outlets that do not lie downstream of the catheter's tip.
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

// One injection over time, computed by core/flow on the tree at rest, as for the window's curves,
// and interpolated linearly.
class DoseCurve {
  public:
    // Costs 0.1 s for a drug with the viscosity of blood, seconds for others. `end_s` >= 0: end of
    // the run. Throws InputError where nothing can flow.
    DoseCurve(const VesselTree& tree, const InjectionOptions& options, double end_s,
              const std::optional<TargetRegion>& target);
    // `time_s` is clamped to the run.
    Dose at(double time_s) const;

  private:
    std::vector<double> time_s_;
    std::vector<Dose> dose_;
};

// Sum over all injections of a play; one that is replaced or removed counts up to that moment.
// Where the play goes back to an earlier state, what was injected since does not count. Keeps a
// reference to the tree. Not thread-safe.
class DoseAccount {
  public:
    DoseAccount(const VesselTree& tree, const std::optional<TargetRegion>& target)
        : tree_(tree), target_(target) {}

    // Call with every frame. Throws InputError where a new injection cannot flow.
    void see(const DrugView& drug);
    Dose total() const;

  private:
    struct Part {        // one injection
        int number = 0;  // DrugView::injections
        std::shared_ptr<const InjectionOptions> injection;
        DoseCurve curve;
        Dose dose;  // up to the last frame that showed it
    };
    const VesselTree& tree_;
    std::optional<TargetRegion> target_;
    std::vector<Part> parts_;
};

}  // namespace hepatica
