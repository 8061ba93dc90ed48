// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/energy_limiter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/deform/step/rigid_motion.h"

namespace hepatica {
namespace {

// A slower mean speed counts as rest, because the energies are then rounding errors of either sign.
constexpr double resting_mm_per_s = 1e-6;

// In free flight; the solver's tolerance loses less.
constexpr double most_momentum_lost = 0.02;
// Of the nodes' mean speed: less is the solver's error where they move against each other.
constexpr double momentum_error = 1e-3;

constexpr double noise = 1e-9;  // relative energies below this are rounding errors

// Stored energy plus friction loss, because a moving tool may do the work of friction in this step.
double kept_energy(const EnergyLedger& ledger) {
    return stored_energy(ledger) + ledger.friction_loss;
}

bool rests(double kinetic_nj, double mass_g) {
    return !(kinetic_nj > 0.5 * mass_g * resting_mm_per_s * resting_mm_per_s);
}

double scale_without(double energy, double kinetic) {
    return kinetic > 0.0 ? std::sqrt(std::max(0.0, kinetic - energy) / kinetic) : 1.0;
}

MomentumLost take_from_free(std::span<const int> nodes, std::span<const double> mass,
                            std::span<const Vec3> x, double energy, std::vector<Vec3>& v) {
    const RigidMotion rigid = rigid_motion(nodes, mass, x, v);
    double deforming = 0.0;
    for (const int i : nodes) deforming += 0.5 * mass[i] * (v[i] - rigid(x[i])).squaredNorm();
    const double drop = 1.0 - scale_without(energy, deforming);
    for (const int i : nodes) v[i] -= drop * (v[i] - rigid(x[i]));
    energy -= deforming;
    if (!(energy > 0.0)) return MomentumLost::none;
    const double spin_drop = 1.0 - scale_without(energy, rigid.spin_energy_nj);
    for (const int i : nodes) v[i] -= spin_drop * rigid.of_spin(x[i]);
    energy -= rigid.spin_energy_nj;
    if (!(energy > 0.0)) return MomentumLost::angular;
    const double flight = scale_without(energy, rigid.flight_energy_nj);
    for (const int i : nodes) v[i] *= flight;
    return MomentumLost::linear;
}

}  // namespace

MomentumLost take_kinetic_energy(std::span<const int> nodes, std::span<const double> mass_g,
                                 std::span<const Vec3> positions_mm, bool held, double energy_nj,
                                 std::vector<Vec3>& velocities_mm_per_s) {
    if (!held) return take_from_free(nodes, mass_g, positions_mm, energy_nj, velocities_mm_per_s);
    double kinetic = 0.0;
    for (const int i : nodes) kinetic += 0.5 * mass_g[i] * velocities_mm_per_s[i].squaredNorm();
    const double scale = scale_without(energy_nj, kinetic);
    for (const int i : nodes) velocities_mm_per_s[i] *= scale;
    return MomentumLost::none;
}

EnergyLimiter::EnergyLimiter(const Body& body, const AssemblyPlan& plan)
    : body_(body), piece_of_node_(connected_pieces(plan)) {
    for (std::size_t i = 0; i < piece_of_node_.size(); ++i) {
        nodes_.resize(std::max(nodes_.size(), static_cast<std::size_t>(piece_of_node_[i]) + 1));
        mass_g_.resize(nodes_.size());
        nodes_[piece_of_node_[i]].push_back(static_cast<int>(i));
        mass_g_[piece_of_node_[i]] += body.mass_g[i];
    }
}

std::vector<EnergyLimiter::Balance> EnergyLimiter::balance(
    const StepUnderway& step, std::span<const Vec3> positions_mm,
    std::span<const Vec3> velocities_mm_per_s, const Assembly& assembly) const {
    std::vector<double> energy(nodes_.size(), 0.0);
    assembly.add_energy_by_piece(piece_of_node_, energy);
    for (const auto& potential : step.potentials.all())
        potential->add_energy_by_piece(positions_mm, step.start.positions_mm, piece_of_node_,
                                       energy);
    std::vector<Balance> sums(nodes_.size());
    for (std::size_t i = 0; i < piece_of_node_.size(); ++i)
        sums[piece_of_node_[i]].kinetic +=
            0.5 * body_.mass_g[i] * velocities_mm_per_s[i].squaredNorm();
    for (std::size_t p = 0; p < sums.size(); ++p) sums[p].energy = sums[p].kinetic + energy[p];
    return sums;
}

void EnergyLimiter::begin(const StepUnderway& step, const Assembly& assembly) {
    after_.clear();
    before_ = pieces() == 1 ? std::vector<Balance>{{kept_energy(step.before), 0.0}}
                            : balance(step, step.start.positions_mm, step.start.velocities_mm_per_s,
                                      assembly);
}

EnergyLimiter::Outcome EnergyLimiter::limit(const StepUnderway& step, const EnergyLedger& after,
                                            const Assembly& assembly,
                                            std::span<const std::uint8_t> held,
                                            std::vector<Vec3>& velocities_mm_per_s) const {
    const std::vector<Balance> now =
        pieces() == 1
            ? std::vector<Balance>{{kept_energy(after) - after.gravity_work, after.kinetic}}
        : after_.empty() ? balance(step, step.positions, velocities_mm_per_s, assembly)
                         : after_;
    return limit({.before = before_, .after = now, .together = step.together}, step.potentials,
                 step.positions, held, velocities_mm_per_s);
}

std::vector<std::vector<int>> EnergyLimiter::coupled_pieces(const PotentialList& potentials,
                                                            bool together) const {
    DisjointSets sets(nodes_.size());
    for (const auto& potential : potentials.all()) potential->join_pieces(piece_of_node_, sets);
    // Pieces that met exchanged momentum, so only the energy of all of them is conserved.
    for (int p = 1; together && p < pieces(); ++p) sets.unite(0, p);
    std::vector<std::vector<int>> groups(nodes_.size());
    for (int p = 0; p < pieces(); ++p) groups[sets.root(p)].push_back(p);
    std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
    return groups;
}

Vec3 EnergyLimiter::flight(const StepUnderway& step, const Vec3& before_mm_per_s) const {
    const Vec3 fall = step.dt_s * step.potentials.gravity_mm_per_s2();
    return (before_mm_per_s + fall) / (1.0 + step.dt_s * body_.damping.alpha_per_s);
}

bool EnergyLimiter::slowed(const StepUnderway& step, std::span<const int> nodes) const {
    const auto speed = [&](const std::vector<Vec3>& x, const std::vector<Vec3>& v) {
        return rigid_motion(nodes, body_.mass_g, x, v).velocity_mm_per_s;
    };
    const Vec3 expected =
        flight(step, speed(step.start.positions_mm, step.start.velocities_mm_per_s));
    double square = 0.0, mass_g = 0.0;
    for (const int i : nodes) {
        square += body_.mass_g[i] * step.velocity[i].squaredNorm();
        mass_g += body_.mass_g[i];
    }
    return (speed(step.positions, step.velocity) - expected).norm() >
           std::max(most_momentum_lost * expected.norm(),
                    momentum_error * std::sqrt(square / mass_g));
}

double EnergyLimiter::deforming_energy(const StepUnderway& step, std::span<const int> nodes) const {
    const RigidMotion rigid = rigid_motion(nodes, body_.mass_g, step.positions, step.velocity);
    double kinetic = 0.0;
    for (const int i : nodes) kinetic += 0.5 * body_.mass_g[i] * step.velocity[i].squaredNorm();
    return kinetic - rigid.spin_energy_nj - rigid.flight_energy_nj;
}

std::vector<EnergyLimiter::Overdrawn> EnergyLimiter::overdrawn(
    const StepUnderway& step, const Assembly& assembly, std::span<const std::uint8_t> held_nodes) {
    if (pieces() == 1) return {};
    after_ = balance(step, step.positions, step.velocity, assembly);
    return overdrawn(step, before_, after_, held_nodes);
}

std::vector<EnergyLimiter::Overdrawn> EnergyLimiter::overdrawn(
    const StepUnderway& step, std::span<const Balance> energies_before,
    std::span<const Balance> energies_after, std::span<const std::uint8_t> held_nodes) const {
    std::vector<Overdrawn> found;
    std::vector<char> marked(held_nodes.begin(), held_nodes.end());
    for (const auto& potential : step.potentials.all())
        potential->mark_held(step.positions, marked);
    for (const std::vector<int>& group : coupled_pieces(step.potentials, step.together)) {
        double excess = 0.0, size = 0.0, before = 0.0, kinetic = 0.0, mass_g = 0.0;
        for (const int p : group) {
            excess += energies_after[p].energy - energies_before[p].energy;
            size += std::abs(energies_before[p].energy) + std::abs(energies_after[p].energy);
            before += energies_before[p].kinetic;
            kinetic += energies_after[p].kinetic;
            mass_g += mass_g_[p];
        }
        if (rests(before + kinetic, mass_g)) continue;
        Overdrawn pieces{.unpaid = excess > kinetic + noise * size};
        for (const int p : group)
            pieces.nodes.insert(pieces.nodes.end(), nodes_[p].begin(), nodes_[p].end());
        pieces.flies = std::ranges::none_of(pieces.nodes, [&](int i) { return marked[i] != 0; });
        const bool alone = pieces.flies && group.size() == 1;
        const double payable =
            alone ? deforming_energy(step, pieces.nodes) + noise * kinetic : kinetic;
        if (excess > payable || (pieces.flies && slowed(step, pieces.nodes)))
            found.push_back(std::move(pieces));
    }
    return found;
}

EnergyLimiter::Outcome EnergyLimiter::limit(const Pieces& energies, const PotentialList& potentials,
                                            std::span<const Vec3> positions_mm,
                                            std::span<const std::uint8_t> held_nodes,
                                            std::vector<Vec3>& velocities_mm_per_s) const {
    const auto& [before, now, rounding, least_nj, together] = energies;
    Outcome outcome;
    for (const std::vector<int>& group : coupled_pieces(potentials, together)) {
        double excess = 0.0, size = 0.0, kinetic = 0.0, mass_g = 0.0;
        for (const int p : group) {
            excess += now[p].energy - before[p].energy;
            size += std::abs(before[p].energy) + std::abs(now[p].energy) + now[p].kinetic;
            kinetic += now[p].kinetic;
            mass_g += mass_g_[p];
        }
        if (rests(kinetic, mass_g) || !(excess > rounding * size + least_nj)) continue;
        std::vector<char> marked(held_nodes.begin(), held_nodes.end());
        for (const auto& potential : potentials.all()) potential->mark_held(positions_mm, marked);
        std::vector<int> nodes;
        for (const int p : group) nodes.insert(nodes.end(), nodes_[p].begin(), nodes_[p].end());
        const bool held = std::ranges::any_of(nodes, [&](int i) { return marked[i] != 0; });
        const MomentumLost lost = take_kinetic_energy(nodes, body_.mass_g, positions_mm, held,
                                                      excess, velocities_mm_per_s);
        outcome.limited = true;
        outcome.lost = std::max(outcome.lost, lost);
    }
    return outcome;
}

void book(const EnergyLimiter::Outcome& outcome, double kinetic_nj, StepReport& report) {
    if (!outcome.limited) return;
    report.energy.limiter_loss = report.energy.kinetic - kinetic_nj;
    report.energy.kinetic = kinetic_nj;
    report.degraded = true;
    report.message = "the body was slowed down: the step would have made energy";
    if (outcome.lost == MomentumLost::angular) report.message += "; a free piece lost spin";
    if (outcome.lost == MomentumLost::linear) report.message += "; a free piece lost momentum";
}

}  // namespace hepatica
