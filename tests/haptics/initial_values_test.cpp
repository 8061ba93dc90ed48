// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/haptics/force_loop.h"
#include "core/haptics/haptic_device.h"
#include "core/haptics/local_model.h"
#include "core/haptics/patch_feed.h"
#include "core/haptics/simulated_device.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(HapticsInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ForceLoopOptions);
    HEPATICA_ADD_INITIAL(figures, Tick);
    HEPATICA_ADD_INITIAL(figures, HapticPose);
    HEPATICA_ADD_INITIAL(figures, HapticForce);
    HEPATICA_ADD_INITIAL(figures, HapticSample);
    HEPATICA_ADD_INITIAL(figures, PortWork);
    HEPATICA_ADD_INITIAL(figures, HapticTraits);
    HEPATICA_ADD_INITIAL(figures, LocalContact);
    HEPATICA_ADD_INITIAL(figures, LocalModel);
    HEPATICA_ADD_INITIAL(figures, PatchFeed);
    HEPATICA_ADD_INITIAL(figures, SimulatedHand);
    test::expect_recorded("haptics", "initial", figures);
}

}  // namespace
}  // namespace hepatica
