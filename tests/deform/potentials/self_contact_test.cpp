// SPDX-License-Identifier: GPL-3.0-or-later
// What the pad between surfaces promises: forces that are the gradient of its energy, in pairs
// without sum or torque; its law in closed form; a stiffness that is that of the force; nothing at
// rest; and motions that end before anything passes.
#include "core/deform/potentials/self_contact.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/base/parallel.h"
#include "core/deform/potentials/pad_pair.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::crossed_bars;
using test::random_field;

Body built(const BodyDescription& description) {
    return build_body(description, ElementModel::corotated, ElementOrder::linear);
}

// Pressed together by two fifths of the pad, and a little shaken. Parallel bars have parallel
// edges, too.
class SelfContactTest : public testing::TestWithParam<double> {
  protected:
    SelfContactTest() : body_(built(crossed_bars(1.0, GetParam()))), contact_(body_) {
        x_ = body_.rest_positions_mm;
        const auto noise = random_field(x_.size(), 0.1 * body_.self_pad->thickness_mm, 3);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            x_[i] += noise[i];
            if (i >= x_.size() / 2) x_[i].z() -= 1.0 - 0.6 * body_.self_pad->thickness_mm;
        }
    }
    std::vector<Vec3> forces() const {
        std::vector<Vec3> force(x_.size(), Vec3::Zero());
        contact_.add_forces(x_, force);
        return force;
    }

    Body body_;
    SelfContact contact_;
    std::vector<Vec3> x_;
};

// A hundredth of the force too much would be seen a thousandfold.
TEST_P(SelfContactTest, ForcesAreTheGradientOfTheEnergy) {
    const std::vector<Vec3> force = forces();
    double size = 0.0, error = 0.0;
    for (const Vec3& f : force) size = std::max(size, f.norm());
    ASSERT_GT(size, 0.0);
    ASSERT_GT(contact_.contacts(x_).size(), 10u);
    constexpr double h = 1e-5;
    std::vector<Vec3> x = x_;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            x[i][c] = x_[i][c] + h;
            const double above = contact_.energy(x, x);
            x[i][c] = x_[i][c] - h;
            const double below = contact_.energy(x, x);
            x[i][c] = x_[i][c];
            error = std::max(error, std::abs(force[i][c] + (above - below) / (2 * h)) / size);
        }
    EXPECT_LT(error, 1e-5);
}

TEST_P(SelfContactTest, ForcesAreEqualOppositeAndInOneLine) {
    const std::vector<Vec3> force = forces();
    Vec3 sum = Vec3::Zero(), torque = Vec3::Zero(), on_upper = Vec3::Zero();
    double size = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        sum += force[i];
        torque += x_[i].cross(force[i]);
        size += force[i].norm();
        if (i >= x_.size() / 2) on_upper += force[i];
    }
    EXPECT_LT(sum.norm(), 1e-12 * size);
    EXPECT_LT(torque.norm(), 1e-11 * size);
    EXPECT_GT(on_upper.z(), 0.1 * size);  // it pushes them apart
}

// Exact where normal and nearest points stay: along the normal of each contact.
TEST_P(SelfContactTest, StiffnessAndCouplingMakeThatOfEveryContact) {
    const auto d = random_field(x_.size(), 1.0, 5);
    BlockMatrix matrix;
    Assembly(body_).gather_stiffness(0.0, matrix);
    contact_.add_stiffness(x_, 2.0, matrix);
    std::vector<Vec3> product, beside(x_.size(), Vec3::Zero()), within = beside;
    multiply(matrix, d, product);
    contact_.add_product(x_, 2.0, d, matrix, within);
    contact_.add_coupling(x_, 2.0, d, beside);
    EXPECT_NEAR(dot(d, product), dot(d, within), 1e-9 * dot(d, product));
    double exact = 0.0;
    for (const SurfaceContact& contact : contact_.contacts(x_))
        exact += 2.0 * contact.stiffness_un_per_mm *
                 std::pow(contact.normal.dot(contact.at.between(d)), 2);
    EXPECT_NEAR(dot(d, within) + dot(d, beside), exact, 1e-9 * exact);
    EXPECT_LE(exact, 2.0 * dot(d, within));  // what coupled_solve.h says
    // Where all goes along, nothing resists.
    const std::vector<Vec3> along(x_.size(), Vec3(1, 2, 3));
    std::ranges::fill(within, Vec3::Zero());
    contact_.add_product(x_, 1.0, along, matrix, within);
    contact_.add_coupling(x_, 1.0, along, within);
    for (const Vec3& value : within) EXPECT_LT(value.norm(), 1e-9 * exact);
}

INSTANTIATE_TEST_SUITE_P(CrossedAndParallel, SelfContactTest, testing::Values(1.4, 0.02, 0.0));

// A corner above a wide face: one vertex and one triangle, and edges far away.
TEST(SelfContact, ThePadsLawInClosedForm) {
    BodyDescription d;
    d.mesh.vertices_mm = {Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 15, 0), Vec3(0, 0, -9),
                          Vec3(0, 0, 1),   Vec3(3, 0, 9),  Vec3(-2, 3, 9), Vec3(-2, -3, 9)};
    d.mesh.tetrahedra = {{0, 2, 1, 3}, {4, 5, 6, 7}};
    d.self.emplace();
    Body body = built(d);
    body.self_pad = {0.4, 1000.0};  // half the distance at rest is more
    const SelfContact contact(body);
    double area = 0.0;
    for (const auto& triangle : body.touching_surface) {
        const Triangle c = corners_of(triangle, body.rest_positions_mm);
        for (const int node : triangle)
            if (node == 4) area += (c[1] - c[0]).cross(c[2] - c[0]).norm() / 6.0;
    }
    for (const double pressed : {0.1, 0.5, 0.9}) {
        std::vector<Vec3> x = body.rest_positions_mm;
        for (int v = 4; v < 8; ++v) x[v].z() += 0.4 * (1.0 - pressed) - 1.0;
        std::vector<Vec3> force(x.size(), Vec3::Zero());
        contact.add_forces(x, force);
        const double expected = 0.5 * area * 1000.0 * pressed / (1.0 - pressed);
        EXPECT_NEAR(force[4].z(), expected, 1e-9 * expected);
        EXPECT_NEAR(contact.energy(x, x),
                    0.5 * area * 1000.0 * 0.4 * (-pressed - std::log(1.0 - pressed)), 1e-9);
        // Of that force by the gap.
        std::vector<Vec3> upwards(x.size(), Vec3::Zero()), product = upwards;
        for (int v = 4; v < 8; ++v) upwards[v].z() = 1.0;
        contact.add_product(x, 1.0, upwards, BlockMatrix(), product);
        const double stiffness = 0.5 * area * 1000.0 / (0.4 * (1.0 - pressed) * (1.0 - pressed));
        EXPECT_NEAR(product[4].z(), stiffness, 1e-9 * stiffness);
        EXPECT_EQ(load_of(contact.contacts(x)).contacts, 1);
        EXPECT_NEAR(load_of(contact.contacts(x)).least_gap_mm, 0.4 * (1.0 - pressed), 1e-12);
    }
}

TEST(SelfContact, IsEmptyAtRestAndWhereItFliesAsAWhole) {
    const Body body = built(crossed_bars(0.02));  // within a pad of each other
    const SelfContact contact(body);
    EXPECT_TRUE(contact.contacts(body.rest_positions_mm).empty());
    EXPECT_FALSE(contact.pairs().overlaps().any());
    std::vector<Vec3> moved = body.rest_positions_mm;
    for (Vec3& x : moved) x = test::about_z(0.7) * x + Vec3(500, -300, 40);
    EXPECT_TRUE(contact.contacts(moved).empty());
    for (Vec3& x : moved) x += Vec3(500, -300, 40);
    EXPECT_EQ(contact.free_share(body.rest_positions_mm, body.rest_positions_mm), 1.0);
    // The upper one goes down.
    moved = body.rest_positions_mm;
    for (std::size_t i = moved.size() / 2; i < moved.size(); ++i) moved[i].z() -= 0.019;
    EXPECT_GT(load_of(contact.contacts(moved)).contacts, 0);
}

// By 0.01 to 1000 mm a step, from above, aside and askew: what is left of a motion leaves a tenth
// of the gap.
TEST(SelfContact, MotionsEndBeforeAnythingPasses) {
    const Body body = built(crossed_bars(2.0));
    const SelfContact contact(body);
    const std::size_t half = body.rest_positions_mm.size() / 2;
    for (const double size : {0.01, 1.0, 3.0, 30.0, 1000.0})
        for (const Vec3& way : {Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0.3, 0.2, -0.9)}) {
            std::vector<Vec3> to = body.rest_positions_mm;
            for (std::size_t i = half; i < to.size(); ++i) to[i] += size * way;
            const double share = contact.free_share(body.rest_positions_mm, to);
            const double down = -way.z() * size;
            EXPECT_EQ(share == 1.0, down < 1.7) << size << " " << way.transpose();
            EXPECT_LT(share * down, 2.0) << size << " " << way.transpose();
            for (std::size_t i = half; i < to.size(); ++i)
                to[i] = body.rest_positions_mm[i] + share * size * way;
            const SelfLoad load = load_of(contact.contacts(to));
            EXPECT_TRUE(share == 1.0 || (share * down > 1.5 && load.least_gap_mm > 0.0));
            EXPECT_TRUE(std::isfinite(contact.energy(to, to)));
        }
}

// The search may be of another motion, or there may have been none before.
TEST(SelfContact, AnswersDoNotDependOnWhatWasAskedBefore) {
    const Body body = built(crossed_bars(0.5));
    const SelfContact often(body);
    for (int k = 0; k < 40; ++k) {
        std::vector<Vec3> x = body.rest_positions_mm;
        const auto noise = random_field(x.size(), 0.05, 100 + k);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += noise[i];
            if (i >= x.size() / 2) x[i].z() -= 0.011 * k;
        }
        const SelfContact fresh(body);
        const auto& expected = fresh.contacts(x);
        const auto& found = often.contacts(x);
        ASSERT_EQ(found.size(), expected.size()) << k;
        EXPECT_EQ(often.energy(x, x), fresh.energy(x, x));
        EXPECT_EQ(often.free_share(body.rest_positions_mm, x),
                  fresh.free_share(body.rest_positions_mm, x));
    }
}

// Whoever asks in whatever order gets the answers of one who was never asked before: contacts,
// shares of motions and what may be touched, to the last bit. In some places the bars cross.
TEST(SelfContact, AnswersDoNotDependOnQuestionsBefore) {
    const Body body = built(crossed_bars(1.0, 1.4));
    const SelfContact asked(body);
    const double pad = body.self_pad->thickness_mm;
    std::mt19937 random(21);
    std::uniform_real_distribution<double> in(0.0, 1.0);
    std::vector<std::vector<Vec3>> places;
    const auto add_place = [&] {
        std::vector<Vec3> x = body.rest_positions_mm;
        const auto number = static_cast<unsigned>(places.size());
        const auto noise = random_field(x.size(), 0.2 * in(random)*pad, number);
        const double drop = 1.0 - pad * (0.3 * number - 0.5), away = number == 5 ? 3.0 : 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += noise[i];
            if (i >= x.size() / 2) x[i] += Vec3(0.02 * in(random), away, away - drop);
        }
        places.push_back(std::move(x));
    };
    for (int k = 0; k < 8; ++k) add_place();
    const auto any = [&] { return static_cast<std::size_t>(in(random)*7.999); };
    std::size_t touching = 0, stopped = 0;
    for (int question = 0; question < 300; ++question) {
        const std::vector<Vec3>&from = places[any()], &to = places[any()];
        const SelfContact fresh(body);
        switch (question % 4) {
            case 0: {
                const double share = fresh.free_share(from, to);
                EXPECT_EQ(asked.free_share(from, to), share) << question;
                stopped += share < 1.0 ? 1 : 0;
                break;
            }
            case 1:
                EXPECT_EQ(asked.share_until_touch(from, to), fresh.share_until_touch(from, to))
                    << question;
                break;
            case 2:
                EXPECT_EQ(asked.contacts(to).size(), fresh.contacts(to).size()) << question;
                EXPECT_EQ(asked.energy(to, to), fresh.energy(to, to)) << question;
                touching += fresh.contacts(to).size();
                break;
            default: {
                std::vector<PadPair> list, expected;
                asked.pairs().list_touches(from, to, list);
                fresh.pairs().list_touches(from, to, expected);
                ASSERT_EQ(list.size(), expected.size()) << question;
                for (std::size_t k = 0; k < list.size(); ++k) {
                    EXPECT_TRUE(std::ranges::equal(list[k].nodes, expected[k].nodes)) << question;
                    EXPECT_EQ(list[k].pad_mm, expected[k].pad_mm) << question;
                }
            }
        }
    }
    EXPECT_GT(touching, 100u);
    EXPECT_GT(stopped, 10u);
}

TEST(SelfContact, WhatFliesByIsNotStoppedHoweverFarItComesFrom) {
    BodyDescription description = crossed_bars(0.5);
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& x : description.mesh.vertices_mm) x = turn * x;
    const Body body = built(description);
    for (const double way : {50.0, 166.0, 600.0, 1700.0}) {
        const SelfContact contact(body);
        std::vector<Vec3> from = body.rest_positions_mm, to = from;
        for (std::size_t i = from.size() / 2; i < from.size(); ++i) {
            from[i] -= turn * Vec3(0.5 * way, 0, 0);
            to[i] += turn * Vec3(0.5 * way, 0, 0);
        }
        EXPECT_EQ(contact.free_share(from, to), 1.0) << way;
    }
}

// Parallel edges have no pad, but where two overlap the gap is closed all the same.
TEST(SelfContact, TheEnergyOfEdgesThatOverlapIsInfinite) {
    const small::Vector3<double> edges[4] = {
        {{0, 0, 0}}, {{1, 0, 0}}, {{0.2, 0, 0}}, {{0.8, 0, 0}}};
    const PadPair pair{.nodes = {0, 1, 2, 3},
                       .in_first = 2,
                       .pad_mm = 0.1,
                       .strength_un = 1.0,
                       .parallel_mm4 = 0.01};
    const PairPull pull = pull_of(pair, nearest_points(2, edges), edges);
    EXPECT_TRUE(std::isinf(pull.pad.energy_nj));
    EXPECT_EQ(small::squared_length(pull.turning_first_un), 0.0);
}

}  // namespace
}  // namespace hepatica
