// SPDX-License-Identifier: GPL-3.0-or-later
// From a unit-width skeleton to a vessel tree: segments between bifurcations and ends, with smooth
// centrelines, sub-voxel radii, parents, Strahler orders and systems.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/extraction/component_pruning.h"
#include "core/tree/extraction/gap_bridging.h"
#include "core/tree/systems/tell_systems_apart.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct TreeOptions {
    // Components with a seed in them are kept however short they are.
    std::vector<VesselSeed> seeds;
    // Places, such as of painted vessels: what lies there is kept as by a seed, whatever it is.
    std::vector<Vec3> kept_mm;
    // Tells the systems apart by anatomy and seeds (tell_systems_apart.h), opens loops and begins
    // each system where anatomy has it. Otherwise systems come from the mask
    // (system_assignment.h).
    bool find_systems = false;
    const Mask* systems_before = nullptr;  // for find_systems: see SystemSearch::before
    Eigen::AlignedBox3d liver_mm;          // for find_systems; empty: not known
    // Where the portal trunk comes in from outside, if known: for find_systems.
    std::optional<Vec3> portal_trunk_mm;
    bool shorten_trunk = false;  // the tree begins shortly before it divides (portal_trunk.h)
    // Wished roots; each acts on the component it lies nearest to, at its end nearest to the
    // position. A component without one begins at its widest end.
    std::vector<Vec3> roots_mm;
    // An end branch that reaches less than this many radii of its parent beyond the parent's wall
    // is a bump of the wall, not a vessel.
    double spur_radii = 0.5;
    // Pieces shorter than this are noise and left out, unless nothing longer exists.
    double minimum_piece_mm = 3.0;
    // The same after gaps have been bridged, for what is still on its own and holds no seed.
    double minimum_component_mm = 15.0;
    // Gaps that are bridged without asking, and those that are only offered.
    BridgeOptions bridging;
};

struct TreeExtraction {
    VesselTree tree;
    std::vector<Bridge> bridges;          // built and offered ones, best first
    RemovedPieces too_short;              // left out, before and after gaps were bridged
    std::optional<SystemsFound> systems;  // where they were looked for
    int opened_loops = 0;
    RemovedPieces blobs;         // what is no vessel, left out where systems were looked for
    RemovedPieces beside_trunk;  // of the portal vein, before it divides (portal_trunk.h)
    std::vector<VesselSeed> trunk_left_out;  // along the trunk that was shortened, and beside it
};

// Both masks lie on one grid; `vessels` holds numbers of systems (vascular_system.h). Radii are
// measured on `ct` where it is given (any grid that covers the masks in space), otherwise on
// `vessels`. Returns an empty tree for an empty skeleton. Deterministic; throws Cancelled, and
// InputError where the masks' grids differ.
TreeExtraction extract_tree_and_bridges(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                                        const TreeOptions& options, Job& job);

// The tree alone.
VesselTree extract_tree(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                        const TreeOptions& options, Job& job);

}  // namespace hepatica
