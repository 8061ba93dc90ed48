// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost over the parameters that contact adds: the thickness of the pad, the tolerance
// of the linear solve, Newton iterations, the length of a step, and friction or none. A block
// slides down an inclined slab; the reference is the same motion with a thin pad, solved tightly in
// short steps.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/study/named_points.h"
#include "core/study/tradeoff.h"

namespace hepatica {

// A setting with contact, and its measurements.
struct ContactPoint {
    std::string name;        // how it differs from a scene's setting
    double pad_edges = 0.1;  // see SelfPad
    double friction = 0.2;
    TradeoffPoint point;
};

struct ContactTradeoff {
    std::vector<ContactPoint> points;
    std::string reference;
};

struct ContactTradeoffOptions {
    int slab_cells = 16, block_cells = 6;  // cells across
    int frames = 24;
};

// Points are in the order of the settings, with the front marked. Begins two stages of the job.
// Throws Cancelled, after a substep at most.
ContactTradeoff measure_contact_tradeoff(const ContactTradeoffOptions& options, Job& job);

}  // namespace hepatica
