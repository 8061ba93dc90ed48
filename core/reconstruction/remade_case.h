// SPDX-License-Identifier: GPL-3.0-or-later
// A case made anew from other voxels of its vessels: painted in the slices, or drawn in another
// program.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// A voxel's number in place of a system's: it was painted by hand.
inline constexpr std::uint8_t painted_voxel = 254;

struct RemadeCase {
    PatientCase patient;
    std::vector<std::string> warnings;  // for the user: doubts, and edits that are made no more
};

// `vessels`: 0 background, else the number of a system, of an unknown one, or painted_voxel, on any
// grid in the frame of `ct`, from which `patient` (with his organs) was reconstructed. Everything
// after the segmentation is made as his parameters say: systems are told apart anew, with the
// portal trunk where it came in before, unless they were drawn by hand. His edits are made again
// one by one; one that cannot be made on the vessels as they are now is left out, and a warning
// says which and why. What was painted is kept in the tree as if a seed lay in it; where it makes
// no centreline a warning says so. Begins remade_stages stages. Throws InputError where no vessel
// is left that makes a tree, Cancelled.
RemadeCase remade(const PatientCase& patient, Mask vessels, const Volume& ct, Job& job);
inline constexpr int remade_stages = 6;

}  // namespace hepatica
