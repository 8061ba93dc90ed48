// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/torn_topology.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"

namespace hepatica {
namespace {

int opposite_corner(const std::array<int, 3>& corners) {
    return 6 - corners[0] - corners[1] - corners[2];
}

}  // namespace

TornTopology::TornTopology(const TetMesh& mesh)
    : joints_(std::make_shared<const std::vector<Joint>>(joints_of(mesh))),
      whole_vertices_(static_cast<int>(mesh.vertices_mm.size())),
      tetrahedra_(mesh.tetrahedra),
      parents_(mesh.vertices_mm.size()),
      parted_(joints_->size(), 0) {
    std::vector<std::array<int, 4>> opposite(tetrahedra_.size(), {-1, -1, -1, -1});
    for (std::size_t j = 0; j < joints_->size(); ++j)
        for (int side = 0; side < 2; ++side) {
            const Joint& joint = (*joints_)[j];
            opposite[joint.tetrahedra[side]][opposite_corner(joint.corners[side])] =
                static_cast<int>(j);
        }
    joint_opposite_ = std::make_shared<const std::vector<std::array<int, 4>>>(std::move(opposite));
    std::iota(parents_.begin(), parents_.end(), 0);
    find_tetrahedra_of_vertices();
}

void TornTopology::find_tetrahedra_of_vertices() {
    tetrahedra_of_.assign(parents_.size(), {});
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
        for (const int v : tetrahedra_[t]) tetrahedra_of_[v].push_back(static_cast<int>(t));
}

std::array<int, 2> TornTopology::sides(const Joint& joint, int k) const {
    return {tetrahedra_[joint.tetrahedra[0]][joint.corners[0][k]],
            tetrahedra_[joint.tetrahedra[1]][joint.corners[1][k]]};
}

template <class Visit>
void TornTopology::for_each_open_face(const Visit& visit) const {
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            const int j = (*joint_opposite_)[t][i];
            bool open = j < 0;
            for (int k = 0; k < 3 && !open && parted_[j]; ++k) {
                const auto both = sides((*joints_)[j], k);
                open = both[0] != both[1];
            }
            if (open) visit(t, i, j);
        }
}

std::vector<std::array<int, 3>> TornTopology::surface() const {
    std::vector<std::array<int, 3>> triangles;
    for_each_open_face([&](std::size_t t, int i, int) {
        std::array<int, 3> triangle{};
        for (int k = 0; k < 3; ++k) triangle[k] = tetrahedra_[t][face_corners[i][k]];
        triangles.push_back(triangle);
    });
    return triangles;
}

std::vector<std::uint8_t> TornTopology::bare_faces() const {
    std::vector<std::uint8_t> bare;
    for_each_open_face([&](std::size_t, int, int joint) { bare.push_back(joint >= 0 ? 1 : 0); });
    return bare;
}

std::vector<int> TornTopology::joints_at(int vertex) const {
    std::vector<int> found;
    for (const int t : tetrahedra_of_[vertex])
        for (int i = 0; i < 4; ++i) {
            const int j = (*joint_opposite_)[t][i];
            if (j >= 0 && tetrahedra_[t][i] != vertex && !parted_[j]) found.push_back(j);
        }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void TornTopology::part(std::span<const int> joints, std::span<const double> volume_mm3) {
    ++version_;
    std::vector<int> touched;
    for (const int j : joints) {
        parted_[j] = 1;
        for (int k = 0; k < 3; ++k)
            for (const int v : sides((*joints_)[j], k)) touched.push_back(v);
    }
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const int v : touched) split(v, volume_mm3);
}

void TornTopology::split(int vertex, std::span<const double> volume_mm3) {
    const std::vector<int> around = tetrahedra_of_[vertex];
    std::vector<std::vector<int>> groups;
    std::vector<std::uint8_t> seen(around.size(), 0);
    for (std::size_t first = 0; first < around.size(); ++first) {
        if (seen[first]) continue;
        seen[first] = 1;
        std::vector<int> group{around[first]};
        for (std::size_t next = 0; next < group.size(); ++next) {
            const int t = group[next];
            for (int i = 0; i < 4; ++i) {
                const int j = (*joint_opposite_)[t][i];
                if (tetrahedra_[t][i] == vertex || j < 0 || parted_[j]) continue;
                const auto& pair = (*joints_)[j].tetrahedra;
                const int other = pair[0] == t ? pair[1] : pair[0];
                const auto place = std::ranges::lower_bound(around, other) - around.begin();
                if (seen[place]) continue;
                seen[place] = 1;
                group.push_back(other);
            }
        }
        std::ranges::sort(group);
        groups.push_back(std::move(group));
    }
    if (groups.size() < 2) return;
    const auto volume = [&](const std::vector<int>& group) {
        double sum = 0.0;
        for (const int t : group) sum += volume_mm3[t];
        return sum;
    };
    const auto largest = std::ranges::max_element(groups, {}, volume);
    for (auto group = groups.begin(); group != groups.end(); ++group) {
        const bool keeps = group == largest;
        const int number = keeps ? vertex : vertex_count();
        for (const int t : *group) std::ranges::replace(tetrahedra_[t], vertex, number);
        if (keeps) {
            tetrahedra_of_[vertex] = *group;
        } else {
            parents_.push_back(vertex);
            tetrahedra_of_.push_back(*group);
        }
    }
}

void TornTopology::restore(std::span<const int> parted, std::span<const int> parents,
                           std::span<const std::array<int, 4>> tetrahedra) {
    const auto fits = [](bool condition) {
        if (!condition)
            throw InputError("is torn otherwise than this body can be", "the checkpoint of a body",
                             "Make the stepper of the body that it was taken of");
    };
    const int count = static_cast<int>(parents.size());
    fits(count >= whole_vertices_ && tetrahedra.size() == tetrahedra_.size());
    for (int v = 0; v < count; ++v)
        fits(v < whole_vertices_ ? parents[v] == v : parents[v] >= 0 && parents[v] < v);
    for (const int j : parted) fits(j >= 0 && j < static_cast<int>(joints_->size()));
    const auto origin = [&](int v) {
        while (parents[v] != v) v = parents[v];
        return v;
    };
    std::vector<std::uint8_t> used(parents.size(), 0);
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            const int v = tetrahedra[t][i];
            fits(v >= 0 && v < count);
            int mine = tetrahedra_[t][i];
            while (parents_[mine] != mine) mine = parents_[mine];
            fits(origin(v) == mine);
            used[v] = 1;
        }
    fits(std::ranges::all_of(used, [](std::uint8_t is) { return is != 0; }));
    // Both sides of a joint that has not parted have the same vertices.
    std::vector<std::uint8_t> are_parted(joints_->size(), 0);
    for (const int j : parted) are_parted[j] = 1;
    for (std::size_t j = 0; j < joints_->size(); ++j) {
        const auto& [one, other] = (*joints_)[j].tetrahedra;
        const auto& [of_one, of_other] = (*joints_)[j].corners;
        for (int k = 0; k < 3 && are_parted[j] == 0; ++k)
            fits(tetrahedra[one][of_one[k]] == tetrahedra[other][of_other[k]]);
    }
    ++version_;
    parents_.assign(parents.begin(), parents.end());
    tetrahedra_.assign(tetrahedra.begin(), tetrahedra.end());
    std::ranges::fill(parted_, 0);
    for (const int j : parted) parted_[j] = 1;
    find_tetrahedra_of_vertices();
}

std::vector<int> TornTopology::piece_of_vertices(std::span<const std::array<int, 2>> ties) const {
    DisjointSets sets(parents_.size());
    for (const auto& [a, b, c, d] : tetrahedra_)
        for (const int other : {b, c, d}) sets.unite(a, other);
    for (const auto& [a, b] : ties) sets.unite(a, b);
    std::vector<int> piece;
    for (std::size_t v = 0; v < parents_.size(); ++v)
        piece.push_back(static_cast<int>(sets.root(static_cast<std::uint32_t>(v))));
    return piece;
}

int TornTopology::pieces(std::span<const std::array<int, 2>> ties) const {
    const std::vector<int> piece = piece_of_vertices(ties);
    int count = 0;
    for (std::size_t v = 0; v < piece.size(); ++v) count += piece[v] == static_cast<int>(v) ? 1 : 0;
    return count;
}

}  // namespace hepatica
