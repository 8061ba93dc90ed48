// SPDX-License-Identifier: GPL-3.0-or-later
// play: plays a session without a window and writes pictures and a report (app/headless_play.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/back_end_choice.h"
#include "app/headless_play.h"
#include "app/html_report.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/accuracy/accuracy.h"
#include "core/base/atomic_write.h"
#include "core/base/quoted_name.h"
#include "core/opening/open_patient.h"
#include "core/patient/patient_case.h"
#include "core/reconstruction/built_in_patient.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct PlayChoices {
    fs::path patient;  // CT, case or tree; empty: the built-in patient
    std::string name;
    fs::path out = "out";
    std::string backend = "cpu";
};

Json facts_of(const VesselTree& tree, const TetMesh& mesh) {
    return {{"segments", tree.segments.size()},
            {"bifurcations", bifurcation_count(tree)},
            {"ends", end_count(tree)},
            {"length_mm", length_mm(tree)},
            {"tetrahedra", mesh.tetrahedra.size()}};
}

Json table_of(const std::vector<StageTime>& stages) {
    Json table = Json::array();
    for (const StageTime& stage : stages)
        table.push_back({{"stage", stage.name}, {"seconds", stage.seconds}});
    return table;
}

OpenRequest request_of(const PlayChoices& options) {
    OpenRequest request{.built_in = options.patient.empty(), .reconstruct = {}};
    request.reconstruct.ct = options.patient;
    request.reconstruct.name = options.name;
    return request;
}

// The case that a play leaves in its folder; empty where a case is played.
fs::path case_of(const PlayChoices& options) {
    if (options.patient.empty()) return options.out / "built_in_patient.hep";
    return is_case(options.patient) ? fs::path() : options.out / "patient.hep";
}

// Stages: opening, the truth where known, building, playing, injecting.
int stage_count_of(const OpenRequest& request) {
    constexpr int truth = 3, building_playing_injecting = 3;
    return opening_stage_count(request) + (request.built_in ? truth : 0) +
           building_playing_injecting;
}

// Files and folders are not named, because their names may contain the patient's and reports are
// passed on.
std::string title_of(const PlayChoices& options, const PatientCase& patient) {
    if (!options.name.empty()) return options.name;
    if (options.patient.empty()) return "the built-in patient";
    return patient.source.name.empty() ? "a patient" : patient.source.name;
}

Json accuracy_of_built_in(const PatientCase& patient, Job& job) {
    const Phantom truth = built_in_truth(job);
    const Accuracy found =
        compare(patient.tree, patient.mask, truth.tree, truth.vessels, AccuracyOptions{}, job);
    Json accuracy = {{"dice", found.dice},
                     {"cldice", found.cldice},
                     {"centreline_mean_mm", found.centreline_mean_mm},
                     {"bifurcation_recall", found.bifurcation_recall},
                     {"bifurcation_precision", found.bifurcation_precision}};
    if (found.radius_mae_mm) accuracy["radius_mae_mm"] = *found.radius_mae_mm;
    return accuracy;
}

// `accuracy` is null unless the truth is known.
void write_report(const fs::path& file, const std::string& title, const OpenedPatient& opened,
                  const Json& accuracy, const HeadlessPlay& played) {
    HtmlReport report("Hepatica: a session on " + title);
    report.add_paragraph(
        "A session played without a window. The pictures are what the window would have shown.");
    for (const std::string& warning : opened.warnings) report.add_paragraph(without_names(warning));
    for (const AlbumPicture& picture : played.pictures)
        report.add_picture(picture.file, picture.caption);
    report.add_heading("The tree and its body");
    report.add_table(facts_of(opened.patient->tree, opened.patient->mesh));
    if (!accuracy.is_null()) {
        report.add_heading("Against the known truth");
        report.add_table(accuracy);
    }
    if (!opened.stages.empty()) {
        report.add_heading("Time of each stage");
        report.add_table(table_of(opened.stages));
    }
    report.add_heading("Pulling");
    report.add_table(played.simulation);
    report.add_heading("Injecting");
    report.add_table(played.injection);
    report.write(file);
}

Json run_play(const PlayChoices& options, Job& job) {
    require_utf8("--name", options.name);
    const fs::path report = options.out / "report.html";
    require_writable_folder(options.out);
    const fs::path made = case_of(options);
    if (!made.empty()) require_replaceable_case(made);
    const BackEndChoice back_end = choose_back_end(options.backend);
    const OpenRequest request = request_of(options);
    job.expect_stages(stage_count_of(request));
    const OpenedPatient opened = open_patient(request, job);
    for (const std::string& warning : opened.warnings) spdlog::warn("{}", warning);
    if (request.built_in || opened.worth_saving) write_case(made, *opened.patient);
    const Json accuracy = request.built_in ? accuracy_of_built_in(*opened.patient, job) : Json();
    HeadlessPlay played;
    write_files_atomically(options.out, [&](const fs::path& folder) {
        played = play_headless(opened.patient, folder, job, back_end.back_end);
        write_report(folder / report.filename(), title_of(options, *opened.patient), opened,
                     accuracy, played);
    });
    Json files = Json::array();
    for (const AlbumPicture& picture : played.pictures)
        files.push_back((options.out / picture.file).string());
    return {{"report", report.string()},
            {"pictures", files},
            {"tree", facts_of(opened.patient->tree, opened.patient->mesh)},
            {"accuracy", accuracy},
            {"simulation", played.simulation},
            {"gpu", facts_of(back_end)},
            {"injection", played.injection},
            {"warnings", opened.warnings}};
}

}  // namespace

void add_play(CommandLine& line) {
    auto options = std::make_shared<PlayChoices>();
    CLI::App& verb = line.add_verb("play", "Play a session without a window: pictures and a report",
                                   [options](Job& job) { return run_play(*options, job); });
    verb.add_option("--name", options->name, "What the report calls the patient");
    verb.add_option("patient", options->patient, "CT, case or tree; none: the built-in patient");
    verb.add_option("--out", options->out,
                    "Folder for pictures and report.html, which appear together at the end")
        ->capture_default_str();
    verb.add_option("--backend", options->backend, "Where the solver runs")
        ->check(CLI::IsMember(back_end_names()))
        ->capture_default_str();
}

}  // namespace hepatica
