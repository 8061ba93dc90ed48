// SPDX-License-Identifier: GPL-3.0-or-later
// Implements Dijkstra's algorithm and A* on voxels visited on demand.
#include "core/tree/extraction/gap_paths.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

namespace hepatica {

namespace {

constexpr double darkest = 0.1;       // a dark millimetre costs as much as ten bright ones
constexpr double own_reach_mm = 4.0;  // how far back into its own piece a path may lead

// A visited voxel. The callbacks, which cost most, are called once for each.
struct Reached {
    int piece = -1;
    double price = 1.0;     // cost of a millimetre
    double still_mm = 0.0;  // least remaining cost to the goal
    double cost_mm = std::numeric_limits<double>::infinity();
    double gap_mm = 0.0;
    std::size_t before = 0;
    bool asked = false;
    bool closed = false;  // its cost is final, or it may not be entered
};

// Voxels are stored in runs along a row, because neighbours are looked up together.
constexpr std::size_t run_length = 16;
using Run = std::array<Reached, run_length>;

class Search {
  public:
    Search(const GapSearch& search, int own_piece) : search_(search), own_(own_piece) {}

    std::vector<GapPath> run(const Index3& start) {
        const Grid& grid = *search_.grid;
        const std::size_t first = grid.offset(start[0], start[1], start[2]);
        start_mm_ = grid.to_mm(start[0], start[1], start[2]);
        Reached& begin = seen(first);
        begin.cost_mm = 0.0;
        begin.before = first;
        open_.emplace(begin.still_mm, first);
        std::vector<GapPath> paths;
        std::set<int> found;
        while (!open_.empty()) {
            const std::size_t here = std::get<1>(open_.top());
            open_.pop();
            Reached& entry = seen(here);
            if (entry.closed) continue;
            entry.closed = true;
            if (entry.piece >= 0 && entry.piece != own_) {
                if (found.insert(entry.piece).second) paths.push_back(path_to(here, entry.piece));
                continue;  // paths do not continue through another piece
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
        Reached& there = seen(next);
        if (there.closed) return;
        const double cost = entry.cost_mm + there.price * step_mm;
        const double gap = entry.gap_mm + (there.piece < 0 ? step_mm : 0.0);
        if (cost > search_.longest_cost_mm || gap > search_.longest_gap_mm) return;
        if (there.cost_mm <= cost) return;
        there.cost_mm = cost;
        there.gap_mm = gap;
        there.before = here;
        open_.emplace(cost + there.still_mm, next);
    }

    Reached& seen(std::size_t voxel) {
        Reached& there = reached_[voxel / run_length][voxel % run_length];
        if (there.asked) return there;
        there.asked = true;
        const auto [x, y, z] = search_.grid->index_of(voxel);
        const Vec3 place = search_.grid->to_mm(x, y, z);
        there.piece = search_.piece_of(voxel);
        there.closed = there.piece == own_ && (place - start_mm_).norm() > own_reach_mm;
        if (there.piece < 0) {
            const double b = search_.brightness(place);
            there.price = 1.0 / (darkest + (1.0 - darkest) * b * b);
        }
        if (search_.goal_mm) there.still_mm = (*search_.goal_mm - place).norm();
        return there;
    }

    GapPath path_to(std::size_t end, int piece) {
        GapPath path;
        path.piece = piece;
        path.cost_mm = seen(end).cost_mm;
        path.gap_mm = seen(end).gap_mm;
        for (std::size_t p = end;; p = seen(p).before) {
            const auto [x, y, z] = search_.grid->index_of(p);
            path.points_mm.push_back(search_.grid->to_mm(x, y, z));
            path.brightness.push_back(
                search_.piece_of(p) >= 0 ? 1.0 : search_.brightness(path.points_mm.back()));
            if (seen(p).before == p) break;
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
    std::unordered_map<std::size_t, Run> reached_;  // looked up, never iterated over
};

}  // namespace

std::vector<GapPath> gap_paths(const GapSearch& search, int own_piece, const Index3& start) {
    return Search(search, own_piece).run(start);
}

}  // namespace hepatica
