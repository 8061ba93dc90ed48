// SPDX-License-Identifier: GPL-3.0-or-later
// tradeoff: error against cost of the solver's settings, on a beam with a known answer or on a
// patient (core/study/tradeoff.h).
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "app/back_end_choice.h"
#include "app/output_place.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/mesh/tetrahedralize.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_part.h"
#include "core/study/contact_tradeoff.h"
#include "core/study/tear_tradeoff.h"
#include "core/study/tradeoff.h"

namespace hepatica {

namespace {

struct TradeoffChoices {
    std::filesystem::path patient;
    std::filesystem::path out;
    bool contact = false;
    bool tear = false;
    std::string backend = "cpu";
    TradeoffOptions measure;
};

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_row(const TradeoffPoint& point) {
    Json json{{"element", point.element},
              {"elements", point.elements},
              {"region", point.region},
              {"back_end", point.back_end},
              {"device", point.device.empty() ? Json(nullptr) : Json(point.device)},
              {"solver", std::string(name_of(point.options.solver))},
              {"energy_tolerance", point.options.linear.energy_tolerance},
              {"max_iterations", point.options.linear.max_iterations},
              {"newton_iterations", point.options.newton_iterations},
              {"dt_s", point.dt_s},
              {"iterations", number(point.iterations)},
              {"step_ms", number(point.step_ms)},
              {"frame_ms", number(point.frame_ms)},
              {"error_relative", number(point.error_relative)},
              {"rest_error_relative", number(point.rest_error_relative)}};
    if (point.on_front) json["quality"] = point.quality;
    if (!point.not_measured.empty()) json["not_measured"] = point.not_measured;
    return json;
}

// The patient's body in tissue, as scenes have it, on the case's mesh and on one with half as many
// tetrahedra again. (The case's mesh is as coarse as the mesher makes them.)
std::vector<BodyDescription> bodies_of(PatientCase patient, Job& job) {
    std::vector<BodyDescription> bodies{DeformPart(patient, {}).body()};
    job.begin_stage("Making a finer mesh");
    MeshOptions finer;
    finer.target_tetrahedra = static_cast<int>(3 * patient.mesh.tetrahedra.size() / 2);
    patient.mesh = tetrahedralize(patient.tree, finer, job);
    bodies.push_back(DeformPart(patient, {}).body());
    return bodies;
}

Tradeoff measure(const TradeoffChoices& options, Job& job) {
    if (options.patient.empty()) {
        job.expect_stages(2);
        return measure_beam_tradeoff(options.measure, job);
    }
    job.expect_stages(5);
    job.begin_stage("Reading the case");
    const PatientCase patient = read_case_without_voxels(options.patient);
    TradeoffOptions how = options.measure;
    how.region = DeformPart::region;
    if (DeformBackEnd back_end = choose_back_end(options.backend).back_end;
        !back_end.device.empty())
        how.device = std::move(back_end);
    return measure_body_tradeoff(bodies_of(patient, job), how, job);
}

// Cost beside that of a scene's setting, which is the first of the points.
template <class Points>
double cost_ratio(const Points& points, const TradeoffPoint& point) {
    return point.frame_ms / points.front().point.frame_ms;
}

Json run_contact_tradeoff(const TradeoffChoices& options, Job& job) {
    if (!options.patient.empty() || options.measure.quick)
        throw UsageError("measures two blocks", "--contact", "Leave CASE and --quick out");
    job.expect_stages(2);
    const ContactTradeoff tradeoff = measure_contact_tradeoff({}, job);
    write_tradeoff(as_tradeoff(tradeoff), options.out);
    Json points = Json::array();
    for (const ContactPoint& point : tradeoff.points) {
        Json json{
            {"name", point.name}, {"pad_edges", point.pad_edges}, {"friction", point.friction}};
        json.update(json_row(point.point));
        json["cost_ratio"] = number(cost_ratio(tradeoff.points, point.point));
        points.push_back(std::move(json));
    }
    return {{"reference", tradeoff.reference},
            {"csv", (options.out / "tradeoff.csv").string()},
            {"plot", (options.out / "tradeoff.svg").string()},
            {"points", points}};
}

Json run_tear_tradeoff(const TradeoffChoices& options, Job& job) {
    if (!options.patient.empty() || options.measure.quick)
        throw UsageError("measures a bar", "--tear", "Leave CASE and --quick out");
    job.expect_stages(2);
    const TearTradeoff tradeoff = measure_tear_tradeoff({}, job);
    write_tradeoff(as_tradeoff(tradeoff), options.out, "error of the force over the pull");
    Json points = Json::array();
    for (const TearPoint& point : tradeoff.points) {
        Json json{{"name", point.name},
                  {"edge_mm", point.edge_mm},
                  {"force_max_un", number(point.force_max_un)},
                  {"force_error_relative", number(point.force_error)},
                  {"work_nj", number(point.work_nj)},
                  {"work_error_relative", number(point.work_error)},
                  {"opened_mm2", point.opened_mm2},
                  {"pieces", point.pieces}};
        json.update(json_row(point.point));
        json["cost_ratio"] = number(cost_ratio(tradeoff.points, point.point));
        points.push_back(std::move(json));
    }
    return {{"reference", tradeoff.reference},
            {"reference_force_max_un", tradeoff.reference_force_max_un},
            {"reference_work_nj", tradeoff.reference_work_nj},
            {"csv", (options.out / "tradeoff.csv").string()},
            {"plot", (options.out / "tradeoff.svg").string()},
            {"points", points}};
}

Json run_tradeoff(const TradeoffChoices& options, Job& job) {
    require_writable_folder(options.out);
    if (options.backend != "cpu" && options.patient.empty())
        throw UsageError("measures on a patient's body alone", "--backend",
                         "Give a CASE, or leave --backend out");
    if (options.contact) return run_contact_tradeoff(options, job);
    if (options.tear) return run_tear_tradeoff(options, job);
    const Tradeoff tradeoff = measure(options, job);
    write_tradeoff(tradeoff, options.out);
    Json points = Json::array(), front = Json::array(), left_out = Json::array();
    for (const TradeoffPoint& point : tradeoff.points) {
        Json json = json_row(point);
        json["reference"] = tradeoff.reference;
        if (point.on_front) front.push_back(json);
        (point.not_measured.empty() ? points : left_out).push_back(std::move(json));
    }
    Json answer{{"reference", tradeoff.reference}};
    if (!tradeoff.rest_reference.empty()) {
        answer["rest_reference"] = tradeoff.rest_reference;
        answer["reference_tip_mm"] = tradeoff.reference_tip_mm;
        answer["timoshenko_tip_mm"] = tradeoff.timoshenko_tip_mm;
    }
    answer["seconds"] = tradeoff.seconds;
    answer["csv"] = (options.out / "tradeoff.csv").string();
    answer["plot"] = (options.out / "tradeoff.svg").string();
    answer["points"] = points;
    answer["pareto"] = front;
    answer["not_measured"] = left_out;
    return answer;
}

}  // namespace

void add_tradeoff(CommandLine& line) {
    const auto options = std::make_shared<TradeoffChoices>();
    CLI::App& verb = line.add_verb(
        "tradeoff",
        "Error against cost over the dial, on a beam whose answer is known or on a patient",
        [options](Job& job) { return run_tradeoff(*options, job); });
    CLI::Option* patient =
        verb.add_option("CASE", options->patient, "A patient's case; without it the clamped beam");
    verb.add_option("--out", options->out, "Folder for tradeoff.csv and tradeoff.svg")->required();
    CLI::Option* budget =
        verb.add_option("--budget", options->measure.budget_s,
                        "Wall time in seconds; settings that do not fit are listed as not measured")
            ->check(CLI::Range(1.0, 1e6))
            ->capture_default_str();
    CLI::Option* contact =
        verb.add_flag("--contact", options->contact,
                      "Of what contact adds: pad, solve, step and friction of a block on a slab")
            ->excludes(budget);
    verb.add_flag("--tear", options->tear,
                  "Of a scene that tears: force and work to tear a notched bar, over settings and "
                  "meshes")
        ->excludes(contact)
        ->excludes(budget);
    verb.add_option("--backend", options->backend,
                    "On whose device a patient's settings are measured beside the processor")
        ->check(CLI::IsMember(back_end_names()))
        ->capture_default_str();
    verb.add_flag("--quick", options->measure.quick, "Of the beam: leave out the large meshes")
        ->excludes(patient);
}

}  // namespace hepatica
