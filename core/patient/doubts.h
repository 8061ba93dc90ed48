// SPDX-License-Identifier: GPL-3.0-or-later
// How sure a reconstruction is of what it shows: contrast, noise, which vessels may belong to the
// other system, loops. Kept with the case and told in words that an instructor understands, with
// what would help.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Of the liver's parting into Couinaud's segments (liver_segments.h).
struct SegmentDoubts {
    double unsure_share = 0.0;        // of the liver: nearest to branches less than 80 % sure
    std::vector<int> without_branch;  // segments 1 to 8 to which no branch was found
    int veins_known = 0;              // 0 to 3 hepatic veins that say where the sectors part
    bool liver_found = false;         // by the program; else its mask was given
};

struct Doubts {
    // What the image says of itself; both 0 where the vessels were given and none was asked.
    double contrast_hu = 0.0;
    double noise_hu = 0.0;
    double coarsest_spacing_mm = 0.0;  // of the CT's voxels
    // Shares of the tree's length.
    double uncertain_share = 0.0;  // confidence of the system under 0.8, unknown ones included
    double unknown_share = 0.0;
    int opened_loops = 0;                     // branches of one system that touched and were parted
    int loops = 0;                            // left in the tree
    std::optional<SegmentDoubts> segments{};  // none where the liver was not parted into segments
};

// The part that the tree itself tells.
Doubts doubts_of(const VesselTree& tree);

// One sentence for each thing that an instructor should know, what matters most first; none where
// there is nothing to doubt.
std::vector<std::string> sentences(const Doubts& doubts);

// The same of a patient with this tree, which corrections may have changed since: its own loops
// instead of those of the reconstruction, and its roots, which stand first. Without doubts of a
// reconstruction these two alone.
std::vector<std::string> sentences(const std::optional<Doubts>& doubts, const VesselTree& tree);

}  // namespace hepatica
