// SPDX-License-Identifier: GPL-3.0-or-later
// Scores how well a case separates the vascular systems of a liver, against what is known of each:
// lengths found and invented, walls, roots, false joins and breaks. Lengths are those of
// centrelines; a stretch is found where the other centreline lies within a tolerance.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/accuracy/false_joins.h"
#include "core/accuracy/found_length.h"
#include "core/accuracy/known_systems.h"

namespace hepatica {

struct SystemScoreOptions {
    double length_tolerance_mm = 2.0;
    double surface_tolerance_mm = 1.0;
    JoinOptions joins;  // stretches shorter than its stray_mm make no break either
    // What is left out as vena cava of hepatic veins whose truth is only a mask.
    CavaNeighbourhood cava;
};

// Vessels of one class of radii; the shares are none where there are no such vessels.
struct RadiusClass {
    double from_mm = 0.0, to_mm = 0.0;
    double truth_length_mm = 0.0, tree_length_mm = 0.0;  // judged
    std::optional<double> length_recall;                 // by the truth's radius
    std::optional<double> length_precision;              // by the tree's radius
};

// Shares lie in [0, 1]. A share of no length is 0; the overlaps of two empty masks are 1.
struct SystemScore {
    VascularSystem system = VascularSystem::unknown;
    double truth_length_mm = 0.0, tree_length_mm = 0.0;  // judged
    double length_recall = 0.0;                          // of the truth's centrelines
    double length_precision = 0.0;                       // of the tree's centrelines of this system
    std::array<RadiusClass, std::tuple_size_v<FoundLengths>> by_radius;
    // Of the judged voxels, on the truth's grid; none where the case has no mask.
    std::optional<double> surface_dice, dice;
    // Distance from the root of the tree's longest piece of this system to the end of the truth's
    // trunk (KnownSystems::trunk_ends). None where the tree has no root of this system.
    std::optional<double> root_error_mm;
    std::optional<Vec3> trunk_at_mm;  // that end; the nearest to the root where there are several
};

struct SystemScores {
    std::vector<SystemScore> systems;  // in the order of the truths
    SystemScore vessels;               // all of them, whatever their system; has no root
    // Share of attributed_mm that carries the right system. A point of the tree belongs to the
    // system whose lumen alone holds it, else to that with the nearest centreline within the
    // tolerance, else to none.
    double system_right = 0.0;
    double attributed_mm = 0.0;  // judged length of the tree that belongs to a system of the truth
    int false_joins = 0;         // see false_joins.h
    int breaks = 0;  // pieces of a system beyond the first on one connected piece of its truth
    int loops = 0;   // in the whole tree
};

// Scores a tree and its mask. The truths (one for each system), `liver` and `cava` share one grid;
// `mask` holds numbers of systems on any grid and may be empty. `liver` and `cava` may be null:
// without a liver the whole grid is judged, apart from the cava. Reports progress in the present
// stage. Throws InputError where a truth or the liver is empty or a grid differs; Cancelled.
SystemScores judge_systems(const VesselTree& tree, const Mask& mask,
                           std::span<const SystemTruth> truths, const Mask* liver, const Mask* cava,
                           const SystemScoreOptions& options, Job& job);

// The same with prepared truths.
SystemScores judge_systems(const VesselTree& tree, const Mask& mask, const KnownSystems& known,
                           const SystemScoreOptions& options, Job& job);

}  // namespace hepatica
