// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the dial of a patient's body: cost and error of each setting in a pull by 30 mm within
// half a second and back, in the scene as it is played. Settings are measured one at a time, the
// most useful first, so that a dial is available early.
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

// Neighbouring settings on a complete front differ in cost by at most this factor, unless no number
// of substeps lies between theirs.
constexpr double widest_cost_ratio = 2.5;

// The most useful setting to measure next: one substep, two, one with a tolerance of a tenth, four,
// three, eight; then numbers of substeps between neighbours on the front whose costs differ by more
// than widest_cost_ratio. None where the front is complete.
std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured);
// The same for a back end, from the points measured with it; then, where it is offered beside the
// processor, for the processor. The options are as the back end takes them.
std::optional<StepperOptions> next_dial_setting(std::span<const QualityPoint> measured,
                                                const DeformBackEnd& back_end);

// Not thread-safe.
class DialStudy {
  public:
    // Continues from what was measured before on this body, with any back end. The patient must
    // have a mesh.
    explicit DialStudy(std::shared_ptr<const PatientCase> patient,
                       std::vector<QualityPoint> measured = {},
                       DeformBackEnd back_end = cpu_back_end());

    // Measures the next setting; the first call also builds the body and measures the reference.
    // Returns false, without any work, where none is left. A setting's cost is the 95th percentile
    // of its frame times. Its error is the root mean square over the pull and the centreline,
    // relative to the motion of the same elements on the same mesh, all of them computed with eight
    // substeps a frame and solved exactly; the mesh's own error is not included. Checks the job
    // after every step. Throws Cancelled, after which the next call measures the same setting
    // again, and InputError where a device left the motion to the processor, because that would not
    // measure the device, or where nothing moves.
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
