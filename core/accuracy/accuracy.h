// SPDX-License-Identifier: GPL-3.0-or-later
// How good a reconstruction is, judged by a truth: overlap of the masks, distance of the
// centrelines, error of the radii, bifurcations found. clDice after Shit et al. (CVPR 2021).
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct AccuracyOptions {
    // Bifurcations count whose narrowest branch is at least this wide, and truth centrelines for
    // length_found; in mm. Negative: 1.5 voxels (cube root of the voxel's volume) of the truth mask
    // for bifurcations, 0 for length_found.
    double bifurcation_radius_mm = -1.0;
    double length_radius_mm = 0.0;
    double length_tolerance_mm = 2.0;  // truth counts as found within this distance
};

// Distances in mm, the rest are shares in [0, 1]. What cannot be judged (no bifurcation in the
// truth, an empty tree) is 1 where nothing was missed and 0 where something was.
struct Accuracy {
    double voxel_mm = 0.0;  // cube root of the truth mask's voxel volume

    double dice = 0.0;    // of the masks, on the truth's grid
    double cldice = 0.0;  // harmonic mean of the shares of each mask's skeleton inside the other

    // From points spaced evenly on the tree's centrelines to the truth's: mean and 95th percentile.
    double centreline_mean_mm = 0.0;
    double centreline_p95_mm = 0.0;
    // Half of the tree's points lie within the first distance of the truth's centrelines, half of
    // the truth's within the second of the tree's. None for an empty tree.
    std::optional<double> centreline_median_mm;
    std::optional<double> truth_median_mm;
    // Share of the truth's centreline length (of radii from length_radius_mm) that has the tree's
    // centreline within length_tolerance_mm.
    double length_found = 0.0;

    // Radius of the tree minus that of the truth at the nearest point, over the points of the tree
    // that lie inside the true lumen: mean (bias) and mean of the absolute value. None where no
    // point does.
    std::optional<double> radius_bias_mm;
    std::optional<double> radius_mae_mm;

    // One to one, nearest pairs first, within the larger of three voxels and the true radius there.
    // A node of degree d counts as d - 2 bifurcations. Recall: wide bifurcations of the truth
    // matched by any of the tree; precision: wide ones of the tree matched by any of the truth.
    double bifurcation_recall = 0.0;
    double bifurcation_precision = 0.0;
    int truth_bifurcations = 0;  // wide ones
    int tree_bifurcations = 0;

    int components = 0;        // of the tree
    int truth_components = 0;  // of the truth's tree
};

// The masks may lie on different grids; each is looked up in the other by position. Throws
// InputError where the truth is empty, Cancelled.
Accuracy compare(const VesselTree& tree, const Mask& mask, const VesselTree& truth_tree,
                 const Mask& truth_mask, const AccuracyOptions& options, Job& job);

}  // namespace hepatica
