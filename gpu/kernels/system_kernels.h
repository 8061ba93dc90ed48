// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of eq. (12) without its diagonal: blocks of K beside it, and what stands on it in
// numbers. A row is y_i = m_i p_i + sum_j A_ij (p_j - p_i), so that a rigid translation costs
// nothing to the last digit, which a stored diagonal in float would not give.
#pragma once

#include "gpu/kernels/grab_kernels.h"
#include "gpu/kernels/planes.h"
#include "gpu/kernels/sums.h"
#include "gpu/kernels/touch_kernels.h"

namespace hepatica::gpu {

// mass M + tether T + stiffness K + grab G + touch C. The matrix of the step, its damping and the
// stiffness of everything differ in these alone.
struct SystemFactors {
    double mass = 0.0, tether = 0.0, stiffness = 0.0, grab = 0.0, touch = 0.0;
};

template <class Real>
struct SystemView {
    View<const int> row_begin, column;  // blocks beside the diagonal
    MatrixPlanes<Real> block;
    View<const double> mass, tether;
    View<const unsigned char> held;
    GrabsView grabs;
    TouchesView touches;
    SystemFactors factors;

    std::size_t bytes() const {
        return bytes_of(row_begin, column, mass, tether, held) + bytes_of(block) + grabs.bytes() +
               (factors.touch != 0.0 ? touches.bytes() : 0);
    }
    HEPATICA_HOST_DEVICE double on_diagonal(int i) const {
        return factors.mass * mass[i] + factors.tether * tether[i];
    }
    // Row i times p, which is zero at held nodes; in Real, or in double whatever the blocks are.
    template <class V>
    HEPATICA_HOST_DEVICE Vector3<V> row(int i, const View<const Vector3<V>>& p) const {
        return whole_row(i, p, differences(i, p, 0, 1));
    }
    // sum_j A_ij (p_j - p_i) over every `lanes`-th block of the row, from `lane` on.
    template <class V>
    HEPATICA_HOST_DEVICE Vector3<V> differences(int i, const View<const Vector3<V>>& p, int lane,
                                                int lanes) const {
        const Vector3<V> own = p[i];
        Vector3<V> sum{{V(0), V(0), V(0)}};
        for (int k = row_begin[i] + lane; k < row_begin[i + 1]; k += lanes) {
            const Matrix3<Real> b = block[k];
            const Vector3<V> d = p[column[k]] - own;
            for (int r = 0; r < 3; ++r)
                sum[r] += V(b(r, 0)) * d[0] + V(b(r, 1)) * d[1] + V(b(r, 2)) * d[2];
        }
        return sum;
    }
    // The row from the sum of its differences.
    template <class V>
    HEPATICA_HOST_DEVICE Vector3<V> whole_row(int i, const View<const Vector3<V>>& p,
                                              const Vector3<V>& sum) const {
        if (held[i] != 0) return {{V(0), V(0), V(0)}};
        const Vector3<V> own = p[i];
        Vector3<V> y = V(factors.stiffness) * sum + V(on_diagonal(i)) * own;
        if (factors.grab != 0.0 && !grabs.first.empty()) {
            const Vector3<double> pulled = grabs.product(i, p);
            for (int c = 0; c < 3; ++c) y[c] += V(factors.grab * pulled[c]);
        }
        if (factors.touch != 0.0 && !touches.row.empty()) {
            const Vector3<double> pressed = touches.product(i, p);
            for (int c = 0; c < 3; ++c) y[c] += V(factors.touch * pressed[c]);
        }
        return y;
    }
};

// y = A p, and then p . y, as SumWhole; the blocks are Real, the vectors V. Four threads a row read
// neighbouring blocks.
template <class Real, class V, class Then>
struct SumProduct {
    static constexpr int lanes = 4, width = 1, least_blocks = 3;
    static constexpr int threads = lanes * nodes_per_chunk, shared = 3 * threads + nodes_per_chunk;
    static_assert(Then::width == width);
    SystemView<Real> system;
    View<const Vector3<V>> p;
    View<Vector3<V>> y;
    Then then;
    View<double> partial;  // of each chunk

    int blocks() const { return (y.size + nodes_per_chunk - 1) / nodes_per_chunk; }
    HEPATICA_HOST_DEVICE int phases() const { return 1 + detail::sum_phases; }
    HEPATICA_HOST_DEVICE int end_phases() const { return detail::sum_phases; }
    std::size_t bytes() const {
        return system.bytes() + bytes_of(p, y) +
               2 * static_cast<std::size_t>(blocks()) * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int chunk, int thread, double* sums) const {
        if (phase == 0) {
            const int i = chunk * nodes_per_chunk + thread / lanes;
            if (i >= y.size) return;
            const Vector3<V> sum = system.differences(i, p, thread % lanes, lanes);
            for (int c = 0; c < 3; ++c) sums[c * threads + thread] = double(sum[c]);
        } else if (thread < nodes_per_chunk) {
            const int i = chunk * nodes_per_chunk + thread;
            detail::sum_over_threads<width>(
                phase - 1, thread, sums + 3 * threads,
                [&](double* dot) {
                    if (i < y.size) dot[0] = finish_row(i, sums + lanes * thread);
                },
                [&](const double* dot) { partial[chunk] = dot[0]; });
        }
    }
    HEPATICA_HOST_DEVICE void end(int phase, int chunks, int thread, double* sums) const {
        if (thread < nodes_per_chunk)
            detail::sum_chunks(phase, thread, sums, partial, 0, chunks, 0, then);
    }

  private:
    // From what its lanes have added up; returns p . y there.
    HEPATICA_HOST_DEVICE double finish_row(int i, const double* of_lanes) const {
        Vector3<V> sum{{V(0), V(0), V(0)}};
        for (int c = 0; c < 3; ++c)
            for (int lane = 0; lane < lanes; ++lane) sum[c] += V(of_lanes[c * threads + lane]);
        const Vector3<V> row = system.whole_row(i, p, sum), own = p[i];
        y[i] = row;
        double dot = 0.0;
        for (int c = 0; c < 3; ++c) dot += double(own[c]) * double(row[c]);
        return dot;
    }
};

// r = b - A x in double, and r . r.
template <class Real>
struct FindResidual {
    static constexpr int width = 1;
    SystemView<Real> system;
    View<const Vector3<double>> b, x;
    View<Vector3<double>> r;

    std::size_t bytes() const { return system.bytes() + bytes_of(b, x, r); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        r[i] = b[i] - system.row(i, x);
        sum[0] += small::dot(r[i], r[i]);
    }
};

// The inverse of each diagonal block; zero where a node is held or the block not positive definite.
template <class Real>
struct InvertDiagonal {
    SystemView<Real> system;
    Planes<Matrix3<Real>, Real> inverse;

    HEPATICA_HOST_DEVICE int count() const { return inverse.size; }
    std::size_t bytes() const { return system.bytes() + bytes_of(inverse); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        Matrix3<double> sum = system.on_diagonal(i) * small::identity_matrix<double>();
        for (int k = system.row_begin[i]; k < system.row_begin[i + 1]; ++k) {
            const Matrix3<Real> b = system.block[k];
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c)
                    sum(r, c) -=
                        system.factors.stiffness * 0.5 * (double(b(r, c)) + double(b(c, r)));
        }
        sum = sum + system.factors.grab * system.grabs.diagonal(i);
        if (system.factors.touch != 0.0)
            sum = sum + system.factors.touch * system.touches.diagonal(i);
        const double volume = small::determinant(sum);
        const Matrix3<double> adjugate = small::transpose(small::cofactor(sum));
        const double scale = system.held[i] == 0 && volume > 0.0 ? 1.0 / volume : 0.0;
        Matrix3<Real> rounded;
        round_to(scale * adjugate, rounded);
        inverse.set(i, rounded);
    }
};

}  // namespace hepatica::gpu
