// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of elements, bodies and parts of a step as they are today: energies, forces, stiffness
// and stress, masses, hollow walls, damping, what puts inverted elements right, and ties.
#include <gtest/gtest.h>

#include "core/deform/body/body.h"
#include "core/deform/body/material.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/potentials/softening_ties.h"
#include "core/deform/potentials/tool_path.h"
#include "core/deform/step/assembly.h"
#include "core/deform/step/damping_regression.h"
#include "core/deform/step/energy_limiter.h"
#include "core/deform/step/inversion_recovery.h"
#include "core/deform/step/path_work.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/hex_mesh.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/step_figures.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::as_doubles;
using test::expect_recorded;
using test::Figures;
using test::flat;
using test::random_field;

BodyDescription shaken_brick(bool hexahedra) {
    BodyDescription body;
    const HexMesh brick = hexahedral_brick(Vec3(6, 4, 3), {3, 2, 2});
    body.mesh.vertices_mm = brick.vertices_mm;
    if (hexahedra)
        body.hexahedra = brick.hexahedra;
    else
        body.mesh = kuhn_brick(Vec3(6, 4, 3), {3, 2, 2});
    const auto shake = random_field(body.mesh.vertices_mm.size(), 0.15, 31);
    for (std::size_t i = 0; i < shake.size(); ++i) {
        body.mesh.vertices_mm[i] += shake[i];
        body.fixed.push_back(i % 12 == 0 ? 1 : 0);
    }
    body.material = {.young_modulus_pa = 900.0, .poisson_ratio = 0.35, .damping_ratio = 0.2};
    const std::size_t elements = body.mesh.tetrahedra.size() + body.hexahedra.size();
    for (std::size_t e = 0; e < elements; ++e) {
        body.stiffness_factor.push_back(0.5 + 0.2 * static_cast<double>(e % 6));
        body.density_factor.push_back(0.7 + 0.1 * static_cast<double>(e % 4));
    }
    body.tether_pa_per_mm2 = 3.0;
    body.touchable = true;
    body.self = SelfPad{};
    return body;
}

std::vector<Vec3> displaced(const Body& body, double size_mm, unsigned seed) {
    std::vector<Vec3> x = body.rest_positions_mm;
    const auto field = random_field(x.size(), size_mm, seed);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += field[i];
    return x;
}

void add_body(Figures& figures, const Body& body) {
    figures.add("mass", body.mass_g)
        .add("tether", body.tether_un_per_mm)
        .add("rest", flat(body.rest_positions_mm))
        .add("edge", body.mean_edge_mm)
        .add("alpha", body.damping.alpha_per_s)
        .add("beta", body.damping.beta_s)
        .add("connectivity", as_doubles(body.groups[0].connectivity))
        .add("surface", test::flat_arrays(body.surface));
    if (body.self_pad)
        figures.add("pad.thickness", body.self_pad->thickness_mm)
            .add("pad.pressure", body.self_pad->pressure_pa);
}

void add_responses(Figures& figures, const Body& body) {
    for (const auto tangent : {small::Tangent::rotated, small::Tangent::projected}) {
        Assembly assembly(body, tangent);
        for (const double size : {0.02, 0.4, 2.5}) {
            const std::string name =
                (tangent == small::Tangent::rotated ? "rotated_" : "projected_") +
                std::to_string(static_cast<int>(100.0 * size));
            const std::vector<Vec3> x = displaced(body, size, 41);
            std::vector<Vec3> force(x.size(), Vec3::Zero());
            BlockMatrix stiffness;
            figures.add(name + ".energy", assembly.evaluate(x));
            assembly.gather_forces(force);
            assembly.gather_stiffness(1.5, stiffness);
            figures.add(name + ".force", flat(force)).add(name + ".stiffness", flat(stiffness));
            figures.add(name + ".form", assembly.quadratic_form(random_field(x.size(), 1.0, 43)));
            std::vector<int> pieces(x.size());
            for (std::size_t i = 0; i < x.size(); ++i) pieces[i] = static_cast<int>(i % 3);
            std::vector<double> energies(3, 0.0);
            assembly.add_energy_by_piece(pieces, energies);
            figures.add(name + ".pieces", energies);
            if (body.groups[0].kind == ElementGroup::Kind::linear_tetrahedron) {
                std::vector<Mat3> stress;
                assembly.find_stress(stress, energies);
                std::vector<double> numbers;
                for (const Mat3& s : stress) numbers.insert(numbers.end(), s.data(), s.data() + 9);
                figures.add(name + ".stress", numbers).add(name + ".energies", energies);
            }
            figures.add(name + ".inverted", as_doubles(inverted_elements(body, x)));
        }
    }
}

TEST(DeformFigures, OfEveryElement) {
    const auto record = [](const std::string& name, ElementModel model, ElementOrder order,
                           bool hexahedra) {
        const Body body = build_body(shaken_brick(hexahedra), model, order);
        Figures figures;
        add_body(figures, body);
        add_responses(figures, body);
        expect_recorded("deform", "element_" + name, figures);
    };
    record("spring", ElementModel::spring, ElementOrder::linear, false);
    record("corotated", ElementModel::corotated, ElementOrder::linear, false);
    record("neohookean", ElementModel::neohookean, ElementOrder::linear, false);
    record("corotated-10", ElementModel::corotated, ElementOrder::quadratic, false);
    record("neohookean-10", ElementModel::neohookean, ElementOrder::quadratic, false);
    record("hexahedra", ElementModel::corotated, ElementOrder::linear, true);
}

TEST(DeformFigures, OfMaterials) {
    Figures figures;
    for (const MaterialPreset& preset : material_presets()) {
        const std::string name(1, static_cast<char>('a' + (&preset - material_presets().data())));
        const Material& m = preset.material;
        const double numbers[] = {m.young_modulus_pa, m.poisson_ratio,  m.density_g_mm3,
                                  m.damping_ratio,    m.damping_low_hz, m.damping_high_hz};
        for (std::size_t k = 0; k < std::size(numbers); ++k)
            figures.add(name + std::to_string(k), numbers[k]);
        figures.add(name + ".strength", preset.strength_pa)
            .add(name + ".fracture", preset.fracture_energy_j_m2)
            .add(name + ".lambda", lame_of(m).lambda_pa)
            .add(name + ".mu", lame_of(m).mu_pa)
            .add(name + ".alpha", rayleigh_of(m).alpha_per_s)
            .add(name + ".beta", rayleigh_of(m).beta_s);
    }
    expect_recorded("deform", "materials", figures);
}

TEST(DeformFigures, OfHollowWallsDampingAndWork) {
    BodyDescription description = test::description_of(test::make_brick_tree(2, 3.0, 1.5));
    make_hollow(description, 0.7);
    Figures figures;
    figures.add("hollow", description.stiffness_factor);
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    std::vector<BodyState> states;
    for (unsigned k = 0; k < 5; ++k)
        states.push_back(
            {displaced(body, 0.1, 51 + k), random_field(body.mass_g.size(), 20.0, 61 + k)});
    for (const double threshold : {0.0, 0.9}) {
        const DampingFit fit = fit_damping(body, states, threshold);
        const std::string name = threshold > 0.0 ? "strict" : "any";
        figures.add(name + ".alpha", fit.error.alpha_per_s)
            .add(name + ".beta", fit.error.beta_s)
            .add(name + ".r_squared", fit.r_squared)
            .add(name + ".steps", fit.steps)
            .add(name + ".used", fit.used);
    }
    PotentialList potentials(body);
    potentials.set_gravity(Vec3(100, -9810, 400));
    const Assembly assembly(body);
    const auto from = displaced(body, 0.2, 71), to = displaced(body, 0.5, 72);
    for (const double tolerance : {1e6, 1.0}) {
        const auto found = PathWork(assembly).along(from, to, potentials, tolerance);
        const std::string name = "work" + std::to_string(static_cast<int>(tolerance));
        figures.add(name, found.work_nj).add(name + ".evaluations", found.evaluations);
        figures.add(name + ".error", std::vector{found.error_nj, found.work_nj});
    }
    expect_recorded("deform", "body_parts", figures);
}

TEST(DeformFigures, OfWhatPutsInversionsRight) {
    for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
        BodyDescription description;
        description.mesh = kuhn_brick(Vec3(80, 40, 40), {6, 3, 3});
        for (const Vec3& x : description.mesh.vertices_mm) description.fixed.push_back(x[0] == 0.0);
        const Body body = build_body(description, ElementModel::corotated, order);
        std::vector<Vec3> folded = displaced(body, 0.5, 81);
        const auto middle = static_cast<std::size_t>(body.vertex_count / 2 + 3);
        folded[middle] += Vec3(31, 9, -4);
        const auto distance = [&](std::span<const Vec3> x) {
            double sum = 0.0;
            for (std::size_t i = 0; i < x.size(); ++i)
                sum += (x[i] - body.rest_positions_mm[i]).squaredNorm();
            return sum;
        };
        InversionRecovery recovery(body);
        const auto found = recovery.recover(folded, distance);
        ASSERT_TRUE(found);
        expect_recorded("deform", order == ElementOrder::linear ? "recovery" : "recovery_quadratic",
                        Figures()
                            .add("inverted", as_doubles(inverted_elements(body, folded)))
                            .add("recovered", flat(*found))
                            .add("unknowns", recovery.unknowns()));
    }
}

TEST(DeformFigures, OfKineticEnergyTaken) {
    const auto x = random_field(15, 30.0, 91);
    std::vector<double> mass;
    std::vector<int> nodes;
    for (int i = 0; i < 15; ++i) {
        mass.push_back(1.0 + 0.1 * i);
        if (i != 4) nodes.push_back(i);
    }
    Figures figures;
    for (const bool held : {false, true})
        for (const double energy : {10.0, 2000.0, 3000.0, 1e9}) {
            std::vector<Vec3> v = random_field(15, 10.0, 92);
            for (std::size_t i = 0; i < v.size(); ++i)
                v[i] += Vec3(9, 4, -7) + Vec3(0.5, -0.3, 0.4).cross(x[i]);
            const MomentumLost lost = take_kinetic_energy(nodes, mass, x, held, energy, v);
            const std::string name =
                (held ? "held" : "free") + std::to_string(static_cast<int>(energy));
            figures.add(name, flat(v)).add(name + ".lost", static_cast<int>(lost));
        }
    expect_recorded("deform", "energy_taken", figures);
}

TEST(DeformFigures, OfTiesAndTurns) {
    SofteningTies ties;
    std::vector<SofteningTie> all;
    for (int k = 0; k < 3; ++k) {
        SofteningTie tie{.vertices = {k, k + 3}, .area_mm2 = 1.0 + k, .most_mm = 0.05 + 0.3 * k};
        tie.triangle = {0, 1, 2};
        all.push_back(tie);
    }
    std::vector<Vec3> x{{0, 0, 0},    {1, 0, 0.1},   {0, 1, 0.2},
                        {0, 0, 0.04}, {1.1, 0, 0.3}, {0, 1.2, 0.7}};
    ties.set({.strength_pa = 1e5, .opening_mm = 1.0}, all, x);
    std::vector<Vec3> force(6, Vec3::Zero());
    std::vector<double> pieces(2, 0.0), numbers;
    const int piece_of_node[] = {0, 1, 0, 1, 1, 0};
    for (int k = 0; k < 4; ++k) {
        ties.add_forces(x, force);
        ties.add_energy_by_piece(x, x, piece_of_node, pieces);
        numbers.push_back(ties.energy(x, x));
        numbers.push_back(ties.settle(x));
        for (const SofteningTie& tie : ties.all()) numbers.push_back(tie.most_mm);
        x[4] += Vec3(0.02, 0.05, 0.11);
        x[1] += Vec3(0.0, 0.03, -0.04);
        ties.turn(x);
    }
    Figures figures;
    figures.add("forces", flat(force)).add("pieces", pieces).add("numbers", numbers);
    const auto first = random_field(20, 2.0, 95), second = random_field(20, 2.0, 96);
    std::vector<Vec3> turns;
    for (std::size_t k = 0; k < first.size(); ++k)
        turns.push_back(turned_after(first[k], second[k]));
    expect_recorded("deform", "ties_and_turns", figures.add("turns", flat(turns)));
}

}  // namespace
}  // namespace hepatica
