// SPDX-License-Identifier: GPL-3.0-or-later
// What every potential promises: a force that is the gradient of its energy, a stiffness that is
// that of its force, energies by piece that add up, and a term of the ledger of its own.
#include "core/deform/potentials/potential.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"

namespace hepatica {
namespace {

using test::random_field;

Body brick() {
    BodyDescription d;
    d.mesh = kuhn_brick(Vec3(30, 20, 20), {2, 1, 1});
    d.tether_pa_per_mm2 = 30.0;
    return build_body(d, ElementModel::corotated, ElementOrder::linear);
}

// One grab within its limit, one beyond it, each of one element: nothing of them is lumped.
void act(const Body& body, PotentialList& potentials) {
    const std::vector<int>& nodes = body.groups[0].connectivity;
    potentials.set_gravity(Vec3(100, -300, 9810));
    Grab near{.vertices = {nodes[0], nodes[1], nodes[2], -1}, .weights = {0.5, 0.3, 0.2, 0}};
    near.target_mm = Vec3(3, -4, 2);
    near.stiffness_un_per_mm = 500.0;
    near.force_limit_un = 1e9;
    Grab far = near;
    far.vertices = {nodes.end()[-1], nodes.end()[-2], -1, -1};
    far.weights = {0.6, 0.4, 0, 0};
    far.target_mm = Vec3(200, 30, -70);
    far.force_limit_un = 4000.0;
    const Grab grabs[] = {near, far};
    potentials.set_grabs(grabs);
}

std::vector<Vec3> moved(const Body& body) {
    std::vector<Vec3> x = body.rest_positions_mm;
    const auto noise = random_field(x.size(), 2.0, 6);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += noise[i];
    return x;
}

TEST(Potential, ForceIsTheGradientOfTheEnergy) {
    const Body body = brick();
    PotentialList potentials(body);
    act(body, potentials);
    std::vector<Vec3> x = moved(body);
    for (const auto& potential : potentials.all()) {
        std::vector<Vec3> force(x.size(), Vec3::Zero());
        potential->add_forces(x, force);
        double size = 0.0;
        for (const Vec3& f : force) size = std::max(size, f.norm());
        EXPECT_GT(size, 0.0);
        const double h = 1e-5;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double kept = x[i][c];
                x[i][c] = kept + h;
                const double above = potential->energy(x, body.rest_positions_mm);
                x[i][c] = kept - h;
                const double below = potential->energy(x, body.rest_positions_mm);
                x[i][c] = kept;
                EXPECT_NEAR(force[i][c], -(above - below) / (2 * h), 1e-5 * size);
            }
    }
}

TEST(Potential, StiffnessIsThatOfItsForceAndItsFormThatOfItsMatrix) {
    const Body body = brick();
    PotentialList potentials(body);
    act(body, potentials);
    const std::vector<Vec3> x = moved(body);
    std::vector<Vec3> d = random_field(x.size(), 1.0, 9), product;
    for (const auto& potential : potentials.all()) {
        BlockMatrix matrix;
        Assembly(body).gather_stiffness(0.0, matrix);
        potential->add_stiffness(x, 2.0, matrix);
        multiply(matrix, d, product);
        double form = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) form += d[i].dot(product[i]);
        product.assign(x.size(), Vec3::Zero());
        potential->add_product(x, 2.0, d, matrix, product);
        EXPECT_NEAR(dot(d, product), form, 1e-12 * std::abs(form));
        const double h = 1e-6;
        std::vector<Vec3> above(x.size(), Vec3::Zero()), below = above, ahead = x, behind = x;
        for (std::size_t i = 0; i < x.size(); ++i) {
            ahead[i] += h * d[i];
            behind[i] -= h * d[i];
        }
        potential->add_forces(ahead, above);
        potential->add_forces(behind, below);
        double change = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
            change -= d[i].dot(above[i] - below[i]) / (2 * h);
        EXPECT_NEAR(0.5 * form, change, 1e-5 * std::abs(form) + 1e-6);
    }
}

// Rows of held nodes are not cleared from step to step: what is added to them stays.
TEST(Potential, AGrabAddsNothingBetweenNodesThatAreHeld) {
    const Body body = brick();
    PotentialList potentials(body);
    act(body, potentials);
    const std::array<int, 4> grabbed = potentials.grabs()[0].vertices;
    std::vector<std::uint8_t> held(body.rest_positions_mm.size(), 0);
    held[grabbed[0]] = held[grabbed[1]] = 1;
    const std::vector<Vec3> x = moved(body);
    const BodyState state{x, std::vector<Vec3>(x.size(), Vec3::Zero())};
    BlockMatrix matrix;
    Assembly(body).gather_stiffness(0.0, matrix);
    potentials.begin_step(state, 0.01, held);
    for (int step = 0; step < 3; ++step) potentials.add_stiffness(x, 2.0, matrix);
    potentials.end_step();
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            if (i == j || (held[i] == 0 && held[j] == 0)) continue;
            EXPECT_TRUE(matrix.block[k].isZero(0.0)) << i << ", " << j;
        }
    // Outside of a step nobody is held.
    const int between = matrix.find(grabbed[0], grabbed[1]);
    ASSERT_GE(between, 0);
    potentials.add_stiffness(x, 2.0, matrix);
    EXPECT_FALSE(matrix.block[between].isZero(0.0));
}

TEST(Potential, EnergiesByPieceAddUpAndEachBooksItsOwnTerm) {
    const Body body = brick();
    PotentialList potentials(body);
    act(body, potentials);
    const std::vector<Vec3> x = moved(body);
    std::vector<int> piece(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) piece[i] = static_cast<int>(i % 3);
    const auto filled = [](const EnergyLedger& ledger) {
        return (ledger.gravity_work != 0.0) + (ledger.tether != 0.0) + (ledger.grab != 0.0);
    };
    double sum = 0.0;
    for (const auto& potential : potentials.all()) {
        const double energy = potential->energy(x, body.rest_positions_mm);
        std::vector<double> by_piece(3, 0.0);
        potential->add_energy_by_piece(x, body.rest_positions_mm, piece, by_piece);
        EXPECT_NEAR(by_piece[0] + by_piece[1] + by_piece[2], energy, 1e-12 * std::abs(energy));
        EnergyLedger ledger;
        potential->book(energy, ledger);
        EXPECT_EQ(filled(ledger), 1);
        EXPECT_EQ(energy_handled(ledger), std::abs(energy));
        sum += energy;
    }
    EnergyLedger all;
    EXPECT_EQ(potentials.book(x, body.rest_positions_mm, all), sum);
    EXPECT_EQ(potentials.energy(x, body.rest_positions_mm), sum);
    EXPECT_EQ(filled(all), 3);
}

TEST(Potential, WhatIsRefusedLeavesTheListAsItWas) {
    const Body body = brick();
    PotentialList potentials(body);
    act(body, potentials);
    EXPECT_THROW(potentials.set_gravity(Vec3(NAN, 0, 0)), InputError);
    EXPECT_EQ(potentials.gravity_mm_per_s2(), Vec3(100, -300, 9810));
    Grab nobody{.vertices = {99, -1, -1, -1}};
    EXPECT_THROW(potentials.set_grabs(std::span(&nobody, 1)), InputError);
    EXPECT_EQ(potentials.grabs().size(), 2u);
}

}  // namespace
}  // namespace hepatica
