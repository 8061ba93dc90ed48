// SPDX-License-Identifier: GPL-3.0-or-later
// The truths of one patient, prepared for look-up: the judged region, the centrelines, and the
// system that a point belongs to.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/accuracy/centreline_samples.h"
#include "core/accuracy/judged_region.h"
#include "core/accuracy/system_truth.h"
#include "core/image/filters.h"
#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

struct KnownSystem {
    VascularSystem system;
    Mask lumen;       // 0 or 1, on the grid of judged()
    VesselTree tree;  // its centrelines
    bool tree_given;  // false: computed from the mask
    CentrelineSamples samples;
    CentrelineLocator locator;
};

// Immutable after construction. The truths are one or more non-empty masks on one grid, which
// `liver` and `cava` share; both may be null, and a given liver has a voxel. The grid of judged()
// is that of the truths, cut to the liver with a margin of 12 mm. The constructor throws InputError
// where that does not hold; Cancelled.
class KnownSystems {
  public:
    KnownSystems(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                 const CavaNeighbourhood& size, Job& job);

    const std::vector<KnownSystem>& all() const { return all_; }
    const Mask& judged() const { return judged_; }  // 1: judged
    double step_mm() const { return step_mm_; }     // distance of samples: half a voxel

    // The number of the system at a point: that of the only lumen that holds it, else that of the
    // nearest centreline within reach_mm, else 0. Thread-safe.
    std::uint8_t system_at(const Vec3& p, double reach_mm) const;

    // Where the trunk of a system ends. With a given tree: its roots. For hepatic veins that reach
    // the vena cava: their voxels near it. For other systems: the point at which they divide
    // outside the judged region, else the middle of the widest section at which they leave it. In
    // all other cases: the widest judged end. Empty where nothing is judged.
    std::vector<Vec3> trunk_ends(const KnownSystem& known) const;

    // A point on the axis of a system, about inwards_mm from its widest judged end, where a user
    // would set a seed. None where nothing is judged.
    std::optional<Vec3> point_in_trunk(const KnownSystem& known, double inwards_mm) const;

  private:
    void set_region(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                    const IndexBox& box, const CavaNeighbourhood& size, Job& job);

    double step_mm_ = 0.5;
    Mask cava_;    // 1 near the vena cava
    Mask judged_;  // on the same grid
    std::vector<KnownSystem> all_;
};

}  // namespace hepatica
