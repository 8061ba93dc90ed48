// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/trial.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/deform/body/energy_ledger.h"
#include "core/deform/step/inversion_recovery.h"

namespace hepatica {
namespace {

constexpr double rounding = 1e-9;

}  // namespace

bool Trial::require(bool good, const std::string& what) {
    if (!good && row_.note.empty()) row_.note = what;
    return good;
}

bool Trial::run(int steps, double dt_s) {
    for (int left = std::min(steps, how_.most_steps); left > 0; --left)
        if (!judge(stepper_.step(dt_s, how_.stop))) return false;
    return true;
}

bool Trial::judge(const StepReport& report) {
    for (const Vec3& x : stepper_.positions_mm())
        if (!require(x.allFinite(), "a position is not finite")) return false;
    double speed_mm_per_s = 0.0;
    for (const Vec3& v : stepper_.velocities_mm_per_s()) speed_mm_per_s += v.norm();
    row_.path_mm +=
        report.dt_s * speed_mm_per_s / static_cast<double>(stepper_.positions_mm().size());
    row_.degraded_steps += report.degraded;
    row_.touched_steps +=
        report.tool.contacts > 0 || report.self.contacts > 0 || report.obstacles.touch.contacts > 0;
    return check_energy(report);
}

// Every step is judged alone, so that earlier losses cannot hide a later gain.
bool Trial::check_energy(const StepReport& report) {
    const EnergyLedger& e = report.energy;
    const double stored = stored_energy(e), work = work_put_in(e);
    // The change that the ledger explains, with the nonlinear loss taken from the energies; the
    // audit is judged separately.
    const double change = explained_change(e) - report.audit_gap_nj;
    // The energy at the start is reconstructed from the first step's ledger.
    const double before = started_ ? stored_ : stored - change - e.imbalance - report.audit_gap_nj;
    started_ = true;
    stored_ = stored;
    const double in_step = std::abs(before) + energy_handled(e);
    // Comparisons below let a value pass that is no number, and all steps after an infinite one.
    if (!require(std::isfinite(in_step), "the ledger of energies is not finite")) return false;
    handled_ = std::max(handled_, in_step);
    // The energies left in a body at rest are rounding errors of those it had.
    const double size = std::max(in_step, rounding * handled_);
    if (!(size > 0.0)) return true;
    row_.energy_made = std::max(row_.energy_made, (stored - before - work) / size);
    if (!require(row_.energy_made < 1e-6, "energy was made")) return false;
    const double open =
        std::abs(stored - before - change) / std::max({size, ledger_share_ * handled_, least_nj_});
    std::ostringstream what;
    what << "the ledger leaves " << open << " of the energies open";
    return require(open < ledger_tolerance, what.str()) && check_audit(report, size);
}

// A law's energy is a difference of terms as large as modulus times volume (its forces are not), so
// rounding weighs more the less strain is left. A step is therefore judged against at least a
// millionth of the most that any step has handled.
bool Trial::check_audit(const StepReport& report, double in_step) {
    // Any moving body of this suite handles more than a nanojoule; one that has not moved yet has
    // only rounding errors.
    constexpr double least_nj = 1e-3;
    const double size = std::max({in_step, 1e-6 * handled_, least_nj});
    if (report.audit_error_nj > 1e-3 * size) {
        ++row_.unresolved_steps;
        return true;
    }
    const double gap = std::abs(report.audit_gap_nj) / size;
    row_.audit_gap = std::max(row_.audit_gap, gap);
    std::ostringstream what;
    what << "energies and forces differ by " << gap << " of what the step handled";
    return require(gap < 1e-5 + 2.0 * report.audit_error_nj / size, what.str());
}

bool Trial::require_close(double value, double expected, double allowed,
                          const std::string& reference) {
    row_.reference = reference;
    row_.error = std::abs(value - expected) / std::abs(expected);
    std::ostringstream what;
    what << value << " where " << reference << " says " << expected;
    return require(row_.error <= allowed, what.str());
}

bool Trial::require_all_close(std::span<const double> values, double expected, double allowed,
                              const std::string& reference) {
    const auto distance = [&](double value) {
        const double apart = std::abs(value - expected);
        return std::isfinite(apart) ? apart : HUGE_VAL;
    };
    const double furthest = *std::ranges::max_element(values, {}, distance);
    return require_close(furthest, expected, allowed, reference);
}

bool Trial::require_positive_volumes(const BodyDescription& body, ElementModel model,
                                     ElementOrder order) {
    const BodyState state = stepper_.state();
    const auto inverted = inverted_elements(build_body(body, model, order), state.positions_mm);
    return require(inverted.empty(), "an element is inverted at rest");
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
