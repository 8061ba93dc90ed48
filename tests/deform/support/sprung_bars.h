// SPDX-License-Identifier: GPL-3.0-or-later
// Two bars tied by springs between nodes that have no block in the matrix, and the dense matrix of
// all of it.
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "core/deform/body/body.h"
#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica::test {

struct SprungBars {
    Body body = build_body(crossed_bars(1.0), ElementModel::corotated, ElementOrder::linear);
    int nodes = body.node_count();
    BlockMatrix unsprung, matrix;  // without the springs, and with what lies within one node
    std::vector<std::pair<PointPair, Mat3>> springs;
    CouplingBlocks coupling;

    SprungBars() {
        Assembly assembly(body);
        assembly.evaluate(body.rest_positions_mm);
        assembly.gather_stiffness(1.0 / 3600.0, unsprung);
        for (int i = 0; i < nodes; ++i)
            unsprung.block[unsprung.diagonal[i]].diagonal().array() += body.mass_g[i];
        matrix = unsprung;
    }

    // Springs k in [begin, end), of other nodes each, up to far stiffer than the body. The third
    // node of each is that one of the second's neighbours.
    void tie(int begin, int end, int apart = 1) {
        springs.clear();
        coupling.clear();
        matrix = unsprung;
        const int half = nodes / 2;
        for (int k = begin; k < end; ++k) {
            const int a = 5 * k % half, b = half + 4 * k % half;
            const int c = neighbour(b, apart);
            const Vec3 along(0.1 * (k % 20), 1, 2);
            springs.push_back({{{a, b, c, c}, {1.0, -0.7, -0.3, 0.0}, 1},
                               std::pow(10.0, k % 5) * along * along.transpose()});
            add_within(springs.back().first, springs.back().second, {}, matrix);
            append_pair_coupling(springs.back().first, springs.back().second, {}, coupling);
        }
    }

    int neighbour(int node, int number) const {
        std::vector<int> others;
        for (int k = unsprung.row_begin[node]; k < unsprung.row_begin[node + 1]; ++k)
            if (unsprung.column[k] != node) others.push_back(unsprung.column[k]);
        return others[static_cast<std::size_t>(number) % others.size()];
    }

    Eigen::MatrixXd dense() const {
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        for (int i = 0; i < nodes; ++i)
            for (int k = unsprung.row_begin[i]; k < unsprung.row_begin[i + 1]; ++k)
                all.block<3, 3>(3 * i, 3 * unsprung.column[k]) = unsprung.block[k];
        for (const auto& [pair, k] : springs)
            for (int a = 0; a < 4; ++a)
                for (int b = 0; b < 4; ++b)
                    all.block<3, 3>(3 * pair.nodes[a], 3 * pair.nodes[b]) +=
                        pair.weights[a] * pair.weights[b] * k;
        return all;
    }
};

// |x - exact| / |exact| in the energy norm, and |sum of the residual| / sum of the right-hand side.
struct DenseErrors {
    double energy = 0.0, sum = 0.0;
};

inline DenseErrors dense_errors(const Eigen::MatrixXd& matrix, const std::vector<Vec3>& rhs,
                                const std::vector<Vec3>& x) {
    const auto size = static_cast<Eigen::Index>(3 * rhs.size());
    const auto flat = [&](const std::vector<Vec3>& v) {
        return Eigen::Map<const Eigen::VectorXd>(v[0].data(), size);
    };
    const Eigen::VectorXd exact = matrix.llt().solve(flat(rhs)), error = exact - flat(x);
    const Eigen::VectorXd residual = matrix * error;
    const Vec3 left = residual.reshaped(3, rhs.size()).rowwise().sum();
    return {.energy = std::sqrt(error.dot(residual) / exact.dot(flat(rhs))),
            .sum = left.norm() / flat(rhs).cwiseAbs().sum()};
}

}  // namespace hepatica::test
