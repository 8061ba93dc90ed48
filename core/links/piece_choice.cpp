// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses pieces by a minimal cut (potts_labelling.h), and assigns voxels to pieces with Dijkstra's
// algorithm.
#include "core/links/piece_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/tree/systems/potts_labelling.h"

namespace hepatica {

namespace {

constexpr double tie_mm = 1.5;  // cost of neighbours that differ: so many millimetres at log-odds
                                // of one
constexpr std::size_t between_looks = 16384;
constexpr double surest = 0.95;  // largest share used, so that no piece decides alone

double log_odds(double share) {
    const double bounded = std::clamp(share, 1.0 - surest, surest);
    return std::log(bounded / (1.0 - bounded));
}

struct Step {
    int dx, dy, dz;
    double length;  // in voxels
};

std::array<Step, 26> steps_to_neighbours() {
    std::array<Step, 26> steps{};
    std::size_t k = 0;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0 || dz != 0)
                    steps[k++] = {dx, dy, dz, std::sqrt(dx * dx + dy * dy + dz * dz)};
    return steps;
}

// Grows the pieces from their centrelines through the mask (Dijkstra's algorithm). A centreline
// point starts at minus its radius, so that the cost of a voxel is its distance to the wall.
class NearestWall {
  public:
    explicit NearestWall(const Mask& vessels)
        : vessels_(vessels),
          cost_(vessels.voxels.size(), std::numeric_limits<float>::infinity()),
          kept_(vessels.voxels.size(), 1) {}

    void begin(const Vec3& p, double radius_mm, bool is_kept) {
        if (const auto at = voxel_at(vessels_.grid, p))
            offer(vessels_.grid.offset((*at)[0], (*at)[1], (*at)[2]),
                  static_cast<float>(-radius_mm), is_kept);
    }

    // 1 where the wall of a kept piece is the nearest. May be called once.
    std::vector<std::uint8_t> grown(const Job& job) {
        const Grid& grid = vessels_.grid;
        const auto steps = steps_to_neighbours();
        for (std::size_t settled = 0; !waiting_.empty(); ++settled) {
            if (settled % between_looks == 0) job.throw_if_cancelled();
            const auto [cost, at] = waiting_.top();
            waiting_.pop();
            if (cost > cost_[at]) continue;
            const Index3 p = grid.index_of(at);
            for (const Step& s : steps) {
                const int x = p[0] + s.dx, y = p[1] + s.dy, z = p[2] + s.dz;
                if (grid.contains(x, y, z))
                    offer(grid.offset(x, y, z),
                          cost + static_cast<float>(s.length * grid.spacing_mm[0]), kept_[at] != 0);
            }
        }
        return std::move(kept_);
    }

  private:
    void offer(std::size_t voxel, float cost, bool is_kept) {
        if (!vessels_.voxels[voxel] || cost > cost_[voxel]) return;
        if (cost == cost_[voxel]) {  // in a tie the voxel is kept
            if (!is_kept || kept_[voxel]) return;
        }
        cost_[voxel] = cost;
        kept_[voxel] = is_kept ? 1 : 0;
        waiting_.emplace(cost, voxel);
    }

    using Entry = std::pair<float, std::size_t>;
    const Mask& vessels_;
    std::vector<float> cost_;
    std::vector<std::uint8_t> kept_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

}  // namespace

std::vector<std::uint8_t> chosen_pieces(const std::vector<LinePiece>& pieces,
                                        const std::vector<double>& shares, double kept_share) {
    PottsProblem problem;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double against = pieces[i].length_mm * (log_odds(kept_share) - log_odds(shares[i]));
        problem.costs.push_back({0.0, against});  // cost of dropping, of keeping
        for (const int next : pieces[i].neighbours)
            if (next > static_cast<int>(i))
                problem.ties.push_back({static_cast<int>(i), next, tie_mm});
    }
    const std::vector<int> labels = least_energy_labels(problem);
    return {labels.begin(), labels.end()};
}

Mask without_dropped(const Mask& vessels, const std::vector<LinePiece>& pieces,
                     const std::vector<std::uint8_t>& chosen, const Job& job) {
    NearestWall nearest(vessels);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t k = 0; k < pieces[i].points_mm.size(); ++k)
            nearest.begin(pieces[i].points_mm[k], pieces[i].radii_mm[k], chosen[i] != 0);
    const std::vector<std::uint8_t> kept = nearest.grown(job);
    Mask left = vessels;
    for (std::size_t i = 0; i < left.voxels.size(); ++i)
        if (!kept[i]) left.voxels[i] = 0;
    return left;
}

}  // namespace hepatica
