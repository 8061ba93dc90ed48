// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a case anew after its vessels' voxels changed: painted in the slices, or drawn in another
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
    std::vector<std::string> warnings;  // for the user: doubts, and edits that could not be
                                        // repeated
};

// Repeats every step after the segmentation with the parameters of `patient`. `vessels` holds 0,
// numbers of systems, or painted_voxel, on any grid in the frame of `ct`, from which `patient`
// (with its organs) was reconstructed. Systems are told apart anew, with the portal trunk where it
// entered before, unless they were given. The patient's edits are applied again one by one; an edit
// that is not possible on the new vessels is left out, and a warning says which and why. Gaps that
// were refused are not offered again. What was painted is kept in the tree as if a seed lay in it;
// where it makes no centreline a warning says so. Begins remade_stages stages. Throws InputError
// where no vessel is left that makes a tree; Cancelled.
RemadeCase remade(const PatientCase& patient, Mask vessels, const Volume& ct, Job& job);
inline constexpr int remade_stages = 6;

}  // namespace hepatica
