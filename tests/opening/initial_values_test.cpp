// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/opening/built_in_cache.h"
#include "core/opening/open_patient.h"
#include "core/opening/patient_image.h"
#include "core/opening/recorded_case.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(OpeningInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, BuiltInCache);
    HEPATICA_ADD_INITIAL(figures, LeftEdits);
    HEPATICA_ADD_INITIAL(figures, OpenRequest);
    HEPATICA_ADD_INITIAL(figures, OpenedPatient);
    HEPATICA_ADD_INITIAL(figures, FoundImage);
    HEPATICA_ADD_INITIAL(figures, CaseSearch);
    test::expect_recorded("opening", "initial", figures);
}

}  // namespace
}  // namespace hepatica
