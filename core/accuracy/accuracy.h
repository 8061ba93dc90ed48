// SPDX-License-Identifier: GPL-3.0-or-later
// Scores of a reconstruction against a known truth: overlap of the masks, distance between
// centrelines, error of the radii, bifurcations found. clDice after Shit et al. (CVPR 2021).
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct AccuracyOptions {
    // In mm. A bifurcation counts where its narrowest branch has at least bifurcation_radius_mm;
    // negative: 1.5 voxels (cube root of the truth mask's voxel volume). length_found counts true
    // centrelines with at least length_radius_mm.
    double bifurcation_radius_mm = -1.0;
    double length_radius_mm = 0.0;
    double length_tolerance_mm = 2.0;  // the truth counts as found within this distance
};

// Distances are in mm, the rest are shares in [0, 1]. For an empty tree the mean and the 95th
// percentile are NaN, length_found and bifurcation_precision are 0. Without bifurcations to judge,
// recall or precision is 1.
struct Accuracy {
    double voxel_mm = 0.0;  // cube root of the truth mask's voxel volume

    double dice = 0.0;    // of all vessels, on the truth's grid
    double cldice = 0.0;  // harmonic mean of the shares of each mask's skeleton inside the other

    // From points half a voxel apart on the tree's centrelines to the truth's: mean and 95th
    // percentile.
    double centreline_mean_mm = 0.0;
    double centreline_p95_mm = 0.0;
    // Medians: from the tree's points to the truth's centrelines, and from the truth's points to
    // the tree's. None for an empty tree.
    std::optional<double> centreline_median_mm;
    std::optional<double> truth_median_mm;
    // Share of the truth's centreline length, where its radius is at least length_radius_mm, that
    // has the tree's centreline within length_tolerance_mm.
    double length_found = 0.0;

    // Radius of the tree minus that of the truth at the nearest point: mean (bias) and mean of the
    // absolute value, over the points of the tree that lie inside the true lumen or within a voxel
    // of the true centreline. None where there is no such point.
    std::optional<double> radius_bias_mm;
    std::optional<double> radius_mae_mm;

    // Bifurcations are matched one to one, nearest pairs first, within the larger of three voxels
    // and the true radius there. A node of degree d counts as d - 2 bifurcations. Recall: share of
    // the truth's wide bifurcations that match any of the tree's. Precision: share of the tree's
    // wide ones that match any of the truth's.
    double bifurcation_recall = 0.0;
    double bifurcation_precision = 0.0;
    int truth_bifurcations = 0;  // wide ones
    int tree_bifurcations = 0;

    int components = 0;        // of the tree
    int truth_components = 0;  // of the truth's tree
};

// Dice coefficient of the nonzero voxels on the truth's grid; 1 where both masks are empty. The
// masks may lie on different grids in one frame; beyond its grid a mask is background. Throws
// Cancelled.
double dice_of(const Mask& mask, const Mask& truth, Job& job);

// Compares a tree and its mask with the truth. The masks may lie on different grids in one frame.
// Reports progress in the present stage. Throws InputError where the true tree or mask is empty, or
// `mask` has no grid, as in cases without voxels; Cancelled.
Accuracy compare(const VesselTree& tree, const Mask& mask, const VesselTree& truth_tree,
                 const Mask& truth_mask, const AccuracyOptions& options, Job& job);

}  // namespace hepatica
