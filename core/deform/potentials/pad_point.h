// SPDX-License-Identifier: GPL-3.0-or-later
// A point of the body's surface with the pad of a tool: the equations of tool_pad.h, for host and
// device.
#pragma once

#include "core/contact/closest_features.h"
#include "core/deform/potentials/pad_barrier.h"

namespace hepatica {

struct PadCapsule {
    small::Vector3<double> begin, end;
    double radius_mm;
};

struct PadPoint {
    int nodes[3];       // the corners of its triangle
    double weights[3];  // barycentric
    int part;           // of the tool
    double pad_mm;      // of its triangle
    double strength_un;
    double dip_mm;  // how far its triangle bulges into the pad; subtracted from the gap
};

struct PointPull {
    bool pressed = false;  // the members below are set only where true
    small::Vector3<double> at{}, normal{};
    double along = 0.0;  // position along the part's axis, from 0 to 1
    PadBarrier pad;      // its force acts along the normal on the surface
};

HEPATICA_HOST_DEVICE PointPull pull_of(const PadPoint& point, const PadCapsule& part,
                                       const small::Vector3<double>* corners) {
    PointPull pull;
    pull.at = small::point_in(corners, point.weights);
    const small::OnSegment on = small::closest_on_segment(pull.at, part.begin, part.end);
    const double distance = std::sqrt(on.squared);
    const double gap = distance - part.radius_mm - point.dip_mm;
    if (!(gap < point.pad_mm)) return pull;
    pull.pressed = true;
    pull.along = on.along;
    const auto apart = pull.at - small::point_between(part.begin, part.end, on.along);
    for (int c = 0; c < 3; ++c) pull.normal[c] = apart[c] / distance;
    pull.pad = pad_barrier(gap, point.pad_mm, point.strength_un);
    return pull;
}

}  // namespace hepatica
