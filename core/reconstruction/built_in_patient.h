// SPDX-License-Identifier: GPL-3.0-or-later
// The synthetic patient that comes with the program, on the same way as any other: its CT and liver
// mask are written as files and reconstructed from there. Its truth is known.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/job.h"
#include "core/phantom/phantom.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

// How many stages of its job reconstruct_built_in() begins.
int built_in_stage_count();

// What the reconstruction is asked for, one JSON object; the phantom is that of PhantomOptions{}.
std::string built_in_parameters();

// Writes ct.nii.gz and liver.nii.gz into `folder`, which must exist, and reconstructs them.
// Throws InputError where the folder cannot be written, Cancelled.
Reconstruction reconstruct_built_in(const std::filesystem::path& folder, Job& job);

// What its CT was drawn from: made anew, with the same bytes. Begins three stages; throws
// Cancelled.
Phantom built_in_truth(Job& job);

}  // namespace hepatica
