// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/split_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/deform/body/torn_body.h"
#include "core/mesh/surface.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

constexpr double split_rounding = 1e-12;

struct WholeMotion {
    double mass = 0.0, kinetic = 0.0;
    double moved = 0.0, turned = 0.0;  // sums of the magnitudes of what is summed below
    Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
};

// Of the first nodes, as many as there are masses.
WholeMotion motion_of(const std::vector<double>& mass_g, const BodyState& state) {
    WholeMotion motion;
    for (std::size_t i = 0; i < mass_g.size(); ++i) {
        const Vec3 momentum = mass_g[i] * state.velocities_mm_per_s[i];
        const Vec3 spin = state.positions_mm[i].cross(momentum);
        motion.mass += mass_g[i];
        motion.kinetic += 0.5 * momentum.dot(state.velocities_mm_per_s[i]);
        motion.momentum += momentum;
        motion.spin += spin;
        motion.moved += momentum.norm();
        motion.turned += spin.norm();
    }
    return motion;
}

// Empty unless the stored energy grew; names the terms.
std::string energy_made(const EnergyLedger& before, const EnergyLedger& after) {
    const double stored = stored_energy(before);
    if (stored_energy(after) - stored <= 1e-9 * std::abs(stored)) return {};
    std::ostringstream text;
    text << "a split made energy: of " << stored << " nJ";
    const auto name = [&](const char* term, double EnergyLedger::*value) {
        const double more = after.*value - before.*value;
        if (std::abs(more) > 1e-10 * std::abs(stored)) text << ", " << term << " " << more;
    };
    name("kinetic", &EnergyLedger::kinetic);
    name("elastic", &EnergyLedger::elastic);
    name("grab", &EnergyLedger::grab);
    name("tether", &EnergyLedger::tether);
    name("contact", &EnergyLedger::contact);
    name("cohesion", &EnergyLedger::cohesion);
    return text.str();
}

std::array<int, 3> sorted(int a, int b, int c) {
    std::array<int, 3> face{a, b, c};
    std::ranges::sort(face);
    return face;
}

std::vector<std::array<int, 3>> in_order(std::vector<std::array<int, 3>> triangles) {
    // Rotates each triangle so that its smallest corner is first, keeping its orientation.
    for (auto& triangle : triangles)
        std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    std::ranges::sort(triangles);
    return triangles;
}

}  // namespace

bool fans_connected(const TetMesh& mesh) {
    // Corner i of tetrahedron t is 4 t + i; corners at one vertex are united across common faces.
    DisjointSets corners(4 * mesh.tetrahedra.size());
    std::map<std::array<int, 3>, std::size_t> faces;
    const auto corner_at = [&](std::size_t t, int vertex) {
        const auto& tetrahedron = mesh.tetrahedra[t];
        return 4 * t + static_cast<std::size_t>(std::ranges::find(tetrahedron, vertex) -
                                                tetrahedron.begin());
    };
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const auto& v = mesh.tetrahedra[t];
        for (int i = 0; i < 4; ++i) {
            const auto face = sorted(v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]);
            const auto [other, first] = faces.try_emplace(face, t);
            if (first) continue;
            for (const int vertex : face)
                corners.unite(static_cast<std::uint32_t>(corner_at(t, vertex)),
                              static_cast<std::uint32_t>(corner_at(other->second, vertex)));
        }
    }
    std::vector<std::int64_t> fan(mesh.vertices_mm.size(), -1);
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            std::int64_t& mine = fan[mesh.tetrahedra[t][i]];
            const auto root = corners.root(static_cast<std::uint32_t>(4 * t + i));
            if (mine < 0) mine = root;
            if (mine != root) return false;
        }
    return true;
}

SplitCheck::SplitCheck(const BodyDescription& whole, const StepperOptions& options)
    : whole_(whole),
      options_(options),
      mass_g_(build_body(whole, options.model, options.order).mass_g) {}

std::string SplitCheck::after_step(const Stepper& stepper, const EnergyLedger& energy) {
    if (stepper.positions_mm().size() == mass_g_.size()) return {};
    ++splits_;
    if (!in_place(stepper)) return "a vertex does not lie where it was split from";
    const std::string wrong = conserved(stepper, energy);
    return wrong.empty() ? well_formed(stepper) : wrong;
}

bool SplitCheck::in_place(const Stepper& stepper) const {
    const auto positions = stepper.positions_mm();
    const auto parents = stepper.tearing()->topology().parents();
    for (std::size_t v = mass_g_.size(); v < parents.size(); ++v)
        if (positions[v] != positions[static_cast<std::size_t>(parents[v])]) return false;
    return true;
}

std::string SplitCheck::conserved(const Stepper& stepper, const EnergyLedger& energy) {
    const BodyState state = stepper.state();
    const std::vector<double> mass_g =
        build_body(torn(whole_, torn_body_of(*stepper.tearing())), options_.model, options_.order)
            .mass_g;
    // Vertices keep their velocity, and new ones have that of their origin.
    const WholeMotion before = motion_of(mass_g_, state), after = motion_of(mass_g, state);
    mass_g_ = mass_g;
    if (std::abs(after.mass - before.mass) > split_rounding * before.mass) return "mass changed";
    if ((after.momentum - before.momentum).norm() > split_rounding * before.moved)
        return "momentum changed";
    if ((after.spin - before.spin).norm() > split_rounding * before.turned)
        return "angular momentum changed";
    if (std::abs(after.kinetic - before.kinetic) > split_rounding * before.kinetic)
        return "kinetic energy changed";
    return energy_made(energy, stepper.energies());
}

std::string SplitCheck::well_formed(const Stepper& stepper) {
    TetMesh mesh;
    const auto positions = stepper.positions_mm();
    const TornTopology& topology = stepper.tearing()->topology();
    mesh.vertices_mm.assign(positions.begin(), positions.end());
    mesh.tetrahedra.assign(topology.tetrahedra().begin(), topology.tetrahedra().end());
    if (!std::ranges::all_of(mesh.vertices_mm, [](const Vec3& x) { return x.allFinite(); }))
        return "a position is not finite after a split";
    with_inverted_ += std::ranges::any_of(mesh.tetrahedra, [&](const auto& t) {
        return signed_volume_mm3(positions[t[0]], positions[t[1]], positions[t[2]],
                                 positions[t[3]]) <= 0.0;
    });
    if (!fans_connected(mesh)) return "tetrahedra hang by a point or an edge";
    TriangleMesh surface{mesh.vertices_mm, boundary_triangles(mesh)};
    if (in_order(surface.triangles) != in_order(topology.surface()))
        return "the topology tells another surface";
    try {
        validate_closed(surface);
    } catch (const InputError& open) {
        return open.what();
    }
    with_touching_edges_ += is_closed_manifold(surface) ? 0 : 1;
    return {};
}

}  // namespace hepatica
