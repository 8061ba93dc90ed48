// SPDX-License-Identifier: GPL-3.0-or-later
// That the checks of a split see what they are there for.
#include "core/study/split_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

// Two tetrahedra across a face.
TetMesh pair() {
    TetMesh mesh;
    mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}, {4, 2, 1, 3}};
    return mesh;
}

TEST(SplitCheck, TetrahedraMustHangTogetherByFaces) {
    TetMesh mesh = pair();
    EXPECT_TRUE(fans_connected(mesh));
    mesh.vertices_mm.push_back({1, 0, 0});
    mesh.tetrahedra[1] = {4, 2, 5, 3};  // by an edge
    EXPECT_FALSE(fans_connected(mesh));
    mesh.vertices_mm.push_back({0, 1, 0});
    mesh.tetrahedra[1] = {4, 6, 5, 3};  // by a point
    EXPECT_FALSE(fans_connected(mesh));
    mesh.vertices_mm.push_back({0, 0, 1});
    mesh.tetrahedra[1] = {4, 6, 5, 7};  // not at all
    EXPECT_TRUE(fans_connected(mesh));
}

class CutBar : public testing::Test {
  protected:
    CutBar() {
        body_.mesh = kuhn_brick(Vec3(8, 2, 2), {8, 2, 2});
        body_.fixed.assign(body_.mesh.vertices_mm.size(), 0);
        body_.tear.emplace();
        stepper_ = make_cpu_stepper(body_, {});
        std::vector<Vec3> velocities(body_.mesh.vertices_mm.size());
        for (std::size_t v = 0; v < velocities.size(); ++v)
            velocities[v] = Vec3(5, 0, 0) + Vec3(0, 0, 3).cross(body_.mesh.vertices_mm[v]);
        stepper_->set_state(body_.mesh.vertices_mm, velocities);
    }
    void cut() { stepper_->cut(Vec3(4.1, -1, -1), Vec3(0, 4, 0), Vec3(0, 0, 4)); }

    BodyDescription body_;
    std::unique_ptr<Stepper> stepper_;
};

TEST_F(CutBar, WhatIsCutCleanlyHoldsAndIsCountedOnce) {
    SplitCheck check(body_, {});
    const EnergyLedger stored = stepper_->energies();
    EXPECT_EQ(check.after_step(*stepper_, stored), "");
    EXPECT_EQ(check.splits(), 0);
    cut();
    for (int again = 0; again < 2; ++again) {
        EXPECT_EQ(check.after_step(*stepper_, stored), "");
        EXPECT_EQ(check.splits(), 1);
    }
    EXPECT_EQ(check.with_inverted(), 0);
    EXPECT_EQ(check.with_touching_edges(), 0);
}

TEST_F(CutBar, MotionThatASplitTakesOrGivesIsSeen) {
    // New vertices that do not move as those do that they come from.
    SplitCheck check(body_, {});
    const EnergyLedger stored = stepper_->energies();
    cut();
    BodyState state = stepper_->state();
    for (std::size_t v = body_.mesh.vertices_mm.size(); v < state.velocities_mm_per_s.size(); ++v)
        state.velocities_mm_per_s[v] += Vec3(0, 0.01, 0);
    stepper_->set_state(state.positions_mm, state.velocities_mm_per_s);
    EXPECT_NE(check.after_step(*stepper_, stored), "");
}

TEST_F(CutBar, AVertexThatASplitMovesIsSeen) {
    SplitCheck check(body_, {});
    const EnergyLedger stored = stepper_->energies();
    cut();
    BodyState state = stepper_->state();
    state.positions_mm.back().x() += 1e-9;
    stepper_->set_state(state.positions_mm, state.velocities_mm_per_s);
    EXPECT_THAT(check.after_step(*stepper_, stored), testing::HasSubstr("where it was split from"));
}

TEST_F(CutBar, EnergyThatASplitMakesIsSeen) {
    SplitCheck check(body_, {});
    const EnergyLedger stored = stepper_->energies();
    cut();
    EnergyLedger less = stored;
    less.kinetic *= 0.99;
    EXPECT_THAT(check.after_step(*stepper_, less), testing::HasSubstr("a split made energy"));
}

TEST_F(CutBar, WhatIsInsideOutIsCounted) {
    SplitCheck check(body_, {});
    cut();
    BodyState state = stepper_->state();
    state.positions_mm[0] += Vec3(3, 3, 3);
    stepper_->set_state(state.positions_mm, state.velocities_mm_per_s);
    check.after_step(*stepper_, stepper_->energies());
    EXPECT_EQ(check.with_inverted(), 1);
}

}  // namespace
}  // namespace hepatica
