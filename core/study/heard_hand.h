// SPDX-License-Identifier: GPL-3.0-or-later
// A hand as a window hears it: not in every frame, because pictures take time.
#pragma once

#include <vector>

#include "core/session/command.h"

namespace hepatica {

struct HeardHand {
    int every = 1;         // frames between two reports
    bool at_once = false;  // jump to each report; otherwise move as HandPace does
};

// The commands that are heard in each frame: moves of a grab only every `every` frames, all others
// as they are.
std::vector<std::vector<Command>> heard(const std::vector<std::vector<Command>>& commands,
                                        const HeardHand& hand);

}  // namespace hepatica
