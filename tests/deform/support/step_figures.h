// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of steps and of fields over nodes, in the form in which they are recorded.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/stepper/stepper.h"
#include "tests/support/recorded_figures.h"

namespace hepatica::test {

inline void append(std::vector<double>& to, const Vec3& value) {
    for (int i = 0; i < 3; ++i) to.push_back(value[i]);
}

inline std::vector<double> flat(std::span<const Vec3> field) {
    std::vector<double> numbers;
    for (const Vec3& value : field) append(numbers, value);
    return numbers;
}

template <class Numbers>
std::vector<double> as_doubles(const Numbers& numbers) {
    std::vector<double> all;
    for (const auto number : numbers) all.push_back(static_cast<double>(number));
    return all;
}

template <class Arrays>
std::vector<double> flat_arrays(const Arrays& arrays) {
    std::vector<double> all;
    for (const auto& array : arrays)
        for (const auto number : array) all.push_back(static_cast<double>(number));
    return all;
}

inline std::vector<double> flat(const BlockMatrix& matrix) {
    std::vector<double> all;
    for (const Mat3& block : matrix.block)
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) all.push_back(block(r, c));
    return all;
}

// What steps report and where they lead. What rounding alone decides stands beside larger numbers
// of its kind.
class StepSeries {
  public:
    void add(const Stepper& stepper, const StepReport& report) {
        positions_.insert(positions_.end(), stepper.positions_mm().begin(),
                          stepper.positions_mm().end());
        velocities_.insert(velocities_.end(), stepper.velocities_mm_per_s().begin(),
                           stepper.velocities_mm_per_s().end());
        add_ledger(report.energy);
        add_counts(report);
        add_loads(report, stepper.tool_load());
        add_ledger(stepper.energies());
    }

    Figures figures() const {
        Figures all;
        all.add("positions", flat(positions_)).add("velocities", flat(velocities_));
        all.add("counts", counts_).add("loads", loads_).add("gaps", gaps_);
        const char* const names[] = {"kinetic", "elastic", "grab",  "tether", "contact",
                                     "work",    "damping", "other", "losses", "handled"};
        for (std::size_t k = 0; k < std::size(names); ++k) all.add(names[k], energies_[k]);
        return all;
    }

  private:
    void add_ledger(const EnergyLedger& e) {
        const double terms[] = {
            e.kinetic,
            e.elastic,
            e.grab,
            e.tether,
            e.contact + 2.0 * e.cohesion,
            e.gravity_work + 2.0 * e.tool_work,
            e.damping_loss,
            e.integrator_loss + 2.0 * e.friction_loss,
            e.integrator_loss + e.nonlinear_loss + 2.0 * e.limiter_loss + 3.0 * e.tear_loss +
                4.0 * e.inversion_recovery_loss + e.solver_work,
            energy_handled(e) + stored_energy(e) + work_put_in(e) + explained_change(e)};
        for (std::size_t k = 0; k < std::size(terms); ++k) energies_[k].push_back(terms[k]);
    }
    void add_counts(const StepReport& r) {
        for (const double count :
             {r.dt_s, 1.0 * r.newton_iterations, 1.0 * r.linear_solves, 1.0 * r.linear_iterations,
              1.0 * r.dropped_pivots, 1.0 * r.degraded, 1.0 * r.predicted, 1.0 * r.shortened,
              1.0 * r.asleep, 1.0 * static_cast<double>(r.message.size()), 1.0 * r.tool.contacts,
              1.0 * static_cast<double>(r.tool.touched.size()), 1.0 * r.self.contacts,
              1.0 * r.tear.joints_parted, 1.0 * r.tear.joints_broken, 1.0 * r.tear.vertices_split,
              1.0 * r.tear.pieces, 1.0 * r.tear.stopped})
            counts_.push_back(count);
    }
    void add_loads(const StepReport& report, const ToolLoad& load) {
        for (const ToolLoad& own : {report.tool, load}) {
            append(loads_, own.force_un);
            append(loads_, own.torque_un_mm);
            append(loads_, own.at_mm);
            append(loads_, own.impulse_un_s);
            loads_.push_back(own.grip_un);
            gaps_.push_back(own.contacts > 0 ? own.least_gap_mm : -1.0);
        }
        gaps_.push_back(report.self.contacts > 0 ? report.self.least_gap_mm : -1.0);
        gaps_.push_back(report.tear.entropy_nats);
        gaps_.push_back(report.tear.entropy_produced_nats);
    }

    std::vector<Vec3> positions_, velocities_;
    std::vector<double> counts_, loads_, gaps_;
    std::vector<double> energies_[10];
};

}  // namespace hepatica::test
