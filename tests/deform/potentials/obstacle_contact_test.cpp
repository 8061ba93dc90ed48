// SPDX-License-Identifier: GPL-3.0-or-later
// The pad on obstacles: forces that are the gradient of its energy, equal and opposite to what the
// obstacle feels; a stiffness within the matrix' pattern; and which surfaces are refused.
#include "core/deform/potentials/obstacle_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/obstacle_shapes.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

using test::ball_surface;
using test::box_surface;
using test::one_obstacle;

// A bar that lies on something, pressed into its pad by two fifths and a little shaken.
class ObstacleContactTest : public testing::TestWithParam<bool> {
  protected:
    static TriangleMesh ground() {
        return GetParam() ? ball_surface(Vec3(6.1, 2.2, -5.0), 5.0)
                          : box_surface(Vec3(-3, -3, -4), Vec3(20, 11, 4), {7, 4, 2});
    }
    static Body body_on(const TriangleMesh& surface) {
        BodyDescription bar;
        bar.mesh = kuhn_brick(Vec3(12, 4, 4), {6, 2, 2});
        for (Vec3& x : bar.mesh.vertices_mm) x.z() += 1.0;
        bar.obstacles = one_obstacle(surface);
        return build_body(bar, ElementModel::corotated, ElementOrder::linear);
    }
    ObstacleContactTest() : body_(body_on(ground())), contact_(body_) {
        const double pad = body_.obstacle_pad.thickness_mm;
        x_ = body_.rest_positions_mm;
        const auto noise = test::random_field(x_.size(), 0.1 * pad, 3);
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += noise[i] - Vec3(0, 0, 1 - 0.6 * pad);
    }

    Body body_;
    ObstacleContact contact_;
    std::vector<Vec3> x_;
};

TEST_P(ObstacleContactTest, ForcesAreTheGradientOfTheEnergy) {
    std::vector<Vec3> force(x_.size(), Vec3::Zero());
    contact_.add_forces(x_, force);
    ASSERT_GT(contact_.contacts(x_).size(), GetParam() ? 0u : 10u);
    double size = 0.0, error = 0.0;
    for (const Vec3& f : force) size = std::max(size, f.norm());
    ASSERT_GT(size, 0.0);
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

// What the obstacle feels is how the energy changes where it is moved instead of the body.
TEST_P(ObstacleContactTest, TheForceOnTheObstacleIsEqualAndOpposite) {
    std::vector<Vec3> force(x_.size(), Vec3::Zero());
    contact_.add_forces(x_, force);
    Vec3 on_body = Vec3::Zero();
    for (const Vec3& f : force) on_body += f;
    Vec3 on_obstacle = Vec3::Zero();
    constexpr double h = 1e-6;
    for (int c = 0; c < 3; ++c) {
        const auto energy_moved_by = [&](double by) {
            TriangleMesh surface = ground();
            for (Vec3& x : surface.vertices_mm) x[c] += by;
            const Body moved = body_on(surface);
            return ObstacleContact(moved).energy(x_, x_);
        };
        on_obstacle[c] = -(energy_moved_by(h) - energy_moved_by(-h)) / (2 * h);
    }
    EXPECT_GT(on_body.z(), 0.0);
    EXPECT_LT((on_body + on_obstacle).norm(), 1e-5 * on_body.norm());
}

TEST_P(ObstacleContactTest, AllStiffnessIsWithinTheMatrix) {
    const auto d = test::random_field(x_.size(), 1.0, 5);
    BlockMatrix matrix;
    Assembly(body_).gather_stiffness(0.0, matrix);
    contact_.add_stiffness(x_, 2.0, matrix);
    std::vector<Vec3> product, within(x_.size(), Vec3::Zero());
    multiply(matrix, d, product);
    contact_.add_product(x_, 2.0, d, matrix, within);
    double exact = 0.0;
    std::vector<Vec3> all = d;
    all.resize(all.size() + 1000, Vec3::Zero());  // obstacles stand still
    for (const SurfaceContact& contact : contact_.contacts(x_))
        exact += 2.0 * contact.stiffness_un_per_mm *
                 std::pow(contact.normal.dot(contact.at.between(all)), 2);
    EXPECT_NEAR(dot(d, product), exact, 1e-9 * exact);
    EXPECT_NEAR(dot(d, within), exact, 1e-9 * exact);
    EXPECT_FALSE(contact_.coupled(x_));
}

TEST_P(ObstacleContactTest, NothingPushesAtRest) {
    EXPECT_TRUE(contact_.contacts(body_.rest_positions_mm).empty());
}

INSTANTIATE_TEST_SUITE_P(BoxAndBall, ObstacleContactTest, testing::Bool());

// A bar that lies nearer to a box than the pad is thick: the pad begins at half of that.
TEST(ObstacleContact, ThePadIsEmptyAtRestHoweverNearTheBodyIs) {
    BodyDescription bar;
    bar.mesh = kuhn_brick(Vec3(12, 4, 4), {6, 2, 2});
    bar.obstacles = one_obstacle(box_surface(Vec3(-3, -3, -4.05), Vec3(20, 11, 4), {7, 4, 2}));
    const Body body = build_body(bar, ElementModel::corotated, ElementOrder::linear);
    ASSERT_GT(body.obstacle_pad.thickness_mm, 0.1);
    const ObstacleContact contact(body);
    const auto lowered = [&](double by) {
        std::vector<Vec3> x = body.rest_positions_mm;
        for (Vec3& at : x) at += Vec3(3.1, 1.3, -by);  // above other triangles than at rest
        return x;
    };
    EXPECT_TRUE(contact.contacts(body.rest_positions_mm).empty());
    EXPECT_TRUE(contact.contacts(lowered(0.0249)).empty());
    EXPECT_FALSE(contact.contacts(lowered(0.0251)).empty());
}

TEST(ObstacleContact, RefusesSurfacesThatAreOpenOrDoNotFit) {
    const auto refused = [](const Obstacles& obstacles) {
        EXPECT_THROW(validate(obstacles), InputError);
    };
    const Obstacle good{ball_surface(Vec3::Zero(), 1.0, 1), SurfaceKind::solid};
    EXPECT_NO_THROW(validate(Obstacles{{good}, 0.0}));
    refused({});
    refused({{good}, -0.1});
    refused({{good}, std::numeric_limits<double>::quiet_NaN()});
    Obstacle bad = good;
    bad.surface.triangles.pop_back();
    refused({{bad}, 0.2});
    bad = good;
    bad.surface.triangles.front()[1] = 1000;
    refused({{bad}, 0.2});
    bad = good;
    bad.surface.vertices_mm.front().x() = INFINITY;
    refused({{bad}, 0.2});
    bad = good;
    bad.kind = SurfaceKind::moving;
    refused({{bad}, 0.2});
    bad.surface.triangles.clear();
    refused({{bad}, 0.2});
}

}  // namespace
}  // namespace hepatica
