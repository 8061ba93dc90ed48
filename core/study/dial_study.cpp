// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/dial_study.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/scene/measured_dial.h"
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
    scene.flow.reset();  // flow is not needed
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

std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured,
                                                const DeformBackEnd& back_end) {
    const auto next_of = [&](const DeformBackEnd& one) {
        std::vector<QualityPoint> points;
        std::ranges::copy_if(measured, std::back_inserter(points), [&](const QualityPoint& point) {
            return is_measured_with(one, point);
        });
        return next_dial_setting(points);
    };
    std::optional<StepperOptions> setting = next_of(back_end);
    if (setting || !back_end.beside_processor) return setting;
    setting = next_of(cpu_back_end());
    if (setting) setting->on_processor = true;
    return setting;
}

DialStudy::DialStudy(std::shared_ptr<const PatientCase> patient, std::vector<QualityPoint> measured,
                     DeformBackEnd back_end)
    : patient_(std::move(patient)), points_(std::move(measured)), back_end_(std::move(back_end)) {}

bool DialStudy::measure_next(Job& job) {
    const std::optional<StepperOptions> setting = next_dial_setting(points_, back_end_);
    if (!setting) return false;
    const HandMotion motion = dial_motion();
    if (!trial_)
        trial_ = std::make_unique<HandTrial>(patient_, scene_as_played(),
                                             PlayedRegion::as_in_scenes, job, back_end_);
    if (reference_.empty()) reference_ = trial_->reference(motion, reference_substeps, job);
    require_movement(reference_);  // a point without an error would make the dial unreadable
    const HandPlay played = trial_->play(motion, *setting, job);
    const DragSummary cost = summary_of(played);
    QualityPoint point{*setting, cost.frame_ms.p95, motion_error(played.motion, reference_),
                       words_of_reference(*patient_)};
    if (!setting->on_processor) {
        if (played.device != back_end_.device)
            throw InputError("has left steps to the processor", back_end_.device,
                             "Measure again, or with --backend cpu");
        point.back_end = back_end_.name;
        point.device = back_end_.device;
        // While a device computes, the processor is idle, so its time says nothing.
        if (!point.device.empty()) point.frame_ms = cost.wall_ms.p95;
    }
    point.options.on_processor = false;  // the point's back end says that
    points_.push_back(std::move(point));
    return true;
}

}  // namespace hepatica
