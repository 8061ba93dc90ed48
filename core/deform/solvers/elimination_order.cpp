// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/elimination_order.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace hepatica {

namespace {

struct SkeletonTree {
    std::vector<std::vector<int>> neighbours;
    std::vector<int> root_of;  // first node of the tree that a node belongs to
};

SkeletonTree neighbours_of(const CoarseSkeleton& skeleton) {
    SkeletonTree tree;
    tree.neighbours.resize(skeleton.parent.size());
    for (int n = 0; n < skeleton.size(); ++n) {
        const int parent = skeleton.parent[n];
        tree.root_of.push_back(parent < 0 ? n : tree.root_of[parent]);
        if (parent < 0) continue;
        tree.neighbours[n].push_back(parent);
        tree.neighbours[parent].push_back(n);
    }
    return tree;
}

// For each tree, the node whose removal leaves the smallest largest part, counted in vertices;
// indexed by the tree's root.
std::vector<int> centres_of(const CoarseSkeleton& skeleton, const SkeletonBinding& binding,
                            const SkeletonTree& tree) {
    const std::size_t count = skeleton.parent.size();
    std::vector<double> below(count, 0.0);  // vertices bound to edges below a node
    for (std::size_t v = 0; v < binding.nodes.size(); ++v) below[binding.nodes[v][1]] += 1.0;
    std::vector<double> largest_child(count, 0.0);
    for (std::size_t n = count; n-- > 0;) {
        const int parent = skeleton.parent[n];
        if (parent < 0) continue;
        below[parent] += below[n];
        largest_child[parent] = std::max(largest_child[parent], below[n]);
    }
    std::vector<int> centre(count, -1);
    std::vector<double> best(count, 0.0);
    for (std::size_t n = 0; n < count; ++n) {
        const int root = tree.root_of[n];
        const double largest = std::max(largest_child[n], below[root] - below[n]);
        if (centre[root] >= 0 && largest >= best[root]) continue;
        centre[root] = static_cast<int>(n);
        best[root] = largest;
    }
    return centre;
}

}  // namespace

std::vector<int> fill_reducing_order(const BlockMatrix& pattern) {
    using Graph = Eigen::SparseMatrix<double>;
    const int rows = pattern.rows();
    const std::vector<double> ones(pattern.column.size(), 1.0);
    const Graph graph =
        Eigen::Map<const Graph>(rows, rows, static_cast<int>(pattern.column.size()),
                                pattern.row_begin.data(), pattern.column.data(), ones.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().data(), order.indices().data() + rows};
}

std::vector<int> order_of_split(std::span<const int> order, std::span<const int> parents) {
    std::vector<int> origin(parents.size());
    std::vector<std::vector<int>> split_from(order.size());
    for (std::size_t i = 0; i < parents.size(); ++i) {
        const bool own = parents[i] == static_cast<int>(i);
        origin[i] = own ? parents[i] : origin[parents[i]];
        if (!own) split_from[origin[i]].push_back(static_cast<int>(i));
    }
    std::vector<int> all;
    for (const int v : order) {
        all.push_back(v);
        all.insert(all.end(), split_from[v].begin(), split_from[v].end());
    }
    return all;
}

std::vector<int> order_from_ends(const CoarseSkeleton& skeleton, const SkeletonBinding& binding) {
    const SkeletonTree tree = neighbours_of(skeleton);
    const std::vector<int> centre = centres_of(skeleton, binding, tree);
    // Ranks nodes from each centre outward, every subtree contiguous; reversed, ends come first.
    std::vector<int> rank(skeleton.parent.size(), 0), inward(skeleton.parent.size(), -1), stack;
    int visited = 0;
    for (const int start : centre) {
        if (start < 0) continue;
        stack.push_back(start);
        while (!stack.empty()) {
            const int node = stack.back();
            stack.pop_back();
            rank[node] = visited++;
            for (const int next : tree.neighbours[node]) {
                if (next == inward[node]) continue;
                inward[next] = node;
                stack.push_back(next);
            }
        }
    }
    using Key = std::tuple<int, double, int>;
    std::vector<Key> keys;
    for (int v = 0; v < static_cast<int>(binding.nodes.size()); ++v) {
        const auto [a, b] = binding.nodes[v];
        const bool b_outside = inward[b] == a;
        const int outer = b_outside ? b : a;
        const double weight_outer = b_outside ? binding.weights[v][1] : binding.weights[v][0];
        keys.emplace_back(-rank[outer], -weight_outer, v);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    for (const Key& key : keys) order.push_back(std::get<2>(key));
    return order;
}

}  // namespace hepatica
