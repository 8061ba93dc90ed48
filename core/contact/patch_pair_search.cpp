// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/patch_pair_search.h"

#include <algorithm>
#include <array>

namespace hepatica {
namespace {

Eigen::Array4d in_four(const Vec3& x) {
    return {x.x(), x.y(), x.z(), 0.0};
}

bool shares(const std::array<int, 4>& nodes, int first_count) {
    for (int a = 0; a < first_count; ++a)
        for (int b = first_count; b < 4; ++b)
            if (nodes[a] == nodes[b]) return true;
    return false;
}

}  // namespace

template <class Nodes>
PatchPairSearch::Swept PatchPairSearch::swept(const Nodes& nodes) const {
    const Eigen::Array4d first = in_four(sweep_.from_mm[*std::begin(nodes)]);
    Swept box{first, first};
    for (const int v : nodes) box.add(in_four(sweep_.from_mm[v]));
    if (sweep_.stands()) return box;
    for (const int v : nodes) box.add(in_four(sweep_.to_mm[v]) - observer_mm_);
    return box;
}

// A feature is inside the box of the triangle that owns it.
void PatchPairSearch::list(int patch, const Swept& near, double margin_mm, Part& part) const {
    part.nodes.clear();
    part.edges.clear();
    part.triangles.clear();
    const auto take = [&](int number, Swept box, std::vector<Feature>& features) {
        box.grow(margin_mm);
        if (!box.meets(near)) return false;
        features.push_back({number, box});
        return true;
    };
    for (const int t : features_.surface().triangles_of(static_cast<std::size_t>(patch))) {
        if (!take(t, swept(features_.surface().triangles()[t]), part.triangles)) continue;
        for (const int v : features_.nodes_owned_by(t)) take(v, swept(std::array{v}), part.nodes);
        for (const int e : features_.edges_owned_by(t))
            take(e, swept(features_.edges()[e]), part.edges);
    }
}

void PatchPairSearch::add_vertices(const Part& of_vertices, const Part& of_triangles,
                                   std::vector<FeaturePair>& found) const {
    for (const Feature& vertex : of_vertices.nodes)
        for (const Feature& triangle : of_triangles.triangles) {
            if (!vertex.box.meets(triangle.box)) continue;
            const auto& corners = features_.surface().triangles()[triangle.number];
            const FeaturePair pair{.first = vertex.number,
                                   .second = triangle.number,
                                   .nodes = {vertex.number, corners[0], corners[1], corners[2]}};
            if (!shares(pair.nodes, 1)) found.push_back(pair);
        }
}

void PatchPairSearch::add_edges(bool within, std::vector<FeaturePair>& found) const {
    for (const Feature& one : first_.edges)
        for (const Feature& other : second_.edges) {
            if (within && one.number >= other.number) continue;
            if (!one.box.meets(other.box)) continue;
            const auto [first, second] = std::minmax(one.number, other.number);
            const auto &a = features_.edges()[first], &b = features_.edges()[second];
            const FeaturePair pair{.of_edges = true,
                                   .first = first,
                                   .second = second,
                                   .nodes = {a[0], a[1], b[0], b[1]}};
            if (!shares(pair.nodes, 2)) found.push_back(pair);
        }
}

void PatchPairSearch::add_pairs_of(int patch, int other, const Sweep& sweep,
                                   std::vector<FeaturePair>& found) {
    sweep_ = sweep;
    observer_mm_.setZero();
    const auto nodes = features_.surface().vertices_of(static_cast<std::size_t>(other));
    if (!sweep.stands()) {
        for (const int v : nodes)
            observer_mm_ += in_four(sweep.to_mm[v]) - in_four(sweep.from_mm[v]);
        observer_mm_ /= static_cast<double>(nodes.size());
    }
    list(patch, swept(nodes), sweep.reach_mm, first_);
    if (first_.triangles.empty()) return;
    Swept ahead = first_.triangles.front().box;
    for (const Feature& triangle : first_.triangles) {
        ahead.low = ahead.low.min(triangle.box.low);
        ahead.high = ahead.high.max(triangle.box.high);
    }
    list(other, ahead, 0.0, second_);
    add_vertices(first_, second_, found);
    if (patch != other) add_vertices(second_, first_, found);
    add_edges(patch == other, found);
}

}  // namespace hepatica
