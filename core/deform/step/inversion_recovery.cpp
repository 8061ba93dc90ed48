// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/inversion_recovery.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "core/base/small_matrix_eigen.h"
#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/step/assembly.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {
namespace {

constexpr double least_gain = 1e-9;  // relative; a smaller decrease of energy may be rounding

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

// The rigid motion from rest that best fits some nodes.
struct RestFit {
    Mat3 rotation = Mat3::Identity();
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    Vec3 operator()(const Vec3& rest) const { return to + rotation * (rest - from); }
};

RestFit motion_of(const std::vector<int>& nodes, const std::vector<Vec3>& rest,
                  const std::vector<Vec3>& now) {
    RestFit motion;
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

// Some elements of a body as a body of their own.
struct Part {
    Body body;
    std::vector<int> node;  // node of the whole body, for each node of the part
};

template <class T>
void take_if_any(const std::vector<T>& from, int e, std::vector<T>& to) {
    if (!from.empty()) to.push_back(from[e]);
}

// `elements` are numbered through the groups, ascending. Nodes that are not `is_free` are fixed.
template <class IsFree>
Part part_of(const Body& whole, const std::vector<int>& elements, const IsFree& is_free) {
    Part part;
    part.body.model = whole.model;
    std::unordered_map<int, int> index;
    const auto take = [&](int i) {
        const auto [known, is_new] = index.emplace(i, static_cast<int>(part.node.size()));
        if (!is_new) return known->second;
        part.node.push_back(i);
        part.body.rest_positions_mm.push_back(whole.rest_positions_mm[i]);
        part.body.mass_g.push_back(whole.mass_g[i]);
        part.body.fixed.push_back(is_free(i) ? 0 : 1);
        part.body.tether_un_per_mm.push_back(0.0);
        return known->second;
    };
    auto next = elements.begin();
    int first = 0;
    for (const ElementGroup& group : whole.groups) {
        ElementGroup& own = part.body.groups.emplace_back();
        own.kind = group.kind;
        own.nodes_per_element = group.nodes_per_element;
        for (; next != elements.end() && *next < first + group.size(); ++next) {
            const int e = *next - first;
            for (int a = 0; a < group.nodes_per_element; ++a)
                own.connectivity.push_back(
                    take(group.connectivity[e * group.nodes_per_element + a]));
            take_if_any(group.tetrahedra, e, own.tetrahedra);
            take_if_any(group.springs, e, own.springs);
            take_if_any(group.hexahedra, e, own.hexahedra);
        }
        first += group.size();
    }
    part.body.vertex_count = part.body.node_count();
    return part;
}

// The nodes of each connected piece, ascending.
std::vector<std::vector<int>> nodes_of_pieces(const AssemblyPlan& plan) {
    std::vector<std::vector<int>> nodes;
    const std::vector<int> piece = connected_pieces(plan);
    for (std::size_t i = 0; i < piece.size(); ++i) {
        nodes.resize(std::max(nodes.size(), static_cast<std::size_t>(piece[i]) + 1));
        nodes[piece[i]].push_back(static_cast<int>(i));
    }
    return nodes;
}

// The motion of one piece of a part, by the nodes that surround the patch. Fewer than three fix no
// rotation; then all of its nodes count.
RestFit motion_of_piece(const Body& part, const std::vector<int>& piece,
                        const std::vector<Vec3>& now) {
    constexpr std::size_t least_around = 3;
    std::vector<int> around;
    for (const int i : piece)
        if (part.fixed[i]) around.push_back(i);
    return motion_of(around.size() < least_around ? piece : around, part.rest_positions_mm, now);
}

// Displacements of the free nodes of a part, in rest coordinates, at which its linear elastic
// forces vanish while the fixed nodes are displaced by `change`.
std::vector<Vec3> balanced(const Part& part, Assembly& assembly, const std::vector<Vec3>& change) {
    assembly.evaluate(part.body.rest_positions_mm);
    BlockMatrix matrix;
    assembly.gather_stiffness(1.0, matrix);
    const std::vector<std::uint8_t>& fixed = part.body.fixed;
    std::vector<Vec3> load(change.size(), Vec3::Zero()), found(change.size(), Vec3::Zero());
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            if (i == j && fixed[i]) matrix.block[k] = Mat3::Identity();
            if (i == j || (!fixed[i] && !fixed[j])) continue;
            if (!fixed[i]) load[i] -= matrix.block[k] * change[j];
            matrix.block[k].setZero();
        }
    const auto solver = make_block_jacobi_solver();
    solver->prepare(matrix, part.body.rest_positions_mm);
    solver->solve(load, found,
                  {.energy_tolerance = 1e-3, .max_iterations = InversionRecovery::most_iterations});
    return found;
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

void InversionRecovery::find_elements_of_nodes() {
    if (!first_element_.empty()) return;
    first_element_.assign(body_.node_count() + 1, 0);
    int first = 0;
    for (const ElementGroup& group : body_.groups) {
        first_of_group_.push_back(first);
        first += group.size();
        for (const int i : group.connectivity) ++first_element_[i + 1];
    }
    std::partial_sum(first_element_.begin(), first_element_.end(), first_element_.begin());
    element_.resize(first_element_.back());
    std::vector<int> next = first_element_;
    for (std::size_t g = 0; g < body_.groups.size(); ++g) {
        const ElementGroup& group = body_.groups[g];
        for (std::size_t k = 0; k < group.connectivity.size(); ++k)
            element_[next[group.connectivity[k]]++] =
                first_of_group_[g] + static_cast<int>(k) / group.nodes_per_element;
    }
}

void InversionRecovery::add_nodes_of(int element, Patch& patch) const {
    const auto after = std::ranges::upper_bound(first_of_group_, element);
    const std::size_t g = static_cast<std::size_t>(after - first_of_group_.begin()) - 1;
    const ElementGroup& group = body_.groups[g];
    const int e = element - first_of_group_[g];
    for (int a = 0; a < group.nodes_per_element; ++a) {
        const int i = group.connectivity[e * group.nodes_per_element + a];
        if (patch.index[i] >= 0) continue;
        patch.index[i] = static_cast<int>(patch.nodes.size());
        patch.nodes.push_back(i);
    }
}

// Elements with a node in the patch, ascending.
std::vector<int> InversionRecovery::elements_around(const Patch& patch) const {
    std::vector<int> elements;
    for (const int i : patch.nodes)
        elements.insert(elements.end(), element_.begin() + first_element_[i],
                        element_.begin() + first_element_[i + 1]);
    std::ranges::sort(elements);
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    return elements;
}

// Adds the nodes that share an element with the patch.
void InversionRecovery::grow(Patch& patch) const {
    for (const int element : elements_around(patch)) add_nodes_of(element, patch);
}

// All positions, with the patch moved to the solution of linear elasticity between the surrounding
// nodes. Each connected piece is moved relative to the rigid motion that fits its own nodes best,
// because what is torn off may be anywhere. None where the patch is still inverted.
std::optional<std::vector<Vec3>> InversionRecovery::span_patch(const Patch& patch,
                                                               std::span<const Vec3> positions_mm) {
    const auto is_free = [&](int i) { return patch.index[i] >= 0 && body_.fixed[i] == 0; };
    const Part part = part_of(body_, elements_around(patch), is_free);
    const std::vector<Vec3>& rest = part.body.rest_positions_mm;
    std::vector<Vec3> now;
    for (const int node : part.node) now.push_back(positions_mm[node]);
    Assembly assembly(part.body);
    const std::vector<std::vector<int>> pieces = nodes_of_pieces(assembly.plan());
    std::vector<RestFit> motions;
    // Deviation of the surrounding nodes from their piece's motion, in rest coordinates.
    std::vector<Vec3> change(rest.size(), Vec3::Zero());
    std::size_t around = 0;
    for (const std::vector<int>& piece : pieces) {
        const RestFit& motion = motions.emplace_back(motion_of_piece(part.body, piece, now));
        for (const int i : piece) {
            if (!part.body.fixed[i]) continue;
            change[i] = motion.rotation.transpose() * (now[i] - motion(rest[i]));
            ++around;
        }
    }
    unknowns_ += 3 * static_cast<int>(rest.size() - around);
    if (around > 0) change = balanced(part, assembly, change);
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (const int i : pieces[p])
            if (!part.body.fixed[i]) now[i] = motions[p](rest[i]) + motions[p].rotation * change[i];
    if (!all_finite(now) || !inverted_elements(part.body, now).empty()) return std::nullopt;
    std::vector<Vec3> x(positions_mm.begin(), positions_mm.end());
    for (std::size_t i = 0; i < now.size(); ++i) x[part.node[i]] = now[i];
    return x;
}

std::optional<std::vector<Vec3>> InversionRecovery::recover(std::span<const Vec3> positions_mm,
                                                            const Energy& energy) {
    unknowns_ = 0;
    const std::vector<int> inverted = inverted_elements(body_, positions_mm);
    if (inverted.empty()) return std::nullopt;
    find_elements_of_nodes();
    const double before = energy(positions_mm);
    Patch patch;
    patch.index.assign(body_.node_count(), -1);
    for (const int element : inverted) add_nodes_of(element, patch);
    for (int rings = 1;; rings *= 2) {
        if (unknowns_ + 3 * static_cast<int>(patch.nodes.size()) > most_unknowns)
            return std::nullopt;
        auto x = span_patch(patch, positions_mm);
        if (x && energy(*x) < before - least_gain * std::abs(before)) return x;
        const std::size_t smaller = patch.nodes.size();
        for (int r = 0; r < rings; ++r) grow(patch);
        if (patch.nodes.size() == smaller) return std::nullopt;
    }
}

}  // namespace hepatica
