// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of a play, few and physical. Lengths in mm, forces in mN, areas in mm^2, masses
// in g, times in simulated seconds.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/lesson/predicate.h"

namespace hepatica {

// Since the lesson began.
struct LessonMetrics {
    double time_s = 0.0;         // during which the clock was not held
    double path_mm = 0.0;        // of the tool's tip, and of the hand while it pulls
    double peak_force_mn = 0.0;  // largest mean over PlayMeter::felt_over_s
    double impulse_mn_s = 0.0;   // integral of the force over time
    int contacts = 0;            // how often a tool began to touch
    double contact_s = 0.0;      // for how long one touched
    double largest_stretch = 1.0;
    int joints_broken = 0;
    int pieces_off = 0;
    double torn_area_mm2 = 0.0;  // of the faces that came apart, at rest
    double blood_lost_g = 0.0;
    double injected_g = 0.0;        // of the drug
    double delivered_g = 0.0;       // through ends of the vessels, into those too small to see
    double dose_target_g = 0.0;     // of what was delivered: in the target
    double dose_elsewhere_g = 0.0;  // the rest of what was delivered
    double reflux_g = 0.0;          // delivered by way of vessels that do not begin at the tip

    bool operator==(const LessonMetrics&) const = default;
};

// How one mark is placed.
struct MarkMoment {
    double distance_mm = std::numeric_limits<double>::infinity();  // of the tip, or of the hand
    double moved_mm = 0.0;                                         // from its place at rest
    double touch_mm = std::numeric_limits<double>::infinity();  // of the middle of what is touched
    bool operator==(const MarkMoment&) const = default;
};

// Of one moment.
struct LessonMoment {
    // Of the hand, and of the tool on the vessels: mean over the last PlayMeter::felt_over_s.
    double force_mn = 0.0;
    double grip_mn = 0.0;  // of jaws
    double stretch = 1.0;  // largest principal stretch of the surface
    double leak_g_s = 0.0;
    double target_filled = 0.0;     // share of the target's surface that the drug has reached
    double elsewhere_filled = 0.0;  // of the rest of the surface
    bool drug_present = false;
    bool holding = false;  // the hand holds a vessel, or the tool touches one
    std::vector<MarkMoment> marks;
    bool operator==(const LessonMoment&) const = default;
};

// `step_time_s`: since the lesson's step began. NaN where a share of nothing is asked for.
double value_of(const Predicate& predicate, const LessonMetrics& metrics,
                const LessonMoment& moment, double step_time_s);

nlohmann::ordered_json to_json(const LessonMetrics& metrics);
// "metric,value,unit" and one row each, with all digits.
std::string to_csv(const LessonMetrics& metrics);

}  // namespace hepatica
