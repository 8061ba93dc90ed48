// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/tension_stiffness.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

// In units of twice the shear modulus: below it an element counts as slack. In a pull by hand this
// leaves a few hundred elements of forty thousand.
constexpr double least_tautness = 0.01;
constexpr std::size_t packs_at_once = 256, rows_at_once = 64;
constexpr int lanes = LiveSet::elements_per_pack;

}  // namespace

TensionStiffness::TensionStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live)
    : body_(body), plan_(plan), live_(live), twice_mu_pa_(body.groups.size()) {
    const auto nodes = static_cast<std::size_t>(body.node_count());
    mean_pull_pa_.assign(nodes, 0.0);
    taut_node_.assign(nodes, 0);
    tautness_.assign(plan.force_slots, 0.0);
    volume_mm3_.assign(nodes, 0.0);
    std::vector<int> element_of_slot(plan.force_slots, -1), group_of_slot(plan.force_slots);
    for (std::size_t g = 0; g < body.groups.size(); ++g) {
        if (!plan.groups[g].in_factors) continue;
        const ElementGroup& group = body.groups[g];
        for (int e = 0; e < group.size(); ++e) {
            const auto& rest = group.tetrahedra[e];
            twice_mu_pa_[g].push_back(2.0 * rest.mu);
            for (int a = 0; a < 4; ++a) {
                volume_mm3_[group.connectivity[4 * e + a]] += rest.volume;
                element_of_slot[plan.force_slot(g, e, 4) + a] = e;
                group_of_slot[plan.force_slot(g, e, 4) + a] = static_cast<int>(g);
            }
        }
    }
    for (std::size_t i = 0; i < nodes; ++i) {
        for (int k = plan.forces.begin[i]; k < plan.forces.begin[i + 1]; ++k)
            if (const int slot = plan.forces.place[k]; element_of_slot[slot] >= 0)
                at_node_.push_back({group_of_slot[slot], element_of_slot[slot]});
        node_begin_.push_back(at_node_.size());
    }
}

// Held nodes are left out, because elements around them need not be live.
double TensionStiffness::tautness(std::size_t group, int element) const {
    const int* nodes = body_.groups[group].connectivity.data() + std::ptrdiff_t{4} * element;
    double sum = 0.0;
    int free = 0;
    for (int a = 0; a < 4; ++a) {
        if (live_.held()[nodes[a]] != 0) continue;
        sum += mean_pull_pa_[nodes[a]];
        ++free;
    }
    if (!(sum > 0.0)) return 0.0;
    const double share = sum / (free * twice_mu_pa_[group][element]);
    return share > least_tautness ? share : 0.0;
}

void TensionStiffness::find_mean_pulls(const ElementSlots& slots) {
    const auto rows = live_.rows();
    parallel_blocks(rows.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const int i = rows[r];
            if (live_.held()[i] != 0 || !(volume_mm3_[i] > 0.0)) continue;
            double sum = 0.0;
            for (std::size_t k = node_begin_[i]; k < node_begin_[i + 1]; ++k)
                sum += slots.pulls(at_node_[k].group)[at_node_[k].element];
            mean_pull_pa_[i] = sum / volume_mm3_[i];
        }
    });
}

// The taut elements of one group, by blocks of packs, in ascending order within a block.
std::vector<std::vector<TensionStiffness::Taut>> TensionStiffness::taut_of(
    std::size_t group) const {
    const int size = body_.groups[group].size();
    const auto packs = live_.packs(group);
    std::vector<std::vector<Taut>> found((packs.size() + packs_at_once - 1) / packs_at_once);
    parallel_blocks(packs.size(), packs_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
            for (int e = packs[p] * lanes; e < std::min((packs[p] + 1) * lanes, size); ++e)
                if (const double share = tautness(group, e); share > 0.0)
                    found[begin / packs_at_once].push_back({e, share});
    });
    return found;
}

void TensionStiffness::find(const ElementSlots& slots) {
    for (const int slot : taut_slots_) tautness_[slot] = 0.0;
    for (const int i : rows_) taut_node_[i] = 0;
    taut_slots_.clear();
    rows_.clear();
    find_mean_pulls(slots);
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        if (!plan_.groups[g].in_factors) continue;
        for (const std::vector<Taut>& block : taut_of(g))
            for (const auto& [element, share] : block)
                for (int a = 0; a < 4; ++a) {
                    taut_slots_.push_back(plan_.force_slot(g, element, 4) + a);
                    tautness_[taut_slots_.back()] = share;
                    taut_node_[body_.groups[g].connectivity[4 * element + a]] = 1;
                }
    }
    for (const int i : live_.rows())
        if (taut_node_[i] != 0) rows_.push_back(i);
    row_begin_.assign(1, 0);
    for (const int i : rows_)
        row_begin_.push_back(row_begin_.back() + plan_.row_begin[i + 1] - plan_.row_begin[i]);
    block_.resize(row_begin_.back());
}

// The sum of t (trace(S) I - S), with S of evaluate_turned_gradients and t the tautness.
Mat3 TensionStiffness::upper_block(const ElementSlots& slots, int k) const {
    Mat3 sum = Mat3::Zero();
    for (int s = plan_.factors.begin[k]; s < plan_.factors.begin[k + 1]; s += 2) {
        const double share = tautness_[plan_.factors.place[s]];
        if (share == 0.0) continue;
        const auto &a = slots.turned_gradient()[plan_.factors.place[s]],
                   &b = slots.turned_gradient()[plan_.factors.place[s + 1]];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) sum(i, j) += share * b[i] * a[j];
    }
    return sum.trace() * Mat3::Identity() - sum;
}

void TensionStiffness::make(const ElementSlots& slots, double factor) {
    parallel_blocks(rows_.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const int first = plan_.row_begin[rows_[r]], last = plan_.row_begin[rows_[r] + 1];
            const int diagonal = plan_.diagonal[rows_[r]];
            Mat3* row = block_.data() + row_begin_[r];
            Mat3 sum = Mat3::Zero();
            for (int k = first; k < last; ++k) {
                if (k == diagonal) continue;
                row[k - first] =
                    k > diagonal ? Mat3(factor * upper_block(slots, k))
                                 : Mat3(factor * upper_block(slots, plan_.mirror[k]).transpose());
                sum += row[k - first];
            }
            row[diagonal - first] = -0.5 * (sum + sum.transpose());
        }
    });
}

void TensionStiffness::add_to(BlockMatrix& matrix, double share) const {
    parallel_blocks(rows_.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            if (live_.held()[rows_[r]] != 0) continue;
            const int first = plan_.row_begin[rows_[r]], last = plan_.row_begin[rows_[r] + 1];
            for (int k = first; k < last; ++k)
                if (live_.held()[plan_.column[k]] == 0)
                    matrix.block[k] += share * block_[row_begin_[r] + (k - first)];
        }
    });
}

void TensionStiffness::subtract_product(std::span<const Vec3> d, std::span<Vec3> product) const {
    parallel_blocks(rows_.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            if (live_.held()[rows_[r]] != 0) continue;
            const int first = plan_.row_begin[rows_[r]], last = plan_.row_begin[rows_[r] + 1];
            Vec3 sum = Vec3::Zero();
            for (int k = first; k < last; ++k)
                sum += block_[row_begin_[r] + (k - first)] * d[plan_.column[k]];
            product[rows_[r]] -= sum;
        }
    });
}

}  // namespace hepatica
