// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/skeleton/thinning_templates.h"
#include "core/skeleton/topology.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(SkeletonInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ThinningTemplate);
    HEPATICA_ADD_INITIAL(figures, Betti);
    HEPATICA_ADD_INITIAL(figures, CrowdedRegion);
    HEPATICA_ADD_INITIAL(figures, UnitWidthStages);
    test::expect_recorded("skeleton", "initial", figures);
}

}  // namespace
}  // namespace hepatica
