// SPDX-License-Identifier: GPL-3.0-or-later
// paper: makes the paper's figures and table anew, as a page (app/paper/paper_page.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>

#include "app/output_place.h"
#include "app/paper/paper_page.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/opening/open_patient.h"
#include "cut_line_script.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct PaperChoices {
    fs::path patient;  // empty: the built-in patient
    fs::path out;
    int threads = 2;
};

Json run_paper(const PaperChoices& options, Job& job) {
    require_writable(options.out);
    require_empty_or_new(options.out);
    PaperOptions paper{.title = "the built-in patient",
                       .cut_line = script_of(cut_line_script, "cut_line.json"),
                       .contact = {.threads = options.threads, .to_budget = true}};
    std::shared_ptr<const PatientCase> patient;
    if (options.patient.empty()) {
        const OpenRequest request{.built_in = true, .reconstruct = {}};
        job.expect_stages(opening_stage_count(request) + paper_stage_count);
        patient = open_patient(request, job).patient;
    } else {
        job.expect_stages(1 + paper_stage_count);
        job.begin_stage("Reading the case");
        patient = std::make_shared<const PatientCase>(read_case(options.patient));
        // Files and folders are not named, because their names may contain the patient's.
        paper.title = patient->source.name.empty() ? "a patient" : patient->source.name;
    }
    Json facts;
    // Files of an older page that this one lacks are kept.
    renew_folder_atomically(
        options.out,
        [&](const fs::path& folder) { facts = write_paper(patient, folder, paper, job); },
        [](const fs::path&) { return false; });
    Json answer{{"page", (options.out / "index.html").string()}};
    answer.update(facts);
    return answer;
}

}  // namespace

void add_paper(CommandLine& line) {
    auto options = std::make_shared<PaperChoices>();
    CLI::App& verb = line.add_verb(
        "paper", "Make the paper's figures and table anew, as a page with ours beside its own",
        [options](Job& job) { return run_paper(*options, job); });
    verb.add_option("case", options->patient, "Case to show; none: the built-in patient");
    verb.add_option("--out", options->out, "Folder to make, with index.html and its pictures")
        ->required();
    verb.add_option("--threads", options->threads, "Of the measured contacts")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
}

}  // namespace hepatica
