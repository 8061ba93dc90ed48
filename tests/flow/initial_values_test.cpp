// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/flow/arrival_times.h"
#include "core/flow/drug_front.h"
#include "core/flow/embolization.h"
#include "core/flow/flow_network.h"
#include "core/flow/flow_solution.h"
#include "core/flow/fluid.h"
#include "core/flow/hydraulic_circuit.h"
#include "core/flow/injection.h"
#include "core/flow/pressure_drop.h"
#include "core/flow/territory.h"
#include "core/flow/tube_law.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(FlowInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, ArrivalTimes);
    HEPATICA_ADD_INITIAL(figures, ArrivalTimes::Knot);
    HEPATICA_ADD_INITIAL(figures, FrontOptions);
    HEPATICA_ADD_INITIAL(figures, FrontStep);
    HEPATICA_ADD_INITIAL(figures, DrugBalance);
    HEPATICA_ADD_INITIAL(figures, Beads);
    HEPATICA_ADD_INITIAL(figures, EmbolizationOptions);
    HEPATICA_ADD_INITIAL(figures, EmbolizationSample);
    HEPATICA_ADD_INITIAL(figures, Embolization);
    HEPATICA_ADD_INITIAL(figures, FlowSegment);
    HEPATICA_ADD_INITIAL(figures, FlowNetwork);
    HEPATICA_ADD_INITIAL(figures, NetworkPoint);
    HEPATICA_ADD_INITIAL(figures, NodeSegments);
    HEPATICA_ADD_INITIAL(figures, Inlet);
    HEPATICA_ADD_INITIAL(figures, FlowConditions);
    HEPATICA_ADD_INITIAL(figures, FlowSolution);
    HEPATICA_ADD_INITIAL(figures, SegmentPressures);
    HEPATICA_ADD_INITIAL(figures, TubeWall);
    HEPATICA_ADD_INITIAL(figures, Filling);
    HEPATICA_ADD_INITIAL(figures, Phase);
    HEPATICA_ADD_INITIAL(figures, Fluid);
    HEPATICA_ADD_INITIAL(figures, HydraulicPart);
    HEPATICA_ADD_INITIAL(figures, HydraulicElement);
    HEPATICA_ADD_INITIAL(figures, HydraulicState);
    HEPATICA_ADD_INITIAL(figures, InjectionOptions);
    HEPATICA_ADD_INITIAL(figures, InjectionSample);
    HEPATICA_ADD_INITIAL(figures, InjectionResult);
    HEPATICA_ADD_INITIAL(figures, Cone);
    HEPATICA_ADD_INITIAL(figures, Drop);
    HEPATICA_ADD_INITIAL(figures, DropCoefficients);
    HEPATICA_ADD_INITIAL(figures, Territory);
    test::expect_recorded("flow", "initial", figures);
}

}  // namespace
}  // namespace hepatica
