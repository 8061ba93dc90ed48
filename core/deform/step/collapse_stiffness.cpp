// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/collapse_stiffness.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/deform/elements/polar_decomposition.h"

namespace hepatica {
namespace {

// An element with s0 > 3 stores more than mu V (s0 - 1)^2.
constexpr double least_energy_of_mu = 4.0;
constexpr std::size_t packs_at_once = 512;
constexpr double least_z = 1e-6;  // bounds the stiffness at the tip of the cone

Vec3 column(const small::Matrix3<double>& m, int j) {
    return {m(0, j), m(1, j), m(2, j)};
}

}  // namespace

void CollapseStiffness::find(const ElementSlots& slots, std::span<const Vec3> positions_mm) {
    collapsed_.clear();
    if (least_nj_.empty()) find_least_energies();
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        if (!plan_.groups[g].in_factors) continue;
        const ElementGroup& group = body_.groups[g];
        const std::vector<double>& energy_nj = slots.energies(g);
        const auto packs = live_.packs(g);
        std::vector<std::vector<int>> may_have(packs.size() / packs_at_once + 1);
        parallel_blocks(packs.size(), packs_at_once, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                const int first = packs[p] * LiveSet::elements_per_pack;
                const int last = std::min(first + LiveSet::elements_per_pack, group.size());
                for (int e = first; e < last; ++e)
                    if (energy_nj[e] > least_nj_[g][e])
                        may_have[begin / packs_at_once].push_back(e);
            }
        });
        for (const std::vector<int>& block : may_have)
            for (const int e : block) add_if_collapsed(group, e, positions_mm);
    }
}

void CollapseStiffness::find_least_energies() {
    least_nj_.resize(body_.groups.size());
    for (std::size_t g = 0; g < body_.groups.size(); ++g)
        if (plan_.groups[g].in_factors)
            for (const auto& rest : body_.groups[g].tetrahedra)
                least_nj_[g].push_back(least_energy_of_mu * rest.mu * rest.volume);
}

// With F = u diag(s) v^T and G = u^T dF v, the two components of dz are G_11 + G_22 and G_12 -
// G_21.
void CollapseStiffness::add_if_collapsed(const ElementGroup& group, int element,
                                         std::span<const Vec3> positions_mm) {
    Collapsed found{group.connectivity.data() + std::ptrdiff_t{4} * element, {}, {}};
    const auto& rest = group.tetrahedra[element];
    std::array<Vec3, 4> gradient;
    gradient[0].setZero();
    for (int a = 1; a < 4; ++a) {
        gradient[a] =
            Vec3(rest.gradient[a - 1][0], rest.gradient[a - 1][1], rest.gradient[a - 1][2]);
        gradient[0] -= gradient[a];
    }
    small::Matrix3<double> f = small::zero_matrix<double>();
    for (int a = 1; a < 4; ++a) {
        const Vec3 arm = positions_mm[found.nodes[a]] - positions_mm[found.nodes[0]];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) f(i, j) += arm[i] * gradient[a][j];
    }
    const small::SignedSvd<double> svd = small::signed_svd(f);
    const double cone = rest.lambda * (svd.sigma[0] - 3.0) - 2.0 * rest.mu;
    if (!(cone > 0.0) || !std::isfinite(cone)) return;
    const double z = std::max(svd.sigma[1] + svd.sigma[2], least_z);
    const double widening = std::sqrt(rest.volume * cone / z);
    const double turning = std::sqrt(rest.volume * (cone / z + rest.mu + rest.lambda));
    const Vec3 u1 = column(svd.u, 1), u2 = column(svd.u, 2);
    const Vec3 v1 = column(svd.v, 1), v2 = column(svd.v, 2);
    for (int a = 0; a < 4; ++a) {
        const double along1 = v1.dot(gradient[a]), along2 = v2.dot(gradient[a]);
        found.widens[a] = widening * (along1 * u1 + along2 * u2);
        found.turns[a] = turning * (along2 * u1 - along1 * u2);
    }
    collapsed_.push_back(found);
}

void CollapseStiffness::add_to(BlockMatrix& matrix, double factor) const {
    for (const Collapsed& c : collapsed_)
        for (int a = 0; a < 4; ++a) {
            const int i = c.nodes[a];
            if (live_.held()[i] != 0) continue;
            for (int b = 0; b < 4; ++b) {
                const int j = c.nodes[b];
                if (live_.held()[j] != 0) continue;
                matrix.block[i == j ? matrix.diagonal[i] : matrix.find(i, j)] +=
                    factor *
                    (c.widens[a] * c.widens[b].transpose() + c.turns[a] * c.turns[b].transpose());
            }
        }
}

void CollapseStiffness::add_product(std::span<const Vec3> d, double factor,
                                    std::span<Vec3> product) const {
    for (const Collapsed& c : collapsed_) {
        double widens = 0.0, turns = 0.0;
        for (int a = 0; a < 4; ++a) {
            widens += c.widens[a].dot(d[c.nodes[a]]);
            turns += c.turns[a].dot(d[c.nodes[a]]);
        }
        for (int a = 0; a < 4; ++a)
            product[c.nodes[a]] += factor * (widens * c.widens[a] + turns * c.turns[a]);
    }
}

}  // namespace hepatica
