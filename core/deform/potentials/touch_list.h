// SPDX-License-Identifier: GPL-3.0-or-later
// What of a body may touch something where it is looked at: points in the pad of a tool, pairs of
// features of its surface and of obstacles, the points that friction acts on during a step, and
// what binds parted joints. The search for these is the host's; what comes of them is computed from
// the lists alone, on any machine.
#pragma once

#include <vector>

#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/pad_point.h"
#include "core/deform/potentials/slip_law.h"
#include "core/tear/softening_law.h"

namespace hepatica {

// A point, or a pair of points, that touched when the step began, see SlipLaw. Its slip is the
// weighted sum of its nodes' places less the anchor, along the surface.
struct RubPoint {
    int nodes[4];  // -1: none
    double weights[4];
    small::Vector3<double> normal, anchor;
    SlipLaw law;
    int kind;  // which friction it is of: the limits of one kind share a node's other forces
};

// Two vertices that were one.
struct TieTouch {
    int nodes[2];
    TieCorner corner;
};

struct TouchList {
    double tool_pad_mm = 0.0;
    std::vector<PadCapsule> tool;
    std::vector<PadPoint> points;
    std::vector<PadPair> pairs;  // nodes behind the body's are those of its obstacles
    std::vector<RubPoint> rubs;
    SofteningLaw softening;
    std::vector<TieTouch> ties;  // that have not come apart
};

}  // namespace hepatica
