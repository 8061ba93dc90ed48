// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/patient/case_header.h"
#include "core/patient/doubts.h"
#include "core/patient/measurement.h"
#include "core/patient/painted_tumours.h"
#include "core/patient/patient_case.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(PatientInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, CaseHeader);
    HEPATICA_ADD_INITIAL(figures, SegmentDoubts);
    HEPATICA_ADD_INITIAL(figures, Doubts);
    HEPATICA_ADD_INITIAL(figures, KeptMeasurement);
    HEPATICA_ADD_INITIAL(figures, Tumour);
    HEPATICA_ADD_INITIAL(figures, CaseSource);
    HEPATICA_ADD_INITIAL(figures, Rebuilding);
    HEPATICA_ADD_INITIAL(figures, Corrections);
    HEPATICA_ADD_INITIAL(figures, PatientCase);
    test::expect_recorded("patient", "initial", figures);
}

}  // namespace
}  // namespace hepatica
