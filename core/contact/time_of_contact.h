// SPDX-License-Identifier: GPL-3.0-or-later
// Continuous collision detection by conservative advancement (Mirtich 1996): two features whose
// corners move in straight lines over the time 0 to 1 are taken forward by steps in which they
// cannot come nearer than asked. With the direction n from one to the other and their distance d,
// corners that close along n at most at the speed s keep them apart for (d - gap) / s: two convex
// sets are at least as far apart as their shadows on a line. Double throughout. Pure functions.
#pragma once

#include <optional>

#include "core/contact/closest_points.h"

namespace hepatica {

template <class Feature>
struct Motion {
    Feature begin;
    Feature end;
};

// A time up to which the features are at least gap_mm >= 0 apart; at it they are nearer than
// gap_mm + tolerance_mm (> 0), unless a hundred steps did not lead there (it is then early, never
// late). None where they keep apart up to the end. 0 where they are nearer from the beginning.
std::optional<double> time_of_contact(const Motion<Vec3>& point, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm);
std::optional<double> time_of_contact(const Motion<Segment>& first, const Motion<Segment>& second,
                                      double gap_mm, double tolerance_mm);
// A capsule's axis, and a triangle; gap_mm holds the capsule's radius.
std::optional<double> time_of_contact(const Motion<Segment>& axis, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm);

}  // namespace hepatica
