// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost over what contact adds to the dial: the thickness of the pad, how far the
// linear solve and Newton's method go, the length of a step, and friction or none. A block slides
// down a slab that leans, against the same play with a thin pad, solved tightly in short steps.
#pragma once

#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/study/tradeoff.h"

namespace hepatica {

// A setting of contact, and its figures: those of a tradeoff's point.
struct ContactPoint {
    std::string name;        // what is other than in a scene
    double pad_edges = 0.1;  // see SelfPad
    double friction = 0.2;
    TradeoffPoint point;
};

struct ContactTradeoff {
    std::vector<ContactPoint> points;
    std::string reference;
};

struct ContactTradeoffOptions {
    int slab_cells = 16, block_cells = 6;  // across
    int frames = 24;
};

// Its points in the order of the settings; the front is marked. Throws Cancelled, after a substep
// at most.
ContactTradeoff measure_contact_tradeoff(const ContactTradeoffOptions& options, Job& job);

// Under the settings' names in the place of elements', to be written as others are.
Tradeoff as_tradeoff(const ContactTradeoff& tradeoff);

}  // namespace hepatica
