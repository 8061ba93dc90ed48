// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/trial.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

bool Trial::require(bool good, const std::string& what) {
    if (!good && row_.note.empty()) row_.note = what;
    return good;
}

bool Trial::run(int steps, double dt_s) {
    for (int i = 0; i < steps; ++i) {
        const StepReport report = stepper_.step(dt_s);
        const EnergyLedger& e = report.energy;
        for (const Vec3& x : stepper_.positions_mm())
            if (!require(x.allFinite(), "a position is not finite")) return false;
        row_.degraded_steps += report.degraded;
        const double stored = e.kinetic + e.elastic + e.grab;
        const double work = e.gravity_work + e.tool_work;
        if (!started_) {
            // The energy at the start, from the first step's ledger.
            start_ = stored - work + e.damping_loss + e.integrator_loss + e.unfolding_loss -
                     e.solver_work;
            handled_ = std::abs(start_);
            started_ = true;
        }
        put_in_ += work;
        handled_ += std::abs(work);
        const double made = stored - start_ - put_in_;
        if (handled_ > 0.0) row_.energy_made = std::max(row_.energy_made, made / handled_);
        if (!require(row_.energy_made < 1e-6, "energy was made")) return false;
    }
    return true;
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
