// SPDX-License-Identifier: GPL-3.0-or-later
// The compliance of a patch against a dense solution of the same system, and against the motion of
// a stepper that a small force pushes.
#include "core/haptics/patch_compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

constexpr double dt_s = 1.0 / 60.0;

BodyDescription held_brick() {
    BodyDescription d;
    d.mesh = kuhn_brick(Vec3(12, 9, 6), {4, 3, 2});
    d.fixed.assign(d.mesh.vertices_mm.size(), 0);
    for (std::size_t v = 0; v < d.fixed.size(); ++v) d.fixed[v] = d.mesh.vertices_mm[v].z() < 1e-9;
    d.tether_pa_per_mm2 = 50.0;
    d.touchable = true;
    return d;
}

std::vector<Vec3> shaken(const BodyDescription& d, double size) {
    std::vector<Vec3> x = d.mesh.vertices_mm;
    const auto noise = test::random_field(x.size(), size, 4);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (d.fixed[i] == 0) x[i] += noise[i];
    return x;
}

// On some nodes of the top and, in part, on held ones.
std::vector<SparseLoad> some_loads(const BodyDescription& d) {
    std::vector<SparseLoad> loads;
    std::vector<int> top, bottom;
    for (std::size_t v = 0; v < d.fixed.size(); ++v)
        if (d.mesh.vertices_mm[v].z() > 6.0 - 1e-9)
            top.push_back(static_cast<int>(v));
        else if (d.fixed[v] != 0)
            bottom.push_back(static_cast<int>(v));
    for (std::size_t i = 0; i + 2 < top.size(); i += 3)
        loads.push_back(
            {{top[i], top[i + 1], top[i + 2], top[i]},
             {Vec3(0.1, 0, -0.5), Vec3(0, 0.2, -0.3), Vec3(0, 0, -0.2), Vec3(0, 0, -0.1)}});
    loads.push_back({{top[0], bottom[0]}, {Vec3(0, 0, -0.5), Vec3(0, 0, -0.5)}});
    return loads;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * matrix.rows(), 3 * matrix.rows());
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            full.block<3, 3>(3 * i, 3 * matrix.column[k]) = matrix.block[k];
    return full;
}

TEST(PatchCompliance, IsTheBlockOfADenseInverse) {
    const BodyDescription d = held_brick();
    const std::vector<Vec3> x = shaken(d, 0.2);
    const std::vector<SparseLoad> loads = some_loads(d);
    PatchCompliance compliance(d, ElementModel::corotated);
    EXPECT_TRUE(compliance.follow(x, dt_s, loads));
    const Eigen::MatrixXd block = compliance.block(loads, dt_s);
    const Eigen::MatrixXd a = dense(compliance.matrix());
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(a.rows(), static_cast<Eigen::Index>(loads.size()));
    for (std::size_t l = 0; l < loads.size(); ++l)
        for (std::size_t i = 0; i < loads[l].vertices.size(); ++i)
            if (d.fixed[loads[l].vertices[i]] == 0)
                j.block<3, 1>(3 * loads[l].vertices[i], static_cast<Eigen::Index>(l)) +=
                    loads[l].forces[i];
    const Eigen::MatrixXd exact = dt_s * dt_s * j.transpose() * a.llt().solve(j);
    EXPECT_LT((block - exact).norm(), 1e-8 * exact.norm());
    EXPECT_GT(exact.norm(), 0.0);
}

// What a small force on a body at rest moves within one step, less than the step without it.
TEST(PatchCompliance, IsHowFarAStepGoesUnderASmallForce) {
    const BodyDescription d = held_brick();
    const int vertex = some_loads(d)[1].vertices[0];
    const std::vector<SparseLoad> load{{{vertex}, {Vec3::UnitZ()}}};
    PatchCompliance compliance(d, ElementModel::corotated);
    compliance.follow(d.mesh.vertices_mm, dt_s, load);
    const double expected_mm_per_un = compliance.block(load, dt_s)(0, 0);
    const auto stepper =
        make_cpu_stepper(d, {.linear = {.energy_tolerance = 1e-8}, .sleeping = false});
    // A soft spring to a place far away: a force that hardly changes.
    constexpr double force_un = 1.0, stiffness = 1e-3;
    const Vec3 away = d.mesh.vertices_mm[vertex] + force_un / stiffness * Vec3::UnitZ();
    const Grab grab{.vertices = {vertex, -1, -1, -1},
                    .target_mm = away,
                    .stiffness_un_per_mm = stiffness,
                    .force_limit_un = 1e9};
    stepper->set_grabs(std::vector<Grab>{grab});
    stepper->step(dt_s);
    const double moved = stepper->positions_mm()[vertex].z() - d.mesh.vertices_mm[vertex].z();
    EXPECT_NEAR(moved / force_un, expected_mm_per_un, 1e-3 * expected_mm_per_un);
}

TEST(PatchCompliance, IsMadeAnewWhereThePatchHasTurnedButNotWhereItFlies) {
    const BodyDescription d = held_brick();
    const std::vector<SparseLoad> loads = some_loads(d);
    PatchCompliance compliance(d, ElementModel::corotated);
    std::vector<Vec3> x = d.mesh.vertices_mm;
    EXPECT_TRUE(compliance.follow(x, dt_s, loads));
    EXPECT_FALSE(compliance.follow(x, dt_s, loads));
    for (Vec3& v : x) v += Vec3(5, 5, 5);
    EXPECT_FALSE(compliance.follow(x, dt_s, loads));
    for (Vec3& v : x) v = Eigen::AngleAxisd(0.5, Vec3::UnitX()) * v;
    EXPECT_TRUE(compliance.follow(x, dt_s, loads));
    EXPECT_TRUE(compliance.follow(x, 0.5 * dt_s, loads));
}

}  // namespace
}  // namespace hepatica
