// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the CT and the voxels of an open case. A case keeps a digest of its CT, never its path: the
// CT is read from a place that the user names, or generated again for the built-in patient, and
// accepted only if its digest is that of the case.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/patient/patient_case.h"

namespace hepatica {

// The CT that `patient` was reconstructed from. `place` is a path for read_volume(); in a folder
// with several series each is tried. Where `place` is empty the built-in patient's CT is generated
// and compared. A case without a digest of its CT (a tree that was opened alone) accepts any CT.
// Throws InputError where the CT is another one, or cannot be found or read; Cancelled. Holds one
// volume at a time.
Volume image_of(const PatientCase& patient, const std::filesystem::path& place, Job& job);

// The same with the number of the series in `place`, as read_volume() takes it; 0: the first
// choice.
struct FoundImage {
    Volume volume;
    int series = 0;
};
FoundImage found_image_of(const PatientCase& patient, const std::filesystem::path& place, Job& job);

// The system number of each voxel: the patient's own mask, or that of the case in `folder` where
// the patient was read without voxels; empty where there is none. Throws InputError as read_case()
// does.
Mask system_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// The labels of organs (organ_label), likewise.
Mask organ_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// The organs on which tumours are painted, likewise: without the strokes of a brush and with room
// around them (tumour_canvas()).
Mask canvas_voxels(const PatientCase& patient, const std::filesystem::path& folder);

// The labels of Couinaud's segments for the patient's present tree, likewise. `corrected` says that
// this tree differs from that of the case in `folder`; the labels are then computed anew from the
// organs of that case, in one stage. Throws Cancelled, too.
Mask segment_voxels(const PatientCase& patient, const std::filesystem::path& folder, bool corrected,
                    Job& job);

// The patient with its voxels, as they were when it was read or, where it kept none of them, read
// from the case in `folder`, with tumours as the strokes among `edits` leave them and with
// Couinaud's segments for the present tree. The edits of the tree among `edits` must be those that
// the patient has already. Throws InputError as read_case() does; Cancelled.
PatientCase whole_case(const PatientCase& patient, const std::filesystem::path& folder,
                       const std::vector<TreeEdit>& edits, Job& job);

}  // namespace hepatica
