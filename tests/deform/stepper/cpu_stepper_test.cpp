// SPDX-License-Identifier: GPL-3.0-or-later
// The stepper against closed forms: free fall, the clamped beam, the ledger of energy.
#include "core/deform/stepper/cpu_stepper.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

using test::copy_of;

const Vec3 gravity(0, 0, -units::standard_gravity);

// A beam along x, clamped at x = 0.
BodyDescription clamped_beam(const Vec3& size_mm, const Index3& cells) {
    BodyDescription body;
    body.mesh = kuhn_brick(size_mm, cells);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0);
    body.material = {.young_modulus_pa = 1e6, .poisson_ratio = 0.3, .density_g_mm3 = 1e-3};
    return body;
}

TEST(CpuStepper, FallsFreely) {
    BodyDescription body = clamped_beam(Vec3(4, 2, 2), {2, 1, 1});
    body.fixed.clear();
    body.material.damping_ratio = 0.0;
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-12}});
    stepper->set_gravity(gravity);
    const std::vector<Vec3> start = copy_of(stepper->positions_mm());
    const double dt = 0.01;
    const int steps = 50;
    for (int i = 0; i < steps; ++i) stepper->step(dt);
    // Backward Euler's exact answer: z = g dt^2 n (n + 1) / 2.
    const double fallen = units::standard_gravity * dt * dt * steps * (steps + 1) / 2.0;
    for (std::size_t v = 0; v < start.size(); ++v) {
        const Vec3 moved = stepper->positions_mm()[v] - start[v];
        EXPECT_NEAR(moved[2], -fallen, 1e-9 * fallen);
        EXPECT_NEAR(moved.head<2>().norm(), 0.0, 1e-9 * fallen);
    }
}

// Its potential is rounding errors, which no search lowers for certain: not a reason to say that
// the step failed, nor to move.
TEST(CpuStepper, ABodyThatHasComeToRestTakesItsStepsWhole) {
    BodyDescription body = clamped_beam(Vec3(20, 4, 4), {10, 2, 2});
    body.material.damping_ratio = 1.0;
    const auto stepper =
        make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-12}, .sleeping = false});
    stepper->set_gravity(gravity);
    for (int i = 0; i < 100; ++i) stepper->step(1.0);
    const std::vector<Vec3> rest = copy_of(stepper->positions_mm());
    for (int i = 0; i < 200; ++i) {
        const StepReport report = stepper->step(1.0 / 60.0);
        EXPECT_FALSE(report.degraded) << "step " << i << ": " << report.message;
    }
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_LT((stepper->positions_mm()[v] - rest[v]).norm(), 1e-9);
}

// Error of a bar that hangs along x, root mean square over its vertices, relative to how far its
// end sinks: rho g L^2 / (2 E). nu = 0, so that the clamp does not disturb.
double hanging_bar_error(const Index3& cells) {
    BodyDescription body = clamped_beam(Vec3(20, 4, 4), cells);
    body.material.poisson_ratio = 0.0;
    body.material.damping_ratio = 1.0;
    const auto stepper =
        make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-8}, .sleeping = false});
    stepper->set_gravity(Vec3(units::standard_gravity, 0, 0));
    for (int i = 0; i < 30; ++i) stepper->step(0.2);
    const double sunk = 1e-3 * units::standard_gravity * 20.0 * 20.0 / (2.0 * 1e6);
    double sum = 0.0;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        const double x = body.mesh.vertices_mm[v][0];
        const double exact = sunk * (2.0 * x / 20.0 - x * x / 400.0);
        sum += std::pow((stepper->positions_mm()[v][0] - x - exact) / sunk, 2);
    }
    return std::sqrt(sum / static_cast<double>(body.mesh.vertices_mm.size()));
}

TEST(CpuStepper, HangingBarStretchesByItsWeightAndConvergesAtSecondOrder) {
    const double coarse = hanging_bar_error({15, 3, 3}), fine = hanging_bar_error({30, 6, 6});
    EXPECT_LT(fine, 0.015);
    EXPECT_GT(coarse / fine, 3.0);
}

double tip_deflection(const BodyDescription& body, const StepperOptions& options, double dt,
                      int steps) {
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(gravity);
    for (int i = 0; i < steps; ++i) stepper->step(dt);
    // Mean over the end face.
    double sum = 0.0;
    int count = 0;
    double length = 0.0;
    for (const Vec3& x : body.mesh.vertices_mm) length = std::max(length, x[0]);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
        if (body.mesh.vertices_mm[v][0] == length) {
            sum += stepper->positions_mm()[v][2] - body.mesh.vertices_mm[v][2];
            ++count;
        }
    return -sum / count;
}

// The same mesh in CalculiX (large deformation) sinks by 10.811 mm.
TEST(CpuStepper, ClampedBeamMatchesAnIndependentFiniteElementProgram) {
    const BodyDescription body = clamped_beam(Vec3(200, 40, 40), {20, 3, 3});
    ASSERT_EQ(body.mesh.tetrahedra.size(), 1080u);
    const double tip = tip_deflection(body, {.linear = {.energy_tolerance = 1e-8}}, 0.1, 100);
    EXPECT_NEAR(tip / 10.811, 1.0, 3e-3);
}

TEST(CpuStepper, LedgerClosesInFlightAndWhileHeld) {
    for (const int iterates : {1, 20}) {
        BodyDescription body = clamped_beam(Vec3(60, 8, 8), {12, 2, 2});
        const auto stepper = make_cpu_stepper(
            body, {.linear = {.energy_tolerance = 1e-3}, .newton_iterations = iterates});
        stepper->set_gravity(gravity);
        const int tip = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
        for (int i = 0; i < 120; ++i) {
            Grab grab{.vertices = {tip, tip - 1, -1, -1}, .weights = {0.5, 0.5, 0, 0}};
            grab.target_mm = Vec3(60, 4 + 20 * std::sin(0.1 * i), 4);
            grab.stiffness_un_per_mm = 1e4;
            grab.force_limit_un = 5e4;
            if (i > 80)
                stepper->set_grabs({});
            else
                stepper->set_grabs(std::span(&grab, 1));
            const StepReport report = stepper->step(1.0 / 60.0);
            EXPECT_LT(relative_imbalance(report.energy), 1e-10) << "step " << i;
            EXPECT_GE(report.energy.damping_loss, 0.0);
        }
    }
}

std::uint64_t hash_after(int threads, const BodyDescription& body) {
    const ThreadLimit limit(threads);
    const auto stepper = make_cpu_stepper(body, {});
    stepper->set_gravity(gravity);
    for (int i = 0; i < 20; ++i) stepper->step(1.0 / 60.0);
    Hasher hasher;
    for (const Vec3& x : stepper->positions_mm()) hasher.add(std::span(x.data(), 3));
    for (const Vec3& v : stepper->velocities_mm_per_s()) hasher.add(std::span(v.data(), 3));
    return hasher.value();
}

TEST(CpuStepper, SameBitsForAnyNumberOfThreads) {
    const BodyDescription body = clamped_beam(Vec3(100, 20, 20), {20, 4, 4});
    const std::uint64_t one = hash_after(1, body);
    EXPECT_EQ(one, hash_after(2, body));
    EXPECT_EQ(one, hash_after(4, body));
}

// The same beam described in millimetres, centimetres and metres (grams, seconds): moduli scale by
// 1/length, densities by 1/length^3.
TEST(CpuStepper, AnswerDoesNotDependOnTheUnitOfLength) {
    std::vector<double> tips;
    for (const double unit_mm : {1.0, 10.0, 1000.0}) {
        BodyDescription body = clamped_beam(Vec3(60, 8, 8) / unit_mm, {12, 2, 2});
        body.material.young_modulus_pa *= unit_mm;
        body.material.density_g_mm3 *= unit_mm * unit_mm * unit_mm;
        const auto stepper =
            make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-6}, .newton_iterations = 10});
        stepper->set_gravity(gravity / unit_mm);
        for (int i = 0; i < 30; ++i) stepper->step(1.0 / 60.0);
        tips.push_back(stepper->positions_mm().back()[2] * unit_mm);
    }
    EXPECT_NEAR(tips[1], tips[0], 1e-6);
    EXPECT_NEAR(tips[2], tips[0], 1e-6);
}

TEST(CpuStepper, HeldPointRestsWhereForcesBalance) {
    BodyDescription body = clamped_beam(Vec3(40, 8, 8), {10, 2, 2});
    body.material.damping_ratio = 1.0;
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-9}});
    // Far beyond the limit: the pull is the limit, as if a weight hung there.
    const int tip = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
    Grab grab{.vertices = {tip, -1, -1, -1}};
    grab.target_mm = Vec3(40, 8, -1e5);
    grab.stiffness_un_per_mm = 1e3;
    grab.force_limit_un = 2000.0;
    stepper->set_grabs(std::span(&grab, 1));
    for (int i = 0; i < 200; ++i) stepper->step(0.05);
    const double pulled = 8.0 - stepper->positions_mm()[tip][2];
    // The same force as gravity on a far heavier body: compare with a direct compliance. F
    // L^3/(3EI).
    const double inertia = 8.0 * 8 * 8 * 8 / 12.0;
    const double beam = 2000.0 * 40 * 40 * 40 / (3.0 * 1e6 * inertia);
    EXPECT_GT(pulled, 0.5 * beam);
    EXPECT_LT(pulled, 1.1 * beam);
    stepper->set_grabs({});
    for (int i = 0; i < 200; ++i) stepper->step(0.05);
    EXPECT_NEAR(stepper->positions_mm()[tip][2], 8.0, 1e-6);
}

TEST(CpuStepper, FallsAsleepAndWakes) {
    BodyDescription body = clamped_beam(Vec3(20, 8, 8), {5, 2, 2});
    body.material.damping_ratio = 1.0;
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-6}});
    stepper->set_gravity(gravity);
    bool asleep = false;
    for (int i = 0; i < 600 && !asleep; ++i) asleep = stepper->step(1.0 / 60.0).asleep;
    EXPECT_TRUE(asleep);
    stepper->set_gravity(2.0 * gravity);
    EXPECT_FALSE(stepper->step(1.0 / 60.0).asleep);
}

// Another element model would bend the body otherwise. It does so with the next motion, and until
// then the energies are those that it stores where the body lies.
TEST(CpuStepper, SleepsOnUnderOtherOptionsAndReportsTheirEnergies) {
    BodyDescription body = clamped_beam(Vec3(20, 8, 8), {5, 2, 2});
    body.material.damping_ratio = 1.0;
    StepperOptions options{.model = ElementModel::spring, .linear = {.energy_tolerance = 1e-6}};
    const auto stepper = make_cpu_stepper(body, options);
    stepper->set_gravity(gravity);
    bool asleep = false;
    for (int i = 0; i < 600 && !asleep; ++i) asleep = stepper->step(1.0 / 60.0).asleep;
    ASSERT_TRUE(asleep);
    const double before = stepper->energies().elastic;
    const BodyState resting = stepper->state();
    options.model = ElementModel::neohookean;
    ASSERT_TRUE(stepper->set_options(options));
    const StepReport report = stepper->step(1.0 / 60.0);
    EXPECT_TRUE(report.asleep);
    EXPECT_EQ(stepper->state().positions_mm, resting.positions_mm);
    EXPECT_GT(std::abs(report.energy.elastic - before), 1e-3 * before);
    EXPECT_DOUBLE_EQ(report.energy.elastic, stepper->energies().elastic);
    const auto restored = make_cpu_stepper(body, options);
    restored->restore(stepper->checkpoint());
    EXPECT_EQ(restored->state_hash(), stepper->state_hash());
    for (Stepper* other : {stepper.get(), restored.get()}) {
        other->set_gravity(1.01 * gravity);
        EXPECT_FALSE(other->step(1.0 / 60.0).asleep);
    }
    EXPECT_EQ(restored->state_hash(), stepper->state_hash());
}

TEST(CpuStepper, RefusesWhatCannotBeSimulated) {
    BodyDescription body = clamped_beam(Vec3(20, 8, 8), {5, 2, 2});
    body.material.poisson_ratio = 0.5;
    EXPECT_THROW(make_cpu_stepper(body, {}), InputError);
    body = clamped_beam(Vec3(20, 8, 8), {5, 2, 2});
    std::swap(body.mesh.tetrahedra[3][0], body.mesh.tetrahedra[3][1]);
    EXPECT_THROW(make_cpu_stepper(body, {}), InputError);
    body = clamped_beam(Vec3(20, 8, 8), {5, 2, 2});
    const auto stepper = make_cpu_stepper(body, {});
    EXPECT_THROW(stepper->step(0.0), InputError);
    EXPECT_THROW(stepper->step(std::nan("")), InputError);
    EXPECT_THROW(stepper->set_gravity(Vec3(0, std::nan(""), 0)), InputError);
    Grab grab{.vertices = {0, -1, -1, -1}};
    grab.target_mm = Vec3(std::numeric_limits<double>::infinity(), 0, 0);
    EXPECT_THROW(stepper->set_grabs(std::span(&grab, 1)), InputError);
}

// The middles of the edges of a bent quadratic body are not on their straight middles.
TEST(CpuStepper, ASnapshotOfAQuadraticBodyGoesOnToTheLastBit) {
    const BodyDescription body = clamped_beam(Vec3(60, 8, 8), {6, 1, 1});
    const StepperOptions options{.order = ElementOrder::quadratic,
                                 .solver = LinearSolverKind::cholesky,
                                 .linear = {.energy_tolerance = 1e-10}};
    const auto first = make_cpu_stepper(body, options);
    first->set_gravity(gravity);
    for (int i = 0; i < 10; ++i) first->step(0.01);
    const BodyState kept = first->state();
    ASSERT_GT(kept.positions_mm.size(), body.mesh.vertices_mm.size());

    std::vector<BodyState> ends;
    for (int run = 0; run < 2; ++run) {
        const auto second = make_cpu_stepper(body, options);
        second->set_gravity(gravity);
        second->set_state(kept.positions_mm, kept.velocities_mm_per_s);
        EXPECT_EQ(second->state().positions_mm, kept.positions_mm);
        EXPECT_EQ(second->state().velocities_mm_per_s, kept.velocities_mm_per_s);
        for (int i = 0; i < 5; ++i) second->step(0.01);
        ends.push_back(second->state());
    }
    EXPECT_EQ(ends[0].positions_mm, ends[1].positions_mm);
    // The one that was never stopped, to what its lagged factor leaves.
    for (int i = 0; i < 5; ++i) first->step(0.01);
    for (std::size_t v = 0; v < kept.positions_mm.size(); ++v)
        EXPECT_LT((first->state().positions_mm[v] - ends[0].positions_mm[v]).norm(), 1e-8);

    first->set_state(first->positions_mm(), first->velocities_mm_per_s());  // vertices suffice
    EXPECT_THROW(first->set_state(std::span(kept.positions_mm).first(3), kept.velocities_mm_per_s),
                 InputError);
}

// Gives up at every solve.
class BrokenSolver final : public LinearSolver {
  public:
    explicit BrokenSolver(int dropped_pivots) : dropped_pivots_(dropped_pivots) {}
    void update(const BlockMatrix&, std::span<const Vec3>, std::span<const int>) override {}
    SolveReport solve(std::span<const Vec3>, std::span<Vec3> x, const SolveLimits&) override {
        std::ranges::fill(x, Vec3::Zero());
        SolveReport report;
        report.converged = dropped_pivots_ > 0;
        report.dropped_pivots = dropped_pivots_;
        return report;
    }
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override { z = r; }
    std::string_view name() const override { return "broken"; }
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override { return {}; }
    void restore(const BlockMatrix&, bool, std::span<const Vec3>,
                 std::span<const double>) override {}

  private:
    int dropped_pivots_;
};

TEST(BackwardEuler, SaysSoWhereItsSystemCouldNotBeSolved) {
    const Body body = build_body(clamped_beam(Vec3(20, 8, 8), {5, 2, 2}), ElementModel::corotated,
                                 ElementOrder::linear);
    for (const int dropped : {0, 5}) {
        BackwardEuler integrator(body, {}, std::make_unique<BrokenSolver>(dropped));
        PotentialList potentials(body);
        potentials.set_gravity(gravity);
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.rest_positions_mm.size(), Vec3::Zero())};
        const StepReport report = integrator.advance(state, 0.01, potentials);
        EXPECT_TRUE(report.degraded);
        EXPECT_NE(report.message, "");
        EXPECT_EQ(report.dropped_pivots, dropped);
        for (const Vec3& x : state.positions_mm) EXPECT_TRUE(x.allFinite());
    }
}

}  // namespace
}  // namespace hepatica
