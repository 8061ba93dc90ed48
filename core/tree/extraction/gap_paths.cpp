// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/gap_paths.h"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

namespace hepatica {

namespace {

constexpr double darkest = 0.1;       // a dark millimetre costs as much as ten bright ones
constexpr double own_reach_mm = 4.0;  // how far back into its own piece a path may lead

struct Reached {
    double cost_mm;
    double gap_mm;
    std::size_t before;
    bool closed;
};

class Search {
  public:
    Search(const GapSearch& search, int own_piece) : search_(search), own_(own_piece) {}

    std::vector<GapPath> run(const Index3& start) {
        const Grid& grid = *search_.grid;
        const std::size_t first = grid.offset(start[0], start[1], start[2]);
        start_mm_ = grid.to_mm(start[0], start[1], start[2]);
        reached_[first] = {0.0, 0.0, first, false};
        open_.emplace(0.0, first);
        std::vector<GapPath> paths;
        std::set<int> found;
        while (!open_.empty()) {
            const std::size_t here = std::get<1>(open_.top());
            open_.pop();
            Reached& entry = reached_[here];
            if (entry.closed) continue;
            entry.closed = true;
            const int piece = search_.piece_of(here);
            if (piece >= 0 && piece != own_) {
                if (found.insert(piece).second) paths.push_back(path_to(here, piece));
                continue;  // what lies behind is that piece's own business
            }
            spread(here, entry);
        }
        return paths;
    }

  private:
    void spread(std::size_t here, const Reached entry) {
        const Grid& grid = *search_.grid;
        const auto [x, y, z] = grid.index_of(here);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!grid.contains(x + dx, y + dy, z + dz)) continue;
                    const std::size_t next = grid.offset(x + dx, y + dy, z + dz);
                    if (next == here) continue;
                    const double step = Vec3(dx, dy, dz).cwiseProduct(grid.spacing_mm).norm();
                    visit(here, entry, next, step);
                }
    }

    void visit(std::size_t here, const Reached& entry, std::size_t next, double step_mm) {
        // Before what is there is asked, which costs most: half of all visits are to closed voxels.
        const auto known = reached_.find(next);
        if (known != reached_.end() && known->second.closed) return;
        const int piece = search_.piece_of(next);
        const bool outside = piece < 0;
        const auto [x, y, z] = search_.grid->index_of(next);
        const Vec3 place = search_.grid->to_mm(x, y, z);
        if (piece == own_ && (place - start_mm_).norm() > own_reach_mm) return;
        double price = 1.0;
        if (outside) {
            const double b = search_.brightness(place);
            price = 1.0 / (darkest + (1.0 - darkest) * b * b);
        }
        const double cost = entry.cost_mm + price * step_mm;
        const double gap = entry.gap_mm + (outside ? step_mm : 0.0);
        if (cost > search_.longest_cost_mm || gap > search_.longest_gap_mm) return;
        if (known == reached_.end()) {
            reached_.emplace(next, Reached{cost, gap, here, false});
        } else {
            if (known->second.cost_mm <= cost) return;
            known->second = {cost, gap, here, false};
        }
        open_.emplace(cost, next);
    }

    GapPath path_to(std::size_t end, int piece) {
        GapPath path;
        path.piece = piece;
        path.cost_mm = reached_[end].cost_mm;
        path.gap_mm = reached_[end].gap_mm;
        for (std::size_t p = end;; p = reached_[p].before) {
            const auto [x, y, z] = search_.grid->index_of(p);
            path.points_mm.push_back(search_.grid->to_mm(x, y, z));
            path.brightness.push_back(
                search_.piece_of(p) >= 0 ? 1.0 : search_.brightness(path.points_mm.back()));
            if (reached_[p].before == p) break;
        }
        std::ranges::reverse(path.points_mm);
        std::ranges::reverse(path.brightness);
        return path;
    }

    const GapSearch& search_;
    int own_;
    Vec3 start_mm_ = Vec3::Zero();
    using Open = std::tuple<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
    std::unordered_map<std::size_t, Reached> reached_;  // looked up, never iterated over
};

}  // namespace

std::vector<GapPath> gap_paths(const GapSearch& search, int own_piece, const Index3& start) {
    return Search(search, own_piece).run(start);
}

}  // namespace hepatica
