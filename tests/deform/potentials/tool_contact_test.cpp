// SPDX-License-Identifier: GPL-3.0-or-later
// What a tool's pad and its friction promise: forces that are the gradients of their energies, a
// stiffness that is that of the force, the law of the pad in closed form, and a load on the tool
// that is opposite to all that it does to the body.
#include "core/deform/potentials/tool_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

using test::random_field;

// 12 x 12 x 6 mm, its top at z = 6.
Body touchable_brick() {
    BodyDescription d;
    d.mesh = kuhn_brick(Vec3(12, 12, 6), {4, 4, 2});
    d.touchable = true;
    return build_body(d, ElementModel::corotated, ElementOrder::linear);
}

std::vector<Vec3> shaken(const Body& body, double size, unsigned seed) {
    std::vector<Vec3> x = body.rest_positions_mm;
    const auto noise = random_field(x.size(), size, seed);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += noise[i];
    return x;
}

// Of a ball or a capsule that presses the top by about a third of its pad.
Tool pressing(bool capsule) {
    Tool tool = single_tool({.centre_mm = Vec3(6.3, 5.6, 6.0 + 4.0 + 0.7),
                             .half_axis_mm = capsule ? Vec3(2.5, 1.0, 0.05) : Vec3(Vec3::Zero()),
                             .radius_mm = 4.0});
    tool.pad_mm = 1.0;
    tool.pressure_pa = 3e5;
    tool.friction = 0.4;
    tool.parts[0].led_by_mm = Vec3(3, -2, 0) / 60.0;
    tool.led_over_s = 1.0 / 60.0;
    return tool;
}

double size_of(const std::vector<Vec3>& force) {
    double size = 0.0;
    for (const Vec3& f : force) size = std::max(size, f.norm());
    return size;
}

// Between centred differences of the energy and the force, relative to the largest force.
double gradient_error(const Potential& potential, std::vector<Vec3> x, double h) {
    std::vector<Vec3> force(x.size(), Vec3::Zero());
    potential.add_forces(x, force);
    const double size = size_of(force);
    EXPECT_GT(size, 0.0);
    double error = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double kept = x[i][c];
            x[i][c] = kept + h;
            const double above = potential.energy(x, x);
            x[i][c] = kept - h;
            const double below = potential.energy(x, x);
            x[i][c] = kept;
            error = std::max(error, std::abs(force[i][c] + (above - below) / (2 * h)) / size);
        }
    return error;
}

class ToolContactTest : public testing::TestWithParam<bool> {
  protected:
    ToolContactTest() : body_(touchable_brick()), list_(body_), x_(shaken(body_, 0.1, 3)) {
        list_.set_tool(pressing(GetParam()));
        list_.begin_step({x_, {}}, dt_s, {});
    }
    const Potential& contact() const { return *list_.all().end()[-2]; }
    const Potential& friction() const { return *list_.all().end()[-1]; }

    static constexpr double dt_s = 1.0 / 60.0;
    Body body_;
    PotentialList list_;
    std::vector<Vec3> x_;
};

// A hundredth of the force too much would be seen a thousandfold.
TEST_P(ToolContactTest, ForcesAreTheGradientsOfTheEnergies) {
    EXPECT_LT(gradient_error(contact(), x_, 1e-5), 1e-5);
    std::vector<Vec3> slipped = x_;
    const auto moved = random_field(slipped.size(), 0.02, 8);
    for (std::size_t i = 0; i < slipped.size(); ++i) slipped[i] += moved[i];
    EXPECT_LT(gradient_error(friction(), slipped, 1e-5), 1e-5);
    // What sticks has gone along with the tool, but for a part of the creep.
    const double creep = 1e-5 * body_.mean_edge_mm * dt_s;
    std::vector<Vec3> stuck = x_;
    const auto crept = random_field(stuck.size(), 0.3 * creep, 9);
    for (std::size_t i = 0; i < stuck.size(); ++i) stuck[i] += dt_s * Vec3(3, -2, 0) + crept[i];
    EXPECT_LT(gradient_error(friction(), stuck, 0.01 * creep), 1e-4);
}

// J^T k J with one point a triangle: exact where normals and weights stay, as in friction, and in
// the pad where the surface moves along its normal.
TEST_P(ToolContactTest, StiffnessIsThatOfTheForce) {
    const auto change = [&](const Potential& potential, const std::vector<Vec3>& x,
                            const std::vector<Vec3>& d, double h) {
        std::vector<Vec3> above(x.size(), Vec3::Zero()), below = above, ahead = x, behind = x;
        for (std::size_t i = 0; i < x.size(); ++i) {
            ahead[i] += h * d[i];
            behind[i] -= h * d[i];
        }
        potential.add_forces(ahead, above);
        potential.add_forces(behind, below);
        double form = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) form -= d[i].dot(above[i] - below[i]) / (2 * h);
        return form;
    };
    const auto form_of = [&](const Potential& potential, const std::vector<Vec3>& x,
                             const std::vector<Vec3>& d) {
        BlockMatrix matrix;
        Assembly(body_).gather_stiffness(0.0, matrix);
        potential.add_stiffness(x, 2.0, matrix);
        std::vector<Vec3> product;
        multiply(matrix, d, product);
        const double form = dot(d, product);
        product.assign(x.size(), Vec3::Zero());
        potential.add_product(x, 2.0, d, matrix, product);
        EXPECT_NEAR(dot(d, product), form, 1e-9 * std::abs(form));
        return 0.5 * form;
    };
    std::vector<Vec3> slipped = x_;
    const auto moved = random_field(slipped.size(), 0.02, 8), d = random_field(x_.size(), 1.0, 4);
    for (std::size_t i = 0; i < slipped.size(); ++i) slipped[i] += moved[i];
    const double sliding = form_of(friction(), slipped, d);
    EXPECT_GT(sliding, 0.0);
    EXPECT_NEAR(change(friction(), slipped, d, 1e-6), sliding, 1e-4 * sliding);
    EXPECT_GE(form_of(contact(), x_, d), 0.0);
    // A flat top that rises under the lowest point of the tool.
    std::vector<Vec3> flat = body_.rest_positions_mm;
    const std::vector<Vec3> up(flat.size(), Vec3(0, 0, 1));
    Tool tool = pressing(GetParam());
    tool.parts[0].shape.half_axis_mm.z() = 0.0;
    list_.set_tool(tool);
    double exact = 0.0;
    for (const PadContact& pad : dynamic_cast<const ToolContact&>(contact()).contacts(flat))
        exact += pad.stiffness_un_per_mm * pad.normal.z() * pad.normal.z();
    EXPECT_NEAR(form_of(contact(), flat, up), exact, 1e-9 * exact);
}

TEST_P(ToolContactTest, TheToolBearsWhatItDoesToTheBody) {
    std::vector<Vec3> force(x_.size(), Vec3::Zero());
    contact().add_forces(x_, force);
    friction().add_forces(x_, force);
    const ToolLoad load = list_.tool_load(x_);
    Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
    for (std::size_t i = 0; i < x_.size(); ++i) {
        sum += force[i];
        torque += (x_[i] - list_.tool()->parts[0].shape.centre_mm).cross(force[i]);
    }
    EXPECT_LT((sum + load.force_un).norm(), 1e-9 * sum.norm());
    EXPECT_LT((torque + load.torque_un_mm).norm(), 1e-9 * sum.norm());
    EXPECT_GT(load.force_un.z(), 0.0);  // it presses down and is pressed up
    // Dragged forward, it is held back.
    EXPECT_LT(load.force_un.dot(list_.tool()->parts[0].led_by_mm), 0.0);
    EXPECT_GT(load.contacts, 3);
    // Where it is pressed: below its middle, on the brick's top.
    EXPECT_NEAR(load.at_mm.z(), 6.0, 0.2);
    EXPECT_LT((load.at_mm - list_.tool()->centre_mm()).head<2>().norm(), 2.0);
    EXPECT_EQ(load.grip_un, 0.0);
    EXPECT_GT(load.least_gap_mm, 0.0);
    EXPECT_LT(load.least_gap_mm, 1.0);
}

TEST_P(ToolContactTest, EnergiesByPieceAddUpAndEachBooksItsOwnTerm) {
    std::vector<int> piece(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) piece[i] = static_cast<int>(i % 3);
    for (const Potential* potential : {&contact(), &friction()}) {
        const double energy = potential->energy(x_, x_);
        EXPECT_GT(energy, 0.0);
        std::vector<double> by_piece(3, 0.0);
        potential->add_energy_by_piece(x_, x_, piece, by_piece);
        EXPECT_NEAR(by_piece[0] + by_piece[1] + by_piece[2], energy, 1e-12 * energy);
        EnergyLedger ledger;
        potential->book(energy, ledger);
        EXPECT_EQ(energy_handled(ledger), energy);
    }
    EnergyLedger both;
    list_.book(x_, x_, both);
    EXPECT_GT(both.contact, 0.0);
    EXPECT_GT(both.friction_loss, 0.0);
    EXPECT_EQ(stored_energy(both), both.contact);
    list_.end_step();  // outside of a step there is no friction
    list_.book(x_, x_, both);
    EXPECT_EQ(both.friction_loss, 0.0);
}

INSTANTIATE_TEST_SUITE_P(BallAndCapsule, ToolContactTest, testing::Bool());

Tool wide_ball(double gap_mm) {
    Tool tool = single_tool({.centre_mm = Vec3(2, 2, 1e8 + gap_mm), .radius_mm = 1e8});
    tool.pad_mm = 0.5;
    tool.pressure_pa = 1000.0;
    return tool;
}

// In a later part of a step, in which a tool that was led away is so no longer where the body is.
TEST(ToolFriction, DoesNotRubWhatHasComeToWhereTheToolWas) {
    const Body body = touchable_brick();
    PotentialList list(body);
    Tool tool = pressing(false);
    const Vec3 away(0, 0, 3);
    tool.parts[0].led_by_mm = away;
    tool.parts[0].shape.centre_mm += away;
    list.set_tool(tool);
    std::vector<Vec3> risen = body.rest_positions_mm;
    for (Vec3& x : risen) x.z() += 1.5;
    list.begin_step({risen, {}}, 1.0 / 60.0, {});
    std::vector<Vec3> force(risen.size(), Vec3::Zero());
    list.all().back()->add_forces(risen, force);
    EXPECT_EQ(size_of(force), 0.0);
    // Where it has only come nearer it is rubbed as it was pressed before.
    list.begin_step({body.rest_positions_mm, {}}, 1.0 / 60.0, {});
    list.all().back()->add_forces(body.rest_positions_mm, force);
    EXPECT_GT(size_of(force), 0.0);
}

// The friction of a ball that presses a shaken brick, told what forces there are on the body:
// `share` of what friction gives.
class ForeseenFriction : public testing::Test {
  protected:
    void foresee(double share) {
        list_.set_tool(pressing(false));
        list_.begin_step({body_.rest_positions_mm, {}}, 1.0 / 60.0, {});
        std::vector<Vec3> rubbed(x_.size(), Vec3::Zero());
        friction().add_forces(x_, rubbed);
        ASSERT_GT(size_of(rubbed), 0.0);
        for (Vec3& f : rubbed) f *= share;
        list_.foresee(x_, rubbed);
    }
    const Potential& friction() const { return *list_.all().back(); }
    // By how much the energy at x + u exceeds what force and stiffness at x make of it.
    double above_model(const std::vector<Vec3>& u) const {
        std::vector<Vec3> force(x_.size(), Vec3::Zero()), product(x_.size(), Vec3::Zero());
        friction().add_forces(x_, force);
        friction().add_product(x_, 1.0, u, BlockMatrix{}, product);
        std::vector<Vec3> moved = x_;
        for (std::size_t i = 0; i < u.size(); ++i) moved[i] += u[i];
        const double model = friction().energy(x_, x_) - dot(force, u) + 0.5 * dot(u, product);
        return friction().energy(moved, moved) - model;
    }

    Body body_ = touchable_brick();
    PotentialList list_{body_};
    std::vector<Vec3> x_ = shaken(body_, 0.02, 4);
};

// So the whole way that the model proposes cannot raise friction's energy by more than it says.
TEST_F(ForeseenFriction, WhatIsAboutToStickHasAStiffnessThatBoundsTheEnergy) {
    foresee(1.0);  // nothing but friction acts: it will hold
    for (unsigned seed = 0; seed < 40; ++seed)
        EXPECT_LE(above_model(random_field(x_.size(), 0.3, seed)), 1e-9) << seed;
}

TEST_F(ForeseenFriction, WhatIsPressedOnSlipsOnWithoutStiffness) {
    foresee(-1.0);                           // the others outweigh it
    const Vec3 on = -Vec3(3, -2, 0) / 60.0;  // as it slips: the tool goes the other way
    const std::vector<Vec3> slides(x_.size(), on), turns(x_.size(), Vec3(-10.0 * on));
    EXPECT_NEAR(above_model(slides), 0.0, 0.01 * friction().energy(x_, x_));
    EXPECT_GT(above_model(turns), friction().energy(x_, x_));
}

// A tetrahedron's top under a ball so wide that it is flat there: A p g / (1 - g). A is what
// the top's corners stand for, a third of all their triangles.
TEST(ToolContact, ThePadsLawInClosedForm) {
    BodyDescription d;
    d.mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(0, 8, 0), Vec3(8, 0, 0), Vec3(2, 2, -50)};
    d.mesh.tetrahedra = {{0, 1, 2, 3}};
    d.touchable = true;
    const Body body = build_body(d, ElementModel::corotated, ElementOrder::linear);
    const std::vector<Vec3>& x = body.rest_positions_mm;
    double area = 0.0;
    for (const auto& triangle : body.surface) {
        const Triangle c = corners_of(triangle, x);
        for (const Vec3& corner : c)
            if (corner.z() == 0.0) area += (c[1] - c[0]).cross(c[2] - c[0]).norm() / 6.0;
    }
    PotentialList list(body);
    for (const double pressed : {0.1, 0.5, 0.9}) {
        list.set_tool(wide_ball(0.5 * (1.0 - pressed)));
        const ToolLoad load = list.tool_load(x);
        const double force = area * 1000.0 * pressed / (1.0 - pressed);
        EXPECT_NEAR(load.force_un.z(), force, 0.01 * force);
        EXPECT_NEAR(load.least_gap_mm, 0.5 * (1.0 - pressed), 1e-4);
        const double energy = area * 1000.0 * 0.5 * (-pressed - std::log(1.0 - pressed));
        EnergyLedger ledger;
        list.book(x, x, ledger);
        EXPECT_NEAR(ledger.contact, energy, 0.01 * energy);
    }
    list.set_tool(wide_ball(-0.001));
    EXPECT_TRUE(std::isinf(list.energy(x, x)));
    EXPECT_FALSE(list.free_of_tool(x));
    list.set_tool(wide_ball(0.01));
    EXPECT_TRUE(list.free_of_tool(x));
    list.set_tool(wide_ball(0.51));
    EXPECT_EQ(list.energy(x, x), 0.0);
}

// The pressure over a flat face under a small ball, against its integral over the circle in the
// pad, with gaps as they are and counted from an eighth of the pad before that.
TEST(ToolContact, PointsOnATriangleIntegrateThePressure) {
    BodyDescription d;
    d.mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(0, 9, 0), Vec3(9, 0, 0), Vec3(3, 3, -50)};
    d.mesh.tetrahedra = {{0, 1, 2, 3}};
    d.touchable = true;
    const Body body = build_body(d, ElementModel::corotated, ElementOrder::linear);
    PotentialList list(body);
    Tool tool = wide_ball(0.0);
    tool.parts[0].shape = {.centre_mm = Vec3(3, 3, 2.25), .radius_mm = 2.0};
    list.set_tool(tool);
    const auto integral = [](double nearer_mm) {
        constexpr int rings = 100000;
        double sum = 0.0;
        for (int i = 0; i < rings; ++i) {
            const double r = 2.0 * (i + 0.5) / rings, distance = std::hypot(2.25, r);
            const double g = std::max(0.0, 1.0 - (distance - 2.0 - nearer_mm) / 0.5);
            sum += 2.0 * M_PI * r * (2.0 / rings) * 1000.0 * g / (1.0 - g) * 2.25 / distance;
        }
        return sum;
    };
    const double force = list.tool_load(body.rest_positions_mm).force_un.z();
    EXPECT_GT(force, 0.98 * integral(0.0));
    EXPECT_LT(force, 1.02 * integral(0.5 / 8.0));
    EXPECT_GT(list.tool_load(body.rest_positions_mm).contacts, 10);
}

TEST(ToolContact, IsLedUntilThePadIsHalfPressedOrTheLimitIsReached) {
    const Body body = touchable_brick();
    PotentialList list(body);
    Tool tool = pressing(false);
    tool.parts[0].shape.centre_mm = Vec3(6, 6, 30);
    tool.target_mm = Vec3(6, 6, -30);
    list.set_tool(tool);
    EXPECT_TRUE(list.lead_tool(body.rest_positions_mm, 0.1, 0.01));
    EXPECT_NEAR(list.tool()->parts[0].shape.centre_mm.z(), 24.0, 1e-9);
    EXPECT_NEAR(list.tool()->speed_mm_per_s(), 600.0, 1e-9);
    list.lead_tool(body.rest_positions_mm, 1.0, 0.01);
    EXPECT_NEAR(list.tool()->parts[0].shape.centre_mm.z(), 6.0 + 4.0 + 0.5, 1e-4);
    const double most = list.tool_load(body.rest_positions_mm).force_un.norm();
    // Half of that is met earlier.
    tool.force_limit_un = 0.5 * most;
    tool.parts[0].shape.centre_mm.z() = 12.0;
    list.set_tool(tool);
    list.lead_tool(body.rest_positions_mm, 1.0, 0.01);
    const double met = list.tool_load(body.rest_positions_mm).force_un.norm();
    EXPECT_LE(met, 0.5 * most);
    EXPECT_GT(met, 0.45 * most);
}

// One end of a rod is turned into the brick: the torque that resists ends the turn.
TEST(ToolContact, IsTurnedUntilTheTorqueOfTheLimitIsReached) {
    const Body body = touchable_brick();
    PotentialList list(body);
    Tool rod = single_tool({.centre_mm = Vec3(6, 6, 6.0 + 2.0 + 1.1),
                            .half_axis_mm = Vec3(4, 0, 0),
                            .radius_mm = 2.0});
    rod.pad_mm = 1.0;
    rod.pressure_pa = 3e5;
    rod.target_mm = rod.centre_mm();
    rod.turn_rad = Vec3(0, 0.5, 0);
    rod.force_limit_un = 1e9;
    list.set_tool(rod);
    list.lead_tool(body.rest_positions_mm, 1.0, 0.01);
    const double most = list.tool_load(body.rest_positions_mm).torque_un_mm.norm();
    ASSERT_GT(most, 0.0);
    rod.force_limit_un = 0.3 * most / rod.reach_mm();
    list.set_tool(rod);
    list.lead_tool(body.rest_positions_mm, 1.0, 0.01);
    const Vec3 met = list.tool_load(body.rest_positions_mm).torque_un_mm;
    EXPECT_LE(met.norm(), 0.3 * most * (1.0 + 1e-9));
    EXPECT_GT(met.norm(), 0.2 * most);
    EXPECT_LT(met.y(), 0.0) << "it resists the turn";
}

TEST(ToolContact, WhatIsRefused) {
    const Body body = touchable_brick();
    PotentialList list(body);
    using Change = void (*)(Tool&);
    for (const Change change :
         {Change([](Tool& t) { t.parts[0].shape.radius_mm = 0; }),
          Change([](Tool& t) { t.parts[0].shape.centre_mm.x() = NAN; }),
          Change([](Tool& t) { t.parts[0].shape.half_axis_mm.x() = NAN; }),
          Change([](Tool& t) { t.target_mm.z() = INFINITY; }),
          Change([](Tool& t) { t.parts[0].led_by_mm.z() = INFINITY; }),
          Change([](Tool& t) { t.pad_mm = 0; }), Change([](Tool& t) { t.pressure_pa = -1; }),
          Change([](Tool& t) { t.friction = -0.1; }),
          Change([](Tool& t) { t.force_limit_un = 0; })}) {
        Tool tool = pressing(false);
        change(tool);
        EXPECT_THROW(list.set_tool(tool), InputError);
        EXPECT_FALSE(list.tool());
    }
    BodyDescription untouchable;
    untouchable.mesh = kuhn_brick(Vec3(1, 1, 1), {1, 1, 1});
    const Body other = build_body(untouchable, ElementModel::corotated, ElementOrder::linear);
    PotentialList nothing(other);
    EXPECT_EQ(nothing.all().size(), 3u);  // nothing is built for tools
    EXPECT_THROW(nothing.set_tool(pressing(false)), InputError);
    nothing.set_tool(std::nullopt);
}

}  // namespace
}  // namespace hepatica
