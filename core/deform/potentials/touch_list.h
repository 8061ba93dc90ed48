// SPDX-License-Identifier: GPL-3.0-or-later
// What may touch at given positions: points of the body in a tool's pad, pairs of features of its
// surface and of obstacles, the friction contacts of a step, and the ties of parted joints. The
// host searches for these; energies and forces are computed from the lists alone, on any back end.
#pragma once

#include <vector>

#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/pad_point.h"
#include "core/deform/potentials/slip_law.h"
#include "core/tear/softening_law.h"

namespace hepatica {

// A point, or a pair of points, that touched when the step began; see SlipLaw. Its slip is the
// tangential part of the weighted sum of its nodes' positions minus the anchor.
struct RubPoint {
    int nodes[4];  // -1: none
    double weights[4];
    small::Vector3<double> normal, anchor;
    SlipLaw law;
    int kind;  // contacts of one kind share the friction limit of a node
};

// Two vertices that were one.
struct TieTouch {
    int nodes[2];
    TieCorner corner;
};

struct TouchList {
    std::vector<PadCapsule> tool;
    std::vector<PadPoint> points;
    std::vector<PadPair> pairs;  // nodes after the body's are those of its obstacles
    std::vector<RubPoint> rubs;
    SofteningLaw softening;
    std::vector<TieTouch> ties;  // those that still hold
};

}  // namespace hepatica
