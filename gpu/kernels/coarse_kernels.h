// SPDX-License-Identifier: GPL-3.0-or-later
// The coarse space of the vessel tree's own centreline (AffineCoarseSpace of core/deform): two
// nodes move a vertex, each by four vectors. P maps their motions to the vertices. Nodes have the
// numbers of their slots (CoarsePlan).
#pragma once

#include "gpu/kernels/cut_kernels.h"
#include "gpu/kernels/sums.h"
#include "gpu/kernels/system_kernels.h"

namespace hepatica::gpu {

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

// One of the two nodes of a vertex and its share of it, which sum to 1 (SkeletonBinding).
struct VertexShares {
    int node[2];
    double share[2];
};

// Sums w x and w over the vertices of each node, w being their shares of it.
struct CentreOfNode {
    static constexpr int width = 4;
    View<const VertexShares> shares;
    View<const int> vertex, node;
    View<const Vector3<double>> position;

    std::size_t bytes() const { return bytes_of(shares, vertex, node, position); }
    HEPATICA_HOST_DEVICE void operator()(int k, double* sum) const {
        const VertexShares& own = shares[vertex[k]];
        for (int side = 0; side < 2; ++side) {
            if (own.node[side] != node[k]) continue;
            for (int c = 0; c < 3; ++c) sum[c] += own.share[side] * position[vertex[k]][c];
            sum[3] += own.share[side];
        }
    }
};
struct KeepCentre {
    static constexpr int width = 4;
    View<Vector3<double>> centre;
    HEPATICA_HOST_DEVICE void operator()(int node, const double* sum) const {
        const double scale = sum[3] > 0.0 ? 1.0 / sum[3] : 0.0;
        for (int c = 0; c < 3; ++c) centre[node][c] = scale * sum[c];
    }
};

// The rows of P at this shape, as AffineCoarseSpace::set_shape.
template <class Real>
struct ShapeModes {
    View<const VertexShares> shares;
    View<const Vector3<double>> position, centre;
    View<const double> radius;  // of each node
    View<const unsigned char> held;
    View<VertexModes<Real>> modes;

    HEPATICA_HOST_DEVICE int count() const { return modes.size; }
    std::size_t bytes() const { return bytes_of(shares, position, centre, radius, held, modes); }
    HEPATICA_HOST_DEVICE void operator()(int i) const {
        const VertexShares& own = shares[i];
        for (int side = 0; side < 2; ++side) {
            const int node = own.node[side];
            const double share = held[i] != 0 ? 0.0 : own.share[side];
            modes[i].node[side] = node;
            modes[i].weight[side][0] = Real(share);
            for (int c = 0; c < 3; ++c)
                modes[i].weight[side][1 + c] =
                    Real(share * (position[i][c] - centre[node][c]) / radius[node]);
        }
    }
};

// Two nodes, and where their part of P^T A P lies: the block of the factor, and the first row and
// column in it.
struct NodePair {
    int own, other;
    int block, row, column;
};

// P^T A P,
//   sum_i P_i (m_i P_i + sum_j A_ij (P_j - P_i)),
// by differences, as A itself: one block of threads a pair of nodes, four threads for the vectors
// of the other node, many times over for the vertices. Grabs are left out.
template <class Real>
struct ProjectMatrix {
    static constexpr int parts = 32, halvings = 5;
    static_assert(1 << halvings == parts);
    static constexpr int entries = 9 * coarse_vectors;  // for all vectors of the own node
    static constexpr int threads = coarse_vectors * parts, shared = entries * threads;
    SystemView<Real> system;
    View<const VertexModes<Real>> modes;
    NodeVertices vertices;
    View<const NodePair> pair;
    View<double> matrix;  // blocks of the factor

    int blocks() const { return pair.size; }
    HEPATICA_HOST_DEVICE int phases() const { return 2 + halvings; }
    std::size_t bytes() const {
        return system.bytes() + bytes_of(modes, vertices.vertex, pair, matrix);
    }
    HEPATICA_HOST_DEVICE void operator()(int phase, int q, int thread, double* sums) const {
        const int half = threads >> phase;
        if (phase == 0) {
            add_up(pair[q], thread, sums);
        } else if (phase <= halvings) {
            for (int e = 0; e < entries && thread < half; ++e)
                sums[e * threads + thread] += sums[e * threads + thread + half];
        } else if (thread < coarse_vectors) {
            write(pair[q], thread, sums);
        }
    }

  private:
    // A P of a vertex, for one vector of the other node.
    HEPATICA_HOST_DEVICE Matrix3<double> image(int i, int other, int vector, double right) const {
        Matrix3<double> sum = small::zero_matrix<double>();
        for (int b = system.row_begin[i]; b < system.row_begin[i + 1]; ++b) {
            const double off = double(modes[system.column[b]].in(other, vector)) - right;
            if (off == 0.0) continue;
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) sum(r, c) += off * double(system.block[b](r, c));
        }
        sum = system.factors.stiffness * sum;
        for (int c = 0; c < 3; ++c) sum(c, c) += system.on_diagonal(i) * right;
        return sum;
    }
    HEPATICA_HOST_DEVICE void add_up(const NodePair& at, int thread, double* sums) const {
        const int vector = thread % coarse_vectors;
        double sum[entries] = {};
        for (int k = vertices.begin[at.own] + thread / coarse_vectors;
             k < vertices.begin[at.own + 1]; k += parts) {
            const int i = vertices.vertex[k];
            const VertexModes<Real> own = modes[i];
            const Matrix3<double> moved =
                image(i, at.other, vector, double(own.in(at.other, vector)));
            for (int m = 0; m < coarse_vectors; ++m) {
                const double left = double(own.in(at.own, m));
                for (int e = 0; e < 9; ++e) sum[9 * m + e] += left * moved(e / 3, e % 3);
            }
        }
        for (int e = 0; e < entries; ++e) sums[e * threads + thread] = sum[e];
    }
    HEPATICA_HOST_DEVICE void write(const NodePair& at, int vector, const double* sums) const {
        double* const block = matrix.data + cut_entries * at.block;
        for (int m = 0; m < coarse_vectors; ++m)
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c)
                    block[entry_of_cut(at.row + 3 * m + r, at.column + 3 * vector + c)] =
                        sums[(9 * m + 3 * r + c) * threads + vector];
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
