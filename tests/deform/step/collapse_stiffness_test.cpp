// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/collapse_stiffness.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

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

// One element, drawn out to u diag(s) v^T of its shape at rest with random rotations.
class DrawnElement {
  public:
    DrawnElement(const Vec3& stretches, unsigned seed, bool held = false)
        : body_(build_body(description(held), ElementModel::corotated, ElementOrder::linear)),
          live_(body_),
          assembly_(body_, small::Tangent::rotated, &live_),
          collapse_(body_, assembly_.plan(), live_) {
        const auto fields = test::random_field(2, 1.0, seed);
        u_ = turn_by(fields[0]);
        v_ = turn_by(fields[1]);
        const Mat3 f = u_ * stretches.asDiagonal() * v_.transpose();
        for (const Vec3& p : body_.rest_positions_mm) x_.emplace_back(f * p);
        energy_ = assembly_.evaluate(x_);
        collapse_.find(assembly_.slots(), x_);
    }

    // The stretch beyond which the least energy across is the tip.
    static double limit() {
        const Material m;
        const double lambda_over_mu = 2.0 * m.poisson_ratio / (1.0 - 2.0 * m.poisson_ratio);
        return 3.0 + 2.0 / lambda_over_mu;
    }
    // A motion that changes the element across and nothing else: G = u^T dF v has no other entries.
    std::vector<Vec3> across(double g11, double g12, double g21, double g22) const {
        Mat3 g = Mat3::Zero();
        g(1, 1) = g11, g(1, 2) = g12, g(2, 1) = g21, g(2, 2) = g22;
        std::vector<Vec3> d;
        for (const Vec3& p : body_.rest_positions_mm) d.emplace_back(u_ * g * v_.transpose() * p);
        return d;
    }
    // By how much the energy at x + d exceeds what its force and stiffness at x make of it.
    double above_model(const std::vector<Vec3>& d, bool with_collapse) const {
        std::vector<Vec3> force(d.size(), Vec3::Zero()), moved = x_;
        assembly_.gather_forces(force);
        for (std::size_t i = 0; i < d.size(); ++i) moved[i] += d[i];
        const double form = assembly_.quadratic_form(d) + (with_collapse ? collapse_form(d) : 0.0);
        return assembly_.energy(moved) - (energy_ - hepatica::dot(force, d) + 0.5 * form);
    }
    double collapse_form(const std::vector<Vec3>& d) const {
        std::vector<Vec3> product(d.size(), Vec3::Zero());
        collapse_.add_product(d, 1.0, product);
        return hepatica::dot(d, product);
    }
    BlockMatrix matrix() const {
        BlockMatrix matrix;
        assembly_.gather_stiffness(0.0, matrix);
        collapse_.add_to(matrix, 1.0);
        return matrix;
    }
    double energy() const { return energy_; }
    const CollapseStiffness& collapse() const { return collapse_; }

  private:
    static BodyDescription description(bool held) {
        BodyDescription d;
        d.mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(1.1, 0.1, -0.1), Vec3(0.2, 0.9, 0.1),
                              Vec3(-0.1, 0.2, 1.0)};
        d.mesh.tetrahedra = {{0, 1, 2, 3}};
        d.fixed = {static_cast<std::uint8_t>(held ? 1 : 0), 0, 0, 0};
        return d;
    }
    static Mat3 turn_by(const Vec3& by) {
        return Eigen::AngleAxisd(3.0 * by.norm(), by.normalized()).toRotationMatrix();
    }

    Body body_;
    LiveSet live_;
    Assembly assembly_;
    CollapseStiffness collapse_;
    Mat3 u_, v_;
    std::vector<Vec3> x_;
    double energy_ = 0.0;
};

// So the whole way that the model proposes cannot raise the energy by more than the model says,
// through the tip and out on the other side.
TEST(CollapseStiffness, BoundsTheEnergyAcross) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    int above_without = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const double s1 = 0.05 + 0.4 * std::abs(share(random));
        const double z = std::pow(10.0, -2.5 + 2.0 * share(random)) * s1;
        const DrawnElement element(
            {DrawnElement::limit() + 0.1 + 2.0 * std::abs(share(random)), s1, z - s1}, seed);
        ASSERT_TRUE(element.collapse().any());
        const auto d = element.across(share(random), share(random), share(random), share(random));
        EXPECT_LE(element.above_model(d, true), 1e-9 * element.energy()) << seed;
        above_without += element.above_model(d, false) > 1e-3 * element.energy() ? 1 : 0;
    }
    EXPECT_GT(above_without, 50) << "the stiffness that holds rotations does not bound it";
}

// It touches the energy along the turn, where the cone is round: no smaller one would do.
TEST(CollapseStiffness, IsThatOfTheConeAlongTheTurn) {
    const DrawnElement element({DrawnElement::limit() + 1.0, 0.3, -0.2}, 3);
    for (const double turn : {1e-3, 1e-2}) {
        const auto d = element.across(0.0, turn, -turn, 0.0);
        const double form = element.collapse_form(d);
        EXPECT_GT(form, 0.0);
        EXPECT_NEAR(element.above_model(d, false), 0.5 * form, 0.02 * form);
    }
}

TEST(CollapseStiffness, IsNotThereBelowTheStretchWhereTheTipIsLeast) {
    EXPECT_FALSE(DrawnElement({1.0, 1.0, 1.0}, 1).collapse().any());
    EXPECT_FALSE(DrawnElement({1.0, 0.01, -0.0099}, 2).collapse().any());
    EXPECT_FALSE(DrawnElement({DrawnElement::limit() - 0.01, 0.2, -0.199}, 3).collapse().any());
    EXPECT_TRUE(DrawnElement({DrawnElement::limit() + 0.01, 0.2, -0.199}, 3).collapse().any());
}

TEST(CollapseStiffness, ItsMatrixIsThatOfItsProductWithoutHeldNodes) {
    const Vec3 stretches(DrawnElement::limit() + 1.0, 0.2, -0.19);
    std::vector<Vec3> d = test::random_field(4, 1.0, 9), product(4, Vec3::Zero());
    const DrawnElement free(stretches, 4);
    multiply(free.matrix(), d, product);
    const double form = free.collapse_form(d);
    EXPECT_NEAR(hepatica::dot(d, product), form, 1e-12 * form);

    const DrawnElement held(stretches, 4, true);
    d[0].setZero();
    multiply(held.matrix(), d, product);
    EXPECT_EQ(product[0], Vec3::Zero().eval());
    const double rest = held.collapse_form(d);
    EXPECT_NEAR(hepatica::dot(d, product), rest, 1e-12 * rest);
}

// A thin bar that a hand draws out to five times its length within a second and then holds there.
class DrawnOut : public testing::Test {
  protected:
    static constexpr int drawn_in = 60, frames = 120;

    DrawnOut() : body_(test::description_of(test::make_bar(20.0, 3.0, 7, 1))) {
        tip_ = test::tip_of(body_);
    }

    std::unique_ptr<Stepper> stepper(bool tension) const {
        StepperOptions options;
        options.solver = LinearSolverKind::skeleton;
        options.tension = tension;
        return make_cpu_stepper(body_, options);
    }
    StepReport step(Stepper& stepper, int frame) const {
        Grab grab{.vertices = {tip_, -1, -1, -1}};
        const double share = std::min(1.0, frame / double{drawn_in});
        grab.target_mm = body_.mesh.vertices_mm[tip_] + share * Vec3(80.0, 5.0, 3.0);
        grab.stiffness_un_per_mm = 1e7;
        grab.force_limit_un = 1e9;
        stepper.set_grabs(std::span(&grab, 1));
        return stepper.step(frame_s);
    }
    int solves(bool tension) const {
        const auto played = stepper(tension);
        int sum = 0;
        for (int frame = 1; frame <= frames; ++frame) {
            const StepReport report = step(*played, frame);
            EXPECT_LT(std::abs(report.energy.imbalance), 1e-9 * energy_handled(report.energy));
            sum += report.linear_solves;
        }
        return sum;
    }

    BodyDescription body_;
    int tip_ = 0;
};

TEST_F(DrawnOut, GoesOnMoving) {
    const int with = solves(true), without = solves(false);
    RecordProperty("with", with);
    RecordProperty("without", without);
    EXPECT_LE(with, 2 * frames) << without;
    EXPECT_GE(without, 4 * with);
}

// The preconditioner outlives its matrix: the checkpoint says whether that had it.
TEST_F(DrawnOut, GoesOnFromACheckpointToTheBit) {
    const auto played = stepper(true);
    for (int frame = 1; frame < frames; ++frame) {
        step(*played, frame);
        if (frame % 20 != 10) continue;
        const StepperCheckpoint kept = played->checkpoint();
        const auto restored = stepper(true);
        restored->restore(checkpoint_from_bytes(to_bytes(kept)));
        const auto further = stepper(true);
        for (int f = 1; f <= frame + 1; ++f) step(*further, f);
        step(*restored, frame + 1);
        EXPECT_TRUE(
            std::ranges::equal(restored->velocities_mm_per_s(), further->velocities_mm_per_s()))
            << frame;
    }
}

// Both ends are fixed, so that what has collapsed stays collapsed.
BodyDescription bar_between_walls() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(40, 8, 8), {10, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() == 0.0 || x.x() == 40.0);
    return body;
}

// The steps after tension was switched off are those of a stepper that never had it: neither their
// damping nor their ledger counts what an earlier matrix had.
TEST(CollapseStiffness, LeavesNothingBehindWhereTensionIsSwitchedOff) {
    const BodyDescription body = bar_between_walls();
    StepperOptions with;
    with.solver = LinearSolverKind::cholesky;
    with.linear.energy_tolerance = 1e-10;
    StepperOptions without = with, published = with;
    without.tension = false;
    published.published = true;
    std::vector<Vec3> drawn_out = body.mesh.vertices_mm;
    for (Vec3& x : drawn_out) x.x() *= 5.0;
    const std::vector<Vec3> at_rest(drawn_out.size(), Vec3::Zero());
    for (const StepperOptions& then : {without, published}) {
        const auto played = make_cpu_stepper(body, with), fresh = make_cpu_stepper(body, then);
        played->set_state(drawn_out, at_rest);
        played->step(frame_s);
        ASSERT_TRUE(played->set_options(then));
        for (Stepper* stepper : {played.get(), fresh.get()}) stepper->set_state(drawn_out, at_rest);
        for (int k = 0; k < 3; ++k) {
            const EnergyLedger energy = played->step(frame_s).energy;
            EXPECT_LT(std::abs(energy.imbalance), 1e-9 * energy_handled(energy)) << k;
            fresh->step(frame_s);
            for (std::size_t v = 0; v < drawn_out.size(); ++v)
                EXPECT_LT((played->positions_mm()[v] - fresh->positions_mm()[v]).norm(), 1e-6) << k;
        }
        const auto restored = make_cpu_stepper(body, then);
        restored->restore(checkpoint_from_bytes(to_bytes(played->checkpoint())));
        for (Stepper* stepper : {played.get(), restored.get()}) stepper->step(frame_s);
        EXPECT_EQ(restored->state_hash(), played->state_hash());
    }
}

}  // namespace
}  // namespace hepatica
