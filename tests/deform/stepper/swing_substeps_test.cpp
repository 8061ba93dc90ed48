// SPDX-License-Identifier: GPL-3.0-or-later
// More substeps while a body swings back that was let go: as many as its motion asks for, only
// then, and nearer to the motion in short steps.
#include "core/deform/stepper/swing_substeps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <numeric>
#include <vector>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "tests/deform/support/resumed_play.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

constexpr double dt_s = 1.0 / 60.0;
constexpr int let_go_at = 40, last_frame = 60;

// A bar in tissue, whose end is drawn aside by 25 mm, held, and let go.
class Swing : public testing::Test {
  protected:
    Swing() : body_(test::description_of(test::make_bar(100.0, 4.0, 25, 1))) {
        body_.tether_pa_per_mm2 = 20.0;
        tip_ = test::tip_of(body_);
    }

    std::unique_ptr<Stepper> stepper(int swing_substeps, int substeps = 1) const {
        StepperOptions options;
        options.swing_substeps = swing_substeps;
        options.substeps = substeps;
        options.linear.energy_tolerance = 1e-8;
        return make_cpu_stepper(body_, options);
    }

    void act_before(int frame, Stepper& stepper) const {
        if (frame == let_go_at) return stepper.set_grabs({});
        if (frame > let_go_at) return;
        Grab grab{.vertices = {tip_, -1, -1, -1}};
        const double mm = std::min(25.0, 1.0 * frame);
        grab.target_mm = body_.mesh.vertices_mm[tip_] + Vec3(0.0, mm, 0.0);
        grab.stiffness_un_per_mm = 2e4;
        grab.force_limit_un = 1e6;
        stepper.set_grabs(std::span(&grab, 1));
    }

    struct Play {
        std::vector<Vec3> tip_mm;
        std::vector<int> solves;
    };
    Play play(Stepper& stepper) const {
        Play played;
        for (int frame = 0; frame < last_frame; ++frame) {
            act_before(frame, stepper);
            played.solves.push_back(stepper.step(dt_s).linear_solves);
            played.tip_mm.push_back(stepper.positions_mm()[tip_]);
        }
        return played;
    }

    BodyDescription body_;
    int tip_ = 0;
};

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double squares = 0.0;
    for (std::size_t i = let_go_at; i < a.size(); ++i) squares += (a[i] - b[i]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(a.size() - let_go_at));
}

TEST_F(Swing, IsNearerToTheMotionInShortSteps) {
    const Play plain = play(*stepper(1)), adapted = play(*stepper(6));
    const std::vector<Vec3> fine = play(*stepper(1, 32)).tip_mm;
    const double missed = distance(adapted.tip_mm, fine);
    EXPECT_LT(missed, 0.7 * distance(plain.tip_mm, fine));
    const Play everywhere = play(*stepper(1, 6));
    EXPECT_LT(missed, 1.2 * distance(everywhere.tip_mm, fine)) << "as six in every frame";
    const auto solves = [](const Play& played) {
        return std::accumulate(played.solves.begin(), played.solves.end(), 0);
    };
    EXPECT_LT(solves(adapted), 0.5 * solves(everywhere));
    for (int frame = 0; frame < let_go_at; ++frame)
        EXPECT_EQ(adapted.tip_mm[frame], plain.tip_mm[frame]) << "held at " << frame;
}

TEST_F(Swing, CostsMoreOnlyWhileItSwings) {
    const Play played = play(*stepper(6));
    EXPECT_GE(played.solves[let_go_at], 4);
    EXPECT_LE(played.solves[let_go_at], 12) << "two a substep";
    EXPECT_EQ(played.solves.back(), 1);
    int long_frames = 0;
    for (const int solves : played.solves) long_frames += solves > 2 ? 1 : 0;
    EXPECT_LE(long_frames, 6);
}

// A little pull is let go: one step is enough.
TEST_F(Swing, DependsOnHowFarItWasPulled) {
    const auto gently = stepper(6);
    Grab grab{.vertices = {tip_, -1, -1, -1}};
    grab.target_mm = body_.mesh.vertices_mm[tip_] + Vec3(0.0, 0.3, 0.0);
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e6;
    gently->set_grabs(std::span(&grab, 1));
    for (int frame = 0; frame < 20; ++frame) gently->step(dt_s);
    gently->set_grabs({});
    EXPECT_EQ(gently->step(dt_s).linear_solves, 1);
}

TEST_F(Swing, EndsWhereSomethingHoldsIt) {
    const auto caught = stepper(6);
    for (int frame = 0; frame <= let_go_at; ++frame) {
        act_before(frame, *caught);
        caught->step(dt_s);
    }
    act_before(let_go_at - 1, *caught);
    for (int frame = 0; frame < 5; ++frame)
        EXPECT_LE(caught->step(dt_s).linear_solves, 3) << "one step and what a cut one adds";
}

TEST_F(Swing, TakesThePublishedStepAsItIs) {
    StepperOptions options;
    options.published = true;
    const auto published = make_cpu_stepper(body_, options);
    const Play played = play(*published);
    for (const int solves : played.solves) EXPECT_EQ(solves, 1);
}

TEST_F(Swing, GoesOnFromACheckpointToTheSameBits) {
    const auto make = [&] { return stepper(6); };
    const auto step = [&](Stepper& stepper, int k) {
        act_before(k, stepper);
        stepper.step(dt_s);
    };
    const StepperCheckpoint kept = test::expect_same_bits_from(let_go_at, last_frame, make, step);
    EXPECT_GT(kept.swing_mm_per_s, 0.0) << "kept while it swings";
    EXPECT_EQ(test::expect_same_bits_from(let_go_at - 2, last_frame, make, step).swing_mm_per_s,
              0.0);
}

// What has crept aside and frozen while the end was held is live at once when that is let go.
TEST_F(Swing, WakesWhatFrozeAwayFromItsPlace) {
    StepperOptions options;
    options.linear.energy_tolerance = 1e-8;
    LiveRegionOptions region;
    region.wake_radii = 3e-3;
    region.still_radii_per_s = 1.5e-2;
    region.reach_nodes = 2;
    const auto part = make_live_stepper(body_, options, region);
    const auto whole = make_cpu_stepper(body_, options);
    Grab grab{.vertices = {tip_, -1, -1, -1}};
    grab.target_mm = body_.mesh.vertices_mm[tip_] + Vec3(0.0, 25.0, 0.0);
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e6;
    for (Stepper* stepper : std::initializer_list<Stepper*>{part.get(), whole.get()}) {
        stepper->set_grabs(std::span(&grab, 1));
        for (int frame = 0; frame < 240; ++frame) stepper->step(dt_s);
    }
    ASSERT_LT(part->extent().live_vertices, part->extent().vertices / 2) << "most of it is still";
    const std::vector<Vec3> held(part->positions_mm().begin(), part->positions_mm().end());
    for (Stepper* stepper : std::initializer_list<Stepper*>{part.get(), whole.get()}) {
        stepper->set_grabs({});
        stepper->step(dt_s);
    }
    double furthest = 0.0, missed = 0.0;
    for (std::size_t v = 0; v < held.size(); ++v) {
        furthest = std::max(furthest, (whole->positions_mm()[v] - held[v]).norm());
        missed = std::max(missed, (whole->positions_mm()[v] - part->positions_mm()[v]).norm());
    }
    EXPECT_GT(furthest, 5.0);
    EXPECT_LT(missed, 0.1 * furthest);
}

// A body that moves as one has the energy of its mass and speed.
TEST(SwingSubsteps, ExpectTheSpeedThatTheEnergyCanBecome) {
    Body body;
    body.mass_g = {0.25, 0.5, 1.25};
    body.mean_edge_mm = 2.0;
    const double speed = 600.0;  // mm/s
    double energy_nj = 0.0;
    for (const double mass : body.mass_g) energy_nj += 0.5 * mass * speed * speed;
    SwingSubsteps swing;
    EXPECT_FALSE(swing.swings());
    EXPECT_EQ(swing.count(body, dt_s, 8), 1);
    swing.let_go(body, energy_nj);
    EXPECT_NEAR(swing.change_mm_per_s(), speed, 1e-9 * speed);
    // It misses 5 mm in 1/60 s: 2.5 edges, of which a substep may miss 0.35.
    EXPECT_EQ(swing.count(body, dt_s, 20), 8);
    EXPECT_EQ(swing.count(body, dt_s, 6), 6);
    EXPECT_EQ(swing.count(body, dt_s / 8.0, 20), 1);
    swing.hold();
    EXPECT_FALSE(swing.swings());
    swing.let_go(body, 0.0);
    EXPECT_FALSE(swing.swings());
}

TEST(SwingSubsteps, FollowTheChangeOfVelocityUntilOneIsEnough) {
    Body body;
    body.mass_g = {1.0, 3.0};
    body.mean_edge_mm = 2.0;
    SwingSubsteps swing;
    swing.restore(600.0);
    const std::vector<Vec3> before{{10.0, 0.0, 0.0}, {0.0, 5.0, 0.0}};
    const BodyState after{.positions_mm = {},
                          .velocities_mm_per_s = {{10.0, 80.0, 0.0}, {0.0, 5.0, 40.0}}};
    swing.watch(body, before, after, 8);
    // (1 * 80² + 3 * 40²) / 4
    EXPECT_NEAR(swing.change_mm_per_s(), std::sqrt(2800.0), 1e-12);
    swing.watch(body, before, after, 1);
    EXPECT_FALSE(swing.swings());
}

}  // namespace
}  // namespace hepatica
