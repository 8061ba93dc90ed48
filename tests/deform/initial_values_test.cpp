// SPDX-License-Identifier: GPL-3.0-or-later
// What objects of this room hold before anyone has written to them.
#include "tests/support/initial_values.h"

#include <gtest/gtest.h>

#include "core/deform/body/body.h"
#include "core/deform/body/body_state.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/body/material.h"
#include "core/deform/body/torn_body.h"
#include "core/deform/potentials/grab.h"
#include "core/deform/potentials/pad_barrier.h"
#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/potentials/tool_contact.h"
#include "core/deform/potentials/tool_friction.h"
#include "core/deform/potentials/tool_path.h"
#include "core/deform/potentials/touch_list.h"
#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"
#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/dense_front.h"
#include "core/deform/solvers/elimination_tree.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/skeleton_preconditioner.h"
#include "core/deform/solvers/tree_cholesky.h"
#include "core/deform/step/assembly_plan.h"
#include "core/deform/step/damping_regression.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/momentum_check.h"
#include "core/deform/step/newton_step.h"
#include "core/deform/step/path_work.h"
#include "core/deform/step/rigid_motion.h"
#include "core/deform/step/solver_checkpoint.h"
#include "core/deform/step/step_report.h"
#include "core/deform/step/step_underway.h"
#include "core/deform/step/velocity_error.h"
#include "core/deform/stepper/live_region.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/deform/stepper/stepper_options.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

TEST(DeformInitialFigures, AreThoseRecorded) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, SelfPad);
    HEPATICA_ADD_INITIAL(figures, BodyDescription);
    HEPATICA_ADD_INITIAL(figures, ElementGroup);
    HEPATICA_ADD_INITIAL(figures, Body);
    HEPATICA_ADD_INITIAL(figures, Body::Pad);
    HEPATICA_ADD_INITIAL(figures, BodyState);
    HEPATICA_ADD_INITIAL(figures, EnergyLedger);
    HEPATICA_ADD_INITIAL(figures, Material);
    HEPATICA_ADD_INITIAL(figures, Lame);
    HEPATICA_ADD_INITIAL(figures, RayleighDamping);
    HEPATICA_ADD_INITIAL(figures, MaterialPreset);
    HEPATICA_ADD_INITIAL(figures, TornBody);
    HEPATICA_ADD_INITIAL(figures, Grab);
    HEPATICA_ADD_INITIAL(figures, PadBarrier);
    HEPATICA_ADD_INITIAL(figures, PointPair);
    HEPATICA_ADD_INITIAL(figures, PointPull);
    HEPATICA_ADD_INITIAL(figures, TouchList);
    HEPATICA_ADD_INITIAL(figures, SurfaceContact);
    HEPATICA_ADD_INITIAL(figures, SelfLoad);
    HEPATICA_ADD_INITIAL(figures, SelfCost);
    HEPATICA_ADD_INITIAL(figures, OverlapsKept);
    HEPATICA_ADD_INITIAL(figures, ToolPart);
    HEPATICA_ADD_INITIAL(figures, Tool);
    HEPATICA_ADD_INITIAL(figures, ToolLoad);
    HEPATICA_ADD_INITIAL(figures, PadContact);
    HEPATICA_ADD_INITIAL(figures, ToolFriction::PointForce);
    HEPATICA_ADD_INITIAL(figures, ToolResistance);
    HEPATICA_ADD_INITIAL(figures, BlockMatrix);
    HEPATICA_ADD_INITIAL(figures, CoarseSkeleton);
    HEPATICA_ADD_INITIAL(figures, SkeletonPolyline);
    HEPATICA_ADD_INITIAL(figures, SkeletonBinding);
    HEPATICA_ADD_INITIAL(figures, ConjugateGradient);
    HEPATICA_ADD_INITIAL(figures, PivotRule);
    HEPATICA_ADD_INITIAL(figures, Supernode);
    HEPATICA_ADD_INITIAL(figures, EliminationTree);
    HEPATICA_ADD_INITIAL(figures, EliminationTree::Chain);
    HEPATICA_ADD_INITIAL(figures, SolveLimits);
    HEPATICA_ADD_INITIAL(figures, SolveReport);
    HEPATICA_ADD_INITIAL(figures, SkeletonSettings);
    HEPATICA_ADD_INITIAL(figures, SparseLoad);
    HEPATICA_ADD_INITIAL(figures, GroupSlots);
    HEPATICA_ADD_INITIAL(figures, GatherLists);
    HEPATICA_ADD_INITIAL(figures, AssemblyPlan);
    HEPATICA_ADD_INITIAL(figures, DampingFit);
    HEPATICA_ADD_INITIAL(figures, DampingRegression);
    HEPATICA_ADD_INITIAL(figures, EnergyLimiter::Overdrawn);
    HEPATICA_ADD_INITIAL(figures, EnergyLimiter::Outcome);
    HEPATICA_ADD_INITIAL(figures, EnergyLimiter::Balance);
    HEPATICA_ADD_INITIAL(figures, EnergyLimiter::Pieces);
    HEPATICA_ADD_INITIAL(figures, MomentumBalance);
    HEPATICA_ADD_INITIAL(figures, NewtonSettings);
    HEPATICA_ADD_INITIAL(figures, PathWork::Result);
    test::expect_recorded("deform", "initial", figures);
}

TEST(DeformInitialFigures, AreThoseRecordedOfOthers) {
    test::Figures figures;
    HEPATICA_ADD_INITIAL(figures, RigidMotion);
    HEPATICA_ADD_INITIAL(figures, MatrixOrigin);
    HEPATICA_ADD_INITIAL(figures, ToolOrigin);
    HEPATICA_ADD_INITIAL(figures, SolverCheckpoint);
    HEPATICA_ADD_INITIAL(figures, StepReport);
    HEPATICA_ADD_INITIAL(figures, LinearisedWork);
    HEPATICA_ADD_INITIAL(figures, VelocityError);
    HEPATICA_ADD_INITIAL(figures, LiveRegionOptions);
    HEPATICA_ADD_INITIAL(figures, LiveStepper::Extent);
    HEPATICA_ADD_INITIAL(figures, QualityPoint);
    HEPATICA_ADD_INITIAL(figures, RegionCheckpoint);
    HEPATICA_ADD_INITIAL(figures, ToolCheckpoint);
    HEPATICA_ADD_INITIAL(figures, SelfCheckpoint);
    HEPATICA_ADD_INITIAL(figures, StepperCheckpoint);
    HEPATICA_ADD_INITIAL(figures, StepperOptions);
    test::expect_recorded("deform", "initial_others", figures);
}

}  // namespace
}  // namespace hepatica
