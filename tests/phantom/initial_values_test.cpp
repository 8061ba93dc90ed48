// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/phantom/disturbances.h"
#include "core/phantom/phantom.h"
#include "core/phantom/phantom_centrelines.h"
#include "core/phantom/phantom_growth.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(PhantomInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, Disturbances);
    HEPATICA_ADD_INITIAL(figures, PhantomOptions);
    HEPATICA_ADD_INITIAL(figures, Phantom);
    HEPATICA_ADD_INITIAL(figures, CentrelineRequest);
    HEPATICA_ADD_INITIAL(figures, StraightVessel);
    HEPATICA_ADD_INITIAL(figures, GrownBranch);
    HEPATICA_ADD_INITIAL(figures, GrowthRequest);
    test::expect_recorded("phantom", "initial", figures);
}

}  // namespace
}  // namespace hepatica
