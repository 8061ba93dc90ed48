// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a case, a CT, a vessel tree or the built-in patient, and returns it as a patient in memory,
// as one cancellable job.
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

// Unsaved corrections and measurements that an earlier run of the program left behind
// (ui/edit_journal.h).
struct LeftEdits {
    std::vector<TreeEdit> edits;         // the whole list; replaces that of the case
    std::vector<PendingStroke> strokes;  // on the vessels' voxels, not yet applied by a rebuild
    std::uint64_t extracted = 0;         // hash_of_extracted() of the patient they belong to
    std::filesystem::path file{};        // the file that holds them
    // The whole list; replaces that of the case. nullopt: those of the case hold.
    std::optional<std::vector<KeptMeasurement>> measured{};
    // digest_of_case() of the case that they were made on, as it was then; empty: not known.
    std::string digest{};
};

struct OpenRequest {
    bool built_in = false;           // the synthetic patient; `reconstruct` is ignored
    ReconstructOptions reconstruct;  // `ct` is the path: case folder, DICOM folder, volume, or tree
    BuiltInCache cache{};            // keeps the built-in patient between starts
    // `ct` is a case that holds unsaved work: it is read with its voxels, and has no place on disk
    // yet.
    bool unsaved_copy = false;
    // To be applied by the caller. open_patient() only checks that they belong to this patient.
    std::optional<LeftEdits> left_edits{};
    ImageRead image_read{};  // called once a CT is read that is to be reconstructed; may be empty
    std::string lost{};      // what of unsaved work is lost, as a warning; empty: nothing
};

// Title of the built-in patient.
inline constexpr const char* built_in_title = "Built-in patient";

// The request with all of its paths made absolute, so that they do not depend on the working
// folder. Empty ones stay empty.
OpenRequest with_absolute_paths(OpenRequest request);

struct OpenedPatient {
    std::string title;
    std::shared_ptr<const PatientCase> patient;
    std::filesystem::path folder;  // the case on disk, which also holds the voxels; empty: none
    std::filesystem::path image;   // the CT of a reconstruction made just now; else empty
    // Of the built-in patient: his case in the cache, for what is measured of him; else empty.
    std::filesystem::path cached_case{};
    // The case that was read; empty: none.
    std::filesystem::path read_from{};
    // The unsaved work it was opened with: a case, or a file of edits; else empty.
    std::filesystem::path kept_copy{};
    // The patient was reconstructed from a CT or holds unsaved work: ask before it is closed.
    bool worth_saving = false;
    std::vector<std::string> warnings;
    // Those of them that concern the image, which other vessels do not change; see Reconstruction.
    std::vector<std::string> warnings_of_image{};
    std::vector<StageTime> stages;  // of a reconstruction made just now; else empty
};

// The CT series to choose from, best first, where the request names a folder with several of them
// and none is chosen; else empty. Reads the headers of the folder's files in one stage. Errors are
// left for open_patient() to report. Throws Cancelled. Thread-safe.
std::vector<SeriesDescription> series_to_choose_from(const OpenRequest& request, Job& job);

// Title of a patient made of one of several series in a folder, `number` in the list of
// list_series() from 1: the folder's name (scan_name.h) and those of the folders below by which it
// parts from the others, or else the number. Made of names of folders alone, never of what DICOM
// tags say. A folder of one series gives its own name.
std::string title_of_series(const std::filesystem::path& folder,
                            const std::vector<SeriesDescription>& series, int number);

// Checks quickly whether the request could be opened: that the file or folder exists and can be
// read, and its headers or series. Throws InputError as open_patient() would, and Cancelled.
// Problems that show only in the whole data are left for open_patient(). Thread-safe.
void look_at(const OpenRequest& request, Job& job);

// Number of stages that open_patient() begins; it begins more where its cache is damaged.
int opening_stage_count(const OpenRequest& request);

// Opens the patient. Throws InputError, with file, value and remedy, where that is not possible;
// Cancelled. Thread-safe.
OpenedPatient open_patient(const OpenRequest& request, Job& job);

}  // namespace hepatica
