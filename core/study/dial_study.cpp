// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/dial_study.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/scene/setting_json.h"
#include "core/study/drag_study.h"

namespace hepatica {
namespace {

constexpr int reference_substeps = 8;
constexpr double loose_tolerance = 0.1;

StepperOptions in_substeps(int substeps) {
    StepperOptions setting;
    setting.substeps = substeps;
    return setting;
}

StepperOptions solved_loosely() {
    StepperOptions setting;
    setting.linear.energy_tolerance = loose_tolerance;
    return setting;
}

bool holds(std::span<const QualityPoint> measured, const StepperOptions& setting) {
    return std::ranges::any_of(
        measured, [&](const QualityPoint& point) { return same_setting(point.options, setting); });
}

std::optional<StepperOptions> setting_in_a_gap(std::span<const QualityPoint> measured) {
    const QualityDial dial({measured.begin(), measured.end()});
    const std::span<const QualityPoint> front = dial.front();
    for (std::size_t i = 1; i < front.size(); ++i) {
        if (front[i].frame_ms <= widest_cost_ratio * front[i - 1].frame_ms) continue;
        const int below = front[i - 1].options.substeps, above = front[i].options.substeps;
        for (int substeps = (below + above) / 2; substeps > below && substeps < above; ++substeps)
            if (!holds(measured, in_substeps(substeps))) return in_substeps(substeps);
    }
    return std::nullopt;
}

SceneSpec scene_as_played() {
    SceneSpec scene = default_scene();
    scene.flow.reset();  // nothing of it moves
    scene.deform->setting = in_substeps(1);
    return scene;
}

std::string words_of_reference(const PatientCase& patient) {
    return "the same body, corotated on " + std::to_string(patient.mesh.tetrahedra.size()) +
           " tetrahedra, all of it in " + std::to_string(reference_substeps) +
           " substeps a frame, solved exactly, pulled by 30 mm in half a second and back (the "
           "mesh's own error is not in it)";
}

}  // namespace

std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured) {
    for (const StepperOptions& setting :
         {in_substeps(1), in_substeps(2), solved_loosely(), in_substeps(4), in_substeps(3),
          in_substeps(reference_substeps)})
        if (!holds(measured, setting)) return setting;
    return setting_in_a_gap(measured);
}

DialStudy::DialStudy(std::shared_ptr<const PatientCase> patient, std::vector<QualityPoint> measured)
    : patient_(std::move(patient)), points_(std::move(measured)) {}

bool DialStudy::measure_next(Job& job) {
    const std::optional<StepperOptions> setting = next_dial_setting(points_);
    if (!setting) return false;
    const HandMotion motion = dial_motion();
    if (!trial_)
        trial_ = std::make_unique<HandTrial>(patient_, scene_as_played(),
                                             PlayedRegion::as_in_scenes, job);
    if (reference_.empty()) reference_ = trial_->reference(motion, reference_substeps, job);
    const HandPlay played = trial_->play(motion, *setting, job);
    points_.push_back({*setting, summary_of(played).frame_ms.p95,
                       motion_error(played.motion, reference_), words_of_reference(*patient_)});
    return true;
}

}  // namespace hepatica
