// SPDX-License-Identifier: GPL-3.0-or-later
// copy: copies a case between the forms NAME.hep and NAME.hepz.
#include <filesystem>
#include <memory>

#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace {

struct CopyChoices {
    std::filesystem::path patient;
    std::filesystem::path out;
    bool replace = false;
};

Json run_copy(const CopyChoices& options, Job& job) {
    require_case_place(options.out);
    job.expect_stages(2);
    job.begin_stage("Reading the case");
    const PatientCase patient = read_case(options.patient);
    require_same_patient_at(options.out, patient, options.replace);
    job.begin_stage("Writing the case");
    write_case_in_job(options.out, patient, job);
    return {{"case", options.out.string()}};
}

}  // namespace

void add_copy(CommandLine& line) {
    const auto options = std::make_shared<CopyChoices>();
    CLI::App& verb =
        line.add_verb("copy", "Copy a case: as a folder NAME.hep, or in one file NAME.hepz",
                      [options](Job& job) { return run_copy(*options, job); });
    verb.add_option("CASE", options->patient, "Case to copy")->required();
    verb.add_option("--out", options->out,
                    "Case to make: NAME.hep, a folder, or NAME.hepz, one file")
        ->required();
    verb.add_flag("--replace", options->replace, replace_help);
}

}  // namespace hepatica
