// SPDX-License-Identifier: GPL-3.0-or-later
// Continuous collision detection by conservative advancement (Mirtich 1996): two features whose
// corners move in straight lines over the time 0 to 1 are advanced by steps during which they
// cannot come nearer than the gap. With the direction n from one to the other and their distance d,
// corners that approach along n at most at the speed s stay apart for (d - gap) / s, because two
// convex sets are at least as far apart as their projections on a line. Double throughout. Pure
// functions.
#pragma once

#include <optional>

#include "core/contact/closest_points.h"

namespace hepatica {

template <class Feature>
struct Motion {
    Feature begin;
    Feature end;
};

// A time up to which the features are at least gap_mm >= 0 apart. At that time they are nearer than
// gap_mm + tolerance_mm (> 0), unless a hundred steps did not suffice (it is then early, never
// late). None where they stay apart until the end; 0 where they are nearer from the start.
std::optional<double> time_of_contact(const Motion<Vec3>& point, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm);
std::optional<double> time_of_contact(const Motion<Segment>& first, const Motion<Segment>& second,
                                      double gap_mm, double tolerance_mm);
// The axis of a capsule and a triangle; gap_mm must include the capsule's radius.
std::optional<double> time_of_contact(const Motion<Segment>& axis, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm);

}  // namespace hepatica
