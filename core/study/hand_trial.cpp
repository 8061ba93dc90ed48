// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/hand_trial.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/base/hash.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/scene/world_checkpoint.h"
#include "core/session/command.h"
#include "core/session/session.h"
#include "core/study/job_within.h"
#include "core/study/motion_file.h"

namespace hepatica {

namespace {

constexpr int most_frames_to_fall_asleep = 120;
constexpr double exact_energy_tolerance = 1e-8;
constexpr int enough_iterations = 10000;

SceneSpec validated(SceneSpec scene) {
    if (!scene.deform)
        throw InputError("has no body that deforms", "the scene", "Name its deform part");
    scene.dt_s = frame_s;
    return scene;
}

DeformBackEnd whole_body_back_end() {
    return {"cpu", [](const BodyDescription& body, const StepperOptions& options,
                      const LiveRegionOptions&) { return make_cpu_stepper(body, options); }};
}

HandFrame frame_of(const SessionStep& step, const FrameStatistics& statistics) {
    HandFrame frame;
    frame.longest_wait_ms = step.longest_wait_ms;
    frame.newton_iterations = step.deform.newton_iterations;
    frame.linear_solves = step.deform.linear_solves;
    frame.linear_iterations = step.deform.linear_iterations;
    frame.asleep = step.deform.asleep;
    frame.degraded = step.deform.degraded || statistics.diverged;
    frame.message = statistics.message;
    return frame;
}

}  // namespace

// Makes the steppers of a session, and knows how much of the body the present one computes.
class HandTrial::WatchedBackEnd {
  public:
    WatchedBackEnd(PlayedRegion region, const DeformBackEnd& back_end)
        : maker_(region == PlayedRegion::whole_body ? whole_body_back_end() : back_end) {}
    WatchedBackEnd(const WatchedBackEnd&) = delete;
    WatchedBackEnd& operator=(const WatchedBackEnd&) = delete;

    // Must not outlive this object.
    DeformBackEnd back_end() {
        DeformBackEnd watched = maker_;
        watched.make = [this](const BodyDescription& body, const StepperOptions& options,
                              const LiveRegionOptions& region) {
            std::unique_ptr<Stepper> made = maker_.make(body, options, region);
            elements_ = static_cast<int>(body.mesh.tetrahedra.size());
            live_ = dynamic_cast<const LiveStepper*>(made.get());
            return made;
        };
        return watched;
    }

    int elements() const { return elements_; }
    int live_elements() const {
        return live_ != nullptr ? live_->extent().live_elements : elements_;
    }

  private:
    DeformBackEnd maker_;
    int elements_ = 0;
    const LiveStepper* live_ = nullptr;  // owned by the session
};

HandTrial::HandTrial(std::shared_ptr<const PatientCase> patient, const SceneSpec& scene,
                     PlayedRegion region, Job& job, const DeformBackEnd& back_end)
    : patient_(std::move(patient)),
      scene_(validated(scene)),
      watched_(std::make_unique<WatchedBackEnd>(region, back_end)),
      probes_({}, {}) {
    JobWithin building(job);
    session_ = std::make_unique<Session>(patient_, scene_, building.job(), watched_->back_end());
    const DeformPart& deform = *session_->world().deform();
    setting_ = deform.setting();
    probes_ = CentrelineProbes(deform.body().skeleton.positions_mm, deform.body().mesh);
    rest_mm_ = probes_.places_mm(deform.rest_positions_mm());
    let_sleep(job);
    at_rest_.world = session_->world().checkpoint();
}

HandTrial::~HandTrial() = default;

void HandTrial::let_sleep(Job& job) {
    for (int f = 0; f < most_frames_to_fall_asleep; ++f) {
        job.throw_if_cancelled();
        if (session_->step(job).deform.asleep) break;
    }
}

void HandTrial::watch(const DeformPart& deform, CentrelineMotion& motion) const {
    const std::vector<Vec3> places = probes_.places_mm(deform.positions_mm());
    for (std::size_t p = 0; p < places.size(); ++p) motion.push_back(places[p] - rest_mm_[p]);
}

HandPlay HandTrial::play(const HandMotion& motion, const StepperOptions& setting, Job& job) {
    session_->restore(at_rest_);
    session_->post(UseSetting{setting});
    let_sleep(job);
    HandPlay played;
    played.elements = watched_->elements();
    const auto commands =
        heard(schedule(motion.script, patient_->tree, frame_s, motion.steps), hand_);
    for (const std::vector<Command>& now : commands) {
        const FrameTimer timer;
        for (const Command& command : now) session_->post(command);
        const SessionStep step = session_->step(job);
        const FrameTime time = timer.passed();
        session_->update_frame();
        HandFrame frame = frame_of(step, session_->frame().statistics);
        frame.time = time;
        frame.live_elements = watched_->live_elements();
        played.frames.push_back(std::move(frame));
        watch(*session_->world().deform(), played.motion);
        job.advance(static_cast<double>(played.frames.size()) /
                    static_cast<double>(commands.size()));
    }
    played.device = session_->world().deform()->device();
    return played;
}

// Substeps are steps of the session, so that it can be stopped between two of them.
SceneSpec HandTrial::reference_scene(int substeps) const {
    StepperOptions exact;
    exact.model = setting_.model;
    exact.order = setting_.order;
    exact.swing_substeps = 1;
    exact.linear = {.energy_tolerance = exact_energy_tolerance,
                    .max_iterations = enough_iterations};
    SceneSpec scene = scene_;
    scene.deform->setting = exact;
    scene.dt_s = frame_s / substeps;
    return scene;
}

CentrelineMotion HandTrial::reference(const HandMotion& motion, int substeps, Job& job) const {
    JobWithin building(job);
    Session session(patient_, reference_scene(substeps), building.job(), whole_body_back_end());
    CentrelineMotion moved;
    const auto commands = schedule(motion.script, patient_->tree, frame_s, motion.steps);
    for (std::size_t f = 0; f < commands.size(); ++f) {
        for (const Command& command : commands[f]) session.post(command);
        for (int part = 0; part < substeps; ++part) {
            job.advance((static_cast<double>(f) + static_cast<double>(part) / substeps) /
                        static_cast<double>(commands.size()));
            session.step(job);
        }
        watch(*session.world().deform(), moved);
    }
    return moved;
}

CentrelineMotion HandTrial::kept_reference(const HandMotion& motion, int substeps,
                                           const std::filesystem::path& folder, Job& job) const {
    const SceneSpec scene = reference_scene(substeps);
    Hasher hasher;
    const std::uint64_t patient = hash_of(*patient_);
    hasher.add_bytes(&patient, sizeof patient);
    const std::string words = to_json(scene).dump();
    hasher.add_bytes(words.data(), words.size());
    for (const auto& now : schedule(motion.script, patient_->tree, frame_s, motion.steps))
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
