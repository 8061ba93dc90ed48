// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <limits>

#include "app/output_place.h"
#include "app/verbs/reconstruction_json.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/text_file.h"
#include "core/patient/corrections.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct Options {
    fs::path patient;
    fs::path edits;
    fs::path out;
    double accept = std::numeric_limits<double>::infinity();
    int undo = 0;
    bool list = false;
};

std::vector<TreeEdit> edits_in(const fs::path& file) {
    return edits_from_json(read_text_file(file, "Give a file of edits (docs/corrections.md)"),
                           file.string());
}

// What the case's edits become: some of the last taken back, then the file's, then bridges.
PatientCase corrected(const Options& options, PatientCase patient, Job& job) {
    std::vector<TreeEdit> edits = patient.corrections.edits;
    if (options.undo > static_cast<int>(edits.size()))
        throw UsageError(std::to_string(options.undo) + " edits cannot be taken back", "--undo",
                         "The case holds " + std::to_string(edits.size()));
    edits.resize(edits.size() - static_cast<std::size_t>(options.undo));
    if (!options.edits.empty()) {
        const std::vector<TreeEdit> more = edits_in(options.edits);
        edits.insert(edits.end(), more.begin(), more.end());
    }
    if (options.accept <= 1.0) {
        const std::vector<TreeEdit> links =
            acceptances(with_edited_tree(patient, edits), options.accept);
        edits.insert(edits.end(), links.begin(), links.end());
    }
    return with_edits(patient, edits, job);
}

Json run(const Options& options, Job& job) {
    if (!options.out.empty()) {
        require_case_name(options.out);
        require_writable(options.out);
        require_own_or_new(options.out, "case.json");
    }
    job.expect_stages(options.list ? 1 : 5);
    job.begin_stage("Reading the case");
    PatientCase patient = read_case(options.patient);
    const std::size_t before = patient.corrections.edits.size();
    if (!options.list) {
        patient = corrected(options, std::move(patient), job);
        job.begin_stage("Writing the case");
        write_case(options.out.empty() ? options.patient : options.out, patient);
    }
    Json answer;
    answer["case"] = (options.out.empty() ? options.patient : options.out).string();
    answer["edits_before"] = before;
    answer["edits"] = Json::parse(edits_to_json(patient.corrections.edits));
    answer["tree"] = to_json(patient.tree);
    answer["mesh"] = to_json(patient.mesh);
    answer["open_bridges"] = to_json(open_bridges(patient));
    return answer;
}

}  // namespace

void add_edit(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb =
        line.add_verb("edit", "Correct a case's tree: links, cuts, branches, roots, systems",
                      [options](Job& job) { return run(*options, job); });
    verb.add_option("case", options->patient, "Case to correct")->required();
    verb.add_option("--edits", options->edits, "JSON array of edits, made after those it holds");
    verb.add_option("--undo", options->undo, "Take back so many of the last edits first")
        ->check(CLI::NonNegativeNumber);
    verb.add_option("--accept-bridges", options->accept,
                    "Build the bridges that are offered with this confidence or more")
        ->check(CLI::Range(0.0, 1.0));
    verb.add_option("--out", options->out,
                    "Write another case, NAME.hep, instead of changing this one");
    verb.add_flag("--list", options->list, "Change nothing: print edits and open bridges");
}

}  // namespace hepatica
