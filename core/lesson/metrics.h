// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities measured in a play. Lengths in mm, forces in mN, areas in mm^2, masses in g, times
// in simulated seconds.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/lesson/predicate.h"

namespace hepatica {

// Accumulated since the lesson began.
struct LessonMetrics {
    double time_s = 0.0;         // without pauses
    double path_mm = 0.0;        // of the tool's tip and of the pulling hand
    double peak_force_mn = 0.0;  // largest mean over PlayMeter::felt_over_s
    double impulse_mn_s = 0.0;   // integral of the force over time
    int contacts = 0;            // number of contacts of a tool
    double contact_s = 0.0;      // total time in contact
    double largest_stretch = 1.0;
    int joints_broken = 0;
    int pieces_off = 0;
    double torn_area_mm2 = 0.0;  // at rest, of what has come apart wholly
    double blood_lost_g = 0.0;
    double injected_g = 0.0;        // of the drug
    double delivered_g = 0.0;       // through the outlets of the vessels
    double dose_target_g = 0.0;     // delivered in the target
    double dose_elsewhere_g = 0.0;  // delivered elsewhere
    double reflux_g = 0.0;          // delivered through outlets that are not beyond the tip

    bool operator==(const LessonMetrics&) const = default;
};

// Position of one mark relative to hand and tool.
struct MarkMoment {
    // From ToolView::working_mm() (0 while the tool touches the vessel there), else from the point
    // held.
    double distance_mm = std::numeric_limits<double>::infinity();
    double moved_mm = 0.0;  // displacement from rest
    // From the centre of the tool's contact, else from the point held.
    double touch_mm = std::numeric_limits<double>::infinity();
    bool operator==(const MarkMoment&) const = default;
};

// Present values.
struct LessonMoment {
    // Of the hand, plus that of vessels and obstacles on the tool; mean over the last
    // PlayMeter::felt_over_s.
    double force_mn = 0.0;
    double grip_mn = 0.0;  // of the jaws
    double stretch = 1.0;  // largest principal stretch of the surface
    double leak_g_s = 0.0;
    // Share of the target's surface vertices that the drug has reached since the lesson began, also
    // by an injection that another one took the place of; 0 once the drug is taken out.
    double target_filled = 0.0;
    double elsewhere_filled = 0.0;  // the same of all others
    bool drug_present = false;      // an injection runs: neither stopped nor taken out
    bool holding = false;           // the hand holds a vessel, or the tool touches one
    std::vector<MarkMoment> marks;
    bool operator==(const LessonMoment&) const = default;
};

// `step_time_s`: time since the present step began. NaN for the target's share of the dose while
// nothing is delivered, and for a mark that there is not.
double value_of(const Predicate& predicate, const LessonMetrics& metrics,
                const LessonMoment& moment, double step_time_s);

nlohmann::ordered_json to_json(const LessonMetrics& metrics);
// CSV: "metric,value,unit" and one row per metric, with all digits; NaN is an empty cell.
std::string to_csv(const LessonMetrics& metrics);

}  // namespace hepatica
