// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/element_slots.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/elements/element_dispatch.h"

namespace hepatica {
namespace {

constexpr std::size_t packs_per_block = 32;

using small::Tangent;

bool in_lanes(const Body& body, const ElementGroup& group, Tangent tangent) {
    using Kind = ElementGroup::Kind;
    return body.model == ElementModel::corotated && tangent != Tangent::projected &&
           (group.kind == Kind::linear_tetrahedron || group.kind == Kind::quadratic_tetrahedron);
}

template <class Wide>
small::TetrahedronRest<Wide> gather_rest(const std::vector<small::TetrahedronRest<double>>& rest,
                                         std::size_t first) {
    small::TetrahedronRest<Wide> wide;
    for (int lane = 0; lane < Wide::count; ++lane) {
        const auto& own = rest[std::min(first + static_cast<std::size_t>(lane), rest.size() - 1)];
        for (int a = 0; a < 3; ++a)
            for (int i = 0; i < 3; ++i) wide.gradient[a][i].set(lane, own.gradient[a][i]);
        wide.volume.set(lane, own.volume);
        wide.lambda.set(lane, own.lambda);
        wide.mu.set(lane, own.mu);
    }
    return wide;
}

// Energy of one element per lane, added up in order.
template <class Wide>
double sum_of(const Wide& energy, int count) {
    double sum = 0.0;
    for (int lane = 0; lane < count; ++lane) sum += energy[lane];
    return sum;
}

}  // namespace

ElementSlots::ElementSlots(const Body& body) : body_(body) {
    std::size_t forces = 0, blocks = 0;
    for (const ElementGroup& group : body.groups) {
        Group own{static_cast<int>(forces), static_cast<int>(blocks), {}};
        const std::size_t packs = static_cast<std::size_t>((group.size() + lanes - 1) / lanes);
        for (std::size_t p = 0; in_lanes(body, group, Tangent::none) && p < packs; ++p)
            own.tetrahedra.push_back(gather_rest<Wide>(group.tetrahedra, p * lanes));
        forces += packs * static_cast<std::size_t>(group.nodes_per_element);
        blocks += packs * static_cast<std::size_t>(group.pairs());
        groups_.push_back(std::move(own));
    }
    if (blocks > static_cast<std::size_t>(std::numeric_limits<int>::max() / lanes))
        throw InputError("the body has too many elements", "elements", "Use a coarser mesh");
    force_.resize(forces);
    block_.resize(blocks);
}

int ElementSlots::force_slot(std::size_t g, int e, int a) const {
    const int n = body_.groups[g].nodes_per_element;
    return (groups_[g].first_force + e / lanes * n + a) * lanes + e % lanes;
}

int ElementSlots::block_slot(std::size_t g, int e, int pair) const {
    const int pairs = body_.groups[g].pairs();
    return (groups_[g].first_block + e / lanes * pairs + pair) * lanes + e % lanes;
}

template <class Visit>
double ElementSlots::sum_over_packs(const Visit& visit) const {
    double total = 0.0;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        const std::size_t packs = static_cast<std::size_t>((group.size() + lanes - 1) / lanes);
        total += parallel_sum(packs, packs_per_block, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t p = begin; p < end; ++p) {
                const int first = static_cast<int>(p) * lanes;
                sum += visit(g, Pack{&group, first, std::min(lanes, group.size() - first)});
            }
            return sum;
        });
    }
    return total;
}

// Values at the nodes of each lane's element, relative to its first.
void ElementSlots::load(const Pack& pack, std::span<const Vec3> values, small::Vector3<Wide>* x) {
    const int* nodes[lanes];
    for (int lane = 0; lane < lanes; ++lane) nodes[lane] = pack.nodes(lane);
    const auto at = [&](int a, int i) {
        return Wide(Wide::Vector{values[nodes[0][a]][i], values[nodes[1][a]][i],
                                 values[nodes[2][a]][i], values[nodes[3][a]][i]});
    };
    const small::Vector3<Wide> origin{{at(0, 0), at(0, 1), at(0, 2)}};
    x[0] = origin - origin;
    for (int a = 1; a < pack.group->nodes_per_element; ++a)
        x[a] = small::Vector3<Wide>{{at(a, 0), at(a, 1), at(a, 2)}} - origin;
}

template <Tangent tangent>
double ElementSlots::evaluate_pack(std::size_t g, const Pack& pack,
                                   std::span<const Vec3> positions_mm) {
    const int n = pack.group->nodes_per_element, p = pack.first / lanes;
    const auto& rest = groups_[g].tetrahedra[static_cast<std::size_t>(p)];
    small::Vector3<Wide>* force = force_.data() + groups_[g].first_force + p * n;
    small::Matrix3<Wide>* blocks = block_.data() + groups_[g].first_block + p * pack.group->pairs();
    small::Vector3<Wide> x[10];
    load(pack, positions_mm, x);
    const Wide energy =
        n == 4
            ? small::evaluate_tetrahedron<4, tangent, small::CorotatedLaw>(rest, x, force, blocks)
            : small::evaluate_tetrahedron<10, tangent, small::CorotatedLaw>(rest, x, force, blocks);
    return sum_of(energy, pack.count);
}

template <Tangent tangent>
double ElementSlots::evaluate_singly(std::size_t g, const Pack& pack,
                                     std::span<const Vec3> positions_mm) {
    const int n = pack.group->nodes_per_element, pairs = pack.group->pairs();
    const int p = pack.first / lanes;
    double sum = 0.0;
    small::Vector3<double> force[10];
    small::Matrix3<double> blocks[45];
    for (int lane = 0; lane < pack.count; ++lane) {
        sum += evaluate_element<tangent>(*pack.group, body_.model, pack.first + lane, positions_mm,
                                         force, blocks);
        for (int a = 0; a < n; ++a)
            for (int i = 0; i < 3; ++i)
                force_[groups_[g].first_force + p * n + a][i].set(lane, force[a][i]);
        for (int k = 0; tangent != Tangent::none && k < pairs; ++k)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    block_[groups_[g].first_block + p * pairs + k](i, j).set(lane, blocks[k](i, j));
    }
    return sum;
}

double ElementSlots::evaluate(std::span<const Vec3> positions_mm, Tangent tangent) {
    return sum_over_packs([&](std::size_t g, const Pack& pack) {
        if (in_lanes(body_, *pack.group, tangent))
            return tangent == Tangent::none
                       ? evaluate_pack<Tangent::none>(g, pack, positions_mm)
                       : evaluate_pack<Tangent::rotated>(g, pack, positions_mm);
        switch (tangent) {
            case Tangent::none:
                return evaluate_singly<Tangent::none>(g, pack, positions_mm);
            case Tangent::rotated:
                return evaluate_singly<Tangent::rotated>(g, pack, positions_mm);
            default:
                return evaluate_singly<Tangent::projected>(g, pack, positions_mm);
        }
    });
}

double ElementSlots::energy(std::span<const Vec3> positions_mm) const {
    return sum_over_packs([&](std::size_t, const Pack& pack) {
        double sum = 0.0;
        for (int lane = 0; lane < pack.count; ++lane)
            sum += evaluate_element<Tangent::none>(
                *pack.group, body_.model, pack.first + lane, positions_mm,
                static_cast<small::Vector3<double>*>(nullptr), nullptr);
        return sum;
    });
}

double ElementSlots::quadratic_form(std::span<const Vec3> d) const {
    return sum_over_packs([&](std::size_t g, const Pack& pack) {
        const int n = pack.group->nodes_per_element;
        const small::Matrix3<Wide>* block =
            block_.data() + groups_[g].first_block + pack.first / lanes * pack.group->pairs();
        small::Vector3<Wide> u[10];  // relative to the first node
        load(pack, d, u);
        // Of the first node's blocks only the share of the others' diagonal blocks remains.
        Wide sum = 0.0;
        for (int b = 1; b < n; ++b, ++block) sum -= small::dot(u[b], *block * u[b]);
        for (int a = 1; a < n; ++a)
            for (int b = a + 1; b < n; ++b, ++block)
                sum += small::dot(Wide(2.0) * u[a] - u[b], *block * u[b]) -
                       small::dot(u[a], *block * u[a]);
        return sum_of(sum, pack.count);
    });
}

}  // namespace hepatica
