// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/patch_compliance.h"

#include <algorithm>

#include "core/deform/solvers/elimination_order.h"

namespace hepatica {

PatchCompliance::PatchCompliance(const BodyDescription& body, ElementModel model)
    : body_(build_body(body, model, ElementOrder::linear)), assembly_(body_) {}

void PatchCompliance::assemble(std::span<const Vec3> positions_mm, double dt_s) {
    const RayleighDamping& damping = body_.damping;
    assembly_.evaluate(positions_mm);
    assembly_.gather_stiffness(dt_s * dt_s + dt_s * damping.beta_s, matrix_);
    for (int i = 0; i < matrix_.rows(); ++i) {
        Mat3& own = matrix_.block[matrix_.diagonal[i]];
        if (body_.fixed[i] != 0) {
            own.setIdentity();
        } else {
            own.diagonal().array() += (1.0 + dt_s * damping.alpha_per_s) * body_.mass_g[i];
            if (!body_.tether_un_per_mm.empty())
                own.diagonal().array() += dt_s * dt_s * body_.tether_un_per_mm[i];
        }
        for (int k = matrix_.row_begin[i]; k < matrix_.row_begin[i + 1]; ++k) {
            const int j = matrix_.column[k];
            if (i != j && (body_.fixed[i] != 0 || body_.fixed[j] != 0)) matrix_.block[k].setZero();
        }
    }
}

bool PatchCompliance::follow(std::span<const Vec3> positions_mm, double dt_s,
                             std::span<const SparseLoad> loads) {
    constexpr double bearable = 0.1;  // of the patch
    if (factor_ && dt_s == factored_dt_s_) {
        Vec3 drift = Vec3::Zero(), least = Vec3::Constant(1e30), most = -least;
        double count = 0.0, worst = 0.0;
        const auto for_each_vertex = [&](const auto& visit) {
            for (const SparseLoad& load : loads)
                for (const int v : load.vertices) visit(v, positions_mm[v] - factored_mm_[v]);
        };
        for_each_vertex([&](int v, const Vec3& moved) {
            drift += moved;
            count += 1.0;
            least = least.cwiseMin(positions_mm[v]);
            most = most.cwiseMax(positions_mm[v]);
        });
        for_each_vertex([&](int, const Vec3& moved) {
            worst = std::max(worst, (moved - drift / count).norm());
        });
        if (count == 0.0 || worst <= bearable * (most - least).norm()) return false;
    }
    assemble(positions_mm, dt_s);
    if (!factor_) factor_.emplace(matrix_, fill_reducing_order(matrix_));
    factor_->factor(matrix_);
    factored_mm_.assign(positions_mm.begin(), positions_mm.end());
    factored_dt_s_ = dt_s;
    return true;
}

Eigen::MatrixXd PatchCompliance::block(std::span<const SparseLoad> loads, double dt_s) const {
    std::vector<SparseLoad> free(loads.begin(), loads.end());
    for (SparseLoad& load : free)
        for (std::size_t i = 0; i < load.vertices.size(); ++i)
            if (body_.fixed[load.vertices[i]] != 0) load.forces[i].setZero();
    return dt_s * dt_s * factor_->inverse_block(free);
}

}  // namespace hepatica
