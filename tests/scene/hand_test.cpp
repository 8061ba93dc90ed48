// SPDX-License-Identifier: GPL-3.0-or-later
// A hand apart from any stepper: what it closes around, its springs, and the pull that it shows.
#include "core/scene/hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::small_patient;

// The vertex with most others within the radius of its vessel.
int best_surrounded(const BodyVertices& body, const std::vector<Vec3>& positions) {
    int best = 0;
    std::ptrdiff_t most = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (body.fixed()[v] != 0) continue;
        const auto near = std::ranges::count_if(positions, [&](const Vec3& x) {
            return (x - positions[v]).norm() <= body.places()[v].radius_mm;
        });
        if (near > most) {
            most = near;
            best = static_cast<int>(v);
        }
    }
    return best;
}

TEST(Hand, ClosesAroundWhatIsNearNowAndAtRest) {
    const PatientCase& patient = *small_patient();
    const BodyVertices body(patient.mesh, patient.tree, FixedEnds::roots);
    std::vector<Vec3> positions = patient.mesh.vertices_mm;
    const int vertex = best_surrounded(body, positions);
    const double radius_mm = body.places()[vertex].radius_mm;
    const Vec3 held = positions[vertex], point_mm = held + Vec3(0.1, 0.2, 0.3);
    // One that comes from elsewhere lies in the hand, but belongs to another vessel.
    std::size_t far = 0;
    for (std::size_t v = 0; v < positions.size(); ++v)
        if ((positions[v] - held).norm() > (positions[far] - held).norm()) far = v;
    ASSERT_GT((positions[far] - held).norm(), 2.0 * radius_mm);
    positions[far] = held;
    const Hold hold = hold_around(vertex, point_mm, body, positions, 5000.0, 2000.0);
    std::vector<int> near;
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (v != far && (positions[v] - held).norm() <= radius_mm && body.fixed()[v] == 0)
            near.push_back(static_cast<int>(v));
    ASSERT_GT(near.size(), 1u);
    EXPECT_EQ(hold.vertices, near);
    EXPECT_EQ(hold.target_mm, point_mm);
    const auto springs = static_cast<double>(near.size());
    EXPECT_NEAR(springs * hold.stiffness_un_per_mm, 5000.0 * std::numbers::pi * radius_mm, 1e-6);
    EXPECT_NEAR(springs * hold.force_limit_un, 2000.0 * std::numbers::pi * radius_mm * radius_mm,
                1e-6);
    for (std::size_t i = 0; i < near.size(); ++i)
        EXPECT_EQ(hold.offsets_mm[i], positions[near[i]] - point_mm);
}

// A vertex at a fixed end is held alone: the others there do not move.
TEST(Hand, HoldsAtLeastTheVertexThatItWasPutOn) {
    const PatientCase& patient = *small_patient();
    const BodyVertices body(patient.mesh, patient.tree, FixedEnds::roots);
    const auto fixed = std::ranges::find(body.fixed(), 1);
    ASSERT_NE(fixed, body.fixed().end());
    // Far from all others, so that none of them is near.
    std::vector<Vec3> positions = patient.mesh.vertices_mm;
    const auto vertex = static_cast<int>(fixed - body.fixed().begin());
    positions[vertex] += Vec3(1000, 0, 0);
    const Hold hold = hold_around(vertex, positions[vertex], body, positions, 5000.0, 2000.0);
    EXPECT_EQ(hold.vertices, std::vector<int>{vertex});
    EXPECT_EQ(hold.offsets_mm, std::vector<Vec3>{Vec3::Zero()});
}

// Two springs of 10 uN/mm, with at most 15 uN each.
Hold two_springs() {
    Hold hold;
    hold.vertices = {2, 0};
    hold.offsets_mm = {Vec3(1, 0, 0), Vec3(-1, 0, 0)};
    hold.target_mm = Vec3(0, 0, 1);
    hold.stiffness_un_per_mm = 10.0;
    hold.force_limit_un = 15.0;
    return hold;
}

TEST(Hand, HasASpringForEachVertex) {
    const std::vector<Grab> springs = springs_of(two_springs());
    ASSERT_EQ(springs.size(), 2u);
    EXPECT_EQ(springs[0].vertices[0], 2);
    EXPECT_EQ(springs[1].vertices[0], 0);
    EXPECT_EQ(springs[0].target_mm, Vec3(1, 0, 1));
    EXPECT_EQ(springs[1].target_mm, Vec3(-1, 0, 1));
    for (const Grab& spring : springs) {
        EXPECT_EQ(spring.stiffness_un_per_mm, 10.0);
        EXPECT_EQ(spring.force_limit_un, 15.0);
    }
}

TEST(Hand, ShowsItsPullAndWhetherHalfOfItsSpringsAreAtTheirLimit) {
    // Both vertices where the hand took them: 1 mm below its target.
    std::vector<Vec3> positions{Vec3(-1, 0, 0), Vec3(9, 9, 9), Vec3(1, 0, 0)};
    GrabView view = view_of(two_springs(), positions);
    EXPECT_EQ(view.target_mm, Vec3(0, 0, 1));
    EXPECT_EQ(view.point_mm, Vec3(0, 0, 0));
    EXPECT_DOUBLE_EQ(view.force_un, 20.0);
    EXPECT_FALSE(view.at_limit);
    // One of them 2 mm below: 15 uN instead of 20.
    positions[0].z() = -1.0;
    view = view_of(two_springs(), positions);
    EXPECT_EQ(view.point_mm, Vec3(0, 0, -0.5));
    EXPECT_DOUBLE_EQ(view.force_un, 25.0);
    EXPECT_TRUE(view.at_limit);
}

TEST(Hand, OfAnotherBodyIsRefused) {
    EXPECT_NO_THROW(require_hold_of(3, two_springs()));
    EXPECT_THROW(require_hold_of(2, two_springs()), InputError);
    Hold wrong = two_springs();
    wrong.vertices[0] = -1;
    EXPECT_THROW(require_hold_of(3, wrong), InputError);
    wrong = two_springs();
    wrong.offsets_mm.pop_back();
    EXPECT_THROW(require_hold_of(3, wrong), InputError);
}

// Whatever pulls otherwise has another hash.
TEST(Hand, IsHashedWhole) {
    const auto hash_of = [](const Hold& hold) {
        Hasher hasher;
        add_to(hasher, hold);
        return hasher.value();
    };
    const std::uint64_t one = hash_of(two_springs());
    EXPECT_EQ(hash_of(two_springs()), one);
    const auto expect_other = [&](auto change) {
        Hold other = two_springs();
        change(other);
        EXPECT_NE(hash_of(other), one);
    };
    expect_other([](Hold& h) { h.vertices[1] = 1; });
    expect_other([](Hold& h) { h.offsets_mm[1].y() = 1e-9; });
    expect_other([](Hold& h) { h.target_mm.x() = 1e-9; });
    expect_other([](Hold& h) { h.stiffness_un_per_mm = 11.0; });
    expect_other([](Hold& h) { h.force_limit_un = 16.0; });
}

}  // namespace
}  // namespace hepatica
