// SPDX-License-Identifier: GPL-3.0-or-later
// Decides by path what a request opens, and opens it.
#include "core/opening/open_patient.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/temporary_folder.h"
#include "core/image/image_look.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/opening/scan_name.h"
#include "core/patient/case_archive.h"
#include "core/patient/case_header.h"
#include "core/patient/corrections.h"
#include "core/reconstruction/built_in_patient.h"
#include "core/tree/files/tree_io.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

void require_there(const fs::path& path) {
    std::error_code failed;
    if (fs::exists(path, failed)) return;
    throw InputError(
        failed ? "cannot be read (" + failed.message() + ")" : "there is no such file or folder",
        path.string(),
        failed ? "Check that it exists and may be read"
               : "check the name, and that its disk is connected");
}

PatientCase patient_of(VesselTree tree, Job& job) {
    PatientCase patient;
    job.begin_stage("Making the mesh");
    patient.mesh = in_part(job, 0.0, 1.0, [&] { return tetrahedralize(tree, MeshOptions{}, job); });
    patient.surface = surface_of(patient.mesh).mesh;
    patient.tree = std::move(tree);
    return patient;
}

OpenedPatient opened_from(Reconstruction made) {
    OpenedPatient opened;
    opened.patient = std::make_shared<const PatientCase>(std::move(made.patient));
    opened.warnings = std::move(made.warnings);
    opened.warnings_of_image.assign(
        opened.warnings.begin(),
        opened.warnings.begin() + static_cast<std::ptrdiff_t>(made.warnings_of_image));
    opened.stages = std::move(made.stages);
    return opened;
}

// What its reconstruction warned of, and the doubts about its vessels and links as they are now.
void tell_warnings_of_case(OpenedPatient& opened) {
    const PatientCase& patient = *opened.patient;
    opened.warnings = patient.warnings;
    opened.warnings_of_image.assign(
        patient.warnings.begin(),
        patient.warnings.begin() + static_cast<std::ptrdiff_t>(patient.warnings_of_image));
    for (const auto& doubts : {doubts_of_links(patient), sentences(patient.doubts, patient.tree)})
        opened.warnings.insert(opened.warnings.end(), doubts.begin(), doubts.end());
}

OpenedPatient built_in_patient(const BuiltInCache& cache, Job& job) {
    OpenedPatient opened;
    if (holds_patient(cache)) {
        job.begin_stage("Reading the built-in patient");
        if (std::optional<PatientCase> kept = patient_of(cache)) {
            opened.patient = std::make_shared<const PatientCase>(*std::move(kept));
            opened.cached_case = case_of(cache);
            return opened;
        }
    }
    const TemporaryFolder scan;
    Reconstruction made = reconstruct_built_in(scan.path(), job);
    // The warnings ask for a better scan or for seeds, which does not apply to a synthetic patient.
    made.warnings.clear();
    made.patient.warnings.clear();
    made.warnings_of_image = made.patient.warnings_of_image = 0;
    opened = opened_from(std::move(made));
    keep(cache, *opened.patient);
    opened.cached_case = case_of(cache);
    return opened;
}

OpenedPatient reconstructed(const ReconstructOptions& options, Job& job,
                            const ImageRead& image_read) {
    OpenedPatient opened = opened_from(reconstruct(options, job, image_read));
    opened.image = options.ct;
    opened.worth_saving = true;
    return opened;
}

bool is_tree_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return false;  // of DICOM images, whatever its name
    const std::string extension = extension_of(path);
    return extension == ".vtp" || extension == ".swc" || extension == ".json";
}

// The last part of a path, which may end in a slash.
std::string name_of(const fs::path& path) {
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

bool is_folder_of_images(const fs::path& path) {
    std::error_code ignored;
    return !is_case(path) && fs::is_directory(path, ignored);
}

// One of the series in a folder was chosen by its number.
bool names_series(const OpenRequest& request) {
    return !request.built_in && request.reconstruct.series != 0 &&
           is_folder_of_images(request.reconstruct.ct);
}

std::string title_of(const OpenRequest& request, Job& job) {
    if (request.built_in) return built_in_title;
    const fs::path& path = request.reconstruct.ct;
    if (!names_series(request))
        return is_folder_of_images(path) ? name_of_scan(path) : name_of(path);
    return title_of_series(path, list_series(path, job), request.reconstruct.series);
}

void make_absolute(fs::path& path) {
    if (!path.empty()) path = fs::absolute(path).lexically_normal();
}

void require_same(const PatientCase& patient, const LeftEdits& left) {
    if (hash_of_extracted(patient) == left.extracted) return;
    throw InputError("holds another patient by now than the unsaved edits were made on",
                     left.file.string(), "Bring the case back as it was, then open them again");
}

}  // namespace

OpenRequest with_absolute_paths(OpenRequest request) {
    ReconstructOptions& options = request.reconstruct;
    make_absolute(options.ct);
    if (!options.ct.has_filename()) options.ct = options.ct.parent_path();  // "scan/"
    for (auto* file : {&options.liver_mask, &options.vessel_mask, &options.model})
        if (*file) make_absolute(**file);
    for (fs::path& mask : options.tumour_masks) make_absolute(mask);
    make_absolute(request.cache.folder);
    if (request.left_edits) make_absolute(request.left_edits->file);
    return request;
}

std::vector<SeriesDescription> series_to_choose_from(const OpenRequest& request, Job& job) {
    const fs::path& path = request.reconstruct.ct;
    std::error_code ignored;
    if (request.built_in || request.reconstruct.series != 0 || is_case(path) ||
        !fs::is_directory(path, ignored))
        return {};
    std::vector<SeriesDescription> series;
    try {
        series = list_series(path, job);
    } catch (const InputError&) {
        return {};
    }
    std::erase_if(series, [](const SeriesDescription& one) {
        return one.modality != "CT" && !one.modality.empty();
    });
    if (series.size() < 2) series.clear();
    return series;
}

std::string title_of_series(const fs::path& folder, const std::vector<SeriesDescription>& series,
                            int number) {
    const std::string name = name_of_scan(folder);
    const auto count = static_cast<int>(series.size());
    if (count < 2 || number < 1 || number > count) return name;
    const auto parts_of = [&](const SeriesDescription& one) {
        const fs::path place = one.middle_slice.parent_path().lexically_relative(folder);
        std::vector<std::string> parts;
        for (const fs::path& part : place)
            if (part != ".") parts.push_back(part.string());
        return parts;
    };
    const std::vector<std::string> own = parts_of(series[static_cast<std::size_t>(number - 1)]);
    std::ptrdiff_t first = std::ssize(own), last = -1;  // where it parts from others
    for (const SeriesDescription& other : series) {
        const std::ptrdiff_t at = std::ranges::mismatch(own, parts_of(other)).in1 - own.begin();
        if (at == std::ssize(own)) continue;
        first = std::min(first, at);
        last = std::max(last, at);
    }
    std::string apart;
    for (std::ptrdiff_t at = first; at <= last; ++at)
        apart += " " + own[static_cast<std::size_t>(at)];
    return name + (apart.empty() ? " " + std::to_string(number) : apart);
}

void look_at(const OpenRequest& request, Job& job) {
    if (request.built_in) return;
    const fs::path& path = request.reconstruct.ct;
    require_there(path);
    std::error_code ignored;
    if (is_case(path)) {
        if (!is_case_archive(path)) read_case_header(path);
    } else if (fs::is_directory(path, ignored)) {
        list_series(path, job);
    } else if (is_tree_file(path)) {
        read_tree(path);
    } else {
        look_at_image(path);
    }
}

int opening_stage_count(const OpenRequest& request) {
    const fs::path& path = request.reconstruct.ct;
    if (request.built_in) return holds_patient(request.cache) ? 1 : built_in_stage_count();
    if (is_case(path)) return 1;
    if (is_tree_file(path)) return 2;
    return stage_count(request.reconstruct) + (names_series(request) ? 1 : 0);
}

OpenedPatient open_patient(const OpenRequest& request, Job& job) {
    job.expect_stages(opening_stage_count(request));
    const fs::path& path = request.reconstruct.ct;
    OpenedPatient opened;
    if (!request.built_in) require_there(path);
    // First, so that nothing that was reconstructed is lost where it cannot be made.
    const std::string title = title_of(request, job);
    if (request.built_in) {
        opened = built_in_patient(request.cache, job);
    } else if (request.unsaved_copy) {
        job.begin_stage("Reading the case");
        opened.patient = std::make_shared<const PatientCase>(read_case(path));
        opened.kept_copy = path;
        opened.worth_saving = true;
        tell_warnings_of_case(opened);
    } else if (is_case(path)) {
        job.begin_stage("Reading the case");
        opened.patient = std::make_shared<const PatientCase>(read_case_without_voxels(path));
        opened.folder = path;
        tell_warnings_of_case(opened);
    } else if (is_tree_file(path)) {
        job.begin_stage("Reading the tree");
        opened.patient = std::make_shared<const PatientCase>(patient_of(read_tree(path), job));
    } else {
        opened = reconstructed(request.reconstruct, job, request.image_read);
    }
    if (!request.built_in && is_case(path)) opened.read_from = path;
    if (request.left_edits) require_same(*opened.patient, *request.left_edits);
    if (request.left_edits) opened.kept_copy = request.left_edits->file;
    if (!request.lost.empty()) opened.warnings.insert(opened.warnings.begin(), request.lost);
    opened.title = title;
    return opened;
}

}  // namespace hepatica
