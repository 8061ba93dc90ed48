// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/verbs/verbs.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_part.h"
#include "core/study/tradeoff.h"

namespace hepatica {

namespace {

struct Options {
    std::filesystem::path patient;
    std::filesystem::path out;
    bool quick = false;
};

Json json_of(const TradeoffPoint& point) {
    Json json{{"element", point.element},
              {"elements", point.elements},
              {"solver", std::string(name_of(point.options.solver))},
              {"energy_tolerance", point.options.linear.energy_tolerance},
              {"max_iterations", point.options.linear.max_iterations},
              {"newton_iterations", point.options.newton_iterations},
              {"dt_s", point.dt_s},
              {"iterations", point.iterations},
              {"step_ms", point.step_ms},
              {"frame_ms", point.frame_ms},
              {"error_relative", point.error_relative}};
    if (std::isfinite(point.motion_error_relative))
        json["motion_error_relative"] = point.motion_error_relative;
    if (point.on_front) json["quality"] = point.quality;
    return json;
}

Tradeoff measure(const Options& options, Job& job) {
    if (options.patient.empty()) return measure_beam_tradeoff(options.quick, job);
    const DeformPart part(read_case_without_voxels(options.patient),
                          DeformSpec{.fixed = FixedEnds::all});
    return measure_body_tradeoff(part.body(), job);
}

}  // namespace

void add_tradeoff(CommandLine& line) {
    const auto options = std::make_shared<Options>();
    CLI::App& verb = line.add_verb(
        "tradeoff",
        "Error against cost over the dial, on a beam whose answer is known or on a patient",
        [options](Job& job) {
            const Tradeoff tradeoff = measure(*options, job);
            write_tradeoff(tradeoff, options->out);
            Json points = Json::array(), front = Json::array();
            for (const TradeoffPoint& point : tradeoff.points) {
                Json json = json_of(point);
                json["reference"] = tradeoff.reference;
                if (point.on_front) front.push_back(json);
                points.push_back(std::move(json));
            }
            return Json{{"reference", tradeoff.reference},
                        {"reference_tip_mm", tradeoff.reference_tip_mm},
                        {"timoshenko_tip_mm", tradeoff.timoshenko_tip_mm},
                        {"csv", (options->out / "tradeoff.csv").string()},
                        {"plot", (options->out / "tradeoff.svg").string()},
                        {"points", points},
                        {"pareto", front}};
        });
    verb.add_option("CASE", options->patient, "A patient's case; without it the clamped beam");
    verb.add_option("--out", options->out, "Folder for tradeoff.csv and tradeoff.svg")->required();
    verb.add_flag("--quick", options->quick, "Leave out the large meshes");
}

}  // namespace hepatica
