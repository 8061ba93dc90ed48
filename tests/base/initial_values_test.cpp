// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/base/child_process.h"
#include "core/base/disjoint_sets.h"
#include "core/base/hash.h"
#include "core/base/job.h"
#include "core/base/sha256.h"
#include "core/base/temporary_folder.h"
#include "core/base/vascular_system.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(BaseInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ChildLimits);
    HEPATICA_ADD_INITIAL(figures, ChildOutcome);
    HEPATICA_ADD_INITIAL(figures, DisjointSets);
    HEPATICA_ADD_INITIAL(figures, Hasher);
    HEPATICA_ADD_INITIAL(figures, JobProgress);
    HEPATICA_ADD_INITIAL(figures, StageTime);
    HEPATICA_ADD_INITIAL(figures, Job);
    HEPATICA_ADD_INITIAL(figures, Sha256);
    HEPATICA_ADD_INITIAL(figures, TemporaryFolder);
    HEPATICA_ADD_INITIAL(figures, VesselSeed);
    test::expect_recorded("base", "initial", figures);
}

}  // namespace
}  // namespace hepatica
