// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the element function for an element group, a model and a tangent. Host only.
#pragma once

#include "core/base/small_matrix_eigen.h"
#include "core/deform/body/body.h"

namespace hepatica {

// Positions of an element's nodes relative to its first node, so that no digits are lost far from
// the origin.
inline void load_positions(const int* nodes, int count, std::span<const Vec3> positions_mm,
                           small::Vector3<double>* x) {
    const Vec3& origin = positions_mm[nodes[0]];
    for (int a = 0; a < count; ++a) x[a] = small::from_eigen(Vec3(positions_mm[nodes[a]] - origin));
}

template <int Nodes, small::Tangent tangent>
double evaluate_elastic(ElementModel model, const small::TetrahedronRest<double>& rest,
                        const small::Vector3<double>* x, small::Vector3<double>* force,
                        small::Matrix3<double>* blocks) {
    if (model == ElementModel::neohookean) {
        constexpr auto projected =
            tangent == small::Tangent::none ? tangent : small::Tangent::projected;
        return small::evaluate_tetrahedron<Nodes, projected, small::NeoHookeanLaw>(rest, x, force,
                                                                                   blocks);
    }
    return small::evaluate_tetrahedron<Nodes, tangent, small::CorotatedLaw>(rest, x, force, blocks);
}

// Energy [nJ] of element e of the group; force and blocks as in evaluate_tetrahedron (may be null).
template <small::Tangent tangent>
double evaluate_element(const ElementGroup& group, ElementModel model, int e,
                        std::span<const Vec3> positions_mm, small::Vector3<double>* force,
                        small::Matrix3<double>* blocks) {
    using Kind = ElementGroup::Kind;
    const int* nodes = group.connectivity.data() + e * group.nodes_per_element;
    small::Vector3<double> x[10];
    load_positions(nodes, group.nodes_per_element, positions_mm, x);
    switch (group.kind) {
        case Kind::spring:
            return small::evaluate_springs(group.springs[e], x, force, blocks);
        case Kind::hexahedron:
            return small::evaluate_hexahedron(group.hexahedra[e], x, force, blocks);
        case Kind::quadratic_tetrahedron:
            return evaluate_elastic<10, tangent>(model, group.tetrahedra[e], x, force, blocks);
        case Kind::linear_tetrahedron:
            break;
    }
    return evaluate_elastic<4, tangent>(model, group.tetrahedra[e], x, force, blocks);
}

}  // namespace hepatica
