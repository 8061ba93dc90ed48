// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/incremental_potential.h"

#include <utility>

#include "core/base/large_vector.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {
namespace {

constexpr std::size_t live_rows_at_once = 256;

}  // namespace

IncrementalPotential::IncrementalPotential(const Body& body, small::Tangent tangent)
    : body_(body),
      live_(body),
      assembly_(body, tangent, &live_),
      collapse_(body, assembly_.plan(), live_) {
    lay_out();
}

// Sets all sizes by the plan. The matrix keeps its memory.
void IncrementalPotential::lay_out() {
    const AssemblyPlan& plan = assembly_.plan();
    matrix_.row_begin = plan.row_begin;
    matrix_.column = plan.column;
    matrix_.diagonal = plan.diagonal;
    matrix_.alone.clear();
    const std::size_t blocks = plan.column.size();
    // A body that tears will need some more.
    if (blocks > matrix_.block.capacity()) reserve_large(matrix_.block, blocks + blocks / 8);
    matrix_.block.resize(blocks);
    for_each_node(matrix_.block.size(), [&](std::size_t k) { matrix_.block[k].setZero(); });
    const auto nodes = static_cast<std::size_t>(body_.node_count());
    elastic_force_.assign(nodes, Vec3::Zero());
    force_.assign(nodes, Vec3::Zero());
    find_cut_blocks();
}

void IncrementalPotential::follow_split(const Body& before) {
    live_.begin_again();
    assembly_.follow_split(before);
    tension_.reset();
    collapse_.forget();
    damping_ = {};
    assembled_rows_.clear();
    stiffness_known_ = tension_added_ = false;
    elastic_ = 0.0;
    lay_out();
}

template <class Visit>
void IncrementalPotential::for_each_live_row(const Visit& visit) const {
    const auto rows = live_.rows();
    parallel_blocks(rows.size(), live_rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) visit(rows[r]);
    });
}

void IncrementalPotential::freeze(std::span<const std::uint8_t> frozen) {
    live_.freeze(frozen);
    stiffness_known_ = false;
    find_cut_blocks();
}

void IncrementalPotential::forget_matrix() {
    live_.forget_written();
    stiffness_known_ = false;
    find_cut_blocks();
}

// Until the matrix is written, these include rows that were live before the last change of the live
// part, because nothing else clears them.
void IncrementalPotential::find_cut_blocks() {
    cut_blocks_.clear();
    for (const int i : live_.changed_rows())
        for (int k = matrix_.row_begin[i]; k < matrix_.row_begin[i + 1]; ++k) {
            const int j = matrix_.column[k];
            if (i == j || (!held(i) && !held(j))) continue;
            cut_blocks_.push_back(k);
            // Assembling a row also writes the mirrored block in its neighbour's row.
            cut_blocks_.push_back(assembly_.plan().mirror[k]);
        }
}

void IncrementalPotential::evaluate(std::span<const Vec3> positions_mm) {
    elastic_ = assembly_.evaluate(positions_mm);
    assembly_.gather_forces(elastic_force_);
    stiffness_known_ = true;
}

void IncrementalPotential::evaluate_forces(std::span<const Vec3> positions_mm) {
    elastic_ = assembly_.evaluate_forces(positions_mm);
    assembly_.gather_forces(elastic_force_);
    stiffness_known_ = false;
}

void IncrementalPotential::evaluate_all_forces(std::span<const Vec3> positions_mm) {
    elastic_ = assembly_.evaluate_all_forces(positions_mm);
    assembly_.gather_forces(elastic_force_);
    stiffness_known_ = false;
}

double IncrementalPotential::value(const StepUnderway& step) const {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    const double inertia = sum_over_nodes(step.velocity.size(), [&](std::size_t i) {
        const Vec3 change = step.velocity[i] - step.start.velocities_mm_per_s[i];
        return 0.5 * body_.mass_g[i] *
               (change.squaredNorm() + dt * alpha * step.velocity[i].squaredNorm());
    });
    return inertia + 0.5 * dt * step.damping_form + elastic_ +
           step.potentials.energy(step.positions, step.start.positions_mm);
}

void IncrementalPotential::find_force(const StepUnderway& step) {
    for_each_node(force_.size(), [&](std::size_t i) { force_[i] = elastic_force_[i]; });
    step.potentials.add_forces(step.positions, force_);
}

void IncrementalPotential::descent(const StepUnderway& step, std::vector<Vec3>& residual) {
    const double dt = step.dt_s, alpha = body_.damping.alpha_per_s;
    find_force(step);
    const bool damped = !step.damping_force.empty();
    residual.resize(force_.size());
    for_each_node(residual.size(), [&](std::size_t i) {
        residual[i] = body_.mass_g[i] * (step.start.velocities_mm_per_s[i] -
                                         (1.0 + dt * alpha) * step.velocity[i]) +
                      dt * force_[i];
        if (damped) residual[i] -= dt * step.damping_force[i];
        if (held(i)) residual[i].setZero();
    });
}

void IncrementalPotential::cut_held(BlockMatrix& matrix) const {
    for (const int k : cut_blocks_) matrix.block[k].setZero();
}

void IncrementalPotential::assemble(const StepUnderway& step) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    if (!stiffness_known_) assembly_.evaluate(step.positions);
    stiffness_known_ = true;
    if (std::exchange(cut_is_wide_, false)) find_cut_blocks();
    assembly_.gather_stiffness(step.iterate == 0 ? dt * dt + dt * beta : dt * dt, matrix_);
    if (step.iterate > 0 && beta > 0.0)
        for_each_live_row([&](int i) {
            for (int k = matrix_.row_begin[i]; k < matrix_.row_begin[i + 1]; ++k)
                matrix_.block[k] += dt * damping_.block[k];
        });
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_node(step.positions.size(), [&](std::size_t i) {
        matrix_.block[matrix_.diagonal[i]].diagonal().array() += inertia * body_.mass_g[i];
    });
    step.potentials.foresee(step.positions, force_);
    step.potentials.add_stiffness(step.positions, dt * dt, matrix_);
    if (collapse_counts_) {
        collapse_.find(assembly_.slots(), step.positions);
        collapse_.add_to(matrix_, dt * dt);
    } else {
        collapse_.leave_out();  // an earlier matrix may have had it
    }
    cut_held(matrix_);
    for_each_node(step.positions.size(), [&](std::size_t i) {
        if (held(i)) matrix_.block[matrix_.diagonal[i]] = Mat3::Identity();
    });
    matrix_.alone = live_.held();
    assembled_rows_.assign(live_.changed_rows().begin(), live_.changed_rows().end());
    cut_is_wide_ = assembled_rows_.size() > live_.rows().size();
    live_.written();
    tension_added_ = false;
}

void IncrementalPotential::add_tension(double dt_s) {
    tension_->make(assembly_.slots(), dt_s * dt_s);
    tension_->add_to(matrix_, 1.0);
    tension_added_ = true;
}

void IncrementalPotential::damping_from(const StepUnderway& step, std::span<const Vec3> first_mm,
                                        const std::vector<Vec3>& d,
                                        const std::vector<Vec3>& product,
                                        std::vector<Vec3>& damping) const {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    damping.resize(d.size());
    for_each_node(d.size(), [&](std::size_t i) {
        damping[i] = product[i] - inertia * body_.mass_g[i] * d[i];
    });
    step.potentials.add_product(first_mm, -dt * dt, d, matrix_, damping);
    collapse_.add_product(d, -dt * dt, damping);
    if (tension_added_) tension_->subtract_product(d, damping);
    const double scale = beta / (dt * dt + dt * beta);
    for_each_node(d.size(), [&](std::size_t i) {
        damping[i] = held(i) ? Vec3(Vec3::Zero()) : Vec3(scale * damping[i]);
    });
}

// The matrix lacks the blocks of held nodes, which does not matter because these do not move.
void IncrementalPotential::keep_damping(const StepUnderway& step, std::span<const Vec3> first_mm,
                                        const BlockMatrix* beside) {
    const double dt = step.dt_s, beta = body_.damping.beta_s;
    if (damping_.block.size() != matrix_.block.size()) damping_ = matrix_;
    damping_.alone.clear();  // held rows keep their values from when they were live
    const double inertia = 1.0 + dt * body_.damping.alpha_per_s;
    for_each_live_row([&](int i) {
        for (int k = matrix_.row_begin[i]; k < matrix_.row_begin[i + 1]; ++k) {
            damping_.block[k] = matrix_.block[k];
            if (beside) damping_.block[k] -= beside->block[k];
        }
        damping_.block[damping_.diagonal[i]].diagonal().array() -= inertia * body_.mass_g[i];
    });
    step.potentials.add_stiffness(first_mm, -dt * dt, damping_);
    collapse_.add_to(damping_, -dt * dt);
    if (tension_added_) tension_->add_to(damping_, -1.0);
    const double scale = beta / (dt * dt + dt * beta);
    for_each_live_row([&](int i) {
        for (int k = damping_.row_begin[i]; k < damping_.row_begin[i + 1]; ++k)
            damping_.block[k] *= scale;
    });
}

}  // namespace hepatica
