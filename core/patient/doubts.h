// SPDX-License-Identifier: GPL-3.0-or-later
// How certain a reconstruction is: contrast, noise, vessels that may belong to the other system,
// loops. Kept with the case and reported in sentences for an instructor, with what would help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Of the division of the liver into Couinaud's segments (liver_segments.h).
struct SegmentDoubts {
    double unsure_share = 0.0;        // share of the liver nearest to branches less than 80 % sure
    std::vector<int> without_branch;  // segments, 1 to 8, without a branch
    int veins_known = 0;       // number of hepatic veins, 0 to 3, that mark borders of sectors
    bool liver_found = false;  // found by the program; else given as a mask
};

struct Doubts {
    // From the image; both 0 where the vessels were given.
    double contrast_hu = 0.0;
    double noise_hu = 0.0;
    double coarsest_spacing_mm = 0.0;  // of the CT's voxels
    // Shares of the tree's length.
    double uncertain_share = 0.0;  // system confidence under 0.8, unknown systems included
    double unknown_share = 0.0;
    int opened_loops = 0;  // loops of touching branches of one system that were opened
    int loops = 0;         // left in the tree
    std::optional<SegmentDoubts> segments{};  // none where the liver was not divided
};

// The doubts that follow from the tree alone.
Doubts doubts_of(const VesselTree& tree);

// One sentence for each doubt that an instructor should know of, the most important first.
std::vector<std::string> sentences(const Doubts& doubts);

// The same for a patient with this tree, which corrections may have changed since: doubtful roots
// come first, and the tree's own loops replace those of the reconstruction. Without `doubts` of a
// reconstruction, only these two.
std::vector<std::string> sentences(const std::optional<Doubts>& doubts, const VesselTree& tree);

}  // namespace hepatica
