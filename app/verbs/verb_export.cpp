// SPDX-License-Identifier: GPL-3.0-or-later
// export: writes a case's vessels and organs as a DICOM segmentation of its CT, or as the file that
// 3D Slicer opens (core/opening/case_segmentation.h).
#include <filesystem>
#include <memory>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/image/header_text.h"
#include "core/image/segmentation_writer.h"
#include "core/opening/case_segmentation.h"

namespace hepatica {

namespace {

struct ExportChoices {
    std::filesystem::path patient;
    std::filesystem::path ct;
    std::filesystem::path out;
};

// Whether `out` is a file of 3D Slicer. Throws UsageError where its name or the CT does not fit.
bool is_for_slicer(const ExportChoices& options) {
    const std::string name = lower_case(options.out.filename().string());
    const bool for_slicer = name.ends_with(".seg.nrrd");
    if (!for_slicer && name.ends_with(".nrrd"))
        throw UsageError("does not end in .seg.nrrd, by which 3D Slicer knows a segmentation",
                         options.out.string(), "Choose such a name, or one that ends in .dcm");
    // DICOM files are often without an ending.
    const std::string ending = extension_of(options.out);
    if (!for_slicer && !ending.empty() && ending != ".dcm" && ending != ".dicom")
        throw UsageError("a segmentation is not written as a \"" + ending + "\" file",
                         options.out.string(), "Choose a name that ends in .dcm or .seg.nrrd");
    if (for_slicer && !options.ct.empty())
        throw UsageError("is not used for a .seg.nrrd", "--ct", "Leave it out");
    if (!for_slicer && options.ct.empty())
        throw UsageError("is missing, and a DICOM segmentation is one of a CT's slices", "--ct",
                         "Give the CT's DICOM folder, or a file --out NAME.seg.nrrd");
    return for_slicer;
}

Json run_export(const ExportChoices& options, Job& job) {
    const bool for_slicer = is_for_slicer(options);
    if (for_slicer) {
        require_writable_file(options.out, ".nrrd");
    } else {
        require_writable(options.out);
        require_segmentation_place(options.out);
    }
    job.expect_stages(for_slicer ? 2 : 3);
    job.begin_stage("Reading the case");
    const PatientCase patient = read_case(options.patient);
    if (for_slicer)
        write_case_labels(patient, options.out, job);
    else
        write_case_segmentation(patient, options.ct, options.out, HEPATICA_VERSION, job);
    return {{"segmentation", options.out.string()}};
}

}  // namespace

void add_export(CommandLine& line) {
    const auto options = std::make_shared<ExportChoices>();
    CLI::App& verb = line.add_verb(
        "export", "Write a case's vessels and organs as a segmentation, of DICOM or for 3D Slicer",
        [options](Job& job) { return run_export(*options, job); });
    verb.add_option("CASE", options->patient, "Case to export")->required();
    verb.add_option("--ct", options->ct,
                    "DICOM folder of the CT that the case was made of, for a DICOM segmentation, "
                    "which names the patient as that CT does");
    verb.add_option("--out", options->out,
                    "File to write: NAME.dcm, or NAME.seg.nrrd for 3D Slicer, without a CT")
        ->required();
}

}  // namespace hepatica
