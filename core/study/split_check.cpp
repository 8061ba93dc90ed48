// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/split_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/deform/stepper/cpu_back_end.h"
#include "core/mesh/surface.h"
#include "core/study/forwarding_back_end.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

constexpr double split_rounding = 1e-12;

struct WholeMotion {
    double mass = 0.0, kinetic = 0.0;
    double moved = 0.0, turned = 0.0;  // sums of the magnitudes of what is summed below
    Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
};

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

// Notes the state before and after each transaction.
class WatchedBackEnd final : public ForwardingBackEnd {
  public:
    WatchedBackEnd(std::unique_ptr<StepBackEnd> watched, std::vector<SplitMoment>& moments)
        : ForwardingBackEnd(std::move(watched)), moments_(moments) {}

    void tear(const BodyDescription& whole, const TornBody& tear) override {
        SplitMoment moment{
            .before = state(), .mass_before_g = body().mass_g, .energies_before = energies()};
        ForwardingBackEnd::tear(whole, tear);
        moment.after = state();
        moment.mass_after_g = body().mass_g;
        moments_.push_back(std::move(moment));
    }

  private:
    std::vector<SplitMoment>& moments_;
};

std::vector<double> masses_of_tetrahedra_g(const BodyDescription& body) {
    std::vector<double> mass_g;
    for (const auto& [a, b, c, d] : body.mesh.tetrahedra) {
        const auto edge = [&](int v) -> Vec3 {
            return body.mesh.vertices_mm[v] - body.mesh.vertices_mm[a];
        };
        const std::size_t t = mass_g.size();
        const double factor = body.density_factor.empty() ? 1.0 : body.density_factor[t];
        mass_g.push_back(factor * body.material.density_g_mm3 *
                         edge(b).dot(edge(c).cross(edge(d))) / 6.0);
    }
    return mass_g;
}

// Whether each node has a quarter of the mass of each of its tetrahedra.
bool has_its_quarters(const std::vector<double>& mass_g,
                      std::span<const std::array<int, 4>> tetrahedra,
                      const std::vector<double>& mass_of_tetrahedron_g) {
    std::vector<double> quarters(mass_g.size(), 0.0);
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (const int v : tetrahedra[t]) {
            if (v >= static_cast<int>(mass_g.size())) return false;
            quarters[v] += 0.25 * mass_of_tetrahedron_g[t];
        }
    for (std::size_t v = 0; v < mass_g.size(); ++v)
        if (!(std::abs(mass_g[v] - quarters[v]) <= split_rounding * quarters[v])) return false;
    return true;
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

std::string fault_of_motion(const SplitMoment& moment) {
    const WholeMotion before = motion_of(moment.mass_before_g, moment.before),
                      after = motion_of(moment.mass_after_g, moment.after);
    if (!(std::abs(after.mass - before.mass) <= split_rounding * before.mass))
        return "mass changed";
    if (!((after.momentum - before.momentum).norm() <= split_rounding * before.moved))
        return "momentum changed";
    if (!((after.spin - before.spin).norm() <= split_rounding * before.turned))
        return "angular momentum changed";
    if (!(std::abs(after.kinetic - before.kinetic) <= split_rounding * before.kinetic))
        return "kinetic energy changed";
    return {};
}

std::string fault_of_shape(const TetMesh& mesh, std::vector<std::array<int, 3>> told_surface) {
    if (!std::ranges::all_of(mesh.vertices_mm, [](const Vec3& x) { return x.allFinite(); }))
        return "a position is not finite after a split";
    if (!fans_connected(mesh)) return "tetrahedra hang by a point or an edge";
    const TriangleMesh surface{mesh.vertices_mm, boundary_triangles(mesh)};
    if (in_order(surface.triangles) != in_order(std::move(told_surface)))
        return "the topology tells another surface";
    try {
        validate_closed(surface);
    } catch (const InputError& open) {
        return open.what();
    }
    return {};
}

SplitCheck::SplitCheck(const BodyDescription& whole, const StepperOptions& options,
                       GovernedStepper::MakeBackEnd make)
    : whole_(whole),
      options_(options),
      make_(make ? std::move(make) : make_cpu_back_end),
      mass_of_tetrahedron_g_(masses_of_tetrahedra_g(whole)),
      tetrahedra_(whole.mesh.tetrahedra) {}

std::unique_ptr<Stepper> SplitCheck::make_stepper() {
    const auto watched = [this](const BodyDescription& body, const StepperOptions& options) {
        return std::make_unique<WatchedBackEnd>(make_(body, options), moments_);
    };
    return std::make_unique<GovernedStepper>(whole_, options_, std::nullopt, watched);
}

std::string SplitCheck::after_step(const Stepper& stepper) {
    const std::vector<SplitMoment> moments = std::exchange(moments_, {});
    for (const SplitMoment& moment : moments) {
        const bool split = moment.after.positions_mm.size() > moment.before.positions_mm.size();
        splits_ += split ? 1 : 0;
        const std::string wrong = over(moment, stepper);
        if (!wrong.empty()) return wrong;
        if (!split) continue;
        const std::string shape = well_formed(stepper);
        if (!shape.empty()) return shape;
    }
    return {};
}

// There is one transaction in a step, and one in a cut, so that the stepper is as it left it.
std::string SplitCheck::over(const SplitMoment& moment, const Stepper& stepper) {
    const auto& [before, after, mass_before_g, mass_after_g, energies] = moment;
    const BodyState now = stepper.state();
    if (now.positions_mm != after.positions_mm ||
        now.velocities_mm_per_s != after.velocities_mm_per_s)
        return "what a split left was changed in the same step";
    const TornTopology& topology = stepper.tearing()->topology();
    const auto parents = topology.parents();
    if (after.positions_mm.size() != parents.size()) return "a split left another number of nodes";
    for (std::size_t v = 0; v < parents.size(); ++v) {
        const bool old = v < before.positions_mm.size();
        const std::size_t origin = old ? v : static_cast<std::size_t>(parents[v]);
        const BodyState& there = old ? before : after;
        if (after.positions_mm[v] != there.positions_mm[origin])
            return old ? "a split moved a vertex" : "a vertex does not lie where it was split from";
        if (after.velocities_mm_per_s[v] != there.velocities_mm_per_s[origin])
            return old ? "a split changed a velocity"
                       : "a vertex does not move as the one does that it was split from";
    }
    if (!has_its_quarters(mass_before_g, tetrahedra_, mass_of_tetrahedron_g_) ||
        !has_its_quarters(mass_after_g, topology.tetrahedra(), mass_of_tetrahedron_g_))
        return "a vertex has not the mass of its tetrahedra";
    tetrahedra_.assign(topology.tetrahedra().begin(), topology.tetrahedra().end());
    const std::string changed = fault_of_motion(moment);
    return changed.empty() ? energy_made(energies, stepper.energies()) : changed;
}

std::string SplitCheck::well_formed(const Stepper& stepper) {
    TetMesh mesh;
    const auto positions = stepper.positions_mm();
    const TornTopology& topology = stepper.tearing()->topology();
    mesh.vertices_mm.assign(positions.begin(), positions.end());
    mesh.tetrahedra = tetrahedra_;
    const std::string fault = fault_of_shape(mesh, topology.surface());
    if (!fault.empty()) return fault;
    with_inverted_ += std::ranges::any_of(mesh.tetrahedra, [&](const auto& t) {
        return signed_volume_mm3(positions[t[0]], positions[t[1]], positions[t[2]],
                                 positions[t[3]]) <= 0.0;
    });
    with_touching_edges_ +=
        is_closed_manifold({mesh.vertices_mm, boundary_triangles(mesh)}) ? 0 : 1;
    return {};
}

}  // namespace hepatica
