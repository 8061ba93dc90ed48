// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/element_slots.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/base/large_vector.h"
#include "core/base/parallel.h"
#include "core/deform/body/element_dispatch.h"
#include "core/tear/joint.h"

namespace hepatica {
namespace {

constexpr int lanes = ElementSlots::Wide::count;
static_assert(lanes == LiveSet::elements_per_pack);
constexpr std::size_t packs_per_block = 32;

using Kind = ElementGroup::Kind;
using Wide = ElementSlots::Wide;
using small::Tangent;

small::TetrahedronRest<Wide> gather_rest(const std::vector<small::TetrahedronRest<double>>& rest,
                                         std::size_t first) {
    small::TetrahedronRest<Wide> wide;
    for (int lane = 0; lane < lanes; ++lane) {
        const auto& own = rest[std::min(first + static_cast<std::size_t>(lane), rest.size() - 1)];
        for (int a = 0; a < 3; ++a)
            for (int i = 0; i < 3; ++i) wide.gradient[a][i].set(lane, own.gradient[a][i]);
        wide.volume.set(lane, own.volume);
        wide.lambda.set(lane, own.lambda);
        wide.mu.set(lane, own.mu);
    }
    return wide;
}

std::size_t packs_of(const ElementGroup& group) {
    return static_cast<std::size_t>((group.size() + lanes - 1) / lanes);
}

// Sum of the first `count` lanes, in order.
double sum_of(const Wide& values, int count) {
    double sum = 0.0;
    for (int lane = 0; lane < count; ++lane) sum += values[lane];
    return sum;
}

}  // namespace

ElementSlots::ElementSlots(const Body& body, Tangent tangent,
                           std::shared_ptr<const AssemblyPlan> plan, const LiveSet* live)
    : body_(body), tangent_(tangent), plan_(std::move(plan)), live_(live) {
    bool factors = false;
    for (std::size_t g = 0; g < body.groups.size(); ++g) {
        const ElementGroup& group = body.groups[g];
        const GroupSlots& slots = plan_->groups[g];
        auto& rest = rest_of_four_.emplace_back();
        if (slots.four_at_a_time) reserve_large(rest, packs_of(group));
        for (std::size_t p = 0; slots.four_at_a_time && p < packs_of(group); ++p)
            rest.push_back(gather_rest(group.tetrahedra, p * lanes));
        energy_.emplace_back(group.size(), 0.0);
        pull_.emplace_back(slots.in_factors ? group.size() : 0, 0.0);
        factors = factors || slots.in_factors;
    }
    reserve_large(force_, plan_->force_slots);
    force_.assign(plan_->force_slots, Wide(0.0));
    if (factors) {
        reserve_large(turned_gradient_, plan_->force_slots);
        turned_gradient_.assign(plan_->force_slots, Wide(0.0));
    }
    block_.resize(plan_->block_slots);
}

int ElementSlots::force_slot(const Pack& pack) const {
    return plan_->force_slot(pack.group, pack.first, body_.groups[pack.group].nodes_per_element);
}

int ElementSlots::block_slot(std::size_t group, int element) const {
    return plan_->block_slot(group, element, body_.groups[group].pairs());
}

template <class Visit>
double ElementSlots::sum_over_packs(const LiveSet* live, const Visit& visit) const {
    double total = 0.0;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const int size = body_.groups[g].size();
        const std::size_t count =
            live != nullptr ? live->packs(g).size() : packs_of(body_.groups[g]);
        total += parallel_sum(count, packs_per_block, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t p = begin; p < end; ++p) {
                const int pack = live != nullptr ? live->packs(g)[p] : static_cast<int>(p);
                const int first = pack * lanes;
                sum += visit(Pack{g, first, std::min(lanes, size - first)});
            }
            return sum;
        });
    }
    return total;
}

double ElementSlots::kept_energy() const {
    double total = 0.0;
    for (const std::vector<double>& energy : energy_)
        total += parallel_sum(
            energy.size(), lanes * packs_per_block, [&](std::size_t begin, std::size_t end) {
                return std::accumulate(energy.begin() + begin, energy.begin() + end, 0.0);
            });
    return total;
}

const int* ElementSlots::nodes(const Pack& pack, int lane) const {
    const ElementGroup& group = body_.groups[pack.group];
    const int e = pack.first + std::min(lane, pack.count - 1);
    return group.connectivity.data() + static_cast<std::ptrdiff_t>(e) * group.nodes_per_element;
}

// Values at the nodes of each lane's element, relative to its first node, so that no digits are
// lost far from the origin.
void ElementSlots::load(const Pack& pack, std::span<const Vec3> values,
                        small::Vector3<Wide>* x) const {
    const int *n0 = nodes(pack, 0), *n1 = nodes(pack, 1), *n2 = nodes(pack, 2),
              *n3 = nodes(pack, 3);
    const auto at = [&](int a) {
        const Vec3 &p = values[n0[a]], &q = values[n1[a]], &r = values[n2[a]], &s = values[n3[a]];
        return small::Vector3<Wide>{{Wide::Vector{p[0], q[0], r[0], s[0]},
                                     Wide::Vector{p[1], q[1], r[1], s[1]},
                                     Wide::Vector{p[2], q[2], r[2], s[2]}}};
    };
    const small::Vector3<Wide> origin = at(0);
    for (int a = 0; a < body_.groups[pack.group].nodes_per_element; ++a) x[a] = at(a) - origin;
}

void ElementSlots::store(const Pack& pack, const small::Vector3<Wide>* values,
                         std::vector<Wide>& slots) {
    const int n = body_.groups[pack.group].nodes_per_element;
    Wide* target = slots.data() + force_slot(pack);
    for (int lane = 0; lane < pack.count; ++lane)
        for (int a = 0; a < n; ++a)
            target[lane * n + a] =
                Wide::Vector{values[a][0][lane], values[a][1][lane], values[a][2][lane], 0.0};
}

void ElementSlots::keep(const Pack& pack, const Wide& energy) {
    for (int lane = 0; lane < pack.count; ++lane)
        energy_[pack.group][pack.first + lane] = energy[lane];
}

// x is relative to the first node.
void ElementSlots::keep_pull(const Pack& pack, const small::Vector3<Wide>* x,
                             const small::Vector3<Wide>* force) {
    Wide sum(0.0);
    for (int a = 1; a < 4; ++a) sum -= small::dot(force[a], x[a]);
    for (int lane = 0; lane < pack.count; ++lane)
        pull_[pack.group][pack.first + lane] = 0.5 * sum[lane];
}

void ElementSlots::evaluate_factors(const Pack& pack, std::span<const Vec3> positions_mm) {
    small::Vector3<Wide> x[4], force[4], turned[4];
    load(pack, positions_mm, x);
    const auto& rest = rest_of_four_[pack.group][static_cast<std::size_t>(pack.first / lanes)];
    const Wide energy = small::evaluate_turned_gradients(rest, x, force, turned);
    store(pack, force, force_);
    store(pack, turned, turned_gradient_);
    keep(pack, energy);
    keep_pull(pack, x, force);
}

void ElementSlots::evaluate_lanes(const Pack& pack, std::span<const Vec3> positions_mm) {
    small::Vector3<Wide> x[10], force[10];
    small::Matrix3<Wide> blocks[45];
    load(pack, positions_mm, x);
    const auto& rest = rest_of_four_[pack.group][static_cast<std::size_t>(pack.first / lanes)];
    const bool linear = body_.groups[pack.group].kind == Kind::linear_tetrahedron;
    const Wide energy =
        linear ? small::evaluate_tetrahedron<4, Tangent::rotated, small::CorotatedLaw>(
                     rest, x, force, blocks)
               : small::evaluate_tetrahedron<10, Tangent::rotated, small::CorotatedLaw>(
                     rest, x, force, blocks);
    store(pack, force, force_);
    for (int lane = 0; lane < pack.count; ++lane) {
        small::Matrix3<double>* target = block_.data() + block_slot(pack.group, pack.first + lane);
        for (int k = 0; k < body_.groups[pack.group].pairs(); ++k)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) target[k](i, j) = blocks[k](i, j)[lane];
    }
    keep(pack, energy);
}

template <Tangent tangent>
void ElementSlots::evaluate_singly(const Pack& pack, std::span<const Vec3> positions_mm) {
    for (int e = pack.first; e < pack.first + pack.count; ++e) {
        small::Vector3<double> force[10];
        energy_[pack.group][e] = evaluate_element<tangent>(
            body_.groups[pack.group], body_.model, e, positions_mm, force,
            tangent == Tangent::none ? nullptr : block_.data() + block_slot(pack.group, e));
        const int n = body_.groups[pack.group].nodes_per_element;
        Wide* target = force_.data() + force_slot(pack) + (e - pack.first) * n;
        for (int a = 0; a < n; ++a)
            target[a] = Wide::Vector{force[a][0], force[a][1], force[a][2], 0.0};
    }
}

double ElementSlots::evaluate(std::span<const Vec3> positions_mm) {
    sum_over_packs(live_, [&](const Pack& pack) {
        if (plan_->groups[pack.group].in_factors)
            evaluate_factors(pack, positions_mm);
        else if (four_at_a_time(pack))
            evaluate_lanes(pack, positions_mm);
        else if (tangent_ == Tangent::rotated)
            evaluate_singly<Tangent::rotated>(pack, positions_mm);
        else
            evaluate_singly<Tangent::projected>(pack, positions_mm);
        return 0.0;
    });
    return kept_energy();
}

// Energies of four elements, and their forces where `force` is not null.
Wide ElementSlots::forces_of_four(const Pack& pack, const small::Vector3<Wide>* x,
                                  small::Vector3<Wide>* force) const {
    const auto& rest = rest_of_four_[pack.group][static_cast<std::size_t>(pack.first / lanes)];
    small::Matrix3<Wide>* no_blocks = nullptr;
    if (body_.groups[pack.group].kind == Kind::linear_tetrahedron)
        return small::evaluate_tetrahedron<4, Tangent::none, small::CorotatedLaw>(rest, x, force,
                                                                                  no_blocks);
    return small::evaluate_tetrahedron<10, Tangent::none, small::CorotatedLaw>(rest, x, force,
                                                                               no_blocks);
}

void ElementSlots::find_forces(const LiveSet* live, std::span<const Vec3> positions_mm) {
    sum_over_packs(live, [&](const Pack& pack) {
        if (!four_at_a_time(pack)) {
            evaluate_singly<Tangent::none>(pack, positions_mm);
            return 0.0;
        }
        small::Vector3<Wide> x[10], force[10];
        load(pack, positions_mm, x);
        const Wide energy = forces_of_four(pack, x, force);
        store(pack, force, force_);
        keep(pack, energy);
        if (plan_->groups[pack.group].in_factors) keep_pull(pack, x, force);
        return 0.0;
    });
}

double ElementSlots::evaluate_forces(std::span<const Vec3> positions_mm) {
    find_forces(live_, positions_mm);
    return kept_energy();
}

double ElementSlots::evaluate_all_forces(std::span<const Vec3> positions_mm) {
    find_forces(nullptr, positions_mm);
    return kept_energy();
}

void ElementSlots::find_stress(std::vector<Mat3>& stress_pa, std::vector<double>& energy_nj) const {
    const ElementGroup& group = body_.groups.front();
    const bool first = stress_pa.empty();
    stress_pa.resize(group.size());
    energy_nj = energy_.front();
    const bool springs = group.kind == Kind::spring;
    sum_over_packs(first ? nullptr : live_, [&](const Pack& pack) {
        const Wide* own = force_.data() + force_slot(pack);
        std::array<small::Vector3<Wide>, 4> force, rest;
        load(pack, body_.rest_positions_mm, rest.data());
        Wide volume;
        for (int lane = 0; lane < lanes; ++lane) {
            const int in_pack = std::min(lane, pack.count - 1), e = pack.first + in_pack;
            volume.set(lane, springs ? group.springs[e].volume : group.tetrahedra[e].volume);
            for (int a = 1; a < 4; ++a)
                for (int i = 0; i < 3; ++i) force[a][i].set(lane, own[4 * in_pack + a][i]);
        }
        const small::Matrix3<Wide> stress = stress_of(force, rest, volume);
        for (int lane = 0; lane < pack.count; ++lane)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) stress_pa[pack.first + lane](i, j) = stress(i, j)[lane];
        return 0.0;
    });
}

double ElementSlots::energy(std::span<const Vec3> positions_mm) const {
    return sum_over_packs(nullptr, [&](const Pack& pack) {
        if (four_at_a_time(pack)) {
            small::Vector3<Wide> x[10];
            load(pack, positions_mm, x);
            return sum_of(forces_of_four(pack, x, nullptr), pack.count);
        }
        double sum = 0.0;
        for (int e = pack.first; e < pack.first + pack.count; ++e)
            sum += evaluate_element<Tangent::none>(
                body_.groups[pack.group], body_.model, e, positions_mm,
                static_cast<small::Vector3<double>*>(nullptr), nullptr);
        return sum;
    });
}

void ElementSlots::add_energy_by_piece(std::span<const int> piece_of_node,
                                       std::span<double> energy_nj) const {
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        for (int e = 0; e < group.size(); ++e)
            energy_nj[piece_of_node[group.connectivity[e * group.nodes_per_element]]] +=
                energy_[g][e];
    }
}

double ElementSlots::factored_form(const Pack& pack, std::span<const Vec3> d) const {
    small::Vector3<Wide> u[4], turned[4];
    load(pack, d, u);
    const Wide* slots = turned_gradient_.data() + force_slot(pack);
    for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
            for (int lane = 0; lane < lanes; ++lane)
                turned[a][i].set(lane, slots[4 * std::min(lane, pack.count - 1) + a][i]);
    return sum_of(small::quadratic_form(turned, Wide(plan_->lambda_over_mu), u), pack.count);
}

double ElementSlots::block_form(const ElementGroup& group, int slot, int e,
                                std::span<const Vec3> d) const {
    const int n = group.nodes_per_element;
    small::Vector3<double> u[10];  // relative to the first node
    load_positions(group.connectivity.data() + static_cast<std::ptrdiff_t>(e) * n, n, d, u);
    const small::Matrix3<double>* block = block_.data() + slot;
    // u[0] = 0, so the blocks of the first node count only as parts of the other diagonal blocks.
    double sum = 0.0;
    for (int b = 1; b < n; ++b, ++block) sum -= small::dot(u[b], *block * u[b]);
    for (int a = 1; a < n; ++a)
        for (int b = a + 1; b < n; ++b, ++block)
            sum += small::dot(2.0 * u[a] - u[b], *block * u[b]) - small::dot(u[a], *block * u[a]);
    return sum;
}

double ElementSlots::quadratic_form(std::span<const Vec3> d) const {
    return sum_over_packs(live_, [&](const Pack& pack) {
        if (plan_->groups[pack.group].in_factors) return factored_form(pack, d);
        double sum = 0.0;
        for (int e = pack.first; e < pack.first + pack.count; ++e)
            sum += block_form(body_.groups[pack.group], block_slot(pack.group, e), e, d);
        return sum;
    });
}

}  // namespace hepatica
