// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/contact/capsule.h"
#include "core/contact/closest_features.h"
#include "core/contact/closest_points.h"
#include "core/contact/near_pairs.h"
#include "core/contact/rigid_fit.h"
#include "core/contact/surface_features.h"
#include "core/contact/surface_patches.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(ContactInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, Capsule);
    HEPATICA_ADD_INITIAL(figures, NearTriangle);
    HEPATICA_ADD_INITIAL(figures, PointSegment);
    HEPATICA_ADD_INITIAL(figures, PointTriangle);
    HEPATICA_ADD_INITIAL(figures, SegmentSegment);
    HEPATICA_ADD_INITIAL(figures, SegmentTriangle);
    HEPATICA_ADD_INITIAL(figures, small::OnSegment);
    HEPATICA_ADD_INITIAL(figures, small::OnTriangle);
    HEPATICA_ADD_INITIAL(figures, small::OnSegments);
    HEPATICA_ADD_INITIAL(figures, Sweep);
    HEPATICA_ADD_INITIAL(figures, RigidFit);
    HEPATICA_ADD_INITIAL(figures, FeaturePair);
    HEPATICA_ADD_INITIAL(figures, Box);
    test::expect_recorded("contact", "initial", figures);
}

}  // namespace
}  // namespace hepatica
