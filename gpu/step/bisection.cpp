// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/bisection.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace hepatica::gpu {
namespace {

class Bisection {
  public:
    Bisection(const CoarseSkeleton& skeleton, const Couplings& coupled)
        : parent_(skeleton.parent),
          coupled_(coupled),
          part_(parent_.size(), 0),
          side_(parent_.size(), 0),
          size_(parent_.size(), 0) {}

    std::vector<std::array<int, 2>> cuts() {
        std::vector<int> all(parent_.size());
        for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<int>(n);
        release(all);
        while (!waiting_.empty()) {
            const std::vector<int> part = std::move(waiting_.back());
            waiting_.pop_back();
            divide(part);
        }
        std::ranges::reverse(cuts_);
        return std::move(cuts_);
    }

  private:
    static constexpr int gone = -1;

    // Removes the separator of a part as cuts of two nodes, and queues the remaining pieces.
    void divide(const std::vector<int>& part) {
        std::vector<int> separator = part.size() > 2 ? separator_of(part) : part;
        for (const int n : separator) part_[n] = gone;
        if (separator.size() % 2 != 0)
            if (const int more = neighbour_of(separator); more >= 0) {
                separator.push_back(more);
                part_[more] = gone;
            }
        for (std::size_t k = 0; k < separator.size(); k += 2)
            cuts_.push_back({separator[k], k + 1 < separator.size() ? separator[k + 1] : -1});
        release(part);
    }
    // The nodes of one half that are coupled with the other, of the half where they are fewer.
    std::vector<int> separator_of(const std::vector<int>& part) {
        const int top = halving_node(part);
        for (const int n : part) {
            const int above = parent_[n];
            side_[n] = n == top || (in_part(above, n) && side_[above] != 0) ? 1 : 0;
        }
        std::array<std::vector<int>, 2> border;
        for (const int n : part)
            if (std::ranges::any_of(coupled_[n], [&](int other) {
                    return in_part(other, n) && side_[other] != side_[n];
                }))
                border[side_[n]].push_back(n);
        return border[0].size() < border[1].size() ? border[0] : border[1];
    }
    // The node whose subtree within the part, itself included, is closest to half of the part, but
    // not all of it.
    int halving_node(const std::vector<int>& part) {
        const int whole = static_cast<int>(part.size());
        for (const int n : part) size_[n] = 1;
        int best = part.back();
        for (std::size_t k = part.size(); k-- > 0;) {
            const int n = part[k];
            if (in_part(parent_[n], n)) size_[parent_[n]] += size_[n];
            if (size_[n] < whole &&
                std::abs(2 * size_[n] - whole) < std::abs(2 * size_[best] - whole))
                best = n;
        }
        return best;
    }
    // The first remaining node that is coupled with one of these; -1: none.
    int neighbour_of(const std::vector<int>& nodes) const {
        for (const int n : nodes)
            for (const int other : coupled_[n])
                if (part_[other] != gone) return other;
        return -1;
    }
    bool in_part(int node, int of) const { return node >= 0 && part_[node] == part_[of]; }

    // Queues the remaining nodes as coupled pieces, each in ascending order.
    void release(const std::vector<int>& nodes) {
        const std::size_t first = waiting_.size();
        for (const int n : nodes)
            if (part_[n] != gone) part_[n] = unreached;
        for (const int start : nodes) {
            if (part_[start] != unreached) continue;
            ++parts_;
            std::vector<int> reached{start};
            part_[start] = parts_;
            for (std::size_t k = 0; k < reached.size(); ++k)
                for (const int other : coupled_[reached[k]])
                    if (part_[other] == unreached) {
                        part_[other] = parts_;
                        reached.push_back(other);
                    }
            std::ranges::sort(reached);
            waiting_.push_back(std::move(reached));
        }
        std::reverse(waiting_.begin() + static_cast<std::ptrdiff_t>(first), waiting_.end());
    }

    static constexpr int unreached = 0;

    const std::vector<int>& parent_;
    const Couplings& coupled_;
    std::vector<int> part_;  // part of each node: 1, 2, ..., unreached or gone
    std::vector<int> side_, size_;
    int parts_ = 0;
    std::vector<std::vector<int>> waiting_;
    std::vector<std::array<int, 2>> cuts_;
};

}  // namespace

std::vector<std::array<int, 2>> bisecting_cuts(const CoarseSkeleton& skeleton,
                                               const Couplings& coupled) {
    return Bisection(skeleton, coupled).cuts();
}

}  // namespace hepatica::gpu
