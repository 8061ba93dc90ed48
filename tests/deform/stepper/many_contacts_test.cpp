// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that touch each other in hundreds of places: solved by the factor that knows them, with
// what a step promises anywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "tests/deform/support/resumed_play.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

// A block of so many cells across above a slab, beside whose vertices its own lie.
BodyDescription block_on_slab(int across, double friction = 0.0) {
    BodyDescription body;
    test::add_mesh(test::bar_at(Vec3(20, 20, 4), {10, 10, 2}, Mat3::Identity(), Vec3(0, 0, -2)),
                   body.mesh);
    test::add_mesh(test::bar_at(Vec3(2.0 * across, 2.0 * across, 4), {across, across, 2},
                                test::about_z(0.05), Vec3(0.31, 0.17, 2.05)),
                   body.mesh);
    body.material.young_modulus_pa = 2e4;
    body.self.emplace().friction = friction;
    return body;
}

BodyDescription block_on_held_slab(int across, double friction = 0.0) {
    BodyDescription body = block_on_slab(across, friction);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < -3.9);
    return body;
}

const Vec3 weight(0, 0, -units::standard_gravity);

// The block slides over the slab under its weight, so that contacts come and go.
void slide(Stepper& stepper, int k) {
    stepper.set_gravity(weight + Vec3(4000.0 * std::sin(0.2 * k), 1500.0 * std::cos(0.13 * k), 0));
}

TEST(ManyContacts, TakeNoMoreIterationsThanFew) {
    for (const int across : {3, 5, 8}) {
        const auto stepper = make_cpu_stepper(block_on_held_slab(across), {.sleeping = false});
        stepper->set_gravity(weight);
        for (int k = 0; k < 20; ++k) stepper->step(frame_s);
        int iterations = 0, solves = 0, contacts = 0;
        for (int k = 0; k < 10; ++k) {
            const StepReport report = stepper->step(frame_s);
            iterations += report.linear_iterations;
            solves += report.linear_solves;
            contacts = report.self.contacts;
            EXPECT_GT(report.self.least_gap_mm, 0.0);
        }
        EXPECT_GT(contacts, 3 * across * across);
        EXPECT_LE(iterations, 8 * solves) << contacts;
    }
}

TEST(ManyContacts, KeepMomentumAndMakeNoEnergy) {
    BodyDescription bodies = block_on_slab(6);
    bodies.material.damping_ratio = 0.0;
    const Body body = build_body(bodies, ElementModel::corotated, ElementOrder::linear);
    const auto stepper =
        make_cpu_stepper(bodies, {.linear = {.energy_tolerance = 1e-10}, .sleeping = false});
    std::vector<Vec3> v(body.mass_g.size(), Vec3::Zero());
    for (std::size_t i = 11 * 11 * 3; i < v.size(); ++i) v[i] = Vec3(20, 10, -200);
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < v.size(); ++i)
            sum += body.mass_g[i] * stepper->velocities_mm_per_s()[i];
        return sum;
    };
    stepper->set_state(body.rest_positions_mm, v);
    const Vec3 begin = momentum();
    double energy = stored_energy(stepper->energies());
    int most = 0;
    for (int k = 0; k < 12; ++k) {
        const StepReport report = stepper->step(frame_s);
        most = std::max(most, report.self.contacts);
        EXPECT_GT(report.self.least_gap_mm, 0.0);
        EXPECT_LT((momentum() - begin).norm(), 1e-10 * begin.norm()) << k;
        EXPECT_LE(stored_energy(report.energy), energy * (1 + 1e-9)) << k;
        energy = stored_energy(report.energy);
    }
    EXPECT_GT(most, 100);
}

TEST(ManyContacts, GiveTheSameBitsForAnyNumberOfThreads) {
    const BodyDescription body = block_on_held_slab(6);
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto stepper = make_cpu_stepper(body, {});
        std::uint64_t all = 0;
        for (int k = 0; k < 30; ++k) {
            slide(*stepper, k);
            stepper->step(frame_s);
            all = 31 * all + stepper->state_hash();
        }
        EXPECT_FALSE(stepper->checkpoint().solver.coupled.pairs.empty());
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

class ManyContactsCheckpointTest : public testing::TestWithParam<bool> {};

// Through bytes, at moments at which the pattern is of some step before.
TEST_P(ManyContactsCheckpointTest, ARestoredStepperGoesOnToTheLastBit) {
    BodyDescription body = block_on_held_slab(6, 0.1);
    if (GetParam()) body.tether_pa_per_mm2 = 5.0;
    const auto make = [&]() -> std::unique_ptr<Stepper> {
        if (GetParam()) return make_live_stepper(body, {});
        return make_cpu_stepper(body, {});
    };
    const auto step = [](Stepper& stepper, int k) {
        slide(stepper, k);
        stepper.step(frame_s);
    };
    for (const int kept_at : {0, 7, 16}) {
        const StepperCheckpoint kept = test::expect_same_bits_from(kept_at, 30, make, step);
        EXPECT_EQ(kept.solver.coupled.pairs.empty(), kept_at == 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Region, ManyContactsCheckpointTest, testing::Bool());

}  // namespace
}  // namespace hepatica
