// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels of the coarse space built on the vessel tree's centreline (AffineCoarseSpace of
// core/deform): each vertex follows two nodes, and each node has four vectors. P maps the nodes'
// motion to the vertices. Nodes are numbered by their slots (CoarsePlan).
#pragma once

#include "gpu/kernels/cut_kernels.h"
#include "gpu/kernels/sums.h"
#include "gpu/kernels/system_kernels.h"

namespace hepatica::gpu {

// A row of P: both nodes of a vertex, and its weights in their vectors. Aligned so that a device
// loads four numbers at once when a kernel reads the whole row.
template <class Real>
struct alignas(16) VertexModes {
    Real weight[2][coarse_vectors];
    int node[2];

    HEPATICA_HOST_DEVICE Real in(int other, int vector) const {
        Real sum = Real(0);
        for (int side = 0; side < 2; ++side)
            if (node[side] == other) sum += weight[side][vector];
        return sum;
    }
};

// The two nodes of a vertex and its shares of them, which sum to 1 (SkeletonBinding).
struct VertexShares {
    int node[2];
    double share[2];
};

// Sums w x and w over the vertices of each node, where w is the vertex's share of the node.
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

// Computes the rows of P at the present shape, as AffineCoarseSpace::set_shape().
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

// Two nodes and the position of their entry of P^T A P: the block of the factor, and the first row
// and column in it.
struct NodePair {
    int own, other;
    int block, row, column;
};

// The contribution of a few vertices between the same two nodes to
//   P^T A P = sum_i P_i (m_i P_i + sum_j A_ij (P_j - P_i)),
// evaluated by differences, as A itself is. It consists of parts of 144 numbers, one per pair of an
// own node and another node that moves these vertices or their neighbours, ordered by the own
// node's vector, the other node's vector, and the rows of the 3 x 3 blocks.
struct CoarseElement {
    static constexpr int most_vertices = 32, most_others = 4;
    static constexpr int part_numbers = 9 * coarse_vectors * coarse_vectors;

    int first, vertices;  // range in the list of vertices
    int own[2];
    int other[most_others];
    unsigned wanted;  // one bit for each part that a pair of nodes uses

    HEPATICA_HOST_DEVICE bool wants(int side, int k) const {
        return (wanted >> (side * most_others + k) & 1u) != 0;
    }
    // Index of a part among those of all elements.
    HEPATICA_HOST_DEVICE static int part(int element, int side, int other) {
        return (2 * element + side) * most_others + other;
    }
};

// One block of threads per element. In the first phase a thread is a vertex and a vector of the
// other nodes; in the second, a pair of nodes with a vector of each. Grabs and touches are left
// out.
template <class Real>
struct ProjectElements {
    static constexpr int others = CoarseElement::most_others;
    static constexpr int threads = CoarseElement::most_vertices * coarse_vectors;
    static_assert(threads == 2 * others * coarse_vectors * coarse_vectors);
    static constexpr int shared = 9 * others * threads;
    SystemView<Real> system;
    View<const VertexModes<Real>> modes;
    View<const CoarseElement> element;
    View<const int> vertex;
    View<double> part;

    int blocks() const { return element.size; }
    HEPATICA_HOST_DEVICE int phases() const { return 2; }
    std::size_t bytes() const { return system.bytes() + bytes_of(modes, element, vertex, part); }
    HEPATICA_HOST_DEVICE void operator()(int phase, int e, int thread, double* image) const {
        if (phase == 0)
            apply(element[e], thread, image + thread);
        else
            project(element[e], e, thread, image);
    }

  private:
    // A P of a vertex for one vector of every other node; consecutive numbers are `threads` apart.
    HEPATICA_HOST_DEVICE void apply(const CoarseElement& at, int thread, double* image) const {
        const int vector = thread % coarse_vectors;
        if (thread / coarse_vectors >= at.vertices) return;
        const int i = vertex[at.first + thread / coarse_vectors];
        double right[others];
        Matrix3<double> sum[others];
        for (int k = 0; k < others; ++k) {
            right[k] = double(modes[i].in(at.other[k], vector));
            sum[k] = small::zero_matrix<double>();
        }
        for (int b = system.row_begin[i]; b < system.row_begin[i + 1]; ++b) {
            const VertexModes<Real>& neighbour = modes[system.column[b]];
            const Matrix3<Real> block = system.block[b];
            HEPATICA_UNROLL
            for (int k = 0; k < others; ++k) {
                const double off = double(neighbour.in(at.other[k], vector)) - right[k];
                for (int c = 0; c < 9; ++c)
                    sum[k](c / 3, c % 3) += off * double(block(c / 3, c % 3));
            }
        }
        for (int k = 0; k < others; ++k) {
            sum[k] = system.factors.stiffness * sum[k];
            for (int c = 0; c < 3; ++c) sum[k](c, c) += system.on_diagonal(i) * right[k];
            for (int c = 0; c < 9; ++c) image[(9 * k + c) * threads] = sum[k](c / 3, c % 3);
        }
    }
    HEPATICA_HOST_DEVICE void project(const CoarseElement& at, int e, int thread,
                                      const double* image) const {
        const int right = thread % coarse_vectors, left = thread / coarse_vectors % coarse_vectors;
        const int pair = thread / (coarse_vectors * coarse_vectors);
        const int k = pair % others, side = pair / others;
        if (!at.wants(side, k)) return;
        double sum[9] = {};
        for (int v = 0; v < at.vertices; ++v) {
            const double weight = double(modes[vertex[at.first + v]].in(at.own[side], left));
            for (int c = 0; c < 9; ++c)
                sum[c] += weight * image[(9 * k + c) * threads + v * coarse_vectors + right];
        }
        double* const own =
            part.data + CoarseElement::part_numbers * CoarseElement::part(e, side, k);
        for (int c = 0; c < 9; ++c) own[9 * (coarse_vectors * left + right) + c] = sum[c];
    }
};

// Gathers P^T A P from its parts: one block of threads per pair of nodes, one thread per number.
struct GatherProjected {
    static constexpr int threads = CoarseElement::part_numbers, shared = 1;
    View<const NodePair> pair;
    View<const int> part_begin, parts;
    View<const double> part;
    View<double> matrix;  // in blocks of the factor

    int blocks() const { return pair.size; }
    HEPATICA_HOST_DEVICE int phases() const { return 1; }
    std::size_t bytes() const {
        return bytes_of(pair, part_begin, parts, matrix) +
               static_cast<std::size_t>(parts.size) * threads * sizeof(double);
    }
    HEPATICA_HOST_DEVICE void operator()(int, int q, int thread, double*) const {
        double sum = 0.0;
        for (int k = part_begin[q]; k < part_begin[q + 1]; ++k)
            sum += part[threads * parts[k] + thread];
        const int vectors = thread / 9, c = thread % 9;
        const NodePair& at = pair[q];
        const int row = at.row + 3 * (vectors / coarse_vectors) + c / 3;
        const int column = at.column + 3 * (vectors % coarse_vectors) + c % 3;
        matrix[cut_entries * at.block + entry_of_cut(row, column)] = sum;
    }
};

// P^T r, summed over the vertices of each node; entry k of the sum is vertex[k] of node[k].
template <class Real>
struct RestrictResidual {
    static constexpr int width = 3 * coarse_vectors;
    View<const VertexModes<Real>> modes;
    View<const int> vertex, node;
    View<const Vector3<Real>> r;

    std::size_t bytes() const { return bytes_of(modes, vertex, node, r); }
    HEPATICA_HOST_DEVICE void operator()(int k, double* sum) const {
        const int i = vertex[k];
        const VertexModes<Real> own = modes[i];
        for (int m = 0; m < coarse_vectors; ++m) {
            const double weight = double(own.in(node[k], m));
            for (int c = 0; c < 3; ++c) sum[3 * m + c] += weight * double(r[i][c]);
        }
    }
};

// z += P c; sums r . z and r . r.
template <class Real>
struct AddMotion {
    static constexpr int width = 2;
    View<const VertexModes<Real>> modes;
    View<const NodeMotion<Real>> motion;
    View<const Vector3<Real>> r;
    View<Vector3<Real>> z;

    std::size_t bytes() const { return bytes_of(modes, motion, r, z, z); }
    HEPATICA_HOST_DEVICE void operator()(int i, double* sum) const {
        const VertexModes<Real> own = modes[i];
        Vector3<double> moved{{double(z[i][0]), double(z[i][1]), double(z[i][2])}};
        for (int side = 0; side < 2; ++side) {
            const NodeMotion<Real> of_node = motion[own.node[side]];
            for (int k = 0; k < node_rows; ++k)
                moved[k % 3] += double(own.weight[side][k / 3]) * double(of_node.number[k]);
        }
        for (int c = 0; c < 3; ++c) {
            z[i][c] = Real(moved[c]);
            sum[0] += double(r[i][c]) * double(z[i][c]);
            sum[1] += double(r[i][c]) * double(r[i][c]);
        }
    }
};

}  // namespace hepatica::gpu
