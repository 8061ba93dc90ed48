// SPDX-License-Identifier: GPL-3.0-or-later
// The coarse space of the vessel tree's own centreline (AffineCoarseSpace of core/deform): two
// nodes move a vertex, each by four vectors. P maps their motions to the vertices.
#pragma once

#include "gpu/kernels/sums.h"
#include "gpu/kernels/system_kernels.h"

namespace hepatica::gpu {

constexpr int coarse_vectors = 4;  // per node, as vectors_per_node

// Row of P: both nodes of a vertex and its weights in their vectors.
template <class Real>
struct VertexModes {
    int node[2];
    Real weight[2][coarse_vectors];

    HEPATICA_HOST_DEVICE Real in(int other, int vector) const {
        Real sum = Real(0);
        for (int side = 0; side < 2; ++side)
            if (node[side] == other) sum += weight[side][vector];
        return sum;
    }
};

// The vertices of each node; one that it shares with itself stands there once.
struct NodeVertices {
    View<const int> begin, vertex;
};

// P^T A P, one thread a 3x3 block of it:
//   sum_i P_i (m_i P_i + sum_j A_ij (P_j - P_i)),
// by differences, as A itself. Grabs are left out.
template <class Real>
struct ProjectMatrix {
    SystemView<Real> system;
    View<const VertexModes<Real>> modes;
    NodeVertices vertices;
    View<const int> row, column;  // of each coarse block
    View<Matrix3<double>> coarse;

    HEPATICA_HOST_DEVICE int count() const { return coarse.size; }
    std::size_t bytes() const {
        return system.bytes() + bytes_of(modes, vertices.vertex, row, column, coarse);
    }
    HEPATICA_HOST_DEVICE void operator()(int q) const {
        const int own = row[q] / coarse_vectors, own_vector = row[q] % coarse_vectors;
        const int other = column[q] / coarse_vectors, other_vector = column[q] % coarse_vectors;
        Matrix3<double> sum = small::zero_matrix<double>();
        for (int k = vertices.begin[own]; k < vertices.begin[own + 1]; ++k) {
            const int i = vertices.vertex[k];
            const double left = double(modes[i].in(own, own_vector));
            const double right = double(modes[i].in(other, other_vector));
            if (left == 0.0) continue;
            const double inertia = left * system.on_diagonal(i) * right;
            for (int c = 0; c < 3; ++c) sum(c, c) += inertia;
            for (int b = system.row_begin[i]; b < system.row_begin[i + 1]; ++b) {
                const double off = double(modes[system.column[b]].in(other, other_vector)) - right;
                if (off == 0.0) continue;
                const double scale = left * system.factors.stiffness * off;
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) sum(r, c) += scale * double(system.block[b](r, c));
            }
        }
        coarse[q] = sum;
    }
};

// P^T r, added up over the vertices of each node: entry k of them is vertex[k].
template <class Real>
struct RestrictResidual {
    static constexpr int width = 3 * coarse_vectors;
    View<const VertexModes<Real>> modes;
    View<const int> vertex, node;
    View<const Vector3<Real>> r;

    std::size_t bytes() const { return bytes_of(modes, vertex, node, r); }
    HEPATICA_HOST_DEVICE void operator()(int k, double* sum) const {
        const int i = vertex[k];
        for (int m = 0; m < coarse_vectors; ++m) {
            const double weight = double(modes[i].in(node[k], m));
            for (int c = 0; c < 3; ++c) sum[3 * m + c] += weight * double(r[i][c]);
        }
    }
};

// The coarse solve as a list of weighted sums in stages: a stage reads what earlier ones wrote.
// A triangular factor of a tree becomes a few of them for each of its levels. One block, with a
// barrier after each stage.
template <class Real>
struct RunStages {
    static constexpr int threads = 256, shared = 1;
    View<const int> stage_begin;    // rows
    View<const int> target, begin;  // of each row: where it is written, its terms
    View<const int> source;
    View<const Real> factor;
    View<double> value;

    int blocks() const { return stage_begin.size > 1 ? 1 : 0; }
    HEPATICA_HOST_DEVICE int phases() const { return stage_begin.size - 1; }
    std::size_t bytes() const { return bytes_of(target, begin, source, factor, value); }
    HEPATICA_HOST_DEVICE void operator()(int stage, int, int thread, double*) const {
        for (int row = stage_begin[stage] + thread; row < stage_begin[stage + 1]; row += threads) {
            double sum = 0.0;
            for (int k = begin[row]; k < begin[row + 1]; ++k)
                sum += double(factor[k]) * value[source[k]];
            value[target[row]] = sum;
        }
    }
};

// z += P c; sums r . z and r . r.
template <class Real>
struct AddMotion {
    static constexpr int width = 2;
    View<const VertexModes<Real>> modes;
    View<const double> motion;  // of every vector of every node
    View<const Vector3<Real>> r;
    View<Vector3<Real>> z;

    std::size_t bytes() const { return bytes_of(modes, motion, r, z, z); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const VertexModes<Real>& own = modes[i];
        Vector3<double> moved{{double(z[i][0]), double(z[i][1]), double(z[i][2])}};
        for (int side = 0; side < 2; ++side)
            for (int m = 0; m < coarse_vectors; ++m) {
                const int first = 3 * (coarse_vectors * own.node[side] + m);
                for (int c = 0; c < 3; ++c)
                    moved[c] += double(own.weight[side][m]) * motion[first + c];
            }
        for (int c = 0; c < 3; ++c) {
            z[i][c] = Real(moved[c]);
            sum[0] += double(r[i][c]) * double(z[i][c]);
            sum[1] += double(r[i][c]) * double(r[i][c]);
        }
    }
};

}  // namespace hepatica::gpu
