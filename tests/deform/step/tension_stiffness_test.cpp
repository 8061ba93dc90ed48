// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/tension_stiffness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

constexpr double bar_length_mm = 8.0;

// A bar along x whose length is changed by `strain`, as if nothing held its sides.
class StretchedBar {
  public:
    explicit StretchedBar(double strain, double held_below_mm = 0.0)
        : body_(build_body(description(held_below_mm), ElementModel::corotated,
                           ElementOrder::linear)),
          live_(body_),
          assembly_(body_, small::Tangent::rotated, &live_),
          tension_(body_, assembly_.plan(), live_) {
        const double across = 1.0 - Material{}.poisson_ratio * strain;
        for (const Vec3& p : body_.rest_positions_mm)
            x_.emplace_back((1.0 + strain) * p[0], across * p[1], across * p[2]);
        assembly_.evaluate(x_);
        tension_.find(assembly_.slots());
        tension_.make(assembly_.slots(), 1.0);
    }

    double stiffness_form(const std::vector<Vec3>& d) const { return assembly_.quadratic_form(d); }
    double tension_form(const std::vector<Vec3>& d) const {
        std::vector<Vec3> product(d.size(), Vec3::Zero());
        tension_.subtract_product(d, product);
        return -hepatica::dot(d, product);
    }
    // By differences of the forces.
    double exact_form(const std::vector<Vec3>& d) {
        constexpr double step = 1e-5;
        return (work(d, -step) - work(d, step)) / (2.0 * step);
    }
    std::vector<Vec3> turned(const Vec3& axis) const {
        std::vector<Vec3> d;
        for (const Vec3& p : x_) d.push_back(axis.cross(p));
        return d;
    }
    BlockMatrix matrix() const {
        BlockMatrix matrix;
        assembly_.gather_stiffness(0.0, matrix);
        tension_.add_to(matrix, 1.0);
        return matrix;
    }
    const Body& body() const { return body_; }
    const TensionStiffness& tension() const { return tension_; }
    // The largest difference of an element's pull from the virial of its forces, over the largest.
    double error_of_pulls() {
        assembly_.evaluate_forces(x_);
        const ElementSlots& slots = assembly_.slots();
        double error = 0.0, largest = 0.0;
        for (int e = 0; e < body_.groups[0].size(); ++e) {
            double pull = 0.0;
            for (int a = 0; a < 4; ++a) {
                const auto& force = slots.force()[assembly_.plan().force_slot(0, e, 4) + a];
                pull -= 0.5 * x_[body_.groups[0].connectivity[4 * e + a]].dot(
                                  Vec3(force[0], force[1], force[2]));
            }
            error = std::max(error, std::abs(slots.pulls(0)[e] - pull));
            largest = std::max(largest, std::abs(pull));
        }
        return error / largest;
    }

  private:
    static BodyDescription description(double held_below_mm) {
        BodyDescription bar;
        bar.mesh = kuhn_brick(Vec3(bar_length_mm, 1.0, 1.0), {8, 1, 1});
        for (const Vec3& p : bar.mesh.vertices_mm)
            bar.fixed.push_back(p[0] < held_below_mm ? 1 : 0);
        return bar;
    }
    double work(const std::vector<Vec3>& d, double step) {
        std::vector<Vec3> moved(d.size()), force(d.size());
        for (std::size_t i = 0; i < d.size(); ++i) moved[i] = x_[i] + step * d[i];
        assembly_.evaluate_forces(moved);
        assembly_.gather_forces(force);
        return hepatica::dot(d, force);
    }

    Body body_;
    LiveSet live_;
    Assembly assembly_;
    TensionStiffness tension_;
    std::vector<Vec3> x_;
};

// The exact stiffness of a bar that is turned across its length is what the stiffness of held
// rotations leaves out, and all of it is the tension: volume times stress.
TEST(TensionStiffness, IsWhatHeldRotationsLeaveOutWhereATautBarIsTurned) {
    const double strain = 0.05;
    StretchedBar bar(strain);
    const std::vector<Vec3> turn = bar.turned(Vec3(0.0, 0.0, 1.0));
    const double exact = bar.exact_form(turn);
    EXPECT_NEAR(exact, bar_length_mm * Material{}.young_modulus_pa * strain, 0.1 * exact);
    EXPECT_LT(bar.stiffness_form(turn), 0.05 * exact);
    EXPECT_NEAR(bar.tension_form(turn), exact, 0.1 * exact);
}

// V s / 4 |sum_a h_a x d_a|^2 in closed form: under a homogeneous strain e the virial is V s with
// s = E e (1 + e), and of a turn by w about z the sum is w (trace(F) - F_zz).
TEST(TensionStiffness, IsTheClosedFormOfAHomogeneousStretch) {
    const double e = 0.05;
    const StretchedBar bar(e);
    const Material material{};
    const double sum = (1.0 + e) + (1.0 - material.poisson_ratio * e);
    const double stress = material.young_modulus_pa * e * (1.0 + e);
    const double closed = 0.25 * bar_length_mm * stress * sum * sum;
    EXPECT_NEAR(bar.tension_form(bar.turned(Vec3(0.0, 0.0, 1.0))), closed, 1e-4 * closed);
}

TEST(TensionStiffness, PullsAreTheVirialsOfTheForces) {
    EXPECT_LT(StretchedBar(0.2).error_of_pulls(), 1e-13);
    EXPECT_LT(StretchedBar(-0.1).error_of_pulls(), 1e-13);
}

TEST(TensionStiffness, IsNothingAtRestAndUnderPressure) {
    EXPECT_FALSE(StretchedBar(0.0).tension().any());
    EXPECT_FALSE(StretchedBar(-0.05).tension().any());
    EXPECT_TRUE(StretchedBar(0.05).tension().any());
}

// Elements of which all nodes are held lie among those that move.
TEST(TensionStiffness, IsNothingAtRestHoweverMuchIsHeld) {
    for (const double held_below_mm : {0.5, 2.5, 4.5, 7.5}) {
        EXPECT_FALSE(StretchedBar(0.0, held_below_mm).tension().any()) << held_below_mm;
        EXPECT_TRUE(StretchedBar(0.05, held_below_mm).tension().any()) << held_below_mm;
    }
}

TEST(TensionStiffness, IsPositiveAndLeavesTranslationsFree) {
    const StretchedBar bar(0.05);
    const std::vector<Vec3> shift(bar.body().node_count(), Vec3(1.0, -2.0, 3.0));
    double largest = 0.0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const double form =
            bar.tension_form(test::random_field(bar.body().node_count(), 1.0, seed));
        EXPECT_GE(form, 0.0);
        largest = std::max(largest, form);
    }
    EXPECT_LT(std::abs(bar.tension_form(shift)), 1e-12 * largest);
}

TEST(TensionStiffness, LeavesRowsAndColumnsOfHeldNodesAlone) {
    const StretchedBar bar(0.05, 0.5);
    const BlockMatrix matrix = bar.matrix();
    int others = 0;
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const bool held = bar.body().fixed[i] != 0 || bar.body().fixed[matrix.column[k]] != 0;
            if (held)
                EXPECT_EQ(matrix.block[k], Mat3::Zero().eval());
            else
                others += matrix.block[k].isZero(0.0) ? 0 : 1;
        }
    EXPECT_GT(others, 0);
}

// A thin bar that a hand stretches by a third in half a second, and then leads sideways.
class LedByAHand : public testing::Test {
  protected:
    static constexpr int stretched_in = 30, frames = 60;

    LedByAHand() : body_(test::description_of(test::make_bar(60.0, 3.0, 20, 1))) {
        tip_ = test::tip_of(body_);
    }

    std::unique_ptr<Stepper> stepper(bool tension,
                                     LinearSolverKind solver = LinearSolverKind::cholesky) const {
        StepperOptions options;
        options.solver = solver;
        options.tension = tension;
        return make_cpu_stepper(body_, options);
    }
    StepReport step(Stepper& stepper, int frame) const {
        Grab grab{.vertices = {tip_, -1, -1, -1}};
        grab.target_mm =
            body_.mesh.vertices_mm[tip_] + Vec3(20.0 * std::min(1.0, frame / double{stretched_in}),
                                                2.0 * std::max(0, frame - stretched_in), 0.0);
        grab.stiffness_un_per_mm = 1e5;
        grab.force_limit_un = 1e7;
        stepper.set_grabs(std::span(&grab, 1));
        return stepper.step(frame_s);
    }
    struct Cost {
        int shortened = 0, solves = 0;
    };
    Cost cost_of(bool tension) const {
        const auto played = stepper(tension);
        Cost cost;
        for (int frame = 1; frame <= frames; ++frame) {
            const StepReport report = step(*played, frame);
            cost.shortened += report.shortened ? 1 : 0;
            cost.solves += report.linear_solves;
            EXPECT_LT(std::abs(report.energy.imbalance), 1e-9 * energy_handled(report.energy));
        }
        return cost;
    }

    BodyDescription body_;
    int tip_ = 0;
};

TEST_F(LedByAHand, StepsOfATautBarNeedNotBeShortened) {
    const Cost with = cost_of(true), without = cost_of(false);
    EXPECT_GE(without.shortened, 10);
    EXPECT_LE(with.shortened, 1);
    EXPECT_LE(with.solves, without.solves);
}

// Drawn out to twice its length: its steps begin at rest, since each would go too far.
TEST_F(LedByAHand, NorNeedThoseOfATautBarThatIsHeld) {
    const auto cost = [&](bool tension) {
        const auto played = stepper(tension);
        Cost held;
        for (int frame = 1; frame <= 200; ++frame) {
            Grab grab{.vertices = {tip_, -1, -1, -1}};
            grab.target_mm = body_.mesh.vertices_mm[tip_] +
                             std::min(1.0, frame / double{stretched_in}) * Vec3(60.0, 20.0, 0.0);
            grab.stiffness_un_per_mm = 1e6;
            grab.force_limit_un = 1e9;
            played->set_grabs(std::span(&grab, 1));
            const StepReport report = played->step(frame_s);
            if (frame <= stretched_in) continue;
            held.shortened += report.shortened ? 1 : 0;
            held.solves += report.linear_solves;
        }
        return held;
    };
    const Cost with = cost(true), without = cost(false);
    EXPECT_LE(with.shortened, 3);
    EXPECT_GE(without.shortened, 100);
    EXPECT_LE(2 * with.solves, without.solves);
}

// The skeleton's preconditioner outlives its matrix: the checkpoint has what tension that one had.
TEST_F(LedByAHand, GoesOnFromACheckpointToTheBit) {
    const auto played = stepper(true, LinearSolverKind::skeleton);
    int taut = 0;
    for (int frame = 1; frame < frames; ++frame) {
        step(*played, frame);
        const StepperCheckpoint kept = played->checkpoint();
        taut += kept.solver.made_from && !kept.solver.made_from->taut_mm.empty() ? 1 : 0;
        if (frame % 10 != 5) continue;
        const auto restored = stepper(true, LinearSolverKind::skeleton);
        restored->restore(checkpoint_from_bytes(to_bytes(kept)));
        const auto same = stepper(true, LinearSolverKind::skeleton);
        same->restore(kept);
        step(*restored, frame + 1);
        step(*same, frame + 1);
        const auto further = stepper(true, LinearSolverKind::skeleton);
        for (int f = 1; f <= frame + 1; ++f) step(*further, f);
        EXPECT_TRUE(
            std::ranges::equal(restored->velocities_mm_per_s(), further->velocities_mm_per_s()))
            << frame;
        EXPECT_TRUE(std::ranges::equal(same->velocities_mm_per_s(), further->velocities_mm_per_s()))
            << frame;
    }
    EXPECT_GT(taut, 0);
}

}  // namespace
}  // namespace hepatica
