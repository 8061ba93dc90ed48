// SPDX-License-Identifier: GPL-3.0-or-later
// From whatever a person opens (a case, a CT, a tree, the built-in patient) to a patient in memory.
// One cancellable job.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume_reader.h"
#include "core/opening/built_in_cache.h"
#include "core/patient/patient_case.h"
#include "core/patient/pending_stroke.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

// Corrections that a program left without having saved them, see ui/edit_journal.h.
struct LeftEdits {
    std::vector<TreeEdit> edits;         // all that are wanted, in place of those of the case
    std::vector<PendingStroke> strokes;  // at his vessels, that waited for a remaking
    std::uint64_t extracted = 0;         // hash_of_extracted() of whom they were made on
    std::filesystem::path file{};        // where they are kept
};

struct OpenRequest {
    bool built_in = false;           // the synthetic patient; `reconstruct` is not read
    ReconstructOptions reconstruct;  // `ct` is the path: case folder, DICOM folder, volume, or tree
    BuiltInCache cache{};            // keeps the built-in patient from one start to the next
    // `ct` is a copy of what was not saved: it is read whole, and lies nowhere yet.
    bool unsaved_copy = false;
    // To be made once he is open: open_patient() only looks whether he is the one they belong to.
    std::optional<LeftEdits> left_edits{};
    ImageRead image_read{};  // of a CT that is reconstructed; empty: nobody waits for it
};

// What the built-in patient is called.
inline constexpr const char* built_in_title = "Built-in patient";

// The same with every path absolute, so that it means the same from every working folder.
OpenRequest with_absolute_paths(OpenRequest request);

struct OpenedPatient {
    std::string title;
    std::shared_ptr<const PatientCase> patient;
    std::filesystem::path folder;  // the case on disk, which holds the voxels too; empty: none yet
    std::filesystem::path image;   // the CT it was reconstructed from just now; else empty
    // The case that was read, wherever it lies; empty: none was.
    std::filesystem::path read_from{};
    // Of what was not saved, with which it was opened: a case, or a file of edits; else empty.
    std::filesystem::path kept_copy{};
    // Its reconstruction was somebody's CT and took its time: worth a question before it is left.
    bool worth_saving = false;
    std::vector<std::string> warnings;
    // Those of them that other vessels change nothing of: of the image, see Reconstruction.
    std::vector<std::string> warnings_of_image{};
    std::vector<StageTime> stages;  // of the job that reconstructed it just now; else empty
};

// The CT series among which a person may choose, the best first: of a folder that holds several,
// and where the request names none of them; else none. Reads the headers of the folder's files in a
// stage of its own. What cannot be read is left for open_patient() to say. Throws Cancelled. Any
// thread.
std::vector<SeriesDescription> series_to_choose_from(const OpenRequest& request, Job& job);

// A quick look whether there is something that could be opened: files and folders that are there
// and may be read, headers, series. Throws InputError as open_patient() would; Cancelled. What only
// shows when all of it is read is left for open_patient(). Any thread.
void look_at(const OpenRequest& request, Job& job);

// How many stages of its job open_patient() begins; more where it finds its cache damaged.
int opening_stage_count(const OpenRequest& request);

// Throws InputError for whatever cannot be opened (with file, value and remedy), Cancelled. Any
// thread.
OpenedPatient open_patient(const OpenRequest& request, Job& job);

}  // namespace hepatica
