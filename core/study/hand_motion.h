// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of a trainee's hand: tens of millimetres within a tenth of a second to some seconds. Cost
// and error of the deforming body in play are measured with them.
#pragma once

#include <string>
#include <vector>

#include "core/session/script.h"

namespace hepatica {

struct HandMotion {
    std::string name;
    Script script;
    int steps = 0;       // of 1/60 s
    int held_steps = 0;  // of these until the last action ends; the rest is swing
};

// pull:  by (30, 20, 0) mm in half a second, then by (-30, -40, 10) mm in half a second;
// jerk:  by (40, 0, 0) mm in a tenth of a second, and back in another;
// twist: once around a circle of 15 mm radius in three seconds.
// Each takes the vessel at half of the longest path, lets go at the end, and is watched for another
// second.
std::vector<std::string> hand_motion_names();
// Throws InputError for any other name.
HandMotion hand_motion(const std::string& name);

// The motion of a script, named "script", until a second after its last action.
HandMotion motion_of(const Script& script);

// The motion by which the dial's settings are measured: from the same place by 30 mm in half a
// second, and back in another; one second in all.
HandMotion dial_motion();

}  // namespace hepatica
