// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/tension_stiffness.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

// Of twice the shear modulus: below it an element counts as slack. In a pull by a hand that leaves
// a few hundred elements of forty thousand.
constexpr double least_tautness = 0.01;
constexpr std::size_t packs_at_once = 32, rows_at_once = 64;
constexpr int lanes = LiveSet::elements_per_pack;

}  // namespace

TensionStiffness::TensionStiffness(const Body& body, const AssemblyPlan& plan, const LiveSet& live)
    : body_(body), plan_(plan), live_(live), of_element_(body.groups.size()) {
    volume_mm3_.assign(body.node_count(), 0.0);
    mean_pull_pa_.assign(body.node_count(), 0.0);
    pull_.assign(plan.force_slots, 0.0);
    at_slot_.assign(plan.force_slots, 0.0);
    for (std::size_t g = 0; g < body.groups.size(); ++g) {
        if (!plan.groups[g].in_factors) continue;
        const ElementGroup& group = body.groups[g];
        of_element_[g].assign(group.size(), 0.0);
        for (int e = 0; e < group.size(); ++e)
            for (int a = 0; a < 4; ++a)
                volume_mm3_[group.connectivity[4 * e + a]] += group.tetrahedra[e].volume;
    }
}

template <class Visit>
void TensionStiffness::for_each_live_element(std::size_t group, const Visit& visit) const {
    const int size = body_.groups[group].size();
    const auto packs = live_.packs(group);
    parallel_blocks(packs.size(), packs_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
            for (int e = packs[p] * lanes; e < std::min((packs[p] + 1) * lanes, size); ++e)
                visit(e);
    });
}

// By the virial of the element's forces, which is minus the volume times the trace of the stress.
double TensionStiffness::pull(const ElementSlots& slots, std::span<const Vec3> positions_mm,
                              std::size_t group, int element) const {
    const int* nodes = body_.groups[group].connectivity.data() + std::ptrdiff_t{4} * element;
    const ElementSlots::Wide* force = slots.force() + plan_.force_slot(group, element, 4);
    double sum = 0.0;
    for (int a = 1; a < 4; ++a) {
        const Vec3 arm = positions_mm[nodes[a]] - positions_mm[nodes[0]];
        sum -= force[a][0] * arm[0] + force[a][1] * arm[1] + force[a][2] * arm[2];
    }
    return 0.5 * sum;
}

// Held nodes are left out: elements around them need not be live.
double TensionStiffness::tautness(std::size_t group, int element) const {
    const int* nodes = body_.groups[group].connectivity.data() + std::ptrdiff_t{4} * element;
    double sum = 0.0;
    int free = 0;
    for (int a = 0; a < 4; ++a) {
        if (live_.held()[nodes[a]] != 0) continue;
        sum += mean_pull_pa_[nodes[a]];
        ++free;
    }
    if (free == 0) return 0.0;
    const double share = sum / (free * 2.0 * body_.groups[group].tetrahedra[element].mu);
    return share > least_tautness ? share : 0.0;
}

void TensionStiffness::find(const ElementSlots& slots, std::span<const Vec3> positions_mm) {
    for (std::size_t g = 0; g < of_element_.size(); ++g) {
        if (of_element_[g].empty()) continue;
        for_each_live_element(g, [&](int e) {
            double* target = pull_.data() + plan_.force_slot(g, e, 4);
            std::fill(target, target + 4, pull(slots, positions_mm, g, e));
        });
    }
    const auto rows = live_.rows();
    parallel_blocks(rows.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const int i = rows[r];
            if (live_.held()[i] != 0 || !(volume_mm3_[i] > 0.0)) continue;
            double sum = 0.0;
            for (int k = plan_.forces.begin[i]; k < plan_.forces.begin[i + 1]; ++k)
                sum += pull_[plan_.forces.place[k]];
            mean_pull_pa_[i] = sum / volume_mm3_[i];
        }
    });
    for (std::size_t g = 0; g < of_element_.size(); ++g)
        if (!of_element_[g].empty())
            for_each_live_element(g, [&](int e) { of_element_[g][e] = tautness(g, e); });
    list_taut();
}

void TensionStiffness::list_taut() {
    for (const int slot : taut_slots_) at_slot_[slot] = 0.0;
    taut_slots_.clear();
    rows_.clear();
    for (std::size_t g = 0; g < of_element_.size(); ++g) {
        if (of_element_[g].empty()) continue;
        const ElementGroup& group = body_.groups[g];
        for (const int pack : live_.packs(g))
            for (int e = pack * lanes; e < std::min((pack + 1) * lanes, group.size()); ++e) {
                if (of_element_[g][e] == 0.0) continue;
                for (int a = 0; a < 4; ++a) {
                    taut_slots_.push_back(plan_.force_slot(g, e, 4) + a);
                    at_slot_[taut_slots_.back()] = of_element_[g][e];
                    rows_.push_back(group.connectivity[4 * e + a]);
                }
            }
    }
    std::ranges::sort(rows_);
    rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
    row_begin_.assign(1, 0);
    for (const int i : rows_)
        row_begin_.push_back(row_begin_.back() + plan_.row_begin[i + 1] - plan_.row_begin[i]);
    block_.resize(row_begin_.back());
}

// With S of evaluate_turned_gradients: the sum of t (trace(S) I - S), t being the tautness.
Mat3 TensionStiffness::upper_block(const ElementSlots& slots, int k) const {
    Mat3 sum = Mat3::Zero();
    for (int s = plan_.factors.begin[k]; s < plan_.factors.begin[k + 1]; s += 2) {
        const double share = at_slot_[plan_.factors.place[s]];
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
