// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/velocity_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/frame_time.h"
#include "core/base/units.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

// The matrix of first iterates of a clamped bar at rest, with a negative E.
class MatrixWithError {
  public:
    MatrixWithError()
        : body_(build_body(test::description_of(test::make_bar(36.0, 3.0, 12, 1)),
                           ElementModel::corotated, ElementOrder::linear)),
          potential_(body_, small::Tangent::rotated),
          potentials_(body_),
          start_{body_.rest_positions_mm, std::vector<Vec3>(body_.mass_g.size(), Vec3::Zero())} {
        error_.set({.alpha_per_s = -20.0, .beta_s = -0.004});
    }

    void freeze_beyond(double x_mm) {
        std::vector<std::uint8_t> frozen;
        for (const Vec3& x : body_.rest_positions_mm) frozen.push_back(x.x() > x_mm ? 1 : 0);
        potential_.freeze(frozen);
    }
    // Assembles so often before E is added, as where the first try of a step is given up.
    void make(int assemblies) {
        const StepUnderway step{.potentials = potentials_,
                                .start = start_,
                                .dt_s = frame_s,
                                .before = {},
                                .velocity = {},
                                .positions = start_.positions_mm};
        potential_.evaluate(step.positions);
        potential_.find_force(step);
        for (int k = 0; k < assemblies; ++k) potential_.assemble(step);
        without_ = potential_.matrix().block;
        error_.add_to(potential_, body_, step.dt_s);
    }

    const std::vector<Mat3>& blocks() { return potential_.matrix().block; }
    // Blocks in rows of held nodes that differ from those of the unit matrix.
    int blocks_beside_unit() {
        const BlockMatrix& matrix = potential_.matrix();
        int others = 0;
        for (int i = 0; i < matrix.rows(); ++i)
            for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
                if (!potential_.held(i)) continue;
                const Mat3 unit = (k == matrix.diagonal[i] ? 1.0 : 0.0) * Mat3::Identity();
                others += matrix.block[k] == unit ? 0 : 1;
            }
        return others;
    }
    // Nodes that are not held, and those of them whose inertia and stiffness E lowers.
    std::array<int, 2> free_and_lowered() {
        const BlockMatrix& matrix = potential_.matrix();
        std::array<int, 2> count{};
        for (int i = 0; i < matrix.rows(); ++i) {
            if (potential_.held(i)) continue;
            const int own = matrix.diagonal[i];
            ++count[0];
            count[1] += matrix.block[own].trace() < without_[own].trace() ? 1 : 0;
        }
        return count;
    }

  private:
    Body body_;
    IncrementalPotential potential_;
    PotentialList potentials_;
    BodyState start_;
    VelocityError error_;
    std::vector<Mat3> without_;
};

TEST(VelocityError, LeavesTheUnitBlocksOfHeldNodes) {
    MatrixWithError all;
    all.make(1);
    EXPECT_EQ(all.blocks_beside_unit(), 0);
    EXPECT_EQ(all.free_and_lowered(), (std::array{48, 48})) << "all but the clamped end";
}

// However often it was added before, and whatever was live then.
TEST(VelocityError, IsNotGatheredUpInRowsThatAreFrozen) {
    MatrixWithError later, at_once;
    later.make(1);
    later.freeze_beyond(10.0);
    at_once.freeze_beyond(10.0);
    at_once.make(1);
    for (int step = 0; step < 3; ++step) {
        later.make(2);
        EXPECT_EQ(later.blocks_beside_unit(), 0) << step;
        EXPECT_TRUE(std::ranges::equal(later.blocks(), at_once.blocks())) << step;
    }
    EXPECT_EQ(later.free_and_lowered(), (std::array{12, 12}));
}

TEST(VelocityError, KeepsTheSystemOfAClampedBodyPositiveDefinite) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(40, 8, 8), {10, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() == 0.0);
    StepperOptions options;
    options.solver = LinearSolverKind::cholesky;
    options.velocity_error = {.alpha_per_s = 0.0, .beta_s = -0.002};
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(units::standard_gravity * Vec3(0, -1, 0));
    for (int k = 0; k < 3; ++k) {
        const StepReport report = stepper->step(frame_s);
        EXPECT_EQ(report.dropped_pivots, 0) << k;
        EXPECT_FALSE(report.degraded) << report.message;
    }
}

}  // namespace
}  // namespace hepatica
