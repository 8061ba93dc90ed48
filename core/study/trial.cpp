// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/trial.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/deform/step/energy_ledger.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {
namespace {

constexpr double rounding = 1e-9;

}  // namespace

bool Trial::require(bool good, const std::string& what) {
    if (!good && row_.note.empty()) row_.note = what;
    return good;
}

bool Trial::run(int steps, double dt_s) {
    for (int i = 0; i < steps; ++i) {
        const StepReport report = stepper_.step(dt_s);
        for (const Vec3& x : stepper_.positions_mm())
            if (!require(x.allFinite(), "a position is not finite")) return false;
        row_.degraded_steps += report.degraded;
        if (!check_energy(report.energy)) return false;
    }
    return true;
}

// Earlier losses must not hide a later gain, so every step is judged alone.
bool Trial::check_energy(const EnergyLedger& e) {
    const double stored = e.kinetic + e.elastic + e.grab;
    const double work = e.gravity_work + e.tool_work;
    const double change =
        work - e.damping_loss - e.integrator_loss - e.unfolding_loss + e.solver_work;
    // The energy at the start is from the first step's ledger.
    const double before = started_ ? stored_ : stored - change - e.imbalance;
    started_ = true;
    stored_ = stored;
    const double in_step = std::abs(before) + energy_handled(e);
    handled_ = std::max(handled_, in_step);
    // What is left of a body's energies when it rests is rounding errors of those it had.
    const double size = std::max(in_step, rounding * handled_);
    if (!(size > 0.0)) return true;
    row_.energy_made = std::max(row_.energy_made, (stored - before - work) / size);
    if (!require(row_.energy_made < 1e-6, "energy was made")) return false;
    const double open =
        std::abs(stored - before - change) / std::max(size, ledger_share_ * handled_);
    std::ostringstream what;
    what << "the ledger leaves " << open << " of the energies open";
    return require(open < 1e-9, what.str());
}

bool Trial::require_close(double value, double expected, double allowed,
                          const std::string& reference) {
    row_.reference = reference;
    row_.error = std::abs(value - expected) / std::abs(expected);
    std::ostringstream what;
    what << value << " where " << reference << " says " << expected;
    return require(row_.error <= allowed, what.str());
}

bool Trial::require_positive_volumes(const std::vector<std::array<int, 4>>& tetrahedra) {
    const auto x = stepper_.positions_mm();
    for (const auto& [a, b, c, d] : tetrahedra)
        if (!require(signed_volume_mm3(x[a], x[b], x[c], x[d]) > 0.0,
                     "an element is inverted at rest"))
            return false;
    return true;
}

bool Trial::require_back_at(std::span<const Vec3> places_mm, double allowed_mm) {
    double furthest = 0.0;
    const auto x = stepper_.positions_mm();
    for (std::size_t v = 0; v < x.size(); ++v)
        furthest = std::max(furthest, (x[v] - places_mm[v]).norm());
    std::ostringstream what;
    what << "after release a vertex is " << furthest << " mm from its place";
    return require(furthest <= allowed_mm, what.str());
}

}  // namespace hepatica
