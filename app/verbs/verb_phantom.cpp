// SPDX-License-Identifier: GPL-3.0-or-later
// phantom: makes a synthetic patient, a CT with its true vessel tree and masks
// (core/phantom/phantom.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/image/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/tree/files/tree_io.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// A patient whose vessels are invisible is no truth for a reconstruction.
constexpr double least_contrast_hu = 1.0;

struct PhantomChoices {
    fs::path out;
    PhantomOptions phantom;
    std::int64_t seed = 1;  // signed, so that negative numbers are detected
    std::string dims;
    std::string spacing;
    std::vector<std::string> formats{"dicom", "nifti"};
};

void parse(PhantomChoices& options) {
    if (options.seed < 0)
        throw InputError(std::to_string(options.seed) + " is no seed", "--seed",
                         "Give a whole number from 0 on");
    options.phantom.seed = static_cast<std::uint64_t>(options.seed);
    if (!(options.phantom.contrast_hu >= least_contrast_hu))
        throw InputError(Json(options.phantom.contrast_hu).dump() + " HU cannot be used",
                         "--contrast-hu",
                         "Choose a value from 1 to 1000: below, no vessel is seen");
    if (!options.dims.empty()) {
        const auto dims = parse_triple("--dims", options.dims);
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double most_checked = 1e9;  // make_phantom() checks the range
            if (dims[axis] != std::trunc(dims[axis]) || std::abs(dims[axis]) > most_checked)
                throw InputError("\"" + options.dims + "\" is no number of voxels", "--dims",
                                 "Choose three whole numbers, from 16 to 2048 each");
            options.phantom.dims[axis] = static_cast<int>(dims[axis]);
        }
    }
    if (!options.spacing.empty()) {
        const auto spacing = parse_triple("--spacing", options.spacing);
        options.phantom.spacing_mm = Vec3(spacing[0], spacing[1], spacing[2]);
    }
    if (options.phantom.hepatic_contrast_hu && options.phantom.systems < 2)
        throw InputError("one system has no hepatic veins", "--hepatic-contrast-hu",
                         "Ask for --systems 2, or leave it out");
    for (const std::string& format : options.formats)
        if (format != "dicom" && format != "nifti")
            throw UsageError("\"" + format + "\" is no format", "--format",
                             "Choose dicom, nifti or both: dicom,nifti");
}

// Whether a file belongs to an earlier phantom, which this one replaces. Other files in the folder
// are kept.
bool is_of_a_phantom(const fs::path& file) {
    constexpr std::array<const char*, 4> names{"ct.nii.gz", "truth_mask.nii.gz", "liver.nii.gz",
                                               "truth_tree.vtp"};
    if (file.parent_path() == "ct") return is_written_slice(file);
    return std::ranges::find(names, file.string()) != names.end();
}

Json make(PhantomChoices options, Job& job) {
    parse(options);
    require_writable(options.out);
    require_own_or_new(options.out, "truth_tree.vtp");
    const auto wanted = [&](const char* format) {
        return std::ranges::find(options.formats, format) != options.formats.end();
    };
    constexpr int growing_to_scanning = 3, writing_the_truth = 1;
    job.expect_stages(growing_to_scanning + (wanted("dicom") ? 1 : 0) + writing_the_truth);
    const Phantom phantom = make_phantom(options.phantom, job);
    Json made = Json::array();
    const auto write = [&](const fs::path& folder) {
        if (wanted("dicom")) {
            write_dicom_series(folder / "ct", phantom.ct, {}, job);
            made.push_back((options.out / "ct").string());
        }
        job.begin_stage("Writing the truth");
        if (wanted("nifti")) {
            write_nifti(folder / "ct.nii.gz", phantom.ct);
            made.push_back((options.out / "ct.nii.gz").string());
        }
        job.advance(0.5);
        write_nifti(folder / "truth_mask.nii.gz", phantom.vessels);
        write_nifti(folder / "liver.nii.gz", phantom.liver);
        write_tree_vtp(folder / "truth_tree.vtp", phantom.tree);
        job.advance(1.0);
    };
    renew_folder_atomically(options.out, write, is_of_a_phantom);
    return {{"ct", made},
            {"truth_tree", (options.out / "truth_tree.vtp").string()},
            {"truth_mask", (options.out / "truth_mask.nii.gz").string()},
            {"liver_mask", (options.out / "liver.nii.gz").string()},
            {"contacts_mm", json_of(phantom.contacts_mm)},
            {"segments", phantom.tree.segments.size()},
            {"length_mm", length_mm(phantom.tree)}};
}

}  // namespace

void add_phantom(CommandLine& line) {
    auto options = std::make_shared<PhantomChoices>();
    CLI::App& verb = line.add_verb(
        "phantom", "Make a synthetic patient: a CT with its true vessel tree and masks",
        [options](Job& job) { return make(*options, job); });
    PhantomOptions& phantom = options->phantom;
    verb.add_option("out", options->out, "Folder to make")->required();
    verb.add_option("--seed", options->seed, "Another seed, another patient; from 0 on")
        ->capture_default_str();
    verb.add_option("--generations", phantom.generations, "2^N ends per vascular system, 1 to 10")
        ->capture_default_str();
    verb.add_option("--systems", phantom.systems, "1: portal vein; 2: and hepatic veins")
        ->capture_default_str();
    verb.add_option("--dims", options->dims, "Voxels along x,y,z, 16 to 2048 each [256,256,160]");
    verb.add_option("--spacing", options->spacing,
                    "Size of a voxel along x,y,z, 0.1 to 10 mm each [0.8,0.8,1]");
    verb.add_option("--noise-hu", phantom.noise_hu,
                    "Standard deviation of the noise, 0 to 500 [HU]")
        ->capture_default_str();
    verb.add_option("--contrast-hu", phantom.contrast_hu,
                    "Vessels above parenchyma, 1 to 1000 [HU]")
        ->capture_default_str();
    verb.add_option(
        "--hepatic-contrast-hu", phantom.hepatic_contrast_hu,
        "Hepatic veins above parenchyma, 0 to 1000; else 0.85 of the portal vein's [HU]");
    verb.add_option("--touch", phantom.touching,
                    "Places at which the two systems touch, 0 to 20; needs --systems 2")
        ->capture_default_str();
    verb.add_option("--format", options->formats, "dicom, nifti or both")
        ->delimiter(',')
        ->capture_default_str();
}

}  // namespace hepatica
