// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of tearing as it is today: joints, softening, and a body torn by stresses made by hand.
#include <gtest/gtest.h>

#include <random>

#include "core/base/small_matrix_eigen.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/entropy.h"
#include "core/tear/tearing.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

class Chance {
  public:
    explicit Chance(unsigned seed) : engine_(seed) {}
    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / std::mt19937::max();
    }
    Vec3 vector(double size) {
        const double x = in(-size, size), y = in(-size, size), z = in(-size, size);
        return {x, y, z};
    }

  private:
    std::mt19937 engine_;
};

TetMesh uneven_brick(Chance& chance, const Index3& cells) {
    TetMesh mesh = kuhn_brick(Vec3(cells[0], cells[1], cells[2]), cells);
    for (Vec3& x : mesh.vertices_mm) x += chance.vector(0.08);
    return mesh;
}

template <class Numbers>
void append_to(std::vector<double>& to, const Numbers& numbers) {
    for (const auto number : numbers) to.push_back(static_cast<double>(number));
}

TEST(TearFigures, OfJoints) {
    Chance chance(901);
    const TetMesh mesh = uneven_brick(chance, {3, 2, 2});
    std::vector<double> numbers, stresses;
    const std::vector<Joint> joints = joints_of(mesh);
    for (const Joint& joint : joints) {
        append_to(numbers, joint.tetrahedra);
        for (const auto& corners : joint.corners) append_to(numbers, corners);
        numbers.push_back(joint.area_mm2);
        append_to(numbers, joint.normal);
        append_to(numbers, joint.centre_mm);
        std::array<small::Vector3<double>, 4> forces, rest;
        const auto& corners = mesh.tetrahedra[joint.tetrahedra[0]];
        for (int i = 0; i < 4; ++i) {
            forces[i] = small::from_eigen(chance.vector(100.0));
            rest[i] = small::from_eigen(
                Vec3(mesh.vertices_mm[corners[i]] - mesh.vertices_mm[corners[0]]));
        }
        const Mat3 stress = small::to_eigen(stress_of(forces, rest, 0.3));
        const Vec3 traction = traction_on(joint, stress, 0.4 * stress.transpose());
        append_to(stresses, stress.reshaped());
        append_to(stresses, traction);
        stresses.push_back(effective_traction_pa(traction, joint.normal));
    }
    std::vector<double> weights;
    for (int i = 0; i < 3000; ++i) weights.push_back(std::max(0.0, chance.in(-0.3, 1.0)));
    expect_recorded("tear", "joints",
                    Figures()
                        .add("joints", numbers)
                        .add("stresses", stresses)
                        .add("entropy", entropy_nats(weights)));
}

TEST(TearFigures, OfSoftening) {
    Chance chance(902);
    const TearLaw law;
    const SofteningLaw softening = law.softening();
    std::vector<double> numbers{softening.strength_pa, softening.opening_mm, softening.peak_mm(),
                                softening.fracture_energy_j_m2()};
    for (int i = 0; i < 200; ++i) {
        const double opening = chance.in(0.0, 1.3) * softening.opening_mm;
        const double most = chance.in(0.0, 1.2) * softening.opening_mm;
        append_to(numbers, std::array{softening.secant_pa_mm(opening, most) * opening,
                                      softening.energy_un_mm(opening, most),
                                      softening.secant_pa_mm(opening, most),
                                      softening.unloading_pa_mm(most)});
    }
    Figures figures;
    figures.add("law", numbers);
    numbers.clear();
    for (int i = 0; i < 200; ++i) {
        SofteningTie tie;
        tie.area_mm2 = chance.in(0.1, 2.0);
        tie.most_mm = std::max(softening.peak_mm(), chance.in(0.0, 0.9) * softening.opening_mm);
        tie.normal = chance.vector(1.0).normalized();
        const Vec3 opening = chance.vector(0.8 * softening.opening_mm);
        numbers.push_back(energy_of(softening, tie, opening));
        numbers.push_back(effective_opening_mm(tie, opening));
        append_to(numbers, force_of(softening, tie, opening));
        append_to(numbers, 1e-3 * stiffness_of(softening, tie, opening).reshaped());
    }
    expect_recorded("tear", "softening", figures.add("ties", numbers));
}

void add_report(std::vector<double>& numbers, const TearReport& report) {
    append_to(numbers, std::array{static_cast<double>(report.joints_parted),
                                  static_cast<double>(report.joints_broken),
                                  static_cast<double>(report.vertices_split),
                                  static_cast<double>(report.pieces), report.entropy_nats,
                                  report.entropy_produced_nats, report.stopped ? 1.0 : 0.0});
}

void add_state(Figures& figures, const std::string& name, const Tearing& tearing) {
    std::vector<double> numbers;
    const TearState state = tearing.state();
    for (const std::vector<int>* part :
         {&state.parents, &state.tetrahedra, &state.corners, &state.parted, &state.weakened})
        append_to(numbers, *part);
    append_to(numbers, state.most_mm);
    append_to(numbers, state.weakness);
    append_to(numbers, std::array{state.begun ? 1.0 : 0.0, state.stopped ? 1.0 : 0.0,
                                  state.entropy_before_nats, state.entropy_nats});
    figures.add(name + ".state", numbers);
    numbers.clear();
    for (const SofteningTie& tie : tearing.ties()) {
        append_to(numbers, tie.vertices);
        append_to(numbers, tie.triangle);
        append_to(numbers, tie.normal);
        append_to(numbers, std::array{tie.area_mm2, tie.most_mm});
    }
    figures.add(name + ".ties", numbers);
    numbers.clear();
    for (const auto& pair : tearing.parted_pairs()) append_to(numbers, pair);
    for (const auto& pair : tearing.bound_pairs()) append_to(numbers, pair);
    for (const auto& triangle : tearing.topology().surface()) append_to(numbers, triangle);
    append_to(numbers, tearing.topology().piece_of_vertices(tearing.bound_pairs()));
    figures.add(name + ".topology", numbers);
}

// Gives those vertices places that have none yet: near where they come from.
void lay_vertices(const Tearing& tearing, const TetMesh& mesh, Chance& chance,
                  std::vector<Vec3>& x) {
    const auto parents = tearing.topology().parents();
    for (int v = static_cast<int>(x.size()); v < tearing.topology().vertex_count(); ++v) {
        int origin = v;
        while (parents[origin] != origin) origin = parents[origin];
        x.push_back(1.1 * mesh.vertices_mm[origin] + chance.vector(0.02));
    }
}

// Stresses, energies and places by chance, and ties that open by chance.
void tear_by_chance(Figures& figures, const std::string& name, const TearLaw& law) {
    Chance chance(903);
    const TetMesh mesh = uneven_brick(chance, {5, 3, 3});
    const std::size_t count = mesh.tetrahedra.size();
    std::vector<double> strength(count);
    for (double& factor : strength) factor = chance.in(0.6, 1.4);
    Tearing tearing(mesh, law, strength);
    tearing.weaken(
        tearing.crossing(Vec3(1.4, -1, -1), Vec3(0.2, 5, 0), Vec3(0, 0.3, 3), mesh.vertices_mm),
        0.5);
    std::vector<double> reports, all_loads;
    for (int round = 0; round < 7; ++round) {
        std::vector<Mat3> stress(count);
        std::vector<double> energy(count);
        for (std::size_t t = 0; t < count; ++t) {
            for (double& value : stress[t].reshaped())
                value = chance.in(-0.75, 0.75) * law.strength_pa;
            energy[t] = chance.in(-0.1, 1.0) * (t % 7 == 0 ? 5.0 : 1.0);
        }
        std::vector<Vec3> x;
        lay_vertices(tearing, mesh, chance, x);
        if (round == 3) {
            tearing.cut(tearing.crossing(Vec3(3.1, 0.3, -1), Vec3(0, 2.2, 0), Vec3(0.1, 0, 5), x));
            lay_vertices(tearing, mesh, chance, x);
        }
        const std::vector<double> mass(x.size(), 0.1);
        const TearLoads loads{stress, energy, x, mass};
        reports.push_back(tearing.part_overloaded(loads) ? 1.0 : 0.0);
        append_to(all_loads, tearing.loads());
        // What was split off now lies where its parent does.
        lay_vertices(tearing, mesh, chance, x);
        const std::vector<double> mass_after(x.size(), 0.1);
        const TearLoads after{stress, energy, x, mass_after};
        std::vector<SofteningTie> ties = tearing.ties();
        for (SofteningTie& tie : ties)
            tie.most_mm = std::max(tie.most_mm, chance.in(0.0, 1.2) * law.softening().opening_mm);
        tearing.take_openings(ties);
        tearing.measure(after);
        add_report(reports, tearing.report());
        std::vector<double> load;
        tearing.find_loads(after, 0.0, load);
        append_to(all_loads, load);
    }
    figures.add(name + ".reports", reports).add(name + ".loads", all_loads);
    add_state(figures, name, tearing);
    Tearing again(mesh, law, strength);
    again.restore(tearing.state());
    EXPECT_EQ(again.report(), tearing.report());
}

TEST(TearFigures, OfBodiesThatTear) {
    Figures figures;
    tear_by_chance(figures, "default", {});
    tear_by_chance(figures, "bare", {.tear_factor = 0.8, .bare_limit = true});
    tear_by_chance(figures, "entropy",
                   {.strength_pa = 3e5, .stop = TearStop::entropy, .entropy_budget_nats = 0.1});
    tear_by_chance(figures, "vertices", {.stop = TearStop::vertices, .vertex_budget = 40});
    expect_recorded("tear", "bodies", figures);
}

}  // namespace
}  // namespace hepatica
