// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/inversion_recovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/deform/step/assembly.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

BodyDescription clamped_brick() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(80, 40, 40), {4, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0);
    return body;
}

// Distance of the rest shape to itself is what every energy of these tests measures.
InversionRecovery::Energy distance_to(const Body& body) {
    return [&body](std::span<const Vec3> x) {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
            sum += (x[i] - body.rest_positions_mm[i]).squaredNorm();
        return sum;
    };
}

TEST(InversionRecovery, LeavesAloneWhatIsNotInverted) {
    for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
        const Body body = build_body(clamped_brick(), ElementModel::corotated, order);
        std::vector<Vec3> bent = body.rest_positions_mm;
        for (Vec3& x : bent) x[2] += 0.002 * x[0] * x[0];
        EXPECT_TRUE(inverted_elements(body, bent).empty());
        EXPECT_FALSE(InversionRecovery(body).recover(bent, distance_to(body)));
    }
}

TEST(InversionRecovery, PutsOneVertexBackAndMovesNothingFurtherAway) {
    const Body body = build_body(clamped_brick(), ElementModel::corotated, ElementOrder::linear);
    std::vector<Vec3> folded = body.rest_positions_mm;
    // A corner of the free end pushed through the body.
    std::size_t corner = 0;
    for (std::size_t i = 0; i < folded.size(); ++i)
        if (folded[i].norm() > folded[corner].norm()) corner = i;
    folded[corner] -= Vec3(45, 0, 0);
    ASSERT_FALSE(inverted_elements(body, folded).empty());
    const auto recovered = InversionRecovery(body).recover(folded, distance_to(body));
    ASSERT_TRUE(recovered);
    EXPECT_TRUE(inverted_elements(body, *recovered).empty());
    for (std::size_t i = 0; i < folded.size(); ++i) {
        EXPECT_LT(((*recovered)[i] - body.rest_positions_mm[i]).norm(), 1e-6);
        if (folded[i][0] < 30.0) {
            EXPECT_EQ((*recovered)[i], folded[i]);
        }
    }
}

TEST(InversionRecovery, NeverRaisesTheEnergy) {
    const Body body = build_body(clamped_brick(), ElementModel::corotated, ElementOrder::linear);
    std::vector<Vec3> folded = body.rest_positions_mm;
    for (std::size_t i = 0; i < folded.size(); ++i)
        if (!body.fixed[i]) folded[i][0] = -folded[i][0];
    const InversionRecovery::Energy worse_than_folded = [&](std::span<const Vec3> x) {
        return x[folded.size() - 1] == folded.back() ? 0.0 : 1.0;
    };
    EXPECT_FALSE(InversionRecovery(body).recover(folded, worse_than_folded));
    EXPECT_TRUE(InversionRecovery(body).recover(folded, distance_to(body)));
}

// What a fold costs to put right is set by the fold: not by the body around it.
TEST(InversionRecovery, CostsWhatThePatchCosts) {
    int unknowns = 0;
    for (const int cells : {8, 64}) {
        BodyDescription description;
        description.mesh = kuhn_brick(Vec3(20.0 * cells, 40, 40), {cells, 2, 2});
        const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
        std::vector<Vec3> folded = body.rest_positions_mm;
        std::size_t pushed = 0;
        const Vec3 place(80, 0, 0);
        for (std::size_t i = 0; i < folded.size(); ++i)
            if ((folded[i] - place).norm() < (folded[pushed] - place).norm()) pushed = i;
        folded[pushed] += Vec3(45, 0, 0);
        InversionRecovery recovery(body);
        ASSERT_TRUE(recovery.recover(folded, distance_to(body)));
        EXPECT_GT(recovery.unknowns(), 0);
        if (unknowns > 0) {
            EXPECT_EQ(recovery.unknowns(), unknowns);
        }
        unknowns = recovery.unknowns();
        EXPECT_LT(unknowns, 3 * 9 * 8);
    }
}

// A body larger than a step can afford is left as it is, after no more work than is allowed.
TEST(InversionRecovery, GivesUpWhereThePatchOutgrowsAStep) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(300, 120, 120), {30, 12, 12});
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    std::vector<Vec3> folded = body.rest_positions_mm;
    folded[folded.size() / 2] += Vec3(25, 0, 0);
    InversionRecovery recovery(body);
    const auto never_lower = [](std::span<const Vec3>) { return 1.0; };
    EXPECT_FALSE(recovery.recover(folded, never_lower));
    EXPECT_GT(recovery.unknowns(), 0);
    EXPECT_LE(recovery.unknowns(), InversionRecovery::most_unknowns);
}

// Nothing fixed: the shape comes back where the body is, not where it was made.
TEST(InversionRecovery, KeepsThePlaceOfAFreeBody) {
    BodyDescription description = clamped_brick();
    description.fixed.clear();
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    std::vector<Vec3> folded;
    for (const Vec3& x : body.rest_positions_mm)
        folded.push_back(Vec3(500, 0, 0) + Vec3(-x[1], x[0], x[2]));
    std::vector<Vec3> place = folded;
    folded[folded.size() / 2] += Vec3(0, 60, 0);
    ASSERT_FALSE(inverted_elements(body, folded).empty());
    const auto recovered = InversionRecovery(body).recover(folded, [&](std::span<const Vec3> x) {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - place[i]).squaredNorm();
        return sum;
    });
    ASSERT_TRUE(recovered);
    for (std::size_t i = 0; i < place.size(); ++i)
        EXPECT_LT(((*recovered)[i] - place[i]).norm(), 0.5);
}

// A fragment that lies far from its place at rest stays where it is, whatever else is put right
// with it: a free cube beside a clamped bar, an element of each turned inside out.
// A bar that is held at one end, and beside it a cube.
BodyDescription bar_and_loose_cube() {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(80, 8, 8), {20, 2, 2});
    const std::size_t first = description.mesh.vertices_mm.size();
    const TetMesh cube = kuhn_brick(Vec3(4, 4, 4), {1, 1, 1});
    for (const Vec3& x : cube.vertices_mm)
        description.mesh.vertices_mm.emplace_back(x + Vec3(40, 20, 0));
    for (auto nodes : cube.tetrahedra) {
        for (int& node : nodes) node += static_cast<int>(first);
        description.mesh.tetrahedra.push_back(nodes);
    }
    for (const Vec3& x : description.mesh.vertices_mm) description.fixed.push_back(x[0] == 0.0);
    return description;
}

TEST(InversionRecovery, KeepsThePlaceOfALoosePiece) {
    const BodyDescription description = bar_and_loose_cube();
    const std::size_t first = description.mesh.vertices_mm.size() - 8;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    std::vector<Vec3> folded = body.rest_positions_mm;
    for (std::size_t i = first; i < folded.size(); ++i) folded[i] += Vec3(0, 150, 0);
    for (std::size_t i = 0; i < folded.size(); ++i) {
        if (body.rest_positions_mm[i] == Vec3(80, 8, 8)) folded[i] -= Vec3(10, 10, 10);
        if (body.rest_positions_mm[i] == Vec3(44, 24, 4)) folded[i] -= Vec3(8, 8, 8);
    }
    const auto centre = [first](const std::vector<Vec3>& x) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = first; i < x.size(); ++i) sum += x[i];
        return Vec3(sum / static_cast<double>(x.size() - first));
    };
    const int inverted_of_cube =
        static_cast<int>(std::ranges::count_if(inverted_elements(body, folded), [&](int e) {
            return description.mesh.tetrahedra[e][0] >= static_cast<int>(first);
        }));
    ASSERT_GT(inverted_of_cube, 0);
    ASSERT_GT(static_cast<int>(inverted_elements(body, folded).size()), inverted_of_cube);
    const Assembly assembly(body);
    const auto recovered = InversionRecovery(body).recover(
        folded, [&](std::span<const Vec3> x) { return assembly.energy(x); });
    ASSERT_TRUE(recovered);
    EXPECT_TRUE(inverted_elements(body, *recovered).empty());
    EXPECT_LT((centre(*recovered) - centre(folded)).norm(), 1e-6);
    for (std::size_t i = 0; i < first; ++i)
        EXPECT_LT(((*recovered)[i] - body.rest_positions_mm[i]).norm(), 1e-3);
}

// One node fixes no rotation; the rest of the piece may turn, but not be drawn, about it.
TEST(InversionRecovery, TurnsAPieceAboutTheOneNodeThatHoldsIt) {
    BodyDescription description = bar_and_loose_cube();
    const std::size_t first = description.mesh.vertices_mm.size() - 8;
    description.fixed[first] = true;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    const std::vector<Vec3>& rest = body.rest_positions_mm;
    std::vector<Vec3> folded = rest;
    for (std::size_t i = first; i < folded.size(); ++i) folded[i] += Vec3(0, 150, 0);
    for (std::size_t i = first; i < folded.size(); ++i)
        if (rest[i] == Vec3(44, 24, 4)) folded[i] -= Vec3(8, 8, 8);
    ASSERT_FALSE(inverted_elements(body, folded).empty());
    const Assembly assembly(body);
    const auto recovered = InversionRecovery(body).recover(
        folded, [&](std::span<const Vec3> x) { return assembly.energy(x); });
    ASSERT_TRUE(recovered);
    EXPECT_TRUE(inverted_elements(body, *recovered).empty());
    EXPECT_EQ((*recovered)[first], folded[first]);
    for (std::size_t i = first; i < rest.size(); ++i)
        for (std::size_t k = first; k < i; ++k)
            EXPECT_NEAR(((*recovered)[i] - (*recovered)[k]).norm(), (rest[i] - rest[k]).norm(),
                        1e-3);
}

// A beam turned back through its clamp finds its way out, and no step makes energy.
TEST(InversionRecovery, ABodyTurnedThroughItsClampComesBack) {
    BodyDescription description = clamped_brick();
    description.material.damping_ratio = 1.0;
    const auto stepper = make_cpu_stepper(description, {});
    std::vector<Vec3> start = description.mesh.vertices_mm;
    for (Vec3& x : start) x[0] = -x[0];
    stepper->set_state(start, std::vector<Vec3>(start.size(), Vec3::Zero()));
    double stored = INFINITY, handled = 0.0;
    for (int i = 0; i < 600; ++i) {
        const EnergyLedger e = stepper->step(i < 300 ? 1e-3 : 0.05).energy;
        EXPECT_GE(e.inversion_recovery_loss, 0.0);
        EXPECT_LE(e.kinetic + e.elastic, stored * (1.0 + 1e-9) + 1e-9);
        handled = std::max(handled, e.kinetic + e.elastic + e.inversion_recovery_loss);
        EXPECT_LE(std::abs(e.imbalance), 1e-10 * handled);
        stored = e.kinetic + e.elastic;
    }
    for (std::size_t v = 0; v < start.size(); ++v)
        EXPECT_LT((stepper->positions_mm()[v] - description.mesh.vertices_mm[v]).norm(), 0.1);
}

// What a recovery gives up is in the report of the step before it, and the body is at rest.
TEST(InversionRecovery, IsBookedInTheReportOfTheStep) {
    const auto back_end = make_cpu_back_end(clamped_brick(), {});
    const Body& body = back_end->body();
    BodyState folded = back_end->state();
    folded.positions_mm[folded.positions_mm.size() / 2] += Vec3(0, 60, 0);
    folded.velocities_mm_per_s.assign(folded.velocities_mm_per_s.size(), Vec3(0, 0, 1));
    back_end->set_state(folded);
    ASSERT_FALSE(inverted_elements(body, folded.positions_mm).empty());
    const EnergyLedger before = back_end->energies();
    StepReport report;
    report.energy.kinetic = before.kinetic;
    report.energy.elastic = before.elastic;
    ASSERT_TRUE(back_end->recover_from_inversion(report));
    const EnergyLedger after = back_end->energies();
    EXPECT_TRUE(inverted_elements(body, back_end->state().positions_mm).empty());
    EXPECT_EQ(after.kinetic, 0.0);
    EXPECT_EQ(report.energy.kinetic, 0.0);
    EXPECT_EQ(report.energy.elastic, after.elastic);
    EXPECT_TRUE(report.degraded);
    const double lost = stored_energy(before) - stored_energy(after);
    EXPECT_GT(lost, 0.0);
    EXPECT_NEAR(report.energy.inversion_recovery_loss, lost, 1e-9 * stored_energy(before));
    EXPECT_FALSE(back_end->recover_from_inversion(report));
}

// A checkpoint has the positions and no normals: ties are restored with those of the positions.
TEST(InversionRecovery, TurnsTheTiesOfATornBodyToTheNewPositions) {
    BodyDescription body = clamped_brick();
    body.tear.emplace();
    Tearing tearing(body.mesh, *body.tear, {});
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    tearing.weaken(tearing.crossing(Vec3(40, -1, -1), Vec3(0, 50, 0), Vec3(0, 0, 50), rest), 0.1);
    const std::vector<Mat3> stress(body.mesh.tetrahedra.size(), Mat3(0.5e6 * Mat3::Identity()));
    const std::vector<double> energy(stress.size(), 1.0), mass(rest.size(), 1.0);
    ASSERT_TRUE(tearing.part_overloaded({stress, energy, rest, mass}));
    TornBody torn_so_far = torn_body_of(tearing);
    ASSERT_FALSE(torn_so_far.ties.empty());
    const auto one = make_cpu_back_end(body, {}), other = make_cpu_back_end(body, {});
    one->tear(body, torn_so_far);
    BodyState folded = one->state();
    const SofteningTie& tie = torn_so_far.ties.front();
    for (const int v : tie.triangle) folded.positions_mm[v] -= 30.0 * tie.normal;
    one->set_state(folded);
    StepReport report;
    ASSERT_TRUE(one->recover_from_inversion(report));
    torn_so_far.ties.assign(one->ties().begin(), one->ties().end());
    other->tear(body, torn_so_far);
    other->set_state(one->state());
    for (std::size_t i = 0; i < torn_so_far.ties.size(); ++i)
        EXPECT_EQ(one->ties()[i].normal, other->ties()[i].normal) << i;
    const double cohesion = other->energies().cohesion;
    EXPECT_NEAR(report.energy.cohesion, cohesion, 1e-9 * (1.0 + cohesion));
    EXPECT_GE(report.energy.tear_loss, 0.0);
}

}  // namespace
}  // namespace hepatica
