// SPDX-License-Identifier: GPL-3.0-or-later
// dial: measures cost and error of the dial's settings on a patient's body and stores them in the
// case (core/study/dial_study.h).
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "app/back_end_choice.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/patient/case_archive.h"
#include "core/patient/patient_case.h"
#include "core/scene/measured_dial.h"
#include "core/scene/setting_json.h"
#include "core/study/dial_study.h"

namespace hepatica {

namespace {

struct DialChoices {
    std::filesystem::path patient;
    double budget_s = 300.0;
    bool anew = false;
    std::string backend = "cpu";
};

Json json_row(const QualityPoint& point) {
    return {{"setting", words_of(point.options)},
            {"back_end", point.back_end},
            {"device", point.device.empty() ? Json(nullptr) : Json(point.device)},
            {"energy_tolerance", point.options.linear.energy_tolerance},
            {"frame_ms", point.frame_ms},
            {"error_relative", point.error_relative}};
}

// Writes the dial to the case after every measurement, so that it always holds the latest.
Json run_dial(const DialChoices& options, Job& job) {
    DeformBackEnd back_end = choose_back_end(options.backend).back_end;
    const std::filesystem::path file =
        is_case_archive(options.patient) ? options.patient : options.patient / "dial.json";
    if (is_case(options.patient)) require_writable(file);  // else reading says what is wrong
    job.expect_stages(2);
    job.begin_stage("Reading the case");
    PatientCase read = read_case_without_voxels(options.patient);
    if (options.anew) read.dial_json.clear();
    const auto patient = std::make_shared<const PatientCase>(std::move(read));
    job.begin_stage("Measuring the settings");
    const FrameTimer timer;
    const auto passed_s = [&] { return 1e-3 * timer.passed().wall_ms; };
    DialStudy study(patient, measured_points(*patient), back_end);
    Json measured = Json::array();
    while (passed_s() < options.budget_s && study.measure_next(job)) {
        write_dial(options.patient, dial_json(study.points(), *patient));
        measured.push_back(json_row(study.points().back()));
        measured.back()["after_s"] = passed_s();
    }
    const bool complete = !next_dial_setting(study.points(), back_end);
    back_end.beside_processor = !back_end.device.empty();
    const QualityDial dial = dial_of_points(points_for(back_end, study.points()));
    if (const std::string words = words_on_left_out(back_end, study.points()); !words.empty())
        spdlog::warn("{}", words);
    Json front = Json::array();
    for (const QualityPoint& point : dial.front()) front.push_back(json_row(point));
    return {{"tetrahedra", patient->mesh.tetrahedra.size()},
            {"reference", dial.front().front().reference},
            {"measured", measured},
            {"front", front},
            {"complete", complete},
            {"dial", file.string()}};
}

}  // namespace

void add_dial(CommandLine& line) {
    auto options = std::make_shared<DialChoices>();
    CLI::App& verb = line.add_verb(
        "dial",
        "Measure what the settings of the dial cost and miss on a patient's own body, and leave "
        "them in the case",
        [options](Job& job) { return run_dial(*options, job); });
    verb.add_option("CASE", options->patient, "Case to measure on")->required();
    verb.add_option("--budget", options->budget_s,
                    "Wall time in seconds, after which no further setting is begun")
        ->check(CLI::Range(1.0, 1e6))
        ->capture_default_str();
    verb.add_flag("--anew", options->anew, "Forget what was measured before");
    verb.add_option("--backend", options->backend,
                    "What is measured: settings on the processor, on a device, or, with auto, both")
        ->check(CLI::IsMember(back_end_names()))
        ->capture_default_str();
}

}  // namespace hepatica
