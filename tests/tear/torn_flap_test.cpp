// SPDX-License-Identifier: GPL-3.0-or-later
// A flap that hangs on the body that it was torn from: once it has opened it does not pass through
// its bed.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/crossing_triangles.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

// A bar that lies on a table and is slit along its middle height from x = -4 to its end: its upper
// half is a flap, led at its end.
struct Flap {
    BodyDescription body;
    std::vector<int> end;
    std::unique_ptr<Stepper> stepper;

    explicit Flap(bool self = true) {
        test::add_mesh(test::bar_at({24, 4, 4}, {12, 2, 4}, Mat3::Identity(), Vec3::Zero()),
                       body.mesh);
        for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
            const Vec3& x = body.mesh.vertices_mm[v];
            body.fixed.push_back(x.z() < -1.9);
            if (x.x() > 11.9 && x.z() > 1.9) end.push_back(static_cast<int>(v));
        }
        if (self) body.self.emplace();
        body.tear.emplace();
        body.tear->tear_factor = 1e3;
        stepper = make_cpu_stepper(body, {});
        stepper->cut(Vec3(-4, -20, 0.1), Vec3(0, 40, 0), Vec3(40, 0, 0));
        EXPECT_EQ(stepper->tearing()->report().pieces, 1);
    }
    void lead(double lift_mm) {
        std::vector<Grab> grabs;
        for (const int v : end) {
            Grab grab;
            grab.vertices[0] = v;
            grab.target_mm = body.mesh.vertices_mm[v] + Vec3(0, 0, lift_mm);
            grab.stiffness_un_per_mm = 1e5;
            grab.force_limit_un = 1e12;
            grabs.push_back(grab);
        }
        stepper->set_grabs(grabs);
    }
    void lead(double from_mm, double to_mm, int steps) {
        for (int k = 1; k <= steps; ++k) {
            lead(from_mm + (to_mm - from_mm) * k / steps);
            last = stepper->step(frame_s);
        }
    }
    std::size_t crossings() const {
        return crossing_triangles(stepper->tearing()->topology().surface(), stepper->positions_mm())
            .size();
    }
    // Of triangles that lie wholly beyond this x.
    int crossings_beyond(double x_mm) const {
        const auto surface = stepper->tearing()->topology().surface();
        const auto x = stepper->positions_mm();
        const auto beyond = [&](int triangle) {
            return std::ranges::all_of(surface[triangle], [&](int v) { return x[v].x() > x_mm; });
        };
        const auto pairs = crossing_triangles(surface, x);
        return static_cast<int>(std::ranges::count_if(
            pairs, [&](const auto& pair) { return beyond(pair[0]) && beyond(pair[1]); }));
    }
    StepReport last;
};

TEST(TornFlap, DoesNotPassThroughItsBed) {
    Flap flap;
    flap.lead(0.0, 6.0, 60);
    EXPECT_EQ(flap.crossings(), 0u);
    flap.lead(6.0, -6.0, 120);
    EXPECT_GT(flap.last.self.contacts, 20);
    EXPECT_EQ(flap.crossings(), 0u);
    // Without contact it does: the bed alone holds it.
    Flap without(false);
    without.lead(0.0, 6.0, 60);
    without.lead(6.0, -6.0, 120);
    EXPECT_GT(without.crossings(), 50u);
}

// A hand that throws it open in two steps, and back.
TEST(TornFlap, IsKeptOutHoweverFastItMoves) {
    Flap flap;
    flap.lead(0.0, 10.0, 2);
    flap.lead(10.0, -10.0, 3);
    for (int k = 0; k < 30; ++k) {
        flap.stepper->step(frame_s);
        ASSERT_EQ(flap.crossings(), 0u) << k;
    }
}

// Cut off at its root while it is pressed into the bed: what counted goes on counting, but for the
// patches beside the cut.
TEST(TornFlap, IsKeptOutWhereItIsCutOffWhileItIsPressed) {
    Flap flap;
    flap.lead(0.0, 6.0, 60);
    flap.lead(6.0, -3.0, 90);
    EXPECT_GT(flap.last.self.contacts, 20);
    flap.stepper->cut(Vec3(-4, -20, -0.5), Vec3(0, 40, 0), Vec3(0, 0, 20));
    ASSERT_EQ(flap.stepper->tearing()->report().pieces, 2);
    for (int k = 0; k < 20; ++k) {
        flap.last = flap.stepper->step(frame_s);
        ASSERT_EQ(flap.crossings_beyond(0.0), 0) << k;
        ASSERT_GT(flap.last.self.contacts, 0) << k;
    }
}

// Nothing is stored where a side begins to count, and what its pads take is in the books.
TEST(TornFlap, OpensAtNoCost) {
    Flap flap;
    EXPECT_EQ(flap.stepper->energies().contact, 0.0);
    flap.lead(0.0, 6.0, 60);
    EXPECT_EQ(flap.stepper->energies().contact, 0.0);
    Flap without(false);
    without.lead(0.0, 6.0, 60);
    for (std::size_t v = 0; v < flap.stepper->positions_mm().size(); ++v)
        ASSERT_NEAR((flap.stepper->positions_mm()[v] - without.stepper->positions_mm()[v]).norm(),
                    0.0, 1e-3);
}

// While it opens, pads grow and twins begin to count in almost every step.
TEST(TornFlap, ACheckpointOfWhatOpensGoesOnToTheSameBits) {
    Flap flap;
    flap.lead(0.0, 0.2, 12);
    for (int k = 0; k < 12; ++k) {
        const auto other = make_cpu_stepper(flap.body, {});
        other->restore(checkpoint_from_bytes(to_bytes(flap.stepper->checkpoint())));
        flap.lead(0.2 + 0.05 * k);
        other->set_grabs(flap.stepper->checkpoint().grabs);
        flap.stepper->step(frame_s);
        other->step(frame_s);
        ASSERT_EQ(other->state_hash(), flap.stepper->state_hash()) << k;
    }
}

TEST(TornFlap, ACheckpointKnowsItsSides) {
    Flap flap;
    flap.lead(0.0, 0.12, 40);
    flap.lead(0.12, 0.05, 10);
    const StepperCheckpoint now = flap.stepper->checkpoint();
    ASSERT_TRUE(now.self);
    ASSERT_FALSE(now.self->overlaps.lying.empty()) << "the tip has opened as well";
    ASSERT_FALSE(now.self->overlaps.pads.empty()) << "no pad is thin";
    const auto other = make_cpu_stepper(flap.body, {});
    other->restore(checkpoint_from_bytes(to_bytes(now)));
    EXPECT_EQ(other->state_hash(), flap.stepper->state_hash());
    for (int k = 0; k < 20; ++k) {
        flap.stepper->step(frame_s);
        other->step(frame_s);
        ASSERT_EQ(other->state_hash(), flap.stepper->state_hash()) << k;
    }
    StepperCheckpoint other_twins = now;
    other_twins.self->overlaps.lying[0] = 0;
    EXPECT_THROW(other->restore(other_twins), InputError);
    StepperCheckpoint no_pad = now;
    no_pad.self->overlaps.pads[0].pad_mm = -1.0;
    EXPECT_THROW(other->restore(no_pad), InputError);
    EXPECT_EQ(other->state_hash(), flap.stepper->state_hash());
}

}  // namespace
}  // namespace hepatica
