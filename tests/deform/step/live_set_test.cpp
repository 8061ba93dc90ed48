// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/live_set.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/frame_time.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

BodyDescription bar() {
    return test::description_of(test::make_bar(36.0, 3.0, 12, 1));
}

// Of the nodes further along x than this: 1.
std::vector<std::uint8_t> beyond(const Body& body, double x_mm) {
    std::vector<std::uint8_t> frozen;
    for (const Vec3& x : body.rest_positions_mm) frozen.push_back(x.x() > x_mm ? 1 : 0);
    return frozen;
}

// With the velocities of what is held put to 0.
BodyState stopped(const StepBackEnd& back_end, const std::vector<std::uint8_t>& held) {
    BodyState state = back_end.state();
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != 0) state.velocities_mm_per_s[i].setZero();
    return state;
}

double furthest_apart(const BodyState& a, const BodyState& b) {
    double apart = 0.0;
    for (std::size_t i = 0; i < a.positions_mm.size(); ++i) {
        apart = std::max(apart, (a.positions_mm[i] - b.positions_mm[i]).norm());
        apart =
            std::max(apart, frame_s * (a.velocities_mm_per_s[i] - b.velocities_mm_per_s[i]).norm());
    }
    return apart;
}

class Frozen : public testing::TestWithParam<std::tuple<LinearSolverKind, ElementOrder, int>> {};

// What is frozen is as if it were fixed there: the rest moves as in a body that was made so. The
// set grows, shrinks and moves on, and the energies stay those of the whole.
TEST_P(Frozen, NodesActAsFixedOnesWhateverWasFrozenBefore) {
    const auto [solver, order, iterations] = GetParam();
    const BodyDescription description = bar();
    const StepperOptions options{
        .order = order,
        .solver = solver,
        .linear = {.energy_tolerance = 1e-10},
        .newton_iterations = iterations,
    };
    Vec3 gravity = 10.0 * units::standard_gravity * Vec3(0, 0.3, -1.0);
    const auto one = make_cpu_back_end(description, options);
    const auto nodes = static_cast<std::size_t>(one->body().node_count());
    double size_mm = 0.0;
    for (const Vec3& x : one->body().rest_positions_mm) size_mm = std::max(size_mm, x.x());
    for (const double share : {2.0, 0.6, 0.2, 0.4, 0.9, 0.1}) {
        const std::vector<std::uint8_t> frozen = beyond(one->body(), share * size_mm);
        gravity *= -1.0;
        one->set_gravity(gravity);
        one->set_velocities(stopped(*one, frozen).velocities_mm_per_s);
        one->freeze(frozen);
        // Another one, made for this set alone: by the description where all nodes are vertices.
        BodyDescription own = description;
        own.fixed.resize(description.mesh.vertices_mm.size(), 0);
        for (std::size_t v = 0; v < own.fixed.size(); ++v) own.fixed[v] |= frozen[v];
        const auto other =
            make_cpu_back_end(order == ElementOrder::linear ? own : description, options);
        other->set_gravity(gravity);
        other->set_state(one->state());
        if (order == ElementOrder::quadratic) other->freeze(frozen);
        double moved = 0.0;
        for (int k = 0; k < 4; ++k) {
            const BodyState before = one->state();
            const StepReport report = one->advance(frame_s);
            const StepReport truth = other->advance(frame_s);
            moved = std::max(moved, furthest_apart(before, one->state()));
            EXPECT_LT(furthest_apart(one->state(), other->state()), 1e-6 * size_mm)
                << "frozen beyond " << share << ", step " << k;
            EXPECT_NEAR(report.energy.elastic, truth.energy.elastic,
                        1e-6 * energy_handled(truth.energy));
            EXPECT_LT(relative_imbalance(report.energy), 1e-9);
            EXPECT_NEAR(report.energy.elastic, one->energies().elastic,
                        1e-12 * energy_handled(truth.energy));
            for (std::size_t i = 0; i < nodes; ++i)
                if (frozen[i] != 0) {
                    EXPECT_EQ(one->state().positions_mm[i], before.positions_mm[i]);
                }
        }
        EXPECT_GT(moved, 1e-4);  // mm
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Frozen,
    testing::Combine(testing::Values(LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                                     LinearSolverKind::cholesky),
                     testing::Values(ElementOrder::linear, ElementOrder::quadratic),
                     testing::Values(1, 3)));

// Random sets: rows and packs are those of the elements that have a live node.
TEST(LiveSet, ListsTheRowsAndPacksOfLiveElements) {
    const Body body = build_body(test::description_of(test::make_brick_tree(3, 3.0, 1.5)),
                                 ElementModel::corotated, ElementOrder::linear);
    const ElementGroup& group = body.groups.at(0);
    LiveSet live(body);
    std::mt19937 random(3);
    std::vector<int> before(live.changed_rows().begin(), live.changed_rows().end());
    EXPECT_EQ(before.size(), body.mass_g.size());
    for (const double share : {0.0, 0.5, 0.9, 0.99, 1.0, 0.7}) {
        std::vector<std::uint8_t> frozen(body.mass_g.size());
        for (auto& f : frozen) f = std::generate_canonical<double, 32>(random) < share ? 1 : 0;
        live.freeze(frozen);
        std::vector<char> row(frozen.size(), 0), pack((group.size() + 3) / 4, 0);
        int elements = 0;
        for (int e = 0; e < group.size(); ++e) {
            bool moves = false, thawed = false;
            for (int a = 0; a < 4; ++a) {
                const int i = group.connectivity[4 * e + a];
                moves |= frozen[i] == 0 && body.fixed[i] == 0;
                thawed |= frozen[i] == 0;
            }
            elements += thawed ? 1 : 0;
            if (!moves) continue;
            pack[e / 4] = 1;
            for (int a = 0; a < 4; ++a) row[group.connectivity[4 * e + a]] = 1;
        }
        EXPECT_EQ(live.live_elements(), elements);
        EXPECT_EQ(live.rows().size(), static_cast<std::size_t>(std::ranges::count(row, 1)));
        for (const int i : live.rows()) EXPECT_EQ(row[i], 1);
        EXPECT_EQ(live.packs(0).size(), static_cast<std::size_t>(std::ranges::count(pack, 1)));
        for (const int p : live.packs(0)) EXPECT_EQ(pack[p], 1);
        // Every row that is written now or was before.
        for (const int i : live.rows())
            EXPECT_TRUE(std::ranges::binary_search(live.changed_rows(), i));
        for (const int i : before) EXPECT_TRUE(std::ranges::binary_search(live.changed_rows(), i));
        live.written();
        before.assign(live.rows().begin(), live.rows().end());
        EXPECT_TRUE(std::ranges::equal(live.changed_rows(), live.rows()));
    }
}

}  // namespace
}  // namespace hepatica
