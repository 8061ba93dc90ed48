// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/elimination_tree.h"

#include <algorithm>
#include <numeric>

namespace hepatica {

namespace {

// Parent of each position in the elimination tree, by path compression (Liu 1990).
std::vector<int> parents_of(const BlockMatrix& pattern, std::span<const int> order,
                            const std::vector<int>& position) {
    const int count = static_cast<int>(order.size());
    std::vector<int> parent(order.size(), -1), ancestor(order.size(), -1);
    for (int j = 0; j < count; ++j) {
        const int v = order[j];
        for (int k = pattern.row_begin[v]; k < pattern.row_begin[v + 1]; ++k) {
            int i = position[pattern.column[k]];
            while (i >= 0 && i < j) {
                const int next = ancestor[i];
                ancestor[i] = j;
                if (next < 0) parent[i] = j;
                i = next;
            }
        }
    }
    return parent;
}

std::vector<std::vector<int>> children_of(const std::vector<int>& parent) {
    std::vector<std::vector<int>> children(parent.size());
    for (std::size_t n = 0; n < parent.size(); ++n) {
        if (parent[n] >= 0) children[parent[n]].push_back(static_cast<int>(n));
    }
    return children;
}

// Postorder of a forest: children before parents, subtree after subtree.
std::vector<int> postorder(const std::vector<int>& parent) {
    const std::vector<std::vector<int>> children = children_of(parent);
    std::vector<int> order, stack;
    for (int root = static_cast<int>(parent.size()) - 1; root >= 0; --root) {
        if (parent[root] < 0) stack.push_back(root);
    }
    // Builds the reversed order: a parent before its children, from right to left.
    while (!stack.empty()) {
        const int node = stack.back();
        stack.pop_back();
        order.push_back(node);
        stack.insert(stack.end(), children[node].begin(), children[node].end());
    }
    std::reverse(order.begin(), order.end());
    return order;
}

struct Structure {
    std::vector<int> columns;
    std::vector<int> rows;
    int parent = -1;
    bool amalgamated = false;  // merged into its parent
};

// Time of one front in nanoseconds, fitted to measurements of a few sizes: arithmetic, assembly,
// overhead.
double front_cost(double columns, double rows) {
    const double k = 3.0 * columns, m = 3.0 * rows;
    return 0.07 * k * (k * k / 3.0 + k * m + m * m) + 0.6 * (k + m) * (k + m) + 400.0;
}

void free_memory(std::vector<int>& values) {
    std::vector<int>().swap(values);
}

// Finds the supernodes from the leaves to the root. The rows of a column are those of its block row
// and of its child supernodes. A supernode that is merged into its parent frees its rows at once,
// so that memory holds the rows of supernodes, not those of every column.
class SupernodeSearch {
  public:
    // Columns and rows are positions in the order; `parent` is the elimination tree.
    SupernodeSearch(const BlockMatrix& pattern, const std::vector<int>& vertex_at,
                    const std::vector<int>& position, const std::vector<int>& parent)
        : pattern_(pattern),
          vertex_at_(vertex_at),
          position_(position),
          structures_(parent.size()),
          children_(parent.size()),
          mark_(parent.size(), -1) {
        for (int j = 0; j < static_cast<int>(parent.size()); ++j) {
            structures_[j].parent = parent[j];
            find_rows(j);
            amalgamate(j);
            if (parent[j] >= 0) children_[parent[j]].push_back(j);
        }
    }

    // A supernode that was not merged is stored at its last column.
    std::vector<Structure> take() { return std::move(structures_); }

  private:
    void find_rows(int j) {
        Structure& own = structures_[j];
        own.columns = {j};
        const auto add = [&](int i) {
            if (i <= j || mark_[i] == j) return;
            mark_[i] = j;
            own.rows.push_back(i);
        };
        const int v = vertex_at_[j];
        for (int k = pattern_.row_begin[v]; k < pattern_.row_begin[v + 1]; ++k)
            add(position_[pattern_.column[k]]);
        for (const int child : children_[j])
            for (const int i : structures_[child].rows) add(i);
        std::sort(own.rows.begin(), own.rows.end());
        own.rows.shrink_to_fit();
    }

    // Merges children wherever one larger front is faster than two.
    void amalgamate(int j) {
        constexpr std::size_t most_columns = 48;
        Structure& parent = structures_[j];
        const double rows = static_cast<double>(parent.rows.size());
        std::vector<int> remaining;
        for (const int c : children_[j]) {
            Structure& child = structures_[c];
            const double child_columns = static_cast<double>(child.columns.size());
            const double columns = static_cast<double>(parent.columns.size());
            const double apart = front_cost(child_columns, static_cast<double>(child.rows.size())) +
                                 front_cost(columns, rows);
            if (child.columns.size() + parent.columns.size() > most_columns ||
                front_cost(child_columns + columns, rows) > apart) {
                remaining.push_back(c);
                continue;
            }
            parent.columns.insert(parent.columns.begin(), child.columns.begin(),
                                  child.columns.end());
            child.amalgamated = true;
            free_memory(child.columns);
            free_memory(child.rows);
            for (const int grandchild : children_[c]) {
                structures_[grandchild].parent = j;
                remaining.push_back(grandchild);
            }
            free_memory(children_[c]);
        }
        children_[j] = std::move(remaining);
    }

    const BlockMatrix& pattern_;
    const std::vector<int>& vertex_at_;
    const std::vector<int>& position_;
    std::vector<Structure> structures_;
    std::vector<std::vector<int>> children_;  // child supernodes of each supernode found so far
    std::vector<int> mark_;
};

// Writes the remaining supernodes in postorder.
void write_supernodes(const std::vector<Structure>& structures, const std::vector<int>& vertex_at,
                      EliminationTree& tree) {
    std::vector<int> kept, index(structures.size(), -1);
    for (int s = 0; s < static_cast<int>(structures.size()); ++s) {
        if (structures[s].amalgamated) continue;
        index[s] = static_cast<int>(kept.size());
        kept.push_back(s);
    }
    std::vector<int> parent;
    for (const int s : kept) {
        parent.push_back(structures[s].parent < 0 ? -1 : index[structures[s].parent]);
    }
    std::vector<int> new_position(structures.size(), -1);
    const std::vector<int> order = postorder(parent);
    std::vector<int> new_index(order.size());
    for (std::size_t n = 0; n < order.size(); ++n) new_index[order[n]] = static_cast<int>(n);
    for (const int n : order) {
        const Structure& structure = structures[kept[n]];
        Supernode supernode;
        supernode.first = static_cast<int>(tree.vertex_at.size());
        supernode.count = static_cast<int>(structure.columns.size());
        supernode.parent = parent[n] < 0 ? -1 : new_index[parent[n]];
        for (const int column : structure.columns) {
            new_position[column] = static_cast<int>(tree.vertex_at.size());
            tree.vertex_at.push_back(vertex_at[column]);
            tree.supernode_of.push_back(static_cast<int>(tree.supernodes.size()));
        }
        tree.supernodes.push_back(supernode);
    }
    for (std::size_t n = 0; n < order.size(); ++n) {
        Supernode& supernode = tree.supernodes[n];
        supernode.rows_begin = static_cast<int>(tree.rows.size());
        for (const int row : structures[kept[order[n]]].rows) {
            tree.rows.push_back(new_position[row]);
        }
        supernode.rows_end = static_cast<int>(tree.rows.size());
        std::sort(tree.rows.begin() + supernode.rows_begin, tree.rows.end());
    }
}

void link_supernodes(EliminationTree& tree) {
    std::vector<std::vector<int>> children(tree.supernodes.size());
    tree.place_in_parent.resize(tree.rows.size());
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
        Supernode& own = tree.supernodes[s];
        own.children_begin = static_cast<int>(tree.children.size());
        tree.children.insert(tree.children.end(), children[s].begin(), children[s].end());
        own.children_end = static_cast<int>(tree.children.size());
        tree.factor_blocks += static_cast<std::size_t>(own.count) * (own.count + 1) / 2 +
                              static_cast<std::size_t>(own.count) * own.rest();
        if (own.parent < 0) continue;
        children[own.parent].push_back(s);
        const Supernode& parent = tree.supernodes[own.parent];
        int place = 0;
        for (int r = own.rows_begin; r < own.rows_end; ++r) {
            const int row = tree.rows[r];
            if (row < parent.first + parent.count) {
                tree.place_in_parent[r] = row - parent.first;
            } else {
                while (tree.rows[parent.rows_begin + place] != row) ++place;
                tree.place_in_parent[r] = parent.count + place;
            }
        }
    }
}

// Sums over the subtree of each supernode, itself included.
struct Subtrees {
    std::vector<double> work;
    std::vector<int> size;
    double small = 0.0;  // work of a subtree that is not worth dividing
};

Subtrees weigh_subtrees(const EliminationTree& tree) {
    const std::size_t count = tree.supernodes.size();
    Subtrees subtrees{std::vector<double>(count, 0.0), std::vector<int>(count, 1)};
    double total = 0.0;
    for (std::size_t s = 0; s < count; ++s) {
        const Supernode& own = tree.supernodes[s];
        subtrees.work[s] += front_cost(own.count, own.rest());
        if (own.parent >= 0) {
            subtrees.work[own.parent] += subtrees.work[s];
            subtrees.size[own.parent] += subtrees.size[s];
        } else {
            total += subtrees.work[s];
        }
    }
    subtrees.small = std::max(total / 24.0, 2e4);
    return subtrees;
}

// Every small subtree is one chain of the first stage; above them a chain runs up to where another
// one joins.
class ChainPlan {
  public:
    explicit ChainPlan(const EliminationTree& tree)
        : tree_(tree), subtrees_(weigh_subtrees(tree)), chain_of_(tree.supernodes.size(), -1) {
        for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
            if (!is_small(s))
                climb(s);
            else if (tree.supernodes[s].parent < 0 || !is_small(tree.supernodes[s].parent))
                take_subtree(s);
        }
    }

    void write_stages(EliminationTree& tree) const {
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            const auto level = static_cast<std::size_t>(stage_[c]);
            if (tree.stages.size() <= level) tree.stages.resize(level + 1);
            EliminationTree::Chain chain;
            chain.begin = static_cast<int>(tree.chain_supernodes.size());
            tree.chain_supernodes.insert(tree.chain_supernodes.end(), chains_[c].begin(),
                                         chains_[c].end());
            chain.end = static_cast<int>(tree.chain_supernodes.size());
            tree.stages[level].push_back(chain);
        }
    }

  private:
    bool is_small(int s) const { return subtrees_.work[s] <= subtrees_.small; }

    void begin_chain(int s, std::vector<int> supernodes, int stage) {
        chain_of_[s] = static_cast<int>(chains_.size());
        chains_.push_back(std::move(supernodes));
        stage_.push_back(stage);
    }

    void take_subtree(int top) {
        std::vector<int> all(static_cast<std::size_t>(subtrees_.size[top]));
        std::iota(all.begin(), all.end(), top - subtrees_.size[top] + 1);
        begin_chain(top, std::move(all), 0);
    }

    // Continues the chain of the only large child if all other children are in earlier stages than
    // it.
    void climb(int s) {
        const Supernode& own = tree_.supernodes[s];
        int large = 0, continued = -1, after_small = 0, after_all = 0;
        for (int c = own.children_begin; c < own.children_end; ++c) {
            const int child = tree_.children[c];
            const int after = stage_[chain_of_[child]] + 1;
            after_all = std::max(after_all, after);
            if (is_small(child)) {
                after_small = std::max(after_small, after);
                continue;
            }
            ++large;
            continued = chain_of_[child];
        }
        if (large != 1 || stage_[continued] < after_small) return begin_chain(s, {s}, after_all);
        chains_[continued].push_back(s);
        chain_of_[s] = continued;
    }

    const EliminationTree& tree_;
    Subtrees subtrees_;
    std::vector<int> chain_of_;  // the chain that ends at each supernode
    std::vector<std::vector<int>> chains_;
    std::vector<int> stage_;  // of each chain
};

// Computes what follows from vertices, supernodes and rows.
void complete(EliminationTree& tree) {
    tree.position_of.resize(tree.vertex_at.size());
    for (std::size_t i = 0; i < tree.vertex_at.size(); ++i)
        tree.position_of[tree.vertex_at[i]] = static_cast<int>(i);
    link_supernodes(tree);
    for (const Supernode& s : tree.supernodes) tree.multiplications += multiplications(s);
    ChainPlan(tree).write_stages(tree);
}

}  // namespace

double multiplications(const Supernode& supernode) {
    const double k = 3.0 * supernode.count, m = 3.0 * supernode.rest();
    return k * (k * k / 6.0 + 0.5 * k * m + 0.5 * m * m);
}

EliminationTree analyse(const BlockMatrix& pattern, std::span<const int> order) {
    std::vector<int> position(order.size());
    for (std::size_t j = 0; j < order.size(); ++j) position[order[j]] = static_cast<int>(j);
    const std::vector<int> first_parent = parents_of(pattern, order, position);
    std::vector<int> vertex_at, new_of(order.size());
    for (const int old : postorder(first_parent)) {
        new_of[old] = static_cast<int>(vertex_at.size());
        vertex_at.push_back(order[old]);
    }
    std::vector<int> parent(order.size(), -1);
    for (std::size_t old = 0; old < order.size(); ++old) {
        if (first_parent[old] >= 0) parent[new_of[old]] = new_of[first_parent[old]];
    }
    for (std::size_t j = 0; j < order.size(); ++j) position[vertex_at[j]] = static_cast<int>(j);

    EliminationTree tree;
    write_supernodes(SupernodeSearch(pattern, vertex_at, position, parent).take(), vertex_at, tree);
    complete(tree);
    return tree;
}

EliminationTree tree_of_split(const EliminationTree& whole, std::span<const int> parents) {
    // For each node of the whole body: itself and the nodes that were split from it.
    std::vector<std::vector<int>> members(whole.vertex_at.size());
    std::vector<int> origin;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        const bool own = parents[i] == static_cast<int>(i);
        origin.push_back(own ? parents[i] : int(origin[parents[i]]));
        members[origin.back()].push_back(static_cast<int>(i));
    }
    EliminationTree tree;
    std::vector<int> first_position;  // of each position of the whole body
    for (std::size_t j = 0; j < whole.vertex_at.size(); ++j) {
        const std::vector<int>& all = members[whole.vertex_at[j]];
        first_position.push_back(static_cast<int>(tree.vertex_at.size()));
        tree.vertex_at.insert(tree.vertex_at.end(), all.begin(), all.end());
        tree.supernode_of.insert(tree.supernode_of.end(), all.size(), whole.supernode_of[j]);
    }
    first_position.push_back(static_cast<int>(tree.vertex_at.size()));
    for (const Supernode& of_whole : whole.supernodes) {
        Supernode own;
        own.first = first_position[of_whole.first];
        own.count = first_position[of_whole.first + of_whole.count] - own.first;
        own.parent = of_whole.parent;
        own.rows_begin = static_cast<int>(tree.rows.size());
        for (int r = of_whole.rows_begin; r < of_whole.rows_end; ++r)
            for (int row = first_position[whole.rows[r]]; row < first_position[whole.rows[r] + 1];
                 ++row)
                tree.rows.push_back(row);
        own.rows_end = static_cast<int>(tree.rows.size());
        tree.supernodes.push_back(own);
    }
    complete(tree);
    return tree;
}

}  // namespace hepatica
