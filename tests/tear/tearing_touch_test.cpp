// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose surfaces touch each other while they tear: what is pressed together stays apart, and
// what was torn off counts as soon as it has come away.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/frame_time.h"
#include "core/contact/surface_patches.h"
#include "core/deform/body/torn_body.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/crossing_triangles.h"
#include "core/mesh/surface.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

// Two crossed bars that tear only where a blade passes. The lower one lies on a table.
BodyDescription bars_to_cut() {
    BodyDescription body = test::crossed_bars(0.5);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < -1.9);
    body.self->pressure_moduli = 0.02;
    body.tear.emplace();
    body.tear->tear_factor = 1e3;
    return body;
}

// Springs that lead the upper side of the upper bar by a shift, on one side of its middle or both.
std::vector<Grab> lead(const BodyDescription& body, const Vec3& shift_mm, double least_y) {
    std::vector<Grab> grabs;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        const Vec3& x = body.mesh.vertices_mm[v];
        if (x.z() < 6.0 || x.y() < least_y) continue;
        Grab grab;
        grab.vertices[0] = static_cast<int>(v);
        grab.target_mm = x + shift_mm;
        grab.stiffness_un_per_mm = 3e6;
        grab.force_limit_un = 1e12;
        grabs.push_back(grab);
    }
    return grabs;
}

// Triangles that cross, of vertices with these heights at rest.
std::size_t crossings(const Stepper& stepper, const BodyDescription& body,
                      const std::function<bool(double, double)>& of_heights) {
    const TornTopology& topology = stepper.tearing()->topology();
    const auto triangles = topology.surface();
    const auto height = [&](int t) {
        int v = triangles[t][0];
        while (topology.parents()[v] != v) v = topology.parents()[v];
        return body.mesh.vertices_mm[v].z();
    };
    std::size_t count = 0;
    for (const auto& [a, b] : crossing_triangles(triangles, stepper.positions_mm()))
        count += of_heights(height(a), height(b)) ? 1 : 0;
    return count;
}

bool any(double, double) {
    return true;
}

// One bar and the other.
bool of_both_bars(double a, double b) {
    return (a < 2.1) != (b < 2.1);
}

constexpr double everywhere = -100.0;

// Presses the upper bar onto the lower one.
void press(Stepper& stepper, const BodyDescription& body) {
    double gap_mm = 0.0;
    for (int k = 1; k <= 90; ++k) {
        stepper.set_grabs(lead(body, Vec3(0, 0, -0.04 * k), everywhere));
        gap_mm = stepper.step(frame_s).self.least_gap_mm;
    }
    ASSERT_LT(gap_mm, 0.01) << "nearer than what overlaps at rest";
    ASSERT_EQ(crossings(stepper, body, any), 0u);
}

// Presses, and cuts beside the place where they touch.
void press_and_cut(Stepper& stepper, const BodyDescription& body) {
    press(stepper, body);
    stepper.cut(Vec3(-20, 5, -20), Vec3(40, 0, 0), Vec3(0, 0, 40));
    ASSERT_EQ(stepper.tearing()->report().pieces, 3);
}

TEST(TearingTouch, WhatIsPressedTogetherStaysApartWhenSomethingTears) {
    const BodyDescription body = bars_to_cut();
    const auto stepper = make_cpu_stepper(body, {});
    press_and_cut(*stepper, body);
    for (int k = 91; k <= 180; ++k) {
        stepper->set_grabs(lead(body, Vec3(0, 0, -0.04 * k), everywhere));
        EXPECT_GT(stepper->step(frame_s).self.contacts, 0) << k;
        if (k % 15 == 0) {
            EXPECT_EQ(crossings(*stepper, body, of_both_bars), 0u) << k;
        }
    }
}

// The cut itself presses nothing: its faces lie on each other.
TEST(TearingTouch, ACutAddsNoEnergy) {
    const BodyDescription body = bars_to_cut();
    const auto stepper = make_cpu_stepper(body, {});
    press_and_cut(*stepper, body);
    const auto whole = make_cpu_stepper(body, {});
    for (int k = 1; k <= 90; ++k) {
        whole->set_grabs(lead(body, Vec3(0, 0, -0.04 * k), everywhere));
        whole->step(frame_s);
    }
    const double before = whole->energies().contact, after = stepper->energies().contact;
    EXPECT_GT(before, 0.0);
    EXPECT_NEAR(after, before, 1e-9 * before);
}

// A cut through the place where they touch: faces are laid bare there, and vertices in pads split.
TEST(TearingTouch, ACutThroughWhatIsPressedStoresNothing) {
    const BodyDescription body = bars_to_cut();
    const auto stepper = make_cpu_stepper(body, {});
    press(*stepper, body);
    const EnergyLedger before = stepper->energies();
    ASSERT_GT(before.contact, 0.0);
    stepper->cut(Vec3(-20, 0.1, -20), Vec3(40, 0, 0), Vec3(0, 0, 40));
    ASSERT_FALSE(stepper->checkpoint().self->overlaps.pads.empty()) << "no pad would be another";
    const EnergyLedger after = stepper->energies();
    EXPECT_NEAR(after.contact, before.contact, 1e-12 * before.contact);
    EXPECT_NEAR(stored_energy(after) - stored_energy(before), after.tool_work - before.tool_work,
                1e-9 * stored_energy(before));
}

TEST(TearingTouch, WhatWasCutOffCountsWhenItHasComeAway) {
    const BodyDescription body = bars_to_cut();
    const auto stepper = make_cpu_stepper(body, {});
    stepper->cut(Vec3(-20, 5, -20), Vec3(40, 0, 0), Vec3(0, 0, 40));
    const auto lead_for = [&](int steps, double from_mm, double to_mm) {
        int touched = 0;
        for (int k = 1; k <= steps; ++k) {
            const double y = from_mm + (to_mm - from_mm) * k / steps;
            stepper->set_grabs(lead(body, Vec3(0, y, 0), 5.5));
            touched += stepper->step(frame_s).self.contacts > 0 ? 1 : 0;
        }
        return touched;
    };
    EXPECT_EQ(lead_for(120, 0.0, 4.0), 0);
    EXPECT_GT(lead_for(180, 4.0, -2.0), 10);
    EXPECT_EQ(crossings(*stepper, body, any), 0u);
}

// A bar that is clamped at one end, cut through the upper half of its middle and pulled down at the
// other end; it is one piece still. Returns how far that end has moved.
double bend_a_slit_bar(double unevenness_mm, bool self) {
    BodyDescription body;
    test::add_mesh(test::bar_at({24, 4, 4}, {12, 2, 2}, Mat3::Identity(), Vec3::Zero()), body.mesh);
    std::size_t tip = 0;
    double phase = 0.0;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        Vec3& x = body.mesh.vertices_mm[v];
        body.fixed.push_back(x.x() < -11.9);
        if (x.x() > 11.9 && x.z() > 1.9) tip = v;
        phase += 1.0;
        x += unevenness_mm *
             Vec3(std::sin(7.1 * phase), std::cos(3.3 * phase), std::sin(1.7 * phase));
    }
    if (self) body.self.emplace();
    body.tear.emplace();
    body.tear->tear_factor = 1e3;
    const auto stepper = make_cpu_stepper(body, {});
    stepper->cut(Vec3(0.2, -20, 0), Vec3(0, 40, 0), Vec3(0, 0, 40));
    EXPECT_EQ(stepper->tearing()->report().pieces, 1);
    EXPECT_GT(stepper->tearing()->report().vertices_split, 0);
    Grab grab;
    grab.vertices[0] = static_cast<int>(tip);
    grab.target_mm = body.mesh.vertices_mm[tip] + Vec3(0, 0, -6);
    grab.stiffness_un_per_mm = 1e5;
    grab.force_limit_un = 1e12;
    stepper->set_grabs(std::vector<Grab>{grab});
    for (int k = 0; k < 60; ++k) stepper->step(frame_s);
    return stepper->positions_mm()[tip].z() - body.mesh.vertices_mm[tip].z();
}

// Rounding leaves other distances between the sides of an uneven slit than 0.
TEST(TearingTouch, WhatIsCutPartOfTheWayBendsAsItDoesWithoutContact) {
    for (const double unevenness_mm : {0.0, 0.02}) {
        const double alone = bend_a_slit_bar(unevenness_mm, false);
        EXPECT_LT(alone, -4.0);
        EXPECT_NEAR(bend_a_slit_bar(unevenness_mm, true), alone, 1e-3);
    }
}

}  // namespace
}  // namespace hepatica
