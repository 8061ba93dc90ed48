// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/live_stepper.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_region.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::tip_of;

BodyDescription tree_body(int generations = 4) {
    BodyDescription body = test::description_of(test::make_brick_tree(generations, 3.0, 1.5));
    body.material.damping_ratio = 0.5;
    return body;
}

Grab pull(int vertex, const Vec3& target_mm) {
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = target_mm;
    grab.stiffness_un_per_mm = 2e4;
    grab.force_limit_un = 1e5;
    return grab;
}

TEST(LiveRegion, FreezesWhatIsStillAndWakesWhatIsHeld) {
    const BodyDescription body = tree_body();
    LiveRegion region(body.skeleton, body.mesh.vertices_mm);
    EXPECT_EQ(region.live_count(), body.skeleton.size());
    const std::vector<Vec3> still(body.mesh.vertices_mm.size(), Vec3::Zero());
    bool changed = false;
    for (int k = 0; k < 60; ++k) changed |= region.watch(body.mesh.vertices_mm, still, 1.0 / 60.0);
    EXPECT_TRUE(changed);
    EXPECT_EQ(region.live_count(), 0);
    const int tip = tip_of(body);
    EXPECT_TRUE(region.hold(std::vector<int>{tip}));
    EXPECT_TRUE(region.live(tip));
    EXPECT_GT(region.live_count(), 4);
    EXPECT_LT(region.live_count(), body.skeleton.size() / 2);
    for (int k = 0; k < 60; ++k) region.watch(body.mesh.vertices_mm, still, 1.0 / 60.0);
    EXPECT_TRUE(region.live(tip));
}

// A stretch creeps by two fifths of the threshold at a time, and between any two of its moves the
// region changes elsewhere: what adds up wakes the frozen neighbour all the same.
void expect_creep_to_wake(double width_mm) {
    const BodyDescription body = test::description_of(test::make_bar(120.0, width_mm, 60, 1));
    LiveRegionOptions options;
    options.reach_nodes = 2;
    LiveRegion region(body.skeleton, body.mesh.vertices_mm, options);
    for (const auto& nodes : body.mesh.tetrahedra) region.connect(nodes);
    std::vector<Vec3> positions = body.mesh.vertices_mm;
    const std::vector<Vec3> still(positions.size(), Vec3::Zero());
    const auto rest = [&] {
        bool changed = false;
        for (int k = 0; k < 60; ++k) changed |= region.watch(positions, still, 1.0 / 60.0);
        return changed;
    };
    int left = 0, right = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (positions[v].x() < positions[left].x()) left = static_cast<int>(v);
        if (positions[v].x() > positions[right].x()) right = static_cast<int>(v);
    }
    rest();
    ASSERT_EQ(region.live_count(), 0);
    region.hold(std::vector<int>{left});
    const int live_around_left = region.live_count();
    double threshold_mm = 0.0;
    for (const double radius : body.skeleton.radii_mm)
        threshold_mm = std::max(threshold_mm, options.wake_radii * radius);
    int moves = 0;
    for (; moves < 12 && region.live_count() == live_around_left; ++moves) {
        // The other end is held and let go, and freezes again.
        region.hold(std::vector<int>{left, right});
        region.hold(std::vector<int>{left});
        rest();
        ASSERT_EQ(region.live_count(), live_around_left);
        for (std::size_t v = 0; v < positions.size(); ++v)
            if (region.live(static_cast<int>(v))) positions[v].y() += 0.4 * threshold_mm;
        region.watch(positions, still, 1.0 / 60.0);
    }
    EXPECT_GE(moves, 2);
    EXPECT_LE(moves, 4);
    EXPECT_GT(region.live_count(), live_around_left);
}

// The threshold is in radii: of a vessel four times as wide it is four times as far.
TEST(LiveRegion, StrainAddsUpOverChangesOfTheRegion) {
    for (const double width_mm : {0.75, 3.0, 12.0}) expect_creep_to_wake(width_mm);
}

TEST(LiveStepper, NothingMovesNothingIsComputed) {
    const BodyDescription body = tree_body();
    const auto stepper = make_live_stepper(body, {});
    for (int k = 0; k < 60; ++k) stepper->step(1.0 / 60.0);
    EXPECT_TRUE(stepper->step(1.0 / 60.0).asleep);
    EXPECT_EQ(stepper->extent().live_elements, 0);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        EXPECT_LT((stepper->positions_mm()[v] - body.mesh.vertices_mm[v]).norm(), 1e-6);
    }
}

struct Comparison {
    int most_live = 0;        // elements
    double difference = 0.0;  // largest, between the live and the whole computation
    double longest_step = 0.0;
    double left_over = 0.0;  // furthest from rest, long after release
};

// A twig's tip is led around by 1.5 mm and let go.
Comparison lead_around(const BodyDescription& body) {
    // Hundreds of steps of loops too short to share: on a busy machine a second thread that is set
    // aside in the middle of one holds up the first.
    const ThreadLimit limit(1);
    const auto live = make_live_stepper(body, {});
    StepperOptions options;
    options.sleeping = false;
    const auto whole = make_cpu_stepper(body, options);
    for (int k = 0; k < 60; ++k) live->step(1.0 / 60.0);
    const int tip = tip_of(body);
    const Vec3 start = body.mesh.vertices_mm[tip];
    Comparison result;
    std::vector<Vec3> before(live->positions_mm().begin(), live->positions_mm().end());
    for (int k = 0; k < 100; ++k) {
        const double angle = 0.05 * std::min(k, 60);
        const Grab grab =
            pull(tip, start + Vec3(0.0, 1.5 * std::sin(angle), 1.0 - std::cos(angle)));
        live->set_grabs(std::span(&grab, 1));
        whole->set_grabs(std::span(&grab, 1));
        EXPECT_FALSE(live->step(1.0 / 60.0).asleep);
        whole->step(1.0 / 60.0);
        result.most_live = std::max(result.most_live, live->extent().live_elements);
        for (std::size_t v = 0; v < before.size(); ++v) {
            const Vec3& now = live->positions_mm()[v];
            result.difference =
                std::max(result.difference, (now - whole->positions_mm()[v]).norm());
            result.longest_step = std::max(result.longest_step, (now - before[v]).norm());
            before[v] = now;
        }
    }
    live->set_grabs({});
    for (int k = 0; k < 300; ++k) live->step(1.0 / 60.0);
    for (std::size_t v = 0; v < before.size(); ++v) {
        result.left_over =
            std::max(result.left_over, (live->positions_mm()[v] - body.mesh.vertices_mm[v]).norm());
    }
    return result;
}

TEST(LiveStepper, AHeldTwigMovesAsInTheWholeBodyAndNothingJumps) {
    const Comparison result = lead_around(tree_body());
    EXPECT_LT(result.difference, 0.15);   // a tenth of the pull, while it wakes
    EXPECT_LT(result.longest_step, 0.3);  // the target itself moves by 0.09 mm a step
    EXPECT_LT(result.left_over, 0.05);
}

TEST(LiveStepper, InTissueOnlyTheHeldTwigIsComputed) {
    BodyDescription body = tree_body(5);
    body.tether_pa_per_mm2 = 5000.0;
    const Comparison result = lead_around(body);
    EXPECT_LT(result.most_live, static_cast<int>(body.mesh.tetrahedra.size()) / 2);
    EXPECT_LT(result.difference, 0.02);
    EXPECT_LT(result.longest_step, 0.3);
    EXPECT_LT(result.left_over, 0.01);
}

TEST(LiveStepper, GravityWakesEverything) {
    const BodyDescription body = tree_body();
    const auto live = make_live_stepper(body, {});
    for (int k = 0; k < 60; ++k) live->step(1.0 / 60.0);
    EXPECT_EQ(live->extent().live_elements, 0);
    live->set_gravity(Vec3(0.0, -9810.0, 0.0));
    EXPECT_EQ(live->extent().live_elements, live->extent().elements);
    EXPECT_FALSE(live->step(1.0 / 60.0).asleep);
}

// Where it rests under gravity, and what is held there still feels its weight: neither what froze
// nor what woke again is lifted.
TEST(LiveStepper, SagsAsTheWholeBodyAndStaysSagged) {
    const BodyDescription body = tree_body();
    const Vec3 gravity(0.0, -9810.0, 0.0);
    const auto live = make_live_stepper(body, {});
    const auto whole = make_cpu_stepper(body, {});
    live->set_gravity(gravity);
    whole->set_gravity(gravity);
    for (int k = 0; k < 400; ++k) {
        live->step(1.0 / 60.0);
        whole->step(1.0 / 60.0);
    }
    const int tip = tip_of(body);
    const double sagged = body.mesh.vertices_mm[tip].y() - live->positions_mm()[tip].y();
    EXPECT_GT(sagged, 0.1);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        EXPECT_LT((live->positions_mm()[v] - whole->positions_mm()[v]).norm(), 0.02 * sagged);
    }
    EXPECT_EQ(live->extent().live_elements, 0);
    const Grab grab = pull(tip, live->positions_mm()[tip]);
    live->set_grabs(std::span(&grab, 1));
    for (int k = 0; k < 100; ++k) live->step(1.0 / 60.0);
    EXPECT_GT(live->extent().live_elements, 0);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        EXPECT_LT((live->positions_mm()[v] - whole->positions_mm()[v]).norm(), 0.02 * sagged);
    }
}

TEST(LiveStepper, QuadraticElementsFallAsInTheWholeBody) {
    StepperOptions options;
    options.order = ElementOrder::quadratic;
    options.sleeping = false;
    const BodyDescription body = test::description_of(test::make_bar(24.0, 6.0, 8, 2));
    const auto live = make_live_stepper(body, options);
    const auto whole = make_cpu_stepper(body, options);
    live->set_gravity(Vec3(0.0, -9810.0, 0.0));
    whole->set_gravity(Vec3(0.0, -9810.0, 0.0));
    for (int k = 0; k < 20; ++k) {  // too short for anything to freeze
        live->step(1.0 / 60.0);
        whole->step(1.0 / 60.0);
    }
    EXPECT_EQ(live->extent().live_elements, live->extent().elements);
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        EXPECT_EQ(live->positions_mm()[v], whole->positions_mm()[v]);
    }
}

TEST(LiveStepper, OfQuadraticElementsOnlyTheHeldTwigIsComputed) {
    StepperOptions options;
    options.order = ElementOrder::quadratic;
    BodyDescription body = tree_body(4);
    body.tether_pa_per_mm2 = 4000.0;
    const auto live = make_live_stepper(body, options, {.wake_radii = 3e-3});
    options.sleeping = false;
    const auto whole = make_cpu_stepper(body, options);
    for (int k = 0; k < 60; ++k) live->step(1.0 / 60.0);
    ASSERT_EQ(live->extent().live_elements, 0);
    const int tip = tip_of(body);
    int most = 0;
    double moved = 0.0, difference = 0.0;
    for (int k = 0; k < 30; ++k) {
        const Grab grab = pull(tip, body.mesh.vertices_mm[tip] + Vec3(0.0, 0.05 * k, 0.0));
        live->set_grabs(std::span(&grab, 1));
        whole->set_grabs(std::span(&grab, 1));
        live->step(1.0 / 60.0);
        whole->step(1.0 / 60.0);
        most = std::max(most, live->extent().live_elements);
        const std::vector<Vec3> now = live->state().positions_mm;
        const std::vector<Vec3> truth = whole->state().positions_mm;
        for (std::size_t i = 0; i < now.size(); ++i) {
            difference = std::max(difference, (now[i] - truth[i]).norm());
            if (i < body.mesh.vertices_mm.size())
                moved = std::max(moved, (truth[i] - body.mesh.vertices_mm[i]).norm());
        }
    }
    EXPECT_LT(most, live->extent().elements);
    EXPECT_GT(moved, 0.3);
    EXPECT_LT(difference, 0.02 * moved);
}

TEST(LiveStepper, KeepsTheMiddlesOfQuadraticElementsInItsState) {
    StepperOptions options;
    options.order = ElementOrder::quadratic;
    const BodyDescription body = tree_body();
    const auto live = make_live_stepper(body, options);
    live->set_gravity(Vec3(0.0, -9810.0, 0.0));
    for (int k = 0; k < 5; ++k) live->step(1.0 / 60.0);
    const BodyState kept = live->state();
    ASSERT_GT(kept.positions_mm.size(), body.mesh.vertices_mm.size());
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
        EXPECT_EQ(kept.positions_mm[v], live->positions_mm()[v]);
    const auto other = make_live_stepper(body, options);
    other->set_state(kept.positions_mm, kept.velocities_mm_per_s);
    EXPECT_EQ(other->state().positions_mm, kept.positions_mm);
    EXPECT_EQ(other->positions_mm()[7], kept.positions_mm[7]);
}

// A change of the dial in mid-pull neither wakes what rests nor moves anything.
TEST(LiveStepper, TakesOtherOptionsWithoutWakingWhatRests) {
    BodyDescription body = tree_body();
    body.tether_pa_per_mm2 = 1000.0;
    const auto live = make_live_stepper(body, {});
    for (int k = 0; k < 60; ++k) live->step(1.0 / 60.0);
    Grab grab;
    grab.vertices[0] = 0;
    grab.target_mm = body.mesh.vertices_mm[0] + Vec3(0.0, 1.0, 0.0);
    grab.stiffness_un_per_mm = 1e4;
    grab.force_limit_un = 1e5;
    live->set_grabs(std::span(&grab, 1));
    for (int k = 0; k < 3; ++k) live->step(1.0 / 60.0);
    const BodyState before = live->state();
    const int computed = live->extent().live_elements;
    StepperOptions options;
    options.substeps = 4;
    EXPECT_TRUE(live->set_options(options));
    options.model = ElementModel::neohookean;
    EXPECT_TRUE(live->set_options(options));
    EXPECT_EQ(live->state().positions_mm, before.positions_mm);
    EXPECT_EQ(live->state().velocities_mm_per_s, before.velocities_mm_per_s);
    EXPECT_EQ(live->extent().live_elements, computed);
    EXPECT_LT(computed, live->extent().elements);
    options.order = ElementOrder::quadratic;
    EXPECT_FALSE(live->set_options(options));
}

}  // namespace
}  // namespace hepatica
