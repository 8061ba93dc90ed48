// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets (union-find with path halving, Tarjan 1975). The root of a set is its smallest
// member, so numbering by roots does not depend on the order of the unions. Not thread-safe: root()
// also writes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace hepatica {

class DisjointSets {
  public:
    // The members 0 to size - 1, each in a set of its own.
    explicit DisjointSets(std::size_t size = 0) : parents_(size), count_(size) {
        std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
    }

    // Adds a set with one new member, and returns the member.
    std::uint32_t add() {
        parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
        ++count_;
        return parents_.back();
    }

    std::uint32_t root(std::uint32_t member) {
        while (parents_[member] != member) member = parents_[member] = parents_[parents_[member]];
        return member;
    }

    // Returns false if both were already in one set.
    bool unite(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return false;
        parents_[std::max(a, b)] = std::min(a, b);
        --count_;
        return true;
    }

    std::size_t size() const { return parents_.size(); }  // members
    std::size_t count() const { return count_; }          // sets

  private:
    std::vector<std::uint32_t> parents_;
    std::size_t count_;
};

}  // namespace hepatica
