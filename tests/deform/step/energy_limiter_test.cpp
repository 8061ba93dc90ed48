// SPDX-License-Identifier: GPL-3.0-or-later
// What removes spurious energy: it keeps the momentum of free pieces, and pieces apart.
#include "core/deform/step/energy_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "core/base/units.h"
#include "core/deform/step/backward_euler.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

struct Cloud {
    std::vector<int> nodes;
    std::vector<double> mass;
    std::vector<Vec3> x, v;
};

// Twenty nodes far from the origin that fly, spin and deform.
Cloud cloud() {
    std::mt19937_64 random(4);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0; };
    Cloud c;
    c.nodes.resize(20);
    std::iota(c.nodes.begin(), c.nodes.end(), 0);
    for (int i = 0; i < 20; ++i) {
        c.mass.push_back(1.5 + uniform());
        const Vec3 r(10 * uniform(), 20 * uniform(), 5 * uniform());
        c.x.push_back(Vec3(1000, -500, 300) + r);
        c.v.push_back(Vec3(50, 20, -30) + Vec3(3, -5, 2).cross(r) +
                      20.0 * Vec3(uniform(), uniform(), uniform()));
    }
    return c;
}

double kinetic(const Cloud& c) {
    double sum = 0.0;
    for (std::size_t i = 0; i < c.x.size(); ++i) sum += 0.5 * c.mass[i] * c.v[i].squaredNorm();
    return sum;
}

Vec3 momentum(const Cloud& c) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < c.x.size(); ++i) sum += c.mass[i] * c.v[i];
    return sum;
}

Vec3 angular_momentum(const Cloud& c) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < c.x.size(); ++i) sum += c.mass[i] * c.x[i].cross(c.v[i]);
    return sum;
}

TEST(EnergyLimiter, TakesFromTheDeformingMotionOfAFreePieceAndKeepsItsMomentum) {
    Cloud c = cloud();
    const double before = kinetic(c), excess = 500.0;
    const Vec3 p = momentum(c), l = angular_momentum(c);
    EXPECT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, false, excess, c.v), MomentumLost::none);
    EXPECT_NEAR(kinetic(c), before - excess, 1e-12 * before);
    EXPECT_LT((momentum(c) - p).norm(), 1e-13 * p.norm());
    EXPECT_LT((angular_momentum(c) - l).norm(), 1e-12 * l.norm());
}

TEST(EnergyLimiter, SaysWhatAFreePieceLostWhereItsDeformingMotionWasNotEnough) {
    Cloud c = cloud();
    // Without its deforming motion.
    ASSERT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, false, 1e-9, c.v), MomentumLost::none);
    const Vec3 p = momentum(c);
    double total_mass = 0.0;
    for (const double m : c.mass) total_mass += m;
    const double flight = 0.5 * p.squaredNorm() / total_mass;
    const double before = kinetic(c), first = 0.9 * (before - flight);
    EXPECT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, false, first, c.v), MomentumLost::angular);
    EXPECT_NEAR(kinetic(c), before - first, 1e-12 * before);
    EXPECT_LT((momentum(c) - p).norm(), 1e-12 * p.norm());
    const double second = before - first - 0.25 * flight;
    EXPECT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, false, second, c.v), MomentumLost::linear);
    EXPECT_NEAR(kinetic(c), 0.25 * flight, 1e-12 * before);
    EXPECT_LT((momentum(c) - 0.5 * p).norm(), 1e-12 * p.norm());
}

TEST(EnergyLimiter, ScalesAHeldPieceAboutRest) {
    Cloud c = cloud();
    const std::vector<Vec3> v = c.v;
    const double before = kinetic(c);
    EXPECT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, true, 0.75 * before, c.v),
              MomentumLost::none);
    for (std::size_t i = 0; i < v.size(); ++i)
        EXPECT_LT((c.v[i] - 0.5 * v[i]).norm(), 1e-13 * v[i].norm());
}

TEST(EnergyLimiter, NodesInALineHaveNoSpinAboutIt) {
    Cloud c;
    for (int i = 0; i < 3; ++i) {
        c.nodes.push_back(i);
        c.mass.push_back(1.0);
        c.x.push_back(Vec3(i, 0, 0));
        c.v.push_back(Vec3(0.1 * i * i, 2.0 * i, 0));
    }
    const Vec3 l = angular_momentum(c);
    EXPECT_EQ(take_kinetic_energy(c.nodes, c.mass, c.x, false, 1e-3, c.v), MomentumLost::none);
    EXPECT_LT((angular_momentum(c) - l).norm(), 1e-13);
}

void append(BodyDescription& body, const Vec3& size, const Index3& cells, const Vec3& place,
            bool clamped) {
    const TetMesh mesh = kuhn_brick(size, cells);
    const int offset = static_cast<int>(body.mesh.vertices_mm.size());
    for (const Vec3& x : mesh.vertices_mm) {
        body.mesh.vertices_mm.push_back(x + place);
        body.fixed.push_back(clamped && x[0] == 0.0);
    }
    for (const auto& t : mesh.tetrahedra)
        body.mesh.tetrahedra.push_back(
            {t[0] + offset, t[1] + offset, t[2] + offset, t[3] + offset});
}

// A whipping beam whose steps make energy, and beside it a brick that tumbles free. From every
// state the brick must go on as if it were alone in the world.
TEST(EnergyLimiter, OnePieceNeverBrakesAnother) {
    BodyDescription both, alone;
    append(both, Vec3(16, 8, 8), {2, 1, 1}, Vec3(500, 0, 0), false);
    alone = both;
    append(both, Vec3(60, 8, 8), {12, 2, 2}, Vec3::Zero(), true);
    both.material.damping_ratio = alone.material.damping_ratio = 0.0;
    const Body body = build_body(both, ElementModel::corotated, ElementOrder::linear);
    const Body brick = build_body(alone, ElementModel::corotated, ElementOrder::linear);
    const std::size_t nodes = brick.rest_positions_mm.size();
    PotentialList weight(body), weight_of_brick(brick);
    const Vec3 gravity(0, 0, -60.0 * units::standard_gravity);
    weight.set_gravity(gravity);
    weight_of_brick.set_gravity(gravity);
    const NewtonSettings settings{.linear = {.energy_tolerance = 1e-12}};
    BackwardEuler integrator(body, settings, make_block_jacobi_solver());
    BackwardEuler of_brick(brick, settings, make_block_jacobi_solver());
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    for (std::size_t i = 0; i < nodes; ++i)
        state.velocities_mm_per_s[i] =
            Vec3(0.5, 1.0, -0.7).cross(Vec3(state.positions_mm[i] - Vec3(508, 4, 4)));
    int limited = 0, compared = 0;
    for (int k = 0; k < 240; ++k) {
        BodyState own{
            {state.positions_mm.begin(), state.positions_mm.begin() + nodes},
            {state.velocities_mm_per_s.begin(), state.velocities_mm_per_s.begin() + nodes}};
        const StepReport report = integrator.advance(state, 1.0 / 240.0, weight);
        of_brick.forget();
        const StepReport own_report = of_brick.advance(own, 1.0 / 240.0, weight_of_brick);
        // Line search and prediction are one for all pieces: another step for the brick, too.
        if (report.shortened || report.newton_iterations > 1) continue;
        if (report.predicted != own_report.predicted) continue;
        ++compared;
        limited += report.energy.limiter_loss > 0.0;
        for (std::size_t i = 0; i < nodes; ++i)
            EXPECT_LT((state.velocities_mm_per_s[i] - own.velocities_mm_per_s[i]).norm(),
                      1e-8 * own.velocities_mm_per_s[i].norm())
                << "step " << k;
    }
    EXPECT_GT(limited, 0);
    EXPECT_GT(compared, 120);
}

// A vessel that rests beside one that is pulled has nothing but rounding errors, which are no
// energy that a step has made: nobody is told that the body was slowed down.
TEST(EnergyLimiter, APieceThatRestsIsLeftAlone) {
    BodyDescription two;
    append(two, Vec3(8, 8, 8), {1, 1, 1}, Vec3::Zero(), false);
    append(two, Vec3(8, 8, 8), {1, 1, 1}, Vec3(20, 0, 0), false);
    const Body body = build_body(two, ElementModel::corotated, ElementOrder::linear);
    const Assembly assembly(body);
    const EnergyLimiter limiter(body, assembly.plan());
    const PotentialList potentials(body);
    const std::vector<std::uint8_t> held(body.mass_g.size(), 0);
    const auto limited = [&](double speed_mm_per_s) {
        std::vector<Vec3> velocities(body.mass_g.size(), Vec3::Zero());
        for (std::size_t i = 0; i < 8; ++i)
            velocities[i] = speed_mm_per_s * (i % 2 == 0 ? Vec3::UnitX() : Vec3::UnitY());
        const double kinetic = kinetic_energy(body, velocities);
        const std::array<EnergyLimiter::Balance, 2> before{{{0.5 * kinetic, 0.5 * kinetic}, {}}};
        const std::array<EnergyLimiter::Balance, 2> after{{{kinetic, kinetic}, {}}};
        return limiter
            .limit({.before = before, .after = after}, potentials, body.rest_positions_mm, held,
                   velocities)
            .limited;
    };
    EXPECT_FALSE(limited(1e-9));
    EXPECT_TRUE(limited(1e-3));
}

// A single tetrahedron spins by two radians a step while a beam beside it is pulled so hard that
// all of it together loses more than the tetrahedron gains by being drawn out along its straight
// ways. It must neither store that energy nor lose its flight.
TEST(EnergyLimiter, APieceThatCannotPayForItsStepFliesOn) {
    for (const bool held : {false, true}) {
        BodyDescription two;
        append(two, Vec3(40, 8, 8), {8, 2, 2}, Vec3::Zero(), true);
        const int first = static_cast<int>(two.mesh.vertices_mm.size());
        for (const Vec3& x : {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3)}) {
            two.mesh.vertices_mm.push_back(x + Vec3(100, 0, 0));
            two.fixed.push_back(held && x.isZero(0.0));
        }
        two.mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
        two.material.damping_ratio = 0.0;
        const Body body = build_body(two, ElementModel::corotated, ElementOrder::linear);
        PotentialList pull(body);
        Grab grab{.vertices = {first - 1, -1, -1, -1}, .weights = {1, 0, 0, 0}};
        grab.target_mm = body.rest_positions_mm[first - 1] + Vec3(0, 30, 0);
        grab.stiffness_un_per_mm = 1e6;
        grab.force_limit_un = 1e9;
        pull.set_grabs(std::span(&grab, 1));
        const NewtonSettings settings{.linear = {.energy_tolerance = 1e-10}};
        BackwardEuler integrator(body, settings, make_block_jacobi_solver());
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        const Vec3 spin = Vec3(1, 2, 2) / 3.0 * 120.0;
        Vec3 momentum = Vec3::Zero();
        for (int i = first; i < first + 4; ++i) {
            const Vec3 from_pivot = state.positions_mm[i] - state.positions_mm[first];
            state.velocities_mm_per_s[i] = spin.cross(from_pivot) + Vec3(0, 0, held ? 0 : 40);
            momentum += body.mass_g[i] * state.velocities_mm_per_s[i];
        }
        double stored = -1.0;
        for (int k = 0; k < 30; ++k) {
            const StepReport report = integrator.advance(state, 1.0 / 60.0, pull);
            if (k > 0) {
                EXPECT_LE(stored_energy(report.energy), stored * (1.0 + 1e-9)) << "step " << k;
            }
            EXPECT_LT(std::abs(report.energy.imbalance), 1e-9 * energy_handled(report.energy));
            stored = stored_energy(report.energy);
            if (held) continue;
            Vec3 now = Vec3::Zero();
            for (int i = first; i < first + 4; ++i)
                now += body.mass_g[i] * state.velocities_mm_per_s[i];
            EXPECT_LT((now - momentum).norm(), 0.02 * momentum.norm()) << "step " << k;
        }
    }
}

// A grab that holds two pieces carries energy from one to the other: they count as one.
TEST(EnergyLimiter, PiecesThatShareAGrabAreJoined) {
    BodyDescription two;
    append(two, Vec3(8, 8, 8), {1, 1, 1}, Vec3::Zero(), false);
    append(two, Vec3(8, 8, 8), {1, 1, 1}, Vec3(20, 0, 0), false);
    append(two, Vec3(8, 8, 8), {1, 1, 1}, Vec3(40, 0, 0), false);
    const Body body = build_body(two, ElementModel::corotated, ElementOrder::linear);
    const Assembly assembly(body);
    const std::vector<int> piece = connected_pieces(assembly.plan());
    for (int i = 0; i < 24; ++i) EXPECT_EQ(piece[i], i / 8);
    PotentialList potentials(body);
    Grab grab{.vertices = {20, 3, -1, -1}, .weights = {0.5, 0.5, 0, 0}};
    grab.stiffness_un_per_mm = 1e3;
    grab.force_limit_un = 1e6;
    potentials.set_grabs(std::span(&grab, 1));
    DisjointSets joined(3);
    for (const auto& potential : potentials.all()) potential->join_pieces(piece, joined);
    EXPECT_EQ(joined.root(2), joined.root(0));
    EXPECT_NE(joined.root(1), joined.root(0));
}

}  // namespace
}  // namespace hepatica
