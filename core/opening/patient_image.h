// SPDX-License-Identifier: GPL-3.0-or-later
// The CT behind a case that is open: a case keeps a digest of it, never a path. It is read from
// where the person says, or made anew for the built-in patient, and taken only if it is the one.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// The CT that `patient` was reconstructed from. `place` is what read_volume() reads, and in a
// folder of several series each is tried; where it is empty the built-in patient's CT is made anew,
// if it is his. Throws InputError where it is another one, saying so, or cannot be found or read;
// Cancelled. A case that does not know its CT (a tree that was opened alone) takes any. Never holds
// two volumes.
Volume image_of(const PatientCase& patient, const std::filesystem::path& place, Job& job);

// The same, and which of the place's series it is: the number by which read_volume() reads it.
struct FoundImage {
    Volume volume;
    int series = 0;
};
FoundImage found_image_of(const PatientCase& patient, const std::filesystem::path& place, Job& job);

// The numbers of systems by voxel: the patient's own, or those of the case in `folder` where he was
// read without them; empty where there are none. Throws InputError as read_case() does.
Mask system_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// Likewise the labels of organs, see organ_label.
Mask organ_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// Likewise what tumours can be painted on: the organs without the strokes of a brush, with room
// about them (tumour_canvas()).
Mask canvas_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// Likewise the labels of Couinaud's segments that belong to his present tree. `corrected`: his tree
// is not that of the case in `folder` any more, so that they are made anew from the organs there.
// Begins one stage where they are; throws Cancelled.
Mask segment_voxels(const PatientCase& patient, const std::filesystem::path& folder, bool corrected,
                    Job& job);

// The patient with his voxels, those of the case in `folder` where he was read without them, with
// the tumours as the strokes among `edits` leave them, and with the segments of the liver that
// belong to his present tree. Of the tree the edits are those that he has. Throws InputError as
// read_case() does, Cancelled.
PatientCase whole_case(const PatientCase& patient, const std::filesystem::path& folder,
                       const std::vector<TreeEdit>& edits, Job& job);

}  // namespace hepatica
