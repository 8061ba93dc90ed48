// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a motion of the hand on a patient as a session does, and records the cost of every frame
// and the path of the centreline; and the same motion of the whole body in short steps, solved
// exactly, as reference.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/scene_spec.h"
#include "core/session/recording.h"
#include "core/study/hand_motion.h"
#include "core/study/heard_hand.h"
#include "core/study/pull_trial.h"
#include "core/study/timing.h"

namespace hepatica {

class DeformPart;
class Session;

struct HandFrame {
    FrameTime time;                // of commands, the world's step and the frame shown
    double longest_wait_ms = 0.0;  // see SessionStep
    int newton_iterations = 0;
    int linear_solves = 0;
    int linear_iterations = 0;
    int live_elements = 0;  // computed, after the step
    bool asleep = false;    // nothing moved, so the step was skipped
    bool degraded = false;  // as in StepReport, or the session had to stop
    std::string message;    // the frame's message to the user
};

struct HandPlay {
    std::vector<HandFrame> frames;
    CentrelineMotion motion;  // in these frames
    int elements = 0;         // of the whole body
    std::string device;       // that made the last step; empty: the processor
};

enum class PlayedRegion {
    as_in_scenes,  // what the back end computes
    whole_body     // nothing is frozen
};

// Not thread-safe.
class HandTrial {
  public:
    // Builds a session of the scene with steps of 1/60 s and lets it fall asleep. A whole body and
    // the reference are always computed on the processor. Throws InputError where case or scene
    // cannot be played; Cancelled.
    HandTrial(std::shared_ptr<const PatientCase> patient, const SceneSpec& scene,
              PlayedRegion region, Job& job, const DeformBackEnd& back_end = cpu_back_end());
    ~HandTrial();
    HandTrial(const HandTrial&) = delete;
    HandTrial& operator=(const HandTrial&) = delete;

    // The scene's initial setting.
    const StepperOptions& setting() const { return setting_; }

    // How later plays hear the hand; the reference hears it in every frame.
    void hear(const HeardHand& hand) { hand_ = hand; }

    // Plays from rest, asleep. Checks the job after every step; throws Cancelled.
    HandPlay play(const HandMotion& motion, const StepperOptions& setting, Job& job);
    HandPlay play(const HandMotion& motion, Job& job) { return play(motion, setting_, job); }

    // The reference of a setting's error: the same motion on the same mesh and element, all of it
    // computed in `substeps` substeps a frame, each solved to 1e-8 in the energy norm. The mesh's
    // own error is not included. Checks the job after every substep.
    CentrelineMotion reference(const HandMotion& motion, int substeps, Job& job) const;
    // The same, stored in `folder`, which must exist, and read from there the next time. The file's
    // name depends on patient, scene, element and motion; a damaged file is replaced. It does not
    // depend on the program: remove the files when elements or potentials change.
    CentrelineMotion kept_reference(const HandMotion& motion, int substeps,
                                    const std::filesystem::path& folder, Job& job) const;

  private:
    class WatchedBackEnd;

    void let_sleep(Job& job);
    SceneSpec reference_scene(int substeps) const;
    void watch(const DeformPart& deform, CentrelineMotion& motion) const;

    std::shared_ptr<const PatientCase> patient_;
    SceneSpec scene_;
    std::unique_ptr<WatchedBackEnd> watched_;
    std::unique_ptr<Session> session_;
    Keyframe at_rest_;
    StepperOptions setting_;
    HeardHand hand_;
    CentrelineProbes probes_;
    std::vector<Vec3> rest_mm_;  // of the probes
};

}  // namespace hepatica
