// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assembly.h"

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t row_block = 256;

}  // namespace

Assembly::Assembly(const Body& body, small::Tangent tangent, const LiveSet* live)
    : body_(body),
      plan_(std::make_shared<AssemblyPlan>(plan_assembly(body, tangent))),
      live_(live),
      slots_(body, tangent, plan_, live) {}

template <class Visit>
void Assembly::for_each_row(const Visit& visit) const {
    const std::size_t count = live_ != nullptr ? live_->rows().size() : plan_->diagonal.size();
    parallel_blocks(count, row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            visit(live_ != nullptr ? static_cast<std::size_t>(live_->rows()[r]) : r);
    });
}

void Assembly::gather_forces(std::span<Vec3> forces_un) const {
    for_each_row([&](std::size_t i) {
        Wide sum(0.0);
        for (int k = plan_->forces.begin[i]; k < plan_->forces.begin[i + 1]; ++k)
            sum += slots_.force()[plan_->forces.place[k]];
        forces_un[i] = Vec3(sum[0], sum[1], sum[2]);
    });
}

// Row-major, as the elements write their blocks.
small::Matrix3<double> Assembly::upper_block(int k) const {
    const Wide* turned = slots_.turned_gradient();
    Wide column[3] = {0.0, 0.0, 0.0};  // of S, see evaluate_turned_gradients
    for (int s = plan_->factors.begin[k]; s < plan_->factors.begin[k + 1]; s += 2) {
        const Wide &a = turned[plan_->factors.place[s]], &b = turned[plan_->factors.place[s + 1]];
        for (int j = 0; j < 3; ++j) column[j] += Wide(a[j]) * b;
    }
    const double ratio = plan_->lambda_over_mu;
    const double trace = column[0][0] + column[1][1] + column[2][2];
    small::Matrix3<double> sum;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) sum(i, j) = column[j][i] + ratio * column[i][j];
        sum(i, i) += trace;
    }
    for (int s = plan_->blocks.begin[k]; s < plan_->blocks.begin[k + 1]; ++s)
        sum = sum + slots_.block(plan_->blocks.place[s]);
    for (int s = plan_->transposed.begin[k]; s < plan_->transposed.begin[k + 1]; ++s)
        sum = sum + transpose(slots_.block(plan_->transposed.place[s]));
    return sum;
}

void Assembly::gather_stiffness(double factor, BlockMatrix& matrix) const {
    if (matrix.column.size() != plan_->column.size()) {
        matrix.row_begin = plan_->row_begin;
        matrix.column = plan_->column;
        matrix.diagonal = plan_->diagonal;
        matrix.block.assign(matrix.column.size(), Mat3::Zero());
    }
    for_each_row([&](std::size_t i) {
        for (int k = plan_->diagonal[i] + 1; k < plan_->row_begin[i + 1]; ++k) {
            const small::Matrix3<double> sum = upper_block(k);
            double* upper = matrix.block[k].data();  // column-major
            double* lower = matrix.block[plan_->mirror[k]].data();
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const double entry = factor * sum(r, c);
                    lower[3 * r + c] = entry;
                    upper[3 * c + r] = entry;
                }
        }
    });
    for_each_row([&](std::size_t i) {
        Mat3 sum = Mat3::Zero();
        const int diagonal = plan_->diagonal[i];
        for (int k = plan_->row_begin[i]; k < plan_->row_begin[i + 1]; ++k)
            if (k != diagonal) sum += matrix.block[k];
        matrix.block[diagonal] = -0.5 * (sum + sum.transpose());
    });
}

}  // namespace hepatica
