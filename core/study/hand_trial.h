// SPDX-License-Identifier: GPL-3.0-or-later
// A motion of the hand played on a patient as a session plays it: what every frame costs and where
// the centreline goes; and the same motion of the whole body in short steps, solved exactly, which
// that is compared with.
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
    FrameTime time;  // of the commands, the world's step and the frame that is shown
    int newton_iterations = 0;
    int linear_solves = 0;
    int linear_iterations = 0;
    int live_elements = 0;  // computed after the step
    bool asleep = false;    // nothing moved: the step was skipped
    bool degraded = false;  // as in StepReport, or the session had to stop
    std::string message;    // what the frame tells the user
};

struct HandPlay {
    std::vector<HandFrame> frames;
    CentrelineMotion motion;  // in them
    int elements = 0;         // of the whole body
    std::string device;       // that made its last step; empty: the processor did
};

enum class PlayedRegion {
    as_in_scenes,  // what the back end computes
    whole_body     // nothing is frozen
};

// Not thread-safe.
class HandTrial {
  public:
    // Builds a session of the scene (at 1/60 s a step) and lets it fall asleep. Throws InputError
    // where case or scene cannot be played with; Cancelled. A whole body and the reference are the
    // processor's.
    HandTrial(std::shared_ptr<const PatientCase> patient, const SceneSpec& scene,
              PlayedRegion region, Job& job, const DeformBackEnd& back_end = cpu_back_end());
    ~HandTrial();
    HandTrial(const HandTrial&) = delete;
    HandTrial& operator=(const HandTrial&) = delete;

    // The setting that the scene begins with.
    const StepperOptions& setting() const { return setting_; }

    // How the hand is heard in the plays to come; the reference hears it in every frame.
    void hear(const HeardHand& hand) { hand_ = hand; }

    // From rest, asleep. Looks at the job after every step; throws Cancelled.
    HandPlay play(const HandMotion& motion, const StepperOptions& setting, Job& job);
    HandPlay play(const HandMotion& motion, Job& job) { return play(motion, setting_, job); }

    // The same hand on the same mesh and element, all of it computed in `substeps` substeps a
    // frame, each solved to 1e-8 in the energy norm: what a setting's error is measured against.
    // What the mesh itself misses is not in it. Looks at the job after every substep.
    CentrelineMotion reference(const HandMotion& motion, int substeps, Job& job) const;
    // The same, kept in `folder`, which must exist, and read from there the next time. A file of
    // another patient, scene, element or motion is left alone; one that is damaged is made anew.
    // Files know nothing of the program: remove them when elements or potentials change.
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
