// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the geodesic Voronoi diagram with a priority queue over voxels.
#include "core/tree/territories/nearest_branch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

namespace {

struct Front {
    float travel_mm;
    std::int32_t owner;
    std::size_t voxel;

    bool operator>(const Front& other) const {
        return std::tie(travel_mm, owner, voxel) >
               std::tie(other.travel_mm, other.owner, other.voxel);
    }
};

struct Step {
    Index3 by;
    float length_mm;
};

std::vector<Step> steps_of(const Grid& grid) {
    std::vector<Step> steps;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0 || z != 0)
                    steps.push_back(
                        {{x, y, z},
                         static_cast<float>(grid.spacing_mm.cwiseProduct(Vec3(x, y, z)).norm())});
    return steps;
}

Index3 nearest_index(const Grid& grid, const Vec3& position_mm) {
    const Vec3 index = grid.to_index(position_mm);
    return {static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
            static_cast<int>(std::lround(index.z()))};
}

// Calls visit(point, radius) along a segment, at most step_mm apart. The segment's own points are
// visited exactly, so that branches that begin in one fork tie there.
template <class Visit>
void walk(const VesselSegment& segment, double step_mm, Visit&& visit) {
    visit(segment.points_mm.front(), segment.radii_mm.front());
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        const Vec3 &from = segment.points_mm[i - 1], &to = segment.points_mm[i];
        const int parts = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_mm)));
        for (int k = 1; k < parts; ++k) {
            const double share = static_cast<double>(k) / parts;
            visit(
                Vec3(from + share * (to - from)),
                segment.radii_mm[i - 1] + share * (segment.radii_mm[i] - segment.radii_mm[i - 1]));
        }
        visit(to, segment.radii_mm[i]);
    }
}

class Diagram {
  public:
    Diagram(const Mask& organ, Job& job)
        : organ_(organ),
          job_(job),
          passable_(organ.voxels),
          owner_(organ.grid, no_owner),
          travel_mm_(organ.grid.count(), std::numeric_limits<float>::infinity()),
          steps_(steps_of(organ.grid)) {}

    void open_lumen(const VesselSegment& segment) {
        const Grid& grid = organ_.grid;
        walk(segment, step_mm(), [&](const Vec3& point, double radius_mm) {
            const Index3 middle = nearest_index(grid, point);
            const Vec3 reach = (Vec3::Constant(radius_mm).cwiseQuotient(grid.spacing_mm));
            Index3 low, high;
            for (std::size_t a = 0; a < 3; ++a) {
                const int r = static_cast<int>(reach[static_cast<Eigen::Index>(a)]);
                low[a] = std::max(middle[a] - r, 0);
                high[a] = std::min(middle[a] + r, grid.dims[a] - 1);
            }
            for (int z = low[2]; z <= high[2]; ++z)
                for (int y = low[1]; y <= high[1]; ++y)
                    for (int x = low[0]; x <= high[0]; ++x)
                        if ((grid.to_mm(x, y, z) - point).squaredNorm() <= radius_mm * radius_mm)
                            passable_[grid.offset(x, y, z)] = 1;
        });
    }

    // Starts at the passable voxels less than one voxel from a centreline point along each axis;
    // the nearest one is always passable.
    void begin_at(const VesselSegment& segment, std::int32_t owner) {
        const Grid& grid = organ_.grid;
        walk(segment, step_mm(), [&](const Vec3& point, double) {
            if (const auto [x, y, z] = nearest_index(grid, point); grid.contains(x, y, z))
                passable_[grid.offset(x, y, z)] = 1;
            const Vec3 index = grid.to_index(point);
            const auto first = [&](int a) {
                return static_cast<int>(std::ceil(index[a] - 1.0 - rounding));
            };
            const auto last = [&](int a) {
                return static_cast<int>(std::floor(index[a] + 1.0 + rounding));
            };
            for (int z = first(2); z <= last(2); ++z)
                for (int y = first(1); y <= last(1); ++y)
                    for (int x = first(0); x <= last(0); ++x)
                        if (grid.contains(x, y, z) && passable_[grid.offset(x, y, z)] != 0)
                            offer(grid.offset(x, y, z),
                                  static_cast<float>((grid.to_mm(x, y, z) - point).norm()), owner);
        });
    }

    void spread() {
        const Grid& grid = organ_.grid;
        constexpr std::size_t look = 1 << 8;
        const auto all =
            static_cast<double>(std::ranges::count_if(passable_, [](auto v) { return v != 0; }));
        for (std::size_t popped = 0; !fronts_.empty(); ++popped) {
            const Front front = fronts_.top();
            fronts_.pop();
            if (popped % look == 0)
                job_.advance(std::min(1.0, static_cast<double>(popped) / (all + 1.0)));
            if (front.travel_mm != travel_mm_[front.voxel] || front.owner != owner_at(front.voxel))
                continue;  // a shorter path was found since
            const auto [x, y, z] = grid.index_of(front.voxel);
            for (const Step& step : steps_) {
                const int i = x + step.by[0], j = y + step.by[1], k = z + step.by[2];
                if (!grid.contains(i, j, k)) continue;
                const std::size_t next = grid.offset(i, j, k);
                if (passable_[next] != 0)
                    offer(next, front.travel_mm + step.length_mm, front.owner);
            }
        }
    }

    Image<std::int32_t>& owner() { return owner_; }

  private:
    static constexpr double rounding = 1e-6;  // makes both ends of an axis equivalent

    double step_mm() const { return organ_.grid.spacing_mm.minCoeff() / 3.0; }
    std::int32_t owner_at(std::size_t voxel) const { return owner_.voxels[voxel]; }

    void offer(std::size_t voxel, float travel_mm, std::int32_t owner) {
        const bool nearer = travel_mm < travel_mm_[voxel] ||
                            (travel_mm == travel_mm_[voxel] && owner < owner_at(voxel));
        if (!nearer) return;
        travel_mm_[voxel] = travel_mm;
        owner_.voxels[voxel] = owner;
        fronts_.push({travel_mm, owner, voxel});
    }

    const Mask& organ_;
    Job& job_;
    std::vector<std::uint8_t> passable_;
    Image<std::int32_t> owner_;
    std::vector<float> travel_mm_;
    std::vector<Step> steps_;
    std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts_;
};

// Assigns voxels that no path reaches by straight distance. Where a tree lies far from the organ,
// that is each of its voxels, and each costs a search of the whole tree.
void reach_islands(const Mask& organ, const VesselTree& tree, std::span<const std::int32_t> owners,
                   const Job& job, Image<std::int32_t>& owner) {
    VesselTree owning;
    std::vector<std::int32_t> of_owning;
    for (std::size_t s = 0; s < tree.segments.size(); ++s)
        if (owners[s] != no_owner) {
            owning.segments.push_back(tree.segments[s]);
            of_owning.push_back(owners[s]);
        }
    if (owning.segments.empty()) return;
    const CentrelineLocator locator(owning);
    constexpr double near_mm = 50.0;
    constexpr std::size_t look = 1 << 8;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < organ.voxels.size(); ++i) {
        if (organ.voxels[i] == 0 || owner.voxels[i] != no_owner) continue;
        if (reached++ % look == 0) job.throw_if_cancelled();
        const auto [x, y, z] = organ.grid.index_of(i);
        const Vec3 at_mm = organ.grid.to_mm(x, y, z);
        const auto found = locator.nearest(at_mm, near_mm);
        const int segment = found ? found->segment : nearest_point(owning, at_mm).segment;
        owner.voxels[i] = of_owning[static_cast<std::size_t>(segment)];
    }
}

}  // namespace

Image<std::int32_t> nearest_branch(const Mask& organ, const VesselTree& tree,
                                   std::span<const std::int32_t> owners, Job& job) {
    Diagram diagram(organ, job);
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        job.throw_if_cancelled();
        if (owners[s] != no_owner) diagram.open_lumen(tree.segments[s]);
    }
    for (std::size_t s = 0; s < tree.segments.size(); ++s)
        if (owners[s] != no_owner) diagram.begin_at(tree.segments[s], owners[s]);
    diagram.spread();
    Image<std::int32_t> owner = std::move(diagram.owner());
    for (std::size_t i = 0; i < organ.voxels.size(); ++i)
        if (organ.voxels[i] == 0) owner.voxels[i] = no_owner;
    reach_islands(organ, tree, owners, job, owner);
    return owner;
}

}  // namespace hepatica
