// SPDX-License-Identifier: GPL-3.0-or-later
// What a law, a cut line and a checkpoint may say, at their limits.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

// Places of all vertices, those of split ones where their origin is.
std::vector<Vec3> places_of_all(const TornTopology& topology, std::vector<Vec3> whole_mm) {
    for (int v = static_cast<int>(whole_mm.size()); v < topology.vertex_count(); ++v)
        whole_mm.push_back(Vec3(whole_mm[static_cast<std::size_t>(topology.parents()[v])]));
    return whole_mm;
}

TEST(TearLimits, OfTheLaw) {
    const auto with = [](auto change) {
        TearLaw law;
        change(law);
        validate(law);
    };
    EXPECT_NO_THROW(validate(TearLaw{}));
    for (const double wrong : {0.0, -1.0, std::nan(""), -HUGE_VAL}) {
        EXPECT_THROW(with([&](TearLaw& l) { l.strength_pa = wrong; }), InputError) << wrong;
        EXPECT_THROW(with([&](TearLaw& l) { l.fracture_energy_j_m2 = wrong; }), InputError);
        EXPECT_THROW(with([&](TearLaw& l) { l.tear_factor = wrong; }), InputError) << wrong;
    }
    EXPECT_THROW(with([](TearLaw& l) { l.strength_pa = HUGE_VAL; }), InputError);
    EXPECT_THROW(with([](TearLaw& l) { l.fracture_energy_j_m2 = HUGE_VAL; }), InputError);
    EXPECT_NO_THROW(with([](TearLaw& l) { l.tear_factor = 1e-300; }));
    EXPECT_NO_THROW(with([](TearLaw& l) { l.strength_pa = 1e-300; }));
    EXPECT_NO_THROW(with([](TearLaw& l) { l.fracture_energy_j_m2 = 1e-300; }));
    EXPECT_NO_THROW(with([](TearLaw& l) { l.entropy_budget_nats = 0.0; }));
    EXPECT_THROW(with([](TearLaw& l) { l.entropy_budget_nats = -1e-300; }), InputError);
    EXPECT_NO_THROW(with([](TearLaw& l) { l.vertex_budget = 0; }));
    EXPECT_THROW(with([](TearLaw& l) { l.vertex_budget = -1; }), InputError);
}

TEST(TearLimits, OfTheStrengthAlongACutLine) {
    const TetMesh mesh = kuhn_brick(Vec3(2, 1, 1), {2, 1, 1});
    Tearing tearing(mesh, {}, {});
    const int last = static_cast<int>(tearing.topology().joints().size()) - 1;
    for (const double wrong : {-1e-300, std::nan(""), HUGE_VAL})
        EXPECT_THROW(tearing.weaken(std::vector{0}, wrong), InputError) << wrong;
    try {
        tearing.weaken(std::vector{0}, -1e-9);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "is -1e-09");
    }
    EXPECT_THROW(tearing.weaken(std::vector{-1}, 0.5), InputError);
    EXPECT_THROW(tearing.weaken(std::vector{last + 1}, 0.5), InputError);
    tearing.weaken(std::vector{0, last}, 0.5);
    tearing.weaken(std::vector{last}, 0.5);
    EXPECT_EQ(tearing.state().weakened, (std::vector{0, last}));
    EXPECT_EQ(tearing.state().weakness, (std::vector{0.5, 0.25}));
    tearing.weaken(std::vector{0}, 0.0);
    EXPECT_EQ(tearing.state().weakness, (std::vector{0.0, 0.25}));
    // What has parted bears nothing that could be weakened.
    tearing.cut(std::vector{1});
    tearing.weaken(std::vector{1}, 0.5);
    EXPECT_EQ(tearing.state().weakened, (std::vector{0, last}));
}

// A joint whose load is its limit parts, and none below it; without neighbours, which would part
// with it.
TEST(TearLimits, AJointPartsAtItsLimitAndNotBelow) {
    const TetMesh mesh = kuhn_brick(Vec3(1, 1, 1), {1, 1, 1});
    const TearLaw law{.strength_pa = 1024.0, .fracture_energy_j_m2 = 1.0, .bare_limit = true};
    for (const double share : {1.0, 0.999}) {
        Tearing tearing(mesh, law, {});
        const std::size_t count = mesh.tetrahedra.size();
        const std::vector<Mat3> stress(count, Mat3(share * 1024.0 * Mat3::Identity()));
        const std::vector<double> energy(count, 1.0), mass(mesh.vertices_mm.size(), 1.0);
        std::vector<double> load;
        tearing.find_loads({stress, energy, mesh.vertices_mm, mass}, 0.0, load);
        ASSERT_EQ(load.size(), tearing.topology().joints().size());
        for (const double value : load) EXPECT_NEAR(value, share, 1e-12);
        // Rounding decides at the limit itself: a hair above it all part.
        const std::vector<Mat3> more(count, Mat3((share + 1e-9) * 1024.0 * Mat3::Identity()));
        EXPECT_EQ(tearing.part_overloaded({more, energy, mesh.vertices_mm, mass}), share == 1.0);
        EXPECT_EQ(tearing.report().joints_parted, share == 1.0 ? static_cast<int>(load.size()) : 0);
    }
}

// However much is overloaded at once, no more is split off than the budget has.
TEST(TearLimits, NoTransactionGoesBeyondTheBudgetOfVertices) {
    const TetMesh mesh = kuhn_brick(Vec3(4, 3, 3), {4, 3, 3});
    const std::size_t count = mesh.tetrahedra.size();
    const std::vector<Mat3> stress(count, Mat3(1e9 * Mat3::Identity()));
    const std::vector<double> energy(count, 1e12), mass(mesh.vertices_mm.size(), 1.0);
    for (const bool bare : {true, false})
        for (const int budget : {0, 1, 2, 7, 20}) {
            Tearing tearing(mesh,
                            {.strength_pa = 1e3,
                             .bare_limit = bare,
                             .stop = TearStop::vertices,
                             .vertex_budget = budget},
                            {});
            for (int k = 0; k < 30; ++k) {
                std::vector<Vec3> at = mesh.vertices_mm;
                for (std::size_t v = at.size(); v < tearing.topology().parents().size(); ++v)
                    at.push_back(at[static_cast<std::size_t>(tearing.topology().parents()[v])]);
                const std::vector<double> masses(at.size(), 1.0);
                const TearLoads loads{stress, energy, at, masses};
                tearing.measure(loads);
                tearing.part_overloaded(loads);
                ASSERT_LE(tearing.report().vertices_split, budget) << bare << " " << k;
            }
            EXPECT_TRUE(tearing.report().stopped) << bare << " " << budget;
            EXPECT_GE(tearing.report().vertices_split, budget - 2) << "nor much less";
        }
}

// A budget of n vertices is used up by the n-th; one of entropy by what exceeds it.
TEST(TearLimits, OfTheBudgets) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    const std::vector<double> energy(mesh.tetrahedra.size(), 1.0);
    const std::vector<Mat3> stress(mesh.tetrahedra.size(), Mat3(Mat3::Zero()));
    const auto stopped_with = [&](TearLaw law) {
        Tearing tearing(mesh, law, {});
        tearing.measure({stress, energy, mesh.vertices_mm, {}});
        tearing.cut(
            tearing.crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3), mesh.vertices_mm));
        EXPECT_EQ(tearing.report().vertices_split, 4);
        EXPECT_EQ(tearing.report().pieces, 2);
        tearing.measure({stress, energy, mesh.vertices_mm, {}});
        EXPECT_EQ(tearing.state().stopped, tearing.report().stopped);
        return tearing.report().stopped;
    };
    EXPECT_TRUE(stopped_with({.stop = TearStop::vertices, .vertex_budget = 4}));
    EXPECT_FALSE(stopped_with({.stop = TearStop::vertices, .vertex_budget = 5}));
    EXPECT_FALSE(stopped_with({.vertex_budget = 0}));
    EXPECT_TRUE(stopped_with({.stop = TearStop::entropy, .entropy_budget_nats = 0.0}));
    EXPECT_FALSE(stopped_with({.stop = TearStop::entropy, .entropy_budget_nats = 10.0}));
}

TEST(TearLimits, OfACheckpoint) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    Tearing tearing(mesh, {}, {});
    tearing.weaken(std::vector{2, 3}, 0.5);
    tearing.cut(
        tearing.crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3), mesh.vertices_mm));
    const TearState good = tearing.state();
    ASSERT_GT(good.parted.size(), 1u);
    ASSERT_GT(good.tetrahedra.size(), 1u);
    const auto refused = [&](const char* what, auto change) {
        TearState state = good;
        change(state);
        Tearing other(mesh, {}, {});
        EXPECT_THROW(other.restore(state), InputError) << what;
        EXPECT_EQ(other.report().joints_parted, 0) << what;
    };
    Tearing other(mesh, {}, {});
    EXPECT_NO_THROW(other.restore(good));
    EXPECT_EQ(other.report(), tearing.report());
    const int joints = static_cast<int>(tearing.topology().joints().size());
    refused("a corner too few", [](TearState& s) { s.corners.pop_back(); });
    refused("an opening too few", [](TearState& s) { s.most_mm.pop_back(); });
    refused("a factor too few", [](TearState& s) { s.weakness.pop_back(); });
    refused("order of tetrahedra", [](TearState& s) { s.tetrahedra[1] = s.tetrahedra[0]; });
    refused("a tetrahedron too far",
            [&](TearState& s) { s.tetrahedra.back() = static_cast<int>(mesh.tetrahedra.size()); });
    refused("order of joints", [](TearState& s) { s.parted[1] = s.parted[0]; });
    refused("a joint too far", [&](TearState& s) { s.parted.back() = joints; });
    refused("a joint below 0", [&](TearState& s) { s.parted.front() = -1; });
    refused("a weak joint too far", [&](TearState& s) { s.weakened.back() = joints; });
    refused("order of weak joints", [](TearState& s) { s.weakened[1] = s.weakened[0]; });
    refused("an opening below 0", [](TearState& s) { s.most_mm[1] = -1e-9; });
    refused("an opening of no number", [](TearState& s) { s.most_mm[1] = std::nan(""); });
    refused("a factor below 0", [](TearState& s) { s.weakness[1] = -1e-9; });
}

// Along a line of strength 0 nothing binds what has parted: it has come apart at once.
TEST(TearLimits, WhatBearsNothingIsBroken) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    Tearing tearing(mesh, {}, {});
    const auto line =
        tearing.crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3), mesh.vertices_mm);
    tearing.weaken(line, 0.0);
    const std::vector<Mat3> stress(mesh.tetrahedra.size(), Mat3(10.0 * Mat3::Identity()));
    const std::vector<double> energy(stress.size(), 1.0), mass(mesh.vertices_mm.size(), 1.0);
    ASSERT_TRUE(tearing.part_overloaded({stress, energy, mesh.vertices_mm, mass}));
    ASSERT_EQ(tearing.report().pieces, 2);
    EXPECT_EQ(tearing.report().joints_broken, static_cast<int>(line.size()));
    EXPECT_TRUE(tearing
                    .crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3),
                              places_of_all(tearing.topology(), mesh.vertices_mm))
                    .empty());
}

TEST(TearLimits, LoadsAreToldWhereAJointIsNearItsLimit) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    Tearing tearing(mesh, {.strength_pa = 1000.0}, {});
    const std::vector<double> energy(mesh.tetrahedra.size(), 1.0),
        mass(mesh.vertices_mm.size(), 1.0);
    const auto told = [&](double pull_pa) {
        const std::vector<Mat3> stress(energy.size(), Mat3(pull_pa * Mat3::Identity()));
        EXPECT_FALSE(tearing.part_overloaded({stress, energy, mesh.vertices_mm, mass}));
        return tearing.loads().size();
    };
    const std::size_t joints = tearing.topology().joints().size();
    EXPECT_EQ(told(490.0), 0u);
    EXPECT_EQ(told(510.0), joints);
    EXPECT_EQ(told(490.0), 0u);
    EXPECT_EQ(told(510.0), joints);
    tearing.restore({});
    EXPECT_EQ(tearing.loads().size(), 0u);
}

TEST(TearLimits, WhatIsWeakenedIsKnownWhoeverWeakenedIt) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    Tearing tearing(mesh, {}, {}), other(mesh, {}, {});
    EXPECT_TRUE(tearing.weakened().empty());
    tearing.weaken(std::array{2, 5}, 0.5);
    EXPECT_EQ(tearing.weakened(), (std::vector<int>{2, 5}));
    other.restore(tearing.state());
    EXPECT_EQ(other.weakened(), (std::vector<int>{2, 5}));
    other.restore({});
    EXPECT_TRUE(other.weakened().empty());
}

// What is shown between a cut and the next step.
TEST(TearLimits, WhatABladePartsHasNoLoad) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    Tearing tearing(mesh, {.strength_pa = 1000.0}, {});
    const std::vector<Mat3> stress(mesh.tetrahedra.size(), Mat3(700.0 * Mat3::Identity()));
    const std::vector<double> energy(stress.size(), 1.0), mass(mesh.vertices_mm.size(), 1.0);
    ASSERT_FALSE(tearing.part_overloaded({stress, energy, mesh.vertices_mm, mass}));
    const auto line =
        tearing.crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3), mesh.vertices_mm);
    ASSERT_FALSE(line.empty());
    for (const int j : line) ASSERT_NEAR(tearing.loads()[j], 0.7, 1e-12);
    tearing.cut(line);
    ASSERT_EQ(tearing.loads().size(), tearing.topology().joints().size());
    for (std::size_t j = 0; j < tearing.loads().size(); ++j) {
        if (tearing.topology().parted(static_cast<int>(j)))
            EXPECT_EQ(tearing.loads()[j], 0.0) << j;
        else
            EXPECT_NEAR(tearing.loads()[j], 0.7, 1e-12) << j;
    }
}

TEST(TearLimits, ALawWithoutAStopGoesOnWithWhatAnotherStopped) {
    const TetMesh mesh = kuhn_brick(Vec3(3, 1, 1), {3, 1, 1});
    const std::vector<double> energy(mesh.tetrahedra.size(), 1.0), mass(64, 1.0);
    const std::vector<Mat3> still(mesh.tetrahedra.size(), Mat3(Mat3::Zero())),
        torn(mesh.tetrahedra.size(), Mat3(1e9 * Mat3::Identity()));
    Tearing stops(mesh, {.stop = TearStop::vertices, .vertex_budget = 1}, {}),
        goes_on(mesh, {}, {});
    stops.cut(stops.crossing(Vec3(1.0, -1, -1), Vec3(0, 3, 0), Vec3(0, 0, 3), mesh.vertices_mm));
    const auto cut_mm = places_of_all(stops.topology(), mesh.vertices_mm);
    stops.measure({still, energy, cut_mm, mass});
    ASSERT_TRUE(stops.report().stopped);
    goes_on.restore(stops.state());
    EXPECT_FALSE(goes_on.report().stopped);
    EXPECT_TRUE(goes_on.part_overloaded({torn, energy, cut_mm, mass}));
}

}  // namespace
}  // namespace hepatica
