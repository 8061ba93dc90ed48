// SPDX-License-Identifier: GPL-3.0-or-later
// Extracts a vessel tree from a unit-width skeleton: segments between bifurcations and ends, with
// smooth centrelines, sub-voxel radii, parents, Strahler orders and systems.
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
    // Components with a seed are kept, however short they are.
    std::vector<VesselSeed> seeds;
    // Places, such as those of painted vessels: what lies there is kept as by a seed, whatever its
    // system.
    std::vector<Vec3> kept_mm;
    // True: tells the systems apart by anatomy and seeds (tell_systems_apart.h), opens loops and
    // places the roots by anatomy. False: systems come from the mask (system_assignment.h).
    bool find_systems = false;
    const Mask* systems_before = nullptr;  // for find_systems: see SystemSearch::before
    Eigen::AlignedBox3d liver_mm;          // for find_systems; empty: not known
    // For find_systems: where the portal trunk enters, if known.
    std::optional<Vec3> portal_trunk_mm;
    bool shorten_trunk = false;  // let the tree begin shortly before the trunk divides
                                 // (portal_trunk.h)
    // Requested roots; each acts on the component it is nearest to, at its end nearest to the
    // position. A component without one begins at its widest end.
    std::vector<Vec3> roots_mm;
    // An end branch that reaches less than this many radii of its parent, or 1.5 voxels, beyond the
    // parent's wall is a bump of the wall, not a vessel.
    double spur_radii = 0.5;
    // Components shorter than this are removed as noise, except the longest and those with a seed.
    double minimum_piece_mm = 3.0;
    // The same after gaps are bridged.
    double minimum_component_mm = 15.0;
    // Which gaps are bridged, and which are only offered.
    BridgeOptions bridging;
};

struct TreeExtraction {
    VesselTree tree;
    std::vector<Bridge> bridges;          // built and offered ones, best first
    RemovedPieces too_short;              // left out, before and after gaps were bridged
    std::optional<SystemsFound> systems;  // with find_systems only
    int opened_loops = 0;
    RemovedPieces blobs;         // no vessels (blob_removal.h); with find_systems only
    RemovedPieces beside_trunk;  // branches of the portal trunk before it divides (portal_trunk.h)
    std::vector<VesselSeed> trunk_left_out;  // points along the removed part of the trunk and its
                                             // branches
};

// Extracts a tree and its bridges. Both masks share one grid; `vessels` holds numbers of systems
// (vascular_system.h). Radii are measured on `ct` where it is given (any grid that covers the
// masks), else on `vessels`. An empty skeleton gives an empty tree. Deterministic. Throws
// InputError where the grids differ or, with find_systems, the vessels are more than 40 m long;
// Cancelled.
TreeExtraction extract_tree_and_bridges(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                                        const TreeOptions& options, Job& job);

// Throws InputError, of the place "vessels", where vessels are longer together than `most_mm`.
// Noise taken for vessels makes a tangle that later steps cannot handle; the vessels of a liver in
// a CT are about 5 to 20 m long in all.
void require_plausible_length(double all_mm, double most_mm = 40000.0);

// The tree alone.
VesselTree extract_tree(const Mask& skeleton, const Mask& vessels, const Volume* ct,
                        const TreeOptions& options, Job& job);

}  // namespace hepatica
