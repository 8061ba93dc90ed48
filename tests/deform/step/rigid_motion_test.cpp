// SPDX-License-Identifier: GPL-3.0-or-later
// Momentum, shape and energy of what flies on rigidly for a step.
#include "core/deform/step/rigid_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace hepatica {
namespace {

struct Swarm {
    std::vector<int> nodes;
    std::vector<double> mass;
    std::vector<Vec3> x, v;
};

Swarm random_swarm(std::uint64_t seed, int count) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0; };
    const auto vector = [&](double size) {
        const double a = uniform(), b = uniform(), c = uniform();
        return Vec3(size * a, size * b, size * c);
    };
    Swarm swarm;
    swarm.nodes.resize(static_cast<std::size_t>(count));
    std::iota(swarm.nodes.begin(), swarm.nodes.end(), 0);
    const Vec3 far = vector(300.0), flight = vector(50.0), spin = vector(100.0);
    for (int i = 0; i < count; ++i) {
        swarm.mass.push_back(1.5 + uniform());
        swarm.x.push_back(far + vector(4.0));
        swarm.v.push_back(flight + spin.cross(Vec3(swarm.x.back() - far)) + vector(5.0));
    }
    return swarm;
}

Vec3 momentum(const Swarm& s, const std::vector<Vec3>& v) {
    Vec3 sum = Vec3::Zero();
    for (const int i : s.nodes) sum += s.mass[i] * v[i];
    return sum;
}

double kinetic(const Swarm& s, const std::vector<Vec3>& v) {
    double sum = 0.0;
    for (const int i : s.nodes) sum += 0.5 * s.mass[i] * v[i].squaredNorm();
    return sum;
}

TEST(RigidMotion, HasTheMomentumAndNoMoreEnergyThanTheNodes) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Swarm s = random_swarm(seed, 3 + static_cast<int>(seed % 6));
        const RigidMotion rigid = rigid_motion(s.nodes, s.mass, s.x, s.v);
        std::vector<Vec3> carried;
        Vec3 spin = Vec3::Zero(), spin_carried = Vec3::Zero();
        for (const int i : s.nodes) {
            carried.push_back(rigid(s.x[i]));
            spin += s.mass[i] * (s.x[i] - rigid.centre_mm).cross(s.v[i]);
            spin_carried += s.mass[i] * (s.x[i] - rigid.centre_mm).cross(carried.back());
        }
        EXPECT_LT((momentum(s, carried) - momentum(s, s.v)).norm(), 1e-9);
        EXPECT_LT((spin_carried - spin).norm(), 1e-9 * spin.norm());
        EXPECT_NEAR(kinetic(s, carried), rigid.spin_energy_nj + rigid.flight_energy_nj,
                    1e-9 * kinetic(s, carried));
        EXPECT_LE(kinetic(s, carried), kinetic(s, s.v));
    }
}

// However fast it spins within a step, every distance stays.
TEST(RigidMotion, FliesOnInItsShapeWithItsMomentumAndNoMoreEnergy) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Swarm s = random_swarm(seed, 4 + static_cast<int>(seed % 5));
        const RigidMotion rigid = rigid_motion(s.nodes, s.mass, s.x, s.v);
        for (const double dt : {1e-4, 1.0 / 60.0, 0.1}) {
            const auto ways = straight_ways(rigid, s.nodes, s.x, dt);
            EXPECT_LT((momentum(s, ways) - momentum(s, s.v)).norm(), 1e-9);
            EXPECT_LE(kinetic(s, ways),
                      (1.0 + 1e-12) * (rigid.spin_energy_nj + rigid.flight_energy_nj));
            for (const int i : s.nodes)
                for (const int j : s.nodes) {
                    const Vec3 apart = s.x[i] - s.x[j];
                    EXPECT_NEAR((apart + dt * (ways[i] - ways[j])).norm(), apart.norm(), 1e-9);
                }
            if (dt > 1e-3) continue;  // a small turn is nearly the motion itself
            for (const int i : s.nodes)
                EXPECT_LT((ways[i] - rigid(s.x[i])).norm(),
                          0.6 * dt * rigid.spin_per_s.squaredNorm() * 8.0);
        }
    }
}

TEST(RigidMotion, TheCommonVelocityIsThatOfTheCentreOfMassUnlessSomethingIsHeld) {
    const Swarm s = random_swarm(3, 6);
    std::vector<std::uint8_t> held(6, 0);
    const auto common = common_velocity(s.mass, held, s.v);
    ASSERT_TRUE(common);
    EXPECT_LT((momentum(s, *common) - momentum(s, s.v)).norm(), 1e-9);
    for (const Vec3& v : *common) EXPECT_EQ(v, common->front());
    held[4] = 1;
    EXPECT_FALSE(common_velocity(s.mass, held, s.v));
}

}  // namespace
}  // namespace hepatica
