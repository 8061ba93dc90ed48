// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/inversion_recovery.h"

#include <algorithm>

#include "core/deform/elements/small_matrix_eigen.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {
namespace {

constexpr double least_gain = 1e-9;  // rounding may not count as less energy

bool is_inverted(const ElementGroup& group, int e, std::span<const Vec3> x) {
    using Kind = ElementGroup::Kind;
    const int* nodes = group.connectivity.data() + e * group.nodes_per_element;
    small::Vector3<double> p[10];
    for (int a = 0; a < group.nodes_per_element; ++a)
        p[a] = small::from_eigen(Vec3(x[nodes[a]] - x[nodes[0]]));
    if (group.kind == Kind::hexahedron) return !(small::least_jacobian(p) > 0.0);
    if (!(signed_volume_mm3(x[nodes[0]], x[nodes[1]], x[nodes[2]], x[nodes[3]]) > 0.0)) return true;
    if (group.kind != Kind::quadratic_tetrahedron) return false;
    for (int q = 0; q < small::detail::point_count<10>; ++q) {
        small::Vector3<double> g[10];
        small::detail::shape_gradients<10>(group.tetrahedra[e], q, g);
        if (!(determinant(small::detail::deformation_gradient<10>(p, g)) > 0.0)) return true;
    }
    return false;
}

// The motion that carries the nodes outside the patch from rest to where they are, at best.
struct RigidMotion {
    Mat3 rotation = Mat3::Identity();
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    Vec3 operator()(const Vec3& rest) const { return to + rotation * (rest - from); }
};

RigidMotion motion_of(const std::vector<int>& nodes, std::span<const Vec3> rest,
                      std::span<const Vec3> now) {
    RigidMotion motion;
    for (const int i : nodes) {
        motion.from += rest[i] / static_cast<double>(nodes.size());
        motion.to += now[i] / static_cast<double>(nodes.size());
    }
    small::Matrix3<double> f = small::zero_matrix<double>();
    double size = 0.0;
    for (const int i : nodes) {
        const Vec3 a = now[i] - motion.to, b = rest[i] - motion.from;
        f = f + small::outer(small::from_eigen(a), small::from_eigen(b));
        size += b.squaredNorm();
    }
    if (size > 0.0) motion.rotation = small::to_eigen(small::nearest_rotation((1.0 / size) * f));
    return motion;
}

}  // namespace

std::vector<int> inverted_elements(const Body& body, std::span<const Vec3> positions_mm) {
    std::vector<int> inverted;
    int first = 0;
    for (const ElementGroup& group : body.groups) {
        for (int e = 0; e < group.size(); ++e)
            if (is_inverted(group, e, positions_mm)) inverted.push_back(first + e);
        first += group.size();
    }
    return inverted;
}

std::vector<char> Unfolding::nodes_of(const std::vector<int>& elements) const {
    std::vector<char> nodes(body_.node_count(), 0);
    auto next = elements.begin();
    int first = 0;
    for (const ElementGroup& group : body_.groups) {
        for (; next != elements.end() && *next < first + group.size(); ++next)
            for (int a = 0; a < group.nodes_per_element; ++a)
                nodes[group.connectivity[(*next - first) * group.nodes_per_element + a]] = 1;
        first += group.size();
    }
    return nodes;
}

// By the nodes that share an element with it.
void Unfolding::grow(std::vector<char>& patch) const {
    const std::vector<char> before = patch;
    for (std::size_t i = 0; i < patch.size(); ++i)
        for (int k = stiffness_.row_begin[i]; before[i] && k < stiffness_.row_begin[i + 1]; ++k)
            patch[stiffness_.column[k]] = 1;
}

// Nodes of the patch where linear elasticity puts them between those outside.
std::vector<Vec3> Unfolding::span_patch(const std::vector<char>& patch,
                                        std::span<const Vec3> positions_mm) const {
    const auto free = [&](int i) { return patch[i] != 0 && body_.fixed[i] == 0; };
    std::vector<int> around, all;
    for (int i = 0; i < body_.node_count(); ++i) {
        all.push_back(i);
        bool touches = false;
        for (int k = stiffness_.row_begin[i]; k < stiffness_.row_begin[i + 1]; ++k)
            touches = touches || free(stiffness_.column[k]);
        if (touches && !free(i)) around.push_back(i);
    }
    const bool held = !around.empty();
    const RigidMotion motion =
        motion_of(held ? around : all, body_.rest_positions_mm, positions_mm);
    std::vector<Vec3> x(positions_mm.begin(), positions_mm.end());
    std::vector<Vec3> rhs(x.size(), Vec3::Zero()), change(x.size(), Vec3::Zero());
    // What the surroundings are off the motion, seen from the frame of rest.
    for (const int i : around)
        change[i] = motion.rotation.transpose() * (x[i] - motion(body_.rest_positions_mm[i]));
    BlockMatrix matrix = stiffness_;
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            if (i == j && !free(i)) matrix.block[k] = Mat3::Identity();
            if (i == j || (free(i) && free(j))) continue;
            if (free(i)) rhs[i] -= matrix.block[k] * change[j];
            matrix.block[k].setZero();
        }
    if (held) {
        const auto solver = make_block_jacobi_solver();
        solver->prepare(matrix, body_.rest_positions_mm);
        std::vector<Vec3> found(x.size(), Vec3::Zero());
        solver->solve(rhs, found, {.energy_tolerance = 1e-3});
        change = std::move(found);
    }
    for (int i = 0; i < body_.node_count(); ++i)
        if (free(i)) x[i] = motion(body_.rest_positions_mm[i]) + motion.rotation * change[i];
    return x;
}

std::optional<std::vector<Vec3>> Unfolding::unfold(std::span<const Vec3> positions_mm,
                                                   const Energy& energy) {
    const std::vector<int> inverted = inverted_elements(body_, positions_mm);
    if (inverted.empty()) return std::nullopt;
    if (stiffness_.column.empty()) {
        Assembly assembly(body_);
        assembly.evaluate(body_.rest_positions_mm);
        assembly.gather_stiffness(1.0, stiffness_);
    }
    const double before = energy(positions_mm);
    std::vector<char> patch = nodes_of(inverted);
    for (int rings = 1;; rings *= 2) {
        std::vector<Vec3> x = span_patch(patch, positions_mm);
        const bool finite = std::ranges::all_of(x, [](const Vec3& p) { return p.allFinite(); });
        if (finite && inverted_elements(body_, x).empty() &&
            energy(x) < before - least_gain * std::abs(before))
            return x;
        const std::vector<char> smaller = patch;
        for (int r = 0; r < rings; ++r) grow(patch);
        if (patch == smaller) return std::nullopt;
    }
}

}  // namespace hepatica
