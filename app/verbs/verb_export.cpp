// SPDX-License-Identifier: GPL-3.0-or-later
// export: writes a case's vessels and organs as a DICOM segmentation of its CT
// (core/opening/case_segmentation.h).
#include <filesystem>
#include <memory>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/image/segmentation_writer.h"
#include "core/opening/case_segmentation.h"

namespace hepatica {

namespace {

struct ExportChoices {
    std::filesystem::path patient;
    std::filesystem::path ct;
    std::filesystem::path out;
};

Json run_export(const ExportChoices& options, Job& job) {
    require_writable(options.out);
    require_segmentation_place(options.out);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    const PatientCase patient = read_case(options.patient);
    write_case_segmentation(patient, options.ct, options.out, HEPATICA_VERSION, job);
    return {{"segmentation", options.out.string()}};
}

}  // namespace

void add_export(CommandLine& line) {
    const auto options = std::make_shared<ExportChoices>();
    CLI::App& verb = line.add_verb(
        "export", "Write a case's vessels and organs as a DICOM segmentation of its CT",
        [options](Job& job) { return run_export(*options, job); });
    verb.add_option("CASE", options->patient, "Case to export")->required();
    verb.add_option("--ct", options->ct,
                    "DICOM folder of the CT that the case was made of; the file that is written "
                    "names the patient as that CT does")
        ->required();
    verb.add_option("--out", options->out, "File to write, such as vessels.dcm")->required();
}

}  // namespace hepatica
