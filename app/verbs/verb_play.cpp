// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/headless_play.h"
#include "app/html_report.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/accuracy/accuracy.h"
#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/patient/patient_case.h"
#include "core/reconstruction/built_in_patient.h"
#include "core/reconstruction/reconstruct.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

struct Options {
    fs::path patient;  // CT or case; empty: the built-in patient
    std::string name;
    fs::path out = "out";
};

// What there is to play with, and what is known of how it was made.
struct Opened {
    PatientCase patient;
    std::string title;
    Json stages = Json::array();
    std::vector<std::string> warnings;
    Json accuracy;  // null unless the truth is known
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

// Of `options`, up to the play and with it.
int play_stages(const Options& options) {
    constexpr int building_playing_injecting = 3;
    if (options.patient.empty()) return built_in_stage_count() + building_playing_injecting;
    if (is_case(options.patient)) return building_playing_injecting;
    return stage_count(ReconstructOptions{}) + building_playing_injecting;
}

Opened reconstructed(const Options& options, Job& job) {
    ReconstructOptions how;
    how.ct = options.patient;
    how.name = options.name;
    Reconstruction made = reconstruct(how, job);
    Opened opened;
    opened.patient = std::move(made.patient);
    opened.stages = table_of(made.stages);
    opened.warnings = std::move(made.warnings);
    write_case(options.out / "patient.hep", opened.patient);
    return opened;
}

Opened built_in(const fs::path& out, Job& job) {
    const fs::path scan = out / "built_in_patient";
    fs::create_directories(scan);
    BuiltInPatient made = reconstruct_built_in(scan, job);
    Opened opened;
    opened.title = "the built-in patient";
    opened.patient = std::move(made.reconstruction.patient);
    opened.stages = table_of(made.reconstruction.stages);
    write_case(out / "built_in_patient.hep", opened.patient);
    const Accuracy found = compare(opened.patient.tree, opened.patient.mask, made.truth.tree,
                                   made.truth.vessels, AccuracyOptions{}, job);
    opened.accuracy = {{"dice", found.dice},
                       {"cldice", found.cldice},
                       {"centreline_mean_mm", found.centreline_mean_mm},
                       {"bifurcation_recall", found.bifurcation_recall},
                       {"bifurcation_precision", found.bifurcation_precision}};
    if (found.radius_mae_mm) opened.accuracy["radius_mae_mm"] = *found.radius_mae_mm;
    return opened;
}

Opened open(const Options& options, Job& job) {
    if (options.patient.empty()) return built_in(options.out, job);
    Opened opened;
    if (is_case(options.patient)) {
        opened.patient = read_case_without_voxels(options.patient);
    } else {
        opened = reconstructed(options, job);
    }
    // No file or folder is named: it may be called after the patient, and a report is passed on.
    const std::string& kept = opened.patient.source.name;
    opened.title = !options.name.empty() ? options.name : !kept.empty() ? kept : "a patient";
    return opened;
}

void write_report(const fs::path& file, const Opened& opened, const HeadlessPlay& played) {
    HtmlReport report("Hepatica: a session on " + opened.title);
    report.add_paragraph(
        "A session played without a window. The pictures are what the window would have shown.");
    for (const std::string& warning : opened.warnings) report.add_paragraph(warning);
    for (const PlayedPicture& picture : played.pictures)
        report.add_picture(picture.file, picture.caption);
    report.add_heading("The tree and its body");
    report.add_table(facts_of(opened.patient.tree, opened.patient.mesh));
    if (!opened.accuracy.is_null()) {
        report.add_heading("Against the known truth");
        report.add_table(opened.accuracy);
    }
    if (!opened.stages.empty()) {
        report.add_heading("Time of each stage");
        report.add_table(opened.stages);
    }
    report.add_heading("Pulling");
    report.add_table(played.simulation);
    report.add_heading("Injecting");
    report.add_table(played.injection);
    report.write(file);
}

Json run(const Options& options, Job& job) {
    const fs::path report = options.out / "report.html";
    require_writable_folder(options.out);
    if (!options.patient.empty() && !fs::exists(options.patient))
        throw InputError("does not exist", options.patient.string(), "Check the path");
    fs::create_directories(options.out);
    job.expect_stages(play_stages(options));
    Opened opened = open(options, job);
    for (const std::string& warning : opened.warnings) spdlog::warn("{}", warning);
    const Json tree = facts_of(opened.patient.tree, opened.patient.mesh);
    const auto patient = std::make_shared<const PatientCase>(opened.patient);
    HeadlessPlay played;
    write_files_atomically(options.out, [&](const fs::path& folder) {
        played = play_headless(patient, folder, job);
        write_report(folder / report.filename(), opened, played);
    });
    Json files = Json::array();
    for (const PlayedPicture& picture : played.pictures)
        files.push_back((options.out / picture.file).string());
    return {{"report", report.string()},
            {"pictures", files},
            {"tree", tree},
            {"accuracy", opened.accuracy},
            {"simulation", played.simulation},
            {"injection", played.injection},
            {"warnings", opened.warnings}};
}

}  // namespace

void add_play(CommandLine& line) {
    auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb("play", "Play a session without a window: pictures and a report",
                                   [options](Job& job) { return run(*options, job); });
    verb.add_option("--name", options->name, "What the report calls the patient");
    verb.add_option("patient", options->patient, "CT or case; none: the built-in patient");
    verb.add_option("--out", options->out,
                    "Folder for pictures and report.html, which appear together at the end")
        ->capture_default_str();
}

}  // namespace hepatica
