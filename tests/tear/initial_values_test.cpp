// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/tear/joint.h"
#include "core/tear/softening.h"
#include "core/tear/tear_law.h"
#include "core/tear/tear_state.h"
#include "core/tear/tearing.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(TearInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, Joint);
    HEPATICA_ADD_INITIAL(figures, SofteningLaw);
    HEPATICA_ADD_INITIAL(figures, SofteningTie);
    HEPATICA_ADD_INITIAL(figures, TieCorner);
    HEPATICA_ADD_INITIAL(figures, TiePull);
    HEPATICA_ADD_INITIAL(figures, TearLaw);
    HEPATICA_ADD_INITIAL(figures, TearState);
    HEPATICA_ADD_INITIAL(figures, TearReport);
    HEPATICA_ADD_INITIAL(figures, TearLoads);
    test::expect_recorded("tear", "initial", figures);
}

}  // namespace
}  // namespace hepatica
