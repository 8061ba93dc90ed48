// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of a patient's vessels as a table, for planning.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/tree/territories/couinaud_branches.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct BranchRow {
    int branch = 0;  // index of the segment in the tree
    VascularSystem system = VascularSystem::unknown;
    double system_confidence = 0.0;
    int generation = 1;  // branches from the root to here; a root is 1
    int strahler_order = 1;
    double length_mm = 0.0;
    double radius_mm = 0.0;  // mean over the length
    int couinaud = 0;  // segment of the liver that it supplies, 1 to 8; 0: several, or unknown
    double couinaud_confidence = 0.0;
    std::optional<double> flow_share;  // of the blood of its tree
    Vec3 middle_mm = Vec3::Zero();     // halfway along it
};

// One row per segment, in the tree's order. `labels` and `flow_shares` (flow_shares.h) are empty or
// have one entry per segment.
std::vector<BranchRow> branch_rows(const VesselTree& tree, std::span<const BranchLabel> labels,
                                   std::span<const double> flow_shares);

// With a header line, decimal points and comma-separated fields; unknown values are empty. Branches
// are numbered from 1.
std::string branch_table_csv(std::span<const BranchRow> rows);

}  // namespace hepatica
