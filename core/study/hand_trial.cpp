// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/hand_trial.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/command.h"
#include "core/session/session.h"
#include "core/study/motion_file.h"

namespace hepatica {
namespace {

constexpr double exact_energy_tolerance = 1e-8;
constexpr int enough_iterations = 10000;

// Makes the steppers of a session, and knows how much of the body the present one computes.
class WatchedBackEnd {
  public:
    explicit WatchedBackEnd(PlayedRegion region) : region_(region) {}
    WatchedBackEnd(const WatchedBackEnd&) = delete;
    WatchedBackEnd& operator=(const WatchedBackEnd&) = delete;

    // Must not be used longer than this object lives.
    DeformBackEnd back_end() {
        return {"cpu", [this](const BodyDescription& body, const StepperOptions& options,
                              const LiveRegionOptions& region) {
                    std::unique_ptr<Stepper> made =
                        region_ == PlayedRegion::whole_body
                            ? make_cpu_stepper(body, options)
                            : cpu_back_end().make(body, options, region);
                    elements_ = static_cast<int>(body.mesh.tetrahedra.size());
                    live_ = dynamic_cast<const LiveStepper*>(made.get());
                    return made;
                }};
    }

    int elements() const { return elements_; }
    int live_elements() const {
        return live_ != nullptr ? live_->extent().live_elements : elements_;
    }

  private:
    PlayedRegion region_;
    int elements_ = 0;
    const LiveStepper* live_ = nullptr;  // owned by the session
};

const std::vector<Vec3>& centreline_of(const DeformPart& deform) {
    return deform.body().skeleton.positions_mm;
}

HandFrame frame_of(const SessionStep& step, const FrameStatistics& statistics) {
    HandFrame frame;
    frame.newton_iterations = step.deform.newton_iterations;
    frame.linear_solves = step.deform.linear_solves;
    frame.linear_iterations = step.deform.linear_iterations;
    frame.asleep = step.deform.asleep;
    frame.degraded = step.deform.degraded || statistics.diverged;
    frame.message = statistics.message;
    return frame;
}

}  // namespace

HandTrial::HandTrial(std::shared_ptr<const PatientCase> patient, SceneSpec scene)
    : patient_(std::move(patient)), scene_(std::move(scene)), probes_({}, {}) {
    if (!scene_.deform)
        throw InputError("has no body that deforms", "the scene", "Name its deform part");
    const DeformPart deform(*patient_, *scene_.deform);
    setting_ = deform.setting();
    probes_ = CentrelineProbes(centreline_of(deform), deform.body().mesh);
    rest_mm_ = probes_.places_mm(deform.rest_positions_mm());
}

HandPlay HandTrial::play(const SceneSpec& scene, const HandMotion& motion, PlayedRegion region,
                         Job& job) const {
    WatchedBackEnd watched(region);
    Job building;  // its stages are none of the caller's
    Session session(patient_, scene, building, watched.back_end());
    HandPlay played;
    played.elements = watched.elements();
    for (int i = 0; i < motion.steps_before; ++i) {
        job.throw_if_cancelled();
        session.step();
    }
    const auto commands = schedule(motion.script, patient_->tree, scene.dt_s, motion.steps);
    for (const std::vector<Command>& now : commands) {
        const FrameTimer timer;
        for (const Command& command : now) session.post(command);
        const SessionStep step = session.step();
        const FrameTime time = timer.passed();
        session.update_frame();
        HandFrame frame = frame_of(step, session.frame().statistics);
        frame.time = time;
        frame.live_elements = watched.live_elements();
        played.frames.push_back(std::move(frame));
        const auto places = probes_.places_mm(session.world().deform()->positions_mm());
        for (std::size_t p = 0; p < places.size(); ++p)
            played.motion.push_back(places[p] - rest_mm_[p]);
        job.advance(static_cast<double>(played.frames.size()) /
                    static_cast<double>(commands.size()));
    }
    return played;
}

HandPlay HandTrial::play(const HandMotion& motion, PlayedRegion region, Job& job) const {
    return play(scene_, motion, region, job);
}

SceneSpec HandTrial::reference_scene(int substeps) const {
    StepperOptions exact;
    exact.model = setting_.model;
    exact.order = setting_.order;
    exact.linear = {.energy_tolerance = exact_energy_tolerance,
                    .max_iterations = enough_iterations};
    exact.substeps = substeps;
    SceneSpec scene = scene_;
    scene.deform->setting = exact;
    return scene;
}

CentrelineMotion HandTrial::reference(const HandMotion& motion, int substeps, Job& job) const {
    HandMotion from_rest = motion;
    from_rest.steps_before = 0;
    return play(reference_scene(substeps), from_rest, PlayedRegion::whole_body, job).motion;
}

CentrelineMotion HandTrial::kept_reference(const HandMotion& motion, int substeps,
                                           const std::filesystem::path& folder, Job& job) const {
    const SceneSpec scene = reference_scene(substeps);
    Hasher hasher;
    const std::uint64_t patient = hash_of(*patient_);
    hasher.add_bytes(&patient, sizeof patient);
    const std::string words = to_json(scene).dump();
    hasher.add_bytes(words.data(), words.size());
    for (const auto& now : schedule(motion.script, patient_->tree, scene.dt_s, motion.steps))
        for (const Command& command : now) {
            const std::string text = to_json(command).dump() + "\n";
            hasher.add_bytes(text.data(), text.size());
        }
    const std::size_t vectors = static_cast<std::size_t>(motion.steps) * rest_mm_.size();
    const auto file = folder / ("reference_" + motion.name + "_" + to_hex(hasher.value()) + ".bin");
    if (auto kept = read_motion(file, vectors)) return *std::move(kept);
    CentrelineMotion made = reference(motion, substeps, job);
    write_motion(file, made);
    return made;
}

}  // namespace hepatica
