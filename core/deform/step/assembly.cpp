// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/assembly.h"

#include <array>
#include <cstring>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t row_block = 256;

using Column = ElementSlots::Wide;
using Columns = std::array<Column, 3>;  // of a 3x3 matrix; the fourth lanes are not used

Columns transposed(const Columns& m) {
    const auto first = __builtin_shufflevector(m[0].v, m[1].v, 0, 4, 2, 6);
    const auto second = __builtin_shufflevector(m[0].v, m[1].v, 1, 5, 3, 7);
    return {Column(__builtin_shufflevector(first, m[2].v, 0, 1, 4, 5)),
            Column(__builtin_shufflevector(second, m[2].v, 0, 1, 5, 4)),
            Column(__builtin_shufflevector(first, m[2].v, 2, 3, 6, 7))};
}

// Writes nine entries, column by column.
void store(const Columns& m, Mat3& block) {
    const auto last = __builtin_shufflevector(m[1].v, m[2].v, 2, 4, 5, 6);
    std::memcpy(block.data(), &m[0].v, sizeof(m[0].v));
    std::memcpy(block.data() + 3, &m[1].v, sizeof(m[1].v));
    std::memcpy(block.data() + 5, &last, sizeof(last));
}

Columns columns_of(const small::Matrix3<double>& m) {
    Columns columns;
    for (int j = 0; j < 3; ++j) columns[j] = Column::Vector{m(0, j), m(1, j), m(2, j), 0.0};
    return columns;
}

}  // namespace

Assembly::Assembly(const Body& body, small::Tangent tangent, const LiveSet* live)
    : body_(body),
      plan_(std::make_shared<AssemblyPlan>(plan_assembly(body, tangent))),
      live_(live),
      slots_(body, tangent, plan_, live) {}

int Assembly::row(std::size_t r) const {
    return live_ != nullptr ? live_->rows()[r] : static_cast<int>(r);
}

template <class Visit>
void Assembly::for_each_row_block(const Visit& visit) const {
    const std::size_t count = live_ != nullptr ? live_->rows().size() : plan_->diagonal.size();
    parallel_blocks(count, row_block, visit);
}

void Assembly::gather_forces(std::span<Vec3> forces_un) const {
    for_each_row_block([&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const int i = row(r);
            Wide sum(0.0);
            for (int k = plan_->forces.begin[i]; k < plan_->forces.begin[i + 1]; ++k)
                sum += slots_.force()[plan_->forces.place[k]];
            forces_un[i] = Vec3(sum[0], sum[1], sum[2]);
        }
    });
}

Assembly::BlockPair Assembly::upper_block(int k) const {
    const Wide* turned = slots_.turned_gradient();
    Columns s{0.0, 0.0, 0.0};  // see evaluate_turned_gradients
    for (int f = plan_->factors.begin[k]; f < plan_->factors.begin[k + 1]; f += 2) {
        const Wide &a = turned[plan_->factors.place[f]], &b = turned[plan_->factors.place[f + 1]];
        for (int j = 0; j < 3; ++j) s[j] += Wide(a[j]) * b;
    }
    const Columns t = transposed(s);
    const Wide ratio(plan_->lambda_over_mu);
    const double trace = s[0][0] + s[1][1] + s[2][2];
    BlockPair pair;
    for (int j = 0; j < 3; ++j) {
        Wide on_diagonal(0.0);
        on_diagonal.set(j, trace);
        pair.upper[j] = s[j] + ratio * t[j] + on_diagonal;
        pair.lower[j] = t[j] + ratio * s[j] + on_diagonal;
    }
    const auto add = [&pair](const Columns& upper, const Columns& lower) {
        for (int j = 0; j < 3; ++j) {
            pair.upper[j] += upper[j];
            pair.lower[j] += lower[j];
        }
    };
    for (int b = plan_->blocks.begin[k]; b < plan_->blocks.begin[k + 1]; ++b) {
        const Columns block = columns_of(slots_.block(plan_->blocks.place[b]));
        add(block, transposed(block));
    }
    for (int b = plan_->transposed.begin[k]; b < plan_->transposed.begin[k + 1]; ++b) {
        const Columns block = columns_of(slots_.block(plan_->transposed.place[b]));
        add(transposed(block), block);
    }
    return pair;
}

void Assembly::gather_upper(int i, double factor, BlockMatrix& matrix) const {
    const Wide by(factor);
    for (int k = plan_->diagonal[i] + 1; k < plan_->row_begin[i + 1]; ++k) {
        const BlockPair pair = upper_block(k);
        store({by * pair.upper[0], by * pair.upper[1], by * pair.upper[2]}, matrix.block[k]);
        store({by * pair.lower[0], by * pair.lower[1], by * pair.lower[2]},
              matrix.block[plan_->mirror[k]]);
    }
}

void Assembly::gather_diagonal(int i, BlockMatrix& matrix) const {
    Mat3 sum = Mat3::Zero();
    const int diagonal = plan_->diagonal[i];
    for (int k = plan_->row_begin[i]; k < plan_->row_begin[i + 1]; ++k)
        if (k != diagonal) sum += matrix.block[k];
    matrix.block[diagonal] = -0.5 * (sum + sum.transpose());
}

// Most rows meet only rows of their own block: their diagonal is summed while they are still in
// the cache, that of the others in a second pass.
void Assembly::gather_stiffness(double factor, BlockMatrix& matrix) const {
    if (matrix.column.size() != plan_->column.size()) {
        matrix.row_begin = plan_->row_begin;
        matrix.column = plan_->column;
        matrix.diagonal = plan_->diagonal;
        matrix.block.assign(matrix.column.size(), Mat3::Zero());
    }
    const auto within = [this](int i, std::size_t begin, std::size_t end) {
        return plan_->column[plan_->row_begin[i]] >= row(begin) &&
               plan_->column[plan_->row_begin[i + 1] - 1] <= row(end - 1);
    };
    for_each_row_block([&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) gather_upper(row(r), factor, matrix);
        for (std::size_t r = begin; r < end; ++r)
            if (within(row(r), begin, end)) gather_diagonal(row(r), matrix);
    });
    for_each_row_block([&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            if (!within(row(r), begin, end)) gather_diagonal(row(r), matrix);
    });
}

}  // namespace hepatica
