// SPDX-License-Identifier: GPL-3.0-or-later
// The truths of one patient as things are looked up in them: where they are judged, their
// centrelines, and which system a point belongs to.
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
    Mask lumen;       // on the grid of what is judged
    VesselTree tree;  // its centrelines
    bool tree_given;  // else they are the mask's
    CentrelineSamples samples;
    CentrelineLocator locator;
};

// What system_scores.h says of truths, liver and cava holds here.
class KnownSystems {
  public:
    KnownSystems(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                 const CavaNeighbourhood& size, Job& job);

    const std::vector<KnownSystem>& all() const { return all_; }
    const Mask& judged() const { return judged_; }  // not zero: is judged
    double step_mm() const { return step_mm_; }     // between samples: half a voxel

    // The system whose lumen alone holds a point, else that of the nearest centreline within
    // reach_mm; 0 where there is none. Thread-safe.
    std::uint8_t system_at(const Vec3& p, double reach_mm) const;

    // Where the trunk of a system ends: the roots of its tree, where that was given; of hepatic
    // veins the voxels near the vena cava, where they reach it; of others the place at which they
    // divide outside of what is judged; else the widest section at which they leave it; else the
    // widest judged end.
    std::vector<Vec3> trunk_ends(const KnownSystem& known) const;

    // A point on the axis of a system's widest judged end, about inwards_mm from that end: where a
    // person would set a seed. None where nothing is judged.
    std::optional<Vec3> point_in_trunk(const KnownSystem& known, double inwards_mm) const;

  private:
    void set_region(std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                    const IndexBox& box, const CavaNeighbourhood& size, Job& job);

    double step_mm_ = 0.5;
    Mask cava_;    // 1 near the vena cava
    Mask judged_;  // same grid
    std::vector<KnownSystem> all_;
};

}  // namespace hepatica
