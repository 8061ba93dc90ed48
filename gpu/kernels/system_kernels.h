// SPDX-License-Identifier: GPL-3.0-or-later
// The system matrix of eq. (12) without a stored diagonal: off-diagonal blocks of K, and scalars
// per node for the rest. A row is y_i = m_i p_i + sum_j A_ij (p_j - p_i), so that a rigid
// translation yields no elastic force to the last digit; a diagonal stored in float could not
// achieve that.
#pragma once

#include "gpu/kernels/grab_kernels.h"
#include "gpu/kernels/planes.h"
#include "gpu/kernels/quads.h"
#include "gpu/kernels/touch_kernels.h"

namespace hepatica::gpu {

// The system mass M + tether T + stiffness K + grab G + touch C. The matrix of the step, its
// damping matrix and the stiffness of everything differ in these factors alone.
struct SystemFactors {
    double mass = 0.0, tether = 0.0, stiffness = 0.0, grab = 0.0, touch = 0.0;
};

// Chunks of rows for a block of threads: at most this many rows, and at most this many blocks of
// the matrix unless a single row has more.
struct RowChunksView {
    static constexpr int most_rows = 64, most_entries = 1024;
    View<const int> begin, entry;  // first row and entry of each chunk, and the ends of the last
    View<const unsigned char>
        row_of;  // row of each block of the matrix, counted from its chunk's first

    HEPATICA_HOST_DEVICE int chunks() const { return begin.size - 1; }
    std::size_t bytes() const { return bytes_of(begin, entry, row_of); }
};

template <class Real>
struct SystemView {
    View<const int> row_begin, column;  // off-diagonal blocks
    RowChunksView chunks;
    MatrixPlanes<Real> block;
    View<const double> mass, tether;
    View<const unsigned char> held;
    GrabsView grabs;
    TouchesView touches;
    SystemFactors factors;

    std::size_t bytes() const {
        return bytes_of(row_begin, column, mass, tether, held) + bytes_of(block) + chunks.bytes() +
               grabs.bytes() + (factors.touch != 0.0 ? touches.bytes() : 0);
    }
    HEPATICA_HOST_DEVICE double on_diagonal(int i) const {
        return factors.mass * mass[i] + factors.tether * tether[i];
    }
    // A_ij (p_j - p_i) of block k, which is in row i; p is zero at held nodes.
    template <class Field>
    HEPATICA_HOST_DEVICE auto difference(int k, int i, const Field& p) const {
        using V = NumberOf<Field>;
        const Matrix3<Real> b = block[k];
        const Vector3<V> d = vector_of(p[column[k]]) - vector_of(p[i]);
        Vector3<V> product;
        for (int r = 0; r < 3; ++r)
            product[r] = V(b(r, 0)) * d[0] + V(b(r, 1)) * d[1] + V(b(r, 2)) * d[2];
        return product;
    }
    // Row i times p, from the sum of its differences.
    template <class Field, class V>
    HEPATICA_HOST_DEVICE Vector3<V> row(int i, const Field& p, const Vector3<V>& sum) const {
        if (held[i] != 0) return {{V(0), V(0), V(0)}};
        const Vector3<V> own = vector_of(p[i]);
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

// Inverts the diagonal blocks; zero where a node is held or the block's determinant is not
// positive.
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
