// SPDX-License-Identifier: GPL-3.0-or-later
// The plan alone, as a back end of another kind would use it: every slot is gathered once, and the
// lists give the matrix of the elements.
#include "core/deform/step/assembly_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "core/deform/body/torn_body.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

Body two_bricks(ElementModel model, ElementOrder order) {
    BodyDescription d;
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(50, 0, 0)}) {
        const TetMesh mesh = kuhn_brick(Vec3(3, 2, 1), {3, 2, 1});
        const int offset = static_cast<int>(d.mesh.vertices_mm.size());
        for (const Vec3& x : mesh.vertices_mm) d.mesh.vertices_mm.push_back(x + place);
        for (const auto& t : mesh.tetrahedra)
            d.mesh.tetrahedra.push_back(
                {t[0] + offset, t[1] + offset, t[2] + offset, t[3] + offset});
    }
    return build_body(d, model, order);
}

// Sorted, the places of all lists together.
std::vector<int> places(const GatherLists& one, const GatherLists& other = {}) {
    std::vector<int> all = one.place;
    all.insert(all.end(), other.place.begin(), other.place.end());
    std::ranges::sort(all);
    return all;
}

std::vector<int> counted(int count) {
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

TEST(AssemblyPlan, GathersEverySlotOnceAtTheNodesItWasWrittenFor) {
    const Body body = two_bricks(ElementModel::neohookean, ElementOrder::quadratic);
    const AssemblyPlan plan = plan_assembly(body, small::Tangent::projected);
    EXPECT_FALSE(plan.groups[0].in_factors);
    EXPECT_EQ(places(plan.forces), counted(plan.force_slots));
    EXPECT_EQ(places(plan.blocks, plan.transposed), counted(plan.block_slots));
    EXPECT_TRUE(plan.factors.place.empty());
    const ElementGroup& group = body.groups[0];
    for (int i = 0; i < body.node_count(); ++i)
        for (int k = plan.forces.begin[i]; k < plan.forces.begin[i + 1]; ++k)
            EXPECT_EQ(group.connectivity[plan.forces.place[k]], i);
}

TEST(AssemblyPlan, FactorsComeInPairsOfOneElementForItsRowAndItsColumn) {
    const Body body = two_bricks(ElementModel::corotated, ElementOrder::linear);
    const AssemblyPlan plan = plan_assembly(body, small::Tangent::rotated);
    EXPECT_TRUE(plan.groups[0].in_factors);
    EXPECT_EQ(plan.block_slots, 0);
    EXPECT_EQ(plan.factors.place.size(), 12 * static_cast<std::size_t>(body.groups[0].size()));
    const ElementGroup& group = body.groups[0];
    for (int i = 0; i < body.node_count(); ++i)
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k)
            for (int s = plan.factors.begin[k]; s < plan.factors.begin[k + 1]; s += 2) {
                const int row = plan.factors.place[s], column = plan.factors.place[s + 1];
                EXPECT_EQ(row / 4, column / 4);
                EXPECT_EQ(group.connectivity[row], i);
                EXPECT_EQ(group.connectivity[column], plan.column[k]);
            }
}

TEST(AssemblyPlan, PatternIsSymmetricAndItsMirrorSaysWhere) {
    const Body body = two_bricks(ElementModel::corotated, ElementOrder::linear);
    const AssemblyPlan plan = plan_assembly(body, small::Tangent::rotated);
    for (int i = 0; i < body.node_count(); ++i) {
        EXPECT_EQ(plan.column[plan.diagonal[i]], i);
        for (int k = plan.row_begin[i]; k < plan.row_begin[i + 1]; ++k) {
            const int j = plan.column[k], m = plan.mirror[k];
            EXPECT_EQ(plan.column[m], i);
            EXPECT_TRUE(m >= plan.row_begin[j] && m < plan.row_begin[j + 1]);
        }
    }
}

TEST(AssemblyPlan, PiecesAreWhatElementsHoldTogether) {
    const Body body = two_bricks(ElementModel::corotated, ElementOrder::quadratic);
    const std::vector<int> piece = connected_pieces(plan_assembly(body, small::Tangent::rotated));
    for (int i = 0; i < body.node_count(); ++i)
        EXPECT_EQ(piece[i], body.rest_positions_mm[i][0] < 25.0 ? 0 : 1);
}

void expect_equal(const GatherLists& one, const GatherLists& other) {
    EXPECT_EQ(one.begin, other.begin);
    EXPECT_EQ(one.place, other.place);
}

void expect_equal(const AssemblyPlan& one, const AssemblyPlan& other) {
    EXPECT_EQ(one.force_slots, other.force_slots);
    EXPECT_EQ(one.block_slots, other.block_slots);
    EXPECT_EQ(one.lambda_over_mu, other.lambda_over_mu);
    EXPECT_EQ(one.row_begin, other.row_begin);
    EXPECT_EQ(one.column, other.column);
    EXPECT_EQ(one.diagonal, other.diagonal);
    EXPECT_EQ(one.mirror, other.mirror);
    expect_equal(one.forces, other.forces);
    expect_equal(one.factors, other.factors);
    expect_equal(one.blocks, other.blocks);
    expect_equal(one.transposed, other.transposed);
}

Body body_of(const BodyDescription& whole, const Tearing& tearing, ElementModel model) {
    const TornBody tear = torn_body_of(tearing);
    Body body = build_body(torn(whole, tear), model, ElementOrder::linear);
    body.parted_pairs = tear.parted_pairs;
    return body;
}

// A few joints at a time, at last all of them; then it is made whole again.
TEST(AssemblyPlan, AfterRandomSplitsItIsWhatWouldBeMadeAnew) {
    std::mt19937 random(5);
    for (const auto model : {ElementModel::corotated, ElementModel::neohookean}) {
        const auto tangent =
            model == ElementModel::corotated ? small::Tangent::rotated : small::Tangent::projected;
        BodyDescription whole;
        whole.mesh = kuhn_brick(Vec3(4, 3, 3), {4, 3, 3});
        whole.tear = TearLaw{};
        Tearing tearing(whole.mesh, *whole.tear, {});
        Body body = body_of(whole, tearing, model);
        AssemblyPlan plan = plan_assembly(body, tangent);
        std::vector<int> joints = counted(static_cast<int>(tearing.topology().joints().size()));
        std::ranges::shuffle(joints, random);
        std::size_t cut = 0;
        const auto follow = [&] {
            const Body before = std::exchange(body, body_of(whole, tearing, model));
            plan = plan_after_split(plan, before, body);
            expect_equal(plan, plan_assembly(body, tangent));
        };
        while (cut < joints.size() && !testing::Test::HasFailure()) {
            const std::size_t count = std::min(joints.size() - cut, std::size_t{1} + random() % 40);
            tearing.cut(std::span(joints).subspan(cut, count));
            cut += count;
            follow();
        }
        EXPECT_EQ(body.node_count(), 4 * static_cast<int>(whole.mesh.tetrahedra.size()));
        tearing.restore({});
        follow();
        EXPECT_EQ(body.node_count(), static_cast<int>(whole.mesh.vertices_mm.size()));
    }
}

}  // namespace
}  // namespace hepatica
