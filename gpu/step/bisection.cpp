// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/bisection.h"

#include <algorithm>

namespace hepatica::gpu {
namespace {

std::vector<std::vector<int>> neighbours_of(const CoarseSkeleton& skeleton) {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(skeleton.size()));
    for (int i = 0; i < skeleton.size(); ++i)
        if (const int parent = skeleton.parent[i]; parent >= 0) {
            neighbours[i].push_back(parent);
            neighbours[parent].push_back(i);
        }
    return neighbours;
}

class Bisection {
  public:
    explicit Bisection(const CoarseSkeleton& skeleton)
        : neighbours_(neighbours_of(skeleton)),
          gone_(neighbours_.size(), 0),
          above_(neighbours_.size(), -1),
          size_(neighbours_.size(), 0) {}

    std::vector<std::array<int, 2>> cuts() {
        std::vector<int> waiting;
        std::vector<std::array<int, 2>> cuts;
        for (int i = static_cast<int>(gone_.size()); i-- > 0;) waiting.push_back(i);
        while (!waiting.empty()) {
            const int start = waiting.back();
            waiting.pop_back();
            if (gone_[start] != 0) continue;
            cuts.push_back(cut_of(start));
            for (const int node : cuts.back()) {
                if (node < 0) continue;
                gone_[node] = 1;
                waiting.insert(waiting.end(), neighbours_[node].begin(), neighbours_[node].end());
            }
        }
        std::ranges::reverse(cuts);
        return cuts;
    }

  private:
    // The centroid of what is left around `start`, and its neighbour in the largest part.
    std::array<int, 2> cut_of(int start) {
        std::vector<int> reached{start};
        above_[start] = -1;
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (const int j : neighbours_[reached[k]])
                if (gone_[j] == 0 && j != above_[reached[k]]) {
                    above_[j] = reached[k];
                    reached.push_back(j);
                }
        const int whole = static_cast<int>(reached.size());
        for (const int i : reached) size_[i] = 1;
        for (std::size_t k = reached.size(); k-- > 1;)
            size_[above_[reached[k]]] += size_[reached[k]];
        for (int at = start;;) {
            const int below = largest_below(at);
            if (below >= 0 && 2 * size_[below] > whole) {
                at = below;
                continue;
            }
            const bool upward = above_[at] >= 0 && (below < 0 || whole - size_[at] > size_[below]);
            return {at, upward ? above_[at] : below};
        }
    }
    int largest_below(int i) const {
        int largest = -1;
        for (const int j : neighbours_[i])
            if (gone_[j] == 0 && j != above_[i] && (largest < 0 || size_[j] > size_[largest]))
                largest = j;
        return largest;
    }

    std::vector<std::vector<int>> neighbours_;
    std::vector<char> gone_;
    std::vector<int> above_, size_;
};

}  // namespace

std::vector<std::array<int, 2>> bisecting_cuts(const CoarseSkeleton& skeleton) {
    return Bisection(skeleton).cuts();
}

}  // namespace hepatica::gpu
