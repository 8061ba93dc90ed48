// SPDX-License-Identifier: GPL-3.0-or-later
// The dial of a patient's own body: what each setting costs and misses in a pull by 30 mm within
// half a second and back, in the scene as it is played. Settings are measured one at a time, the
// most useful first, so that there is a dial early and the rest can be measured later.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/patient/patient_case.h"
#include "core/study/hand_trial.h"

namespace hepatica {

// Settings that follow each other on a filled front differ in cost by this factor at most, where
// there is a number of substeps between theirs.
constexpr double widest_cost_ratio = 2.5;

// Most useful next after those measured: one substep, two, one that is solved to a tenth, four,
// three, eight; then numbers of substeps between those of neighbours on the front that are further
// apart than widest_cost_ratio. None where the front is filled.
std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured);
// Of the points measured with a back end, and then, where it stands beside the processor, of the
// processor's. The options are as the back end is to be given them.
std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured,
                                                const DeformBackEnd& back_end);

// Not thread-safe.
class DialStudy {
  public:
    // Goes on behind what was measured before on this body, with any back end. The patient has a
    // mesh.
    explicit DialStudy(std::shared_ptr<const PatientCase> patient,
                       std::vector<QualityPoint> measured = {},
                       DeformBackEnd back_end = cpu_back_end());

    // Measures the next setting; the first call builds the body and measures the reference as well.
    // False, without any work, where none is left. A setting's cost is what 95 of 100 of its frames
    // take at most; its error is the root mean square over the pull and the centreline, relative
    // to the motion of the same elements on the same mesh, all computed, in eight substeps a frame,
    // solved exactly. What the mesh itself misses is not in it. Looks at the job after every step;
    // throws Cancelled, after which the setting under way is measured anew by the next call, and
    // InputError where a device left the motion to the processor: that is no measure of it.
    bool measure_next(Job& job);

    const std::vector<QualityPoint>& points() const { return points_; }

  private:
    std::shared_ptr<const PatientCase> patient_;
    std::vector<QualityPoint> points_;
    DeformBackEnd back_end_;
    std::unique_ptr<HandTrial> trial_;
    CentrelineMotion reference_;
};

}  // namespace hepatica
