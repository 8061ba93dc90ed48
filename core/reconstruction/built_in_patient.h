// SPDX-License-Identifier: GPL-3.0-or-later
// The synthetic patient that comes with the program. It is reconstructed like any other: its CT and
// liver mask are written as files and read from there. Its truth is known.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

// Number of stages that reconstruct_built_in() begins.
int built_in_stage_count();

// The parameters of its reconstruction as one JSON object. The phantom is that of PhantomOptions{}.
std::string built_in_parameters();

// Writes ct.nii.gz and liver.nii.gz into `folder`, which must exist, and reconstructs the patient
// from them. Throws InputError where the folder cannot be written; Cancelled.
Reconstruction reconstruct_built_in(const std::filesystem::path& folder, Job& job);

// Generates the phantom, always with the same bytes. Begins three stages; throws Cancelled.
Phantom built_in_truth(Job& job);

}  // namespace hepatica
