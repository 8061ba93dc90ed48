// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/dissection_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "core/deform/solvers/elimination_order.h"

namespace hepatica {
namespace {

constexpr int small_part = 100;
constexpr double most_one_sided = 0.7;  // largest acceptable share of the larger side
constexpr int most_ends_tried = 6;

class Dissection {
  public:
    explicit Dissection(const BlockMatrix& pattern)
        : pattern_(pattern),
          part_of_(static_cast<std::size_t>(pattern.rows()), 0),
          mark_(static_cast<std::size_t>(pattern.rows()), -1),
          order_(static_cast<std::size_t>(pattern.rows())) {}

    std::vector<int> find() {
        std::vector<int> all(order_.size());
        std::iota(all.begin(), all.end(), 0);
        parts_.push_back({std::move(all), order_.size()});
        while (!parts_.empty()) {
            Part part = std::move(parts_.back());
            parts_.pop_back();
            divide(std::move(part));
        }
        return order_;
    }

  private:
    struct Part {
        std::vector<int> nodes;
        std::size_t end = 0;  // one past the part's places in the order
    };
    // Breadth-first levels of the nodes of a part that are connected to a start node.
    struct Levels {
        std::vector<int> nodes;
        std::vector<std::size_t> begin;  // of each level, then the end of the last one

        std::size_t count() const { return begin.size() - 1; }
        std::size_t size(std::size_t level) const { return begin[level + 1] - begin[level]; }
    };

    template <class Visit>
    void for_each_neighbour(int node, const Visit& visit) const {
        for (int k = pattern_.row_begin[node]; k < pattern_.row_begin[node + 1]; ++k)
            visit(pattern_.column[k]);
    }

    Levels levels_from(int start) {
        const int part = part_of_[start];
        Levels levels{{start}, {0}};
        mark_[start] = 0;
        for (std::size_t next = 0; next < levels.nodes.size(); ++next) {
            const int node = levels.nodes[next];
            if (mark_[node] == static_cast<int>(levels.begin.size())) levels.begin.push_back(next);
            for_each_neighbour(node, [&](int other) {
                if (part_of_[other] != part || mark_[other] >= 0) return;
                mark_[other] = mark_[node] + 1;
                levels.nodes.push_back(other);
            });
        }
        levels.begin.push_back(levels.nodes.size());
        for (const int node : levels.nodes) mark_[node] = -1;
        return levels;
    }

    // Levels from a pseudo-peripheral node: restarts from the farthest one while that adds levels.
    Levels levels_of(int start) {
        Levels levels = levels_from(start);
        for (int tried = 0; tried < most_ends_tried; ++tried) {
            Levels others = levels_from(levels.nodes.back());
            const bool more = others.count() > levels.count();
            if (tried == 0 || more) levels = std::move(others);
            if (tried > 0 && !more) break;
        }
        return levels;
    }

    // The best separator among the levels: small, and near the middle.
    static std::size_t parting_level(const Levels& levels) {
        const auto nodes = static_cast<double>(levels.nodes.size());
        std::size_t best = 1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t level = 1; level + 1 < levels.count(); ++level) {
            const std::size_t larger =
                std::max(levels.begin[level], levels.nodes.size() - levels.begin[level + 1]);
            const double share = static_cast<double>(larger) / nodes, beside = 4.0 * (share - 0.5);
            // Any separator that is not too one-sided is better than any that is.
            const double cost = share > most_one_sided ? nodes * (2.0 + share)
                                                       : static_cast<double>(levels.size(level)) *
                                                             (1.0 + beside * beside);
            if (cost >= least) continue;
            least = cost;
            best = level;
        }
        return best;
    }

    void divide(Part part) {
        if (part.nodes.size() <= small_part) return place(part.nodes, part.end);
        ++parts_seen_;
        for (const int node : part.nodes) part_of_[node] = parts_seen_;
        Levels levels = levels_of(part.nodes.front());
        if (levels.nodes.size() < part.nodes.size()) return take_apart(part, levels.nodes);
        if (levels.count() < 3) return place(part.nodes, part.end);
        const std::size_t level = parting_level(levels);
        const auto at = [&](std::size_t k) {
            return levels.nodes.begin() + static_cast<std::ptrdiff_t>(levels.begin[k]);
        };
        std::vector<int> near(levels.nodes.begin(), at(level)), wall;
        std::vector<int> beyond(at(level + 1), levels.nodes.end());
        for (const int node : beyond) mark_[node] = 0;
        for (auto node = at(level); node != at(level + 1); ++node) {
            bool parts = false;
            for_each_neighbour(*node, [&](int other) { parts = parts || mark_[other] == 0; });
            (parts ? wall : near).push_back(*node);
        }
        for (const int node : beyond) mark_[node] = -1;
        place(wall, part.end);
        for (const int node : wall) part_of_[node] = 0;
        const std::size_t end = part.end - wall.size(), middle = end - beyond.size();
        parts_.push_back({std::move(beyond), end});
        parts_.push_back({std::move(near), middle});
    }

    void take_apart(const Part& part, const std::vector<int>& joined) {
        for (const int node : joined) mark_[node] = 0;
        std::vector<int> rest;
        for (const int node : part.nodes)
            if (mark_[node] < 0) rest.push_back(node);
        for (const int node : joined) mark_[node] = -1;
        const std::size_t middle = part.end - rest.size();
        parts_.push_back({std::move(rest), part.end});
        parts_.push_back({joined, middle});
    }

    // Orders the nodes by minimum degree, at the places just before `end`.
    void place(const std::vector<int>& nodes, std::size_t end) {
        if (nodes.empty()) return;
        for (std::size_t i = 0; i < nodes.size(); ++i) mark_[nodes[i]] = static_cast<int>(i);
        BlockMatrix own;
        for (const int node : nodes) {
            for_each_neighbour(node, [&](int other) {
                if (mark_[other] >= 0) own.column.push_back(mark_[other]);
            });
            std::sort(own.column.begin() + own.row_begin.back(), own.column.end());
            own.row_begin.push_back(static_cast<int>(own.column.size()));
        }
        std::size_t next = end - nodes.size();
        for (const int i : fill_reducing_order(own)) order_[next++] = nodes[i];
        for (const int node : nodes) mark_[node] = -1;
    }

    const BlockMatrix& pattern_;
    std::vector<int> part_of_;  // the part that each node was last seen in; 0: placed
    std::vector<int> mark_;     // per node; -1 between uses
    std::vector<int> order_;
    std::vector<Part> parts_;
    int parts_seen_ = 0;
};

}  // namespace

std::vector<int> dissection_order(const BlockMatrix& pattern) {
    return Dissection(pattern).find();
}

}  // namespace hepatica
