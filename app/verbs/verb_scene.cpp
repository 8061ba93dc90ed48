// SPDX-License-Identifier: GPL-3.0-or-later
// scene: the parts that a scene builds, their memory, and their cost per frame.
#include <algorithm>
#include <filesystem>

#include "app/back_end_choice.h"
#include "app/measured_play.h"
#include "app/verbs/verbs.h"
#include "core/patient/patient_case.h"
#include "core/scene/world.h"
#include "core/session/script.h"
#include "core/session/session.h"

namespace hepatica {

namespace {

struct SceneChoices {
    std::filesystem::path file;
    std::string backend = "cpu";
};

// Reads a scene file, which names its case; a case alone means the default scene.
SceneFile scene_of(const std::filesystem::path& file) {
    return is_case(file) ? SceneFile{default_scene(), file} : read_scene(file);
}

// Builds the world to measure its body. Tools and tears are built with the body, so their cost is
// the difference to a body without them; their cost per frame is included in the body's.
PartCost weigh_body(const std::shared_ptr<const PatientCase>& patient, const SceneSpec& spec,
                    const DeformBackEnd& back_end) {
    Job job;
    const World world(patient, spec, job, back_end);
    return *std::ranges::find(world.parts(), "deform", &PartCost::name);
}

Json part_of_body(const char* name, const PartCost& heavy, const PartCost& light) {
    return {{"name", name},
            {"bytes", heavy.bytes > light.bytes ? heavy.bytes - light.bytes : 0},
            {"ms", nullptr},
            {"build_ms", std::max(0.0, heavy.build_ms - light.build_ms)}};
}

// Measures the parts while a branch is pulled and a drug flows, as far as the scene has them.
Json run_scene(const SceneChoices& options, Job& job) {
    const BackEndChoice back_end = choose_back_end(options.backend);
    const SceneFile scene = scene_of(options.file);
    job.expect_stages(3);
    job.begin_stage("Reading the case");
    auto patient = std::make_shared<const PatientCase>(read_case_without_voxels(scene.patient));
    Session session(patient, scene.spec, job, back_end.back_end);
    say_where_obstacles_are_none(session.world());
    job.begin_stage("Weighing the parts");
    const Vec3 held = point_on_longest_path(patient->tree, 0.5);
    if (scene.spec.flow) session.post(InjectDrug{held});
    if (scene.spec.deform) session.post(GrabPoint{held});
    constexpr int steps = 60;
    std::vector<double> frame_ms(session.world().parts().size(), 0.0);
    for (int i = 0; i < steps; ++i) {
        if (scene.spec.deform) session.post(MoveGrab{held + Vec3(0.2 * i, 0, 0)});
        session.step(job);
        for (std::size_t p = 0; p < frame_ms.size(); ++p)
            frame_ms[p] += session.world().parts()[p].frame_ms / steps;
        job.advance(static_cast<double>(i) / steps);
    }
    Json parts = Json::array();
    for (std::size_t p = 0; p < frame_ms.size(); ++p) {
        const PartCost& part = session.world().parts()[p];
        parts.push_back({{"name", part.name},
                         {"bytes", part.bytes},
                         {"ms", frame_ms[p]},
                         {"build_ms", part.build_ms}});
    }
    const bool has_tools = scene.spec.contact && scene.spec.contact->tools;
    if (has_tools || scene.spec.tear) {
        const PartCost all = weigh_body(patient, scene.spec, back_end.back_end);
        const auto add = [&](const char* name, const SceneSpec& without) {
            parts.push_back(
                part_of_body(name, all, weigh_body(patient, without, back_end.back_end)));
        };
        SceneSpec no_tools = scene.spec, no_tear = scene.spec;
        if (has_tools) no_tools.contact->tools = false;
        no_tear.tear.reset();
        if (has_tools) add("tools", no_tools);
        if (scene.spec.tear) add("tear", no_tear);
    }
    return {{"scene", scene.spec.name},
            {"case", scene.patient.string()},
            {"vertices", session.world().vertex_count()},
            {"parts", parts},
            {"obstacles", obstacles_of(session.world())},
            {"gpu", facts_of(back_end)}};
}

}  // namespace

void add_scene(CommandLine& line) {
    auto options = std::make_shared<SceneChoices>();
    CLI::App& verb = line.add_verb(
        "scene", "The parts that a scene builds, their memory, and their cost per frame",
        [options](Job& job) { return run_scene(*options, job); });
    verb.add_option("file", options->file, "Scene file (JSON) or case")->required();
    verb.add_option("--backend", options->backend, "Where the solver runs")
        ->check(CLI::IsMember(back_end_names()))
        ->capture_default_str();
}

}  // namespace hepatica
