// SPDX-License-Identifier: GPL-3.0-or-later
// A hand as a window hears it: not in every frame, because pictures take their time.
#pragma once

#include <vector>

#include "core/session/command.h"

namespace hepatica {

struct HeardHand {
    int every = 1;         // frames from one report to the next
    bool at_once = false;  // what it holds is there at every report, else as HandPace has it
};

// Of the commands of each frame those that are heard: of the moves of a grab only the ones in every
// so many frames, all others as they are.
std::vector<std::vector<Command>> heard(const std::vector<std::vector<Command>>& commands,
                                        const HeardHand& hand);

}  // namespace hepatica
