// SPDX-License-Identifier: GPL-3.0-or-later
// In the first iterate damping is linear along the direction, and its form from rest is quadratic,
// so that no product is needed for each step length; from the second iterate on beta K_0 is a
// matrix of its own.
#include "core/deform/step/step_damping.h"

#include "core/deform/solvers/node_loops.h"

namespace hepatica {

void StepDamping::begin(const std::vector<Vec3>& first_mm) {
    copy_nodes(first_mm, first_mm_);
}

void StepDamping::add_at_start(StepUnderway& step, std::vector<Vec3>& residual) {
    if (!any()) return;
    multiply(potential_.matrix(), step.velocity, product_);
    potential_.damping_from(step, first_mm_, step.velocity, product_, step.damping_force);
    for_each_node(residual.size(),
                  [&](std::size_t i) { residual[i] -= step.dt_s * step.damping_force[i]; });
    step.damping_form = dot(step.velocity, step.damping_force);
    step.value += 0.5 * step.dt_s * step.damping_form;
}

void StepDamping::take_from_rest(const StepUnderway& step, double elastic_form) {
    direction_form_ = body_.damping.beta_s * elastic_form / (step.dt_s * step.dt_s);
}

void StepDamping::take(const StepUnderway& step, const std::vector<Vec3>& d,
                       std::vector<Vec3>& product, const BlockMatrix* beside) {
    from_product(step, d, product, beside, along_);
}

// damping = beta K_0 velocity, from `product` = first iterate's matrix * velocity.
void StepDamping::from_product(const StepUnderway& step, const std::vector<Vec3>& velocity,
                               std::vector<Vec3>& product, const BlockMatrix* beside,
                               std::vector<Vec3>& damping) const {
    if (beside) {
        multiply(*beside, velocity, damping);
        for_each_node(product.size(), [&](std::size_t i) { product[i] -= damping[i]; });
    }
    potential_.damping_from(step, first_mm_, velocity, product, damping);
}

void StepDamping::hold(const StepUnderway& step) {
    copy_nodes(step.damping_force, before_);
    form_before_ = step.damping_form;
}

void StepDamping::advance(StepUnderway& step, double step_length) {
    if (!any()) return;
    if (step.iterate == 0 && !step.predicted) {
        step.damping_form = step_length * step_length * direction_form_;
        return;
    }
    if (step.iterate == 0)
        for_each_node(step.velocity.size(), [&](std::size_t i) {
            step.damping_force[i] = before_[i] + step_length * along_[i];
        });
    else
        potential_.damping_of(step.velocity, step.damping_force);
    step.damping_form = dot(step.velocity, step.damping_force);
}

void StepDamping::release(StepUnderway& step) const {
    copy_nodes(before_, step.damping_force);
    step.damping_form = form_before_;
}

void StepDamping::keep(StepUnderway& step, const BlockMatrix* beside) {
    if (!any()) return;
    potential_.keep_damping(step, first_mm_, beside);
    potential_.damping_of(step.velocity, step.damping_force);
}

void StepDamping::complete(StepUnderway& step, const BlockMatrix* beside) {
    if (!any() || !step.damping_force.empty()) return;
    multiply(potential_.matrix(), step.velocity, product_);
    from_product(step, step.velocity, product_, beside, step.damping_force);
}

void StepDamping::find_again(StepUnderway& step, const BlockMatrix* beside) {
    if (!any()) return;
    if (step.iterate > 0) {
        potential_.damping_of(step.velocity, step.damping_force);
    } else {
        step.damping_force.clear();
        complete(step, beside);
    }
    step.damping_form = dot(step.velocity, step.damping_force);
}

}  // namespace hepatica
