// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a play from its frames alone, so that a play and its replay give identical numbers to
// the last bit. Wall time has no influence.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/lesson/dose_account.h"
#include "core/lesson/lesson.h"
#include "core/lesson/metrics.h"
#include "core/patient/patient_case.h"
#include "core/scene/felt_force.h"
#include "core/scene/frame.h"
#include "core/scene/surface_stretch.h"
#include "core/scene/vertex_places.h"

namespace hepatica {

// Not thread-safe.
class PlayMeter {
  public:
    // Throws InputError where the patient has no surface or no vessel tree. O(vertices).
    PlayMeter(const Lesson& lesson, std::shared_ptr<const PatientCase> patient);

    // The frame before the first that counts; tears in it are not counted.
    void begin(const Frame& frame);
    // Call with every later frame in order, each one step of the scene's dt_s; paused frames are
    // ignored. Throws InputError where an injection cannot flow, and Cancelled where its dose is
    // waited for and a stop is requested.
    void see(const Frame& frame, const std::stop_token& stop = {});
    // Call before the next frame where another tool, or a grab at another place, has replaced the
    // last one: nothing has gone the way between them.
    void take_another_tool() { tip_.reset(); }
    void take_another_hold() { hand_.reset(); }

    const LessonMetrics& metrics() const { return metrics_; }
    const LessonMoment& moment() const { return moment_; }
    // Marks in a frame: mean of the surface vertices of the mark's segment within one radius along
    // it; without any, the nearest vertex. The frame must be of the lesson's scene and patient: the
    // vertices are indexed.
    std::vector<Vec3> marks_in(const Frame& frame) const;

    // Contacts with a shorter gap in s count as one.
    static constexpr double same_contact_s = 0.1;
    // Whether a tool that touches after nothing was touched for so long begins a contact. Times are
    // sums of steps, which round.
    static bool begins_contact(double free_s) { return free_s >= same_contact_s - 1e-9; }
    // Forces are means over this time, the integral excepted: a hand is judged by what it would
    // feel, not by the jump of a single step.
    static constexpr double felt_over_s = FeltForce::over_s;

  private:
    void place_marks(const Lesson& lesson, const std::vector<VertexPlace>& on_tree);
    void see_hand(const Frame& frame);
    void see_contact(const Frame& frame);
    void see_marks(const Frame& frame);
    void see_tear(const Frame& frame);
    void see_drug(const Frame& frame, const std::stop_token& stop);
    void take_arrivals(const DrugView& drug);

    std::shared_ptr<const PatientCase> patient_;
    double dt_s_;
    const std::vector<Vec3>& rest_mm_;
    std::vector<int> on_surface_;          // sorted vertices of the surface at rest
    std::vector<char> in_target_;          // per vertex of on_surface_; empty without flow
    std::vector<std::vector<int>> marks_;  // the vertices around each mark
    std::vector<Vec3> marks_rest_mm_;
    SurfaceStretch surface_;
    std::optional<DoseAccount> dose_;  // if the scene has flow
    LessonMetrics metrics_;
    LessonMoment moment_;
    FeltForce felt_force_;
    std::optional<Vec3> tip_, hand_;  // of the frame before
    double since_touch_s_ = 1e9;
    TearView before_;                                      // of the first frame
    DrugView drug_;                                        // of the last frame
    std::vector<float> target_arrivals_, other_arrivals_;  // ascending
};

}  // namespace hepatica
