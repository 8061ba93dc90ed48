// SPDX-License-Identifier: GPL-3.0-or-later
// Compares digests to find a case's CT, and reads the voxels that a patient was opened without.
#include "core/opening/patient_image.h"

#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/quoted_name.h"
#include "core/image/volume_reader.h"
#include "core/patient/image_digest.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/reconstruction/built_in_patient.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// The voxels of the case on disk, which must be the same patient.
PatientCase voxels_of(const PatientCase& patient, const fs::path& folder) {
    PatientCase voxels;
    voxels.source = patient.source;
    add_voxels(folder, voxels);
    return voxels;
}

bool is_image_of(const PatientCase& patient, const Volume& ct, Job& job) {
    const std::string& wanted = patient.source.image_sha256;
    if (wanted.empty()) return true;
    // The stage is that of reading it, which has reported all of itself.
    return in_part(job, 1.0, 1.0, [&] { return digest_of(ct, job); }) == wanted;
}

// None where the series is not the patient's, or cannot be read, as one that lacks slices.
std::optional<Volume> image_in_series(const PatientCase& patient, const fs::path& place, int series,
                                      Job& job) {
    try {
        Volume ct = read_volume(place, job, nullptr, series);
        if (is_image_of(patient, ct, job)) return ct;
    } catch (const InputError&) {
    }
    return std::nullopt;
}

// None where the patient is not the built-in one.
std::optional<Volume> built_in_image(const PatientCase& patient, Job& job) {
    const PhantomOptions made;
    const Grid& grid = patient.source.image_grid;
    // A file keeps its spacing in single precision.
    if (grid.dims != made.dims || !grid.spacing_mm.isApprox(made.spacing_mm, 1e-6))
        return std::nullopt;
    Volume ct = built_in_truth(job).ct;
    if (!is_image_of(patient, ct, job)) return std::nullopt;
    return ct;
}

void require_ct_there(const fs::path& place) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) return;
    const fs::path name = place.has_filename() ? place : place.parent_path();
    throw InputError("the CT " + quoted_name(name.filename().string()) + " is not there any more",
                     place.string(),
                     "choose the folder or file where it lies now, or connect its disk");
}

}  // namespace

Volume image_of(const PatientCase& patient, const fs::path& place, Job& job) {
    return std::move(found_image_of(patient, place, job).volume);
}

FoundImage found_image_of(const PatientCase& patient, const fs::path& place, Job& job) {
    if (place.empty()) {
        if (std::optional<Volume> ct = built_in_image(patient, job)) return {std::move(*ct), 0};
        throw InputError("it is not known where this patient's CT lies", patient.source.name,
                         "choose its folder or file");
    }
    require_ct_there(place);
    std::optional<InputError> unread;  // what is wrong with the first series
    try {
        Volume first = read_volume(place, job);
        if (is_image_of(patient, first, job)) return {std::move(first), 0};
    } catch (const InputError& error) {
        unread = error;
    }
    std::error_code ignored;
    const std::size_t series =
        fs::is_directory(place, ignored) ? list_series(place, job).size() : 0;
    for (std::size_t i = 2; i <= series; ++i) {
        std::optional<Volume> next = image_in_series(patient, place, static_cast<int>(i), job);
        if (next) return {*std::move(next), static_cast<int>(i)};
    }
    if (unread) throw *unread;
    throw InputError("this is not the CT that the patient was reconstructed from", place.string(),
                     "choose the one that was opened when the case was made; its files may have "
                     "other names, but the voxels must be the same");
}

Mask system_voxels(const PatientCase& patient, const fs::path& folder) {
    if (!patient.mask.voxels.empty() || folder.empty()) return patient.mask;
    return std::move(voxels_of(patient, folder).mask);
}

Mask organ_voxels(const PatientCase& patient, const fs::path& folder) {
    if (!patient.organs.voxels.empty() || folder.empty()) return patient.organs;
    return std::move(voxels_of(patient, folder).organs);
}

Mask canvas_voxels(const PatientCase& patient, const fs::path& folder) {
    const bool has_voxels = !patient.mask.voxels.empty() || !patient.organs.voxels.empty();
    return tumour_canvas(has_voxels || folder.empty() ? patient : voxels_of(patient, folder));
}

Mask segment_voxels(const PatientCase& patient, const fs::path& folder, bool corrected, Job& job) {
    // A patient with organs in memory already has the segments of its tree, if there are any.
    if (!patient.couinaud.voxels.empty() || !patient.organs.voxels.empty() || folder.empty())
        return patient.couinaud;
    PatientCase voxels = voxels_of(patient, folder);
    if (!corrected) return std::move(voxels.couinaud);
    job.begin_stage("Parting the liver into segments");
    voxels.tree = patient.tree;
    label_segments(voxels, job);
    return std::move(voxels.couinaud);
}

PatientCase whole_case(const PatientCase& patient, const fs::path& folder,
                       const std::vector<TreeEdit>& edits, Job& job) {
    PatientCase whole = patient;
    const bool reads = !folder.empty() && whole.mask.voxels.empty();
    if (reads) whole.kept_voxels ? add_kept_voxels(whole) : add_voxels(folder, whole);
    if (!reads && edits == patient.corrections.edits) return whole;
    set_tumour_strokes(whole, edits);  // the case on disk may have others
    label_segments(whole, job);
    return whole;
}

}  // namespace hepatica
