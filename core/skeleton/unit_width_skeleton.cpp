// SPDX-License-Identifier: GPL-3.0-or-later
// Crowded regions by flood fill, their centre, and A* paths from the centre to the exits.
#include "core/skeleton/unit_width_skeleton.h"

#include <algorithm>
#include <concepts>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "core/skeleton/padded_object.h"
#include "core/skeleton/simple_point.h"

namespace hepatica {

namespace {

using Voxels = std::vector<std::size_t>;

double squared_distance(const Index3& a, const Index3& b) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += static_cast<double>(a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

// Degrees, crowded regions, centres and paths on a skeleton.
class Valence {
  public:
    explicit Valence(PaddedObject& object) : object_(object), steps_(object.neighbour_steps()) {}

    int degree_of(std::size_t p) const { return degree(object_.neighbourhood(p)); }

    bool crowded(std::size_t p) const {
        return degree_of(p) > 2 && std::ranges::any_of(steps_, [&](std::ptrdiff_t step) {
                   return object_.contains(p + step) && degree_of(p + step) > 2;
               });
    }

    // The 26-connected components of the crowded points, each ascending, in the order of their
    // first voxel.
    std::vector<Voxels> regions(const Voxels& skeleton) {
        Voxels crowded_points;
        std::ranges::copy_if(skeleton, std::back_inserter(crowded_points),
                             [&](std::size_t p) { return crowded(p); });
        for (const std::size_t p : crowded_points) object_.mark(p);
        std::vector<Voxels> found;
        for (const std::size_t p : crowded_points)
            if (object_.marked(p)) found.push_back(flood(p));
        return found;
    }

    // Skeleton voxels of degree 2 or less that touch the region, ascending.
    Voxels exits(const Voxels& region) const {
        Voxels found;
        for (const std::size_t p : region)
            for (const std::ptrdiff_t step : steps_)
                if (object_.contains(p + step) && degree_of(p + step) <= 2)
                    found.push_back(p + step);
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    // The voxel that minimises the sum of squared distances to the region's voxels, divided by its
    // degree; ties by the first.
    std::size_t centre(const Voxels& region) const {
        std::vector<Index3> places;
        for (const std::size_t p : region) places.push_back(object_.index_in_mask(p));
        // Sum of |p - q|^2 over q = n |p|^2 - 2 p . sum q + sum |q|^2, all exact integers.
        std::array<double, 3> sum{0, 0, 0};
        double squares = 0.0;
        for (const Index3& q : places) {
            for (int a = 0; a < 3; ++a) sum[a] += q[a];
            squares += squared_distance(q, {0, 0, 0});
        }
        std::size_t best = 0;
        double best_score = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Index3& p = places[i];
            const double cross = p[0] * sum[0] + p[1] * sum[1] + p[2] * sum[2];
            const double distances =
                static_cast<double>(region.size()) * squared_distance(p, {0, 0, 0}) - 2.0 * cross +
                squares;
            const double score = distances / degree_of(region[i]);
            if (score < best_score) {
                best_score = score;
                best = i;
            }
        }
        return region[best];
    }

    // Shortest paths from `from` to each exit through the region's voxels (A*, Euclidean step
    // lengths in voxels, ties by voxel). Empty where an exit cannot be reached.
    std::vector<Voxels> shortest_paths(std::size_t from, const Voxels& exits, const Voxels& region,
                                       const Job& job) {
        for (const std::size_t p : region) object_.mark(p);
        std::vector<Voxels> paths;
        for (const std::size_t exit : exits) {
            job.throw_if_cancelled();  // in a skeleton of noise one region may hold most of it
            paths.push_back(shortest_path(from, exit));
        }
        for (const std::size_t p : region) object_.unmark(p);
        return paths;
    }

  private:
    Voxels shortest_path(std::size_t from, std::size_t exit) const;

    Voxels flood(std::size_t start) {
        Voxels found{start};
        object_.unmark(start);
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const std::ptrdiff_t step : steps_) {
                const std::size_t q = found[i] + step;
                if (!object_.marked(q)) continue;
                object_.unmark(q);
                found.push_back(q);
            }
        std::ranges::sort(found);
        return found;
    }

    PaddedObject& object_;
    std::array<std::ptrdiff_t, 26> steps_;
};

// Through marked voxels.
Voxels Valence::shortest_path(std::size_t from, std::size_t exit) const {
    struct Reached {
        double length;
        std::size_t before;
        bool closed;
    };
    using Open = std::tuple<double, std::size_t>;  // estimated total length, voxel
    std::map<std::size_t, Reached> reached;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    const Index3 goal = object_.index_in_mask(exit);
    const auto estimate = [&](std::size_t p) {
        return std::sqrt(squared_distance(object_.index_in_mask(p), goal));
    };
    const auto allowed = [&](std::size_t q) { return q == exit || object_.marked(q); };
    reached[from] = {0.0, from, false};
    open.emplace(estimate(from), from);
    while (!open.empty()) {
        const std::size_t p = std::get<1>(open.top());
        open.pop();
        Reached& here = reached[p];
        if (here.closed) continue;
        here.closed = true;
        if (p == exit) break;
        for (const std::ptrdiff_t step : steps_) {
            const std::size_t q = p + step;
            if (!allowed(q)) continue;
            const double length =
                here.length +
                std::sqrt(squared_distance(object_.index_in_mask(p), object_.index_in_mask(q)));
            const auto [entry, is_new] = reached.try_emplace(q);
            if (!is_new && (entry->second.closed || entry->second.length <= length)) continue;
            entry->second = {length, p, false};
            open.emplace(length + estimate(q), q);
        }
    }
    if (!reached.contains(exit)) return {};
    Voxels path{exit};
    while (path.back() != from) path.push_back(reached[path.back()].before);
    std::ranges::reverse(path);
    return path;
}

// Deletes removable voxels among `voxels` until none is left; those with keep(p) stay.
template <class Keep>
void delete_removable(PaddedObject& object, const Voxels& voxels, const Keep& keep) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::size_t p : voxels) {
            if (!object.contains(p) || keep(p) || !is_deletable(object.neighbourhood(p))) continue;
            object.remove(p);
            changed = true;
        }
    }
}

CrowdedRegion in_mask_offsets(const PaddedObject& object, CrowdedRegion region) {
    const auto convert = [&](Voxels& voxels) {
        for (std::size_t& p : voxels) p = object.offset_in_mask(p);
    };
    convert(region.voxels);
    convert(region.exits);
    for (Voxels& path : region.paths) convert(path);
    region.centre = object.offset_in_mask(region.centre);
    return region;
}

std::size_t count_of(const Voxels& voxels, const std::predicate<std::size_t> auto& counts) {
    return static_cast<std::size_t>(std::ranges::count_if(voxels, counts));
}

}  // namespace

UnitWidthStages unit_width_stages(const Mask& skeleton, Job& job) {
    UnitWidthStages stages;
    PaddedObject object(skeleton);
    const Voxels voxels = object.object_voxels();
    Valence valence(object);
    // All regions are measured on the original skeleton, before any voxel is deleted.
    std::vector<CrowdedRegion> regions;
    std::vector<Voxels> crowded_regions = valence.regions(voxels);
    const auto count = static_cast<double>(crowded_regions.size());
    for (Voxels& crowded : crowded_regions) {
        job.advance(0.5 * static_cast<double>(regions.size()) / count);
        CrowdedRegion region;
        region.exits = valence.exits(crowded);
        region.centre = valence.centre(crowded);
        region.paths = valence.shortest_paths(region.centre, region.exits, crowded, job);
        region.voxels = std::move(crowded);
        regions.push_back(std::move(region));
    }
    for (std::size_t i = 0; i < regions.size(); ++i) {
        job.advance(0.5 + 0.5 * static_cast<double>(i) / count);
        Voxels kept{regions[i].centre};
        for (const Voxels& path : regions[i].paths)
            kept.insert(kept.end(), path.begin(), path.end());
        std::ranges::sort(kept);
        delete_removable(object, regions[i].voxels,
                         [&](std::size_t p) { return std::ranges::binary_search(kept, p); });
        stages.regions.push_back(in_mask_offsets(object, regions[i]));
    }
    delete_removable(object, voxels, [](std::size_t) { return false; });
    stages.skeleton = object.empty() ? Mask(skeleton.grid) : object.to_mask();
    job.advance(1.0);
    return stages;
}

Mask unit_width(const Mask& skeleton, Job& job) {
    return unit_width_stages(skeleton, job).skeleton;
}

std::size_t crowded_point_count(const Mask& skeleton) {
    PaddedObject object(skeleton);
    const Valence valence(object);
    return count_of(object.object_voxels(), [&](std::size_t p) { return valence.crowded(p); });
}

std::size_t removable_point_count(const Mask& skeleton) {
    const PaddedObject object(skeleton);
    return count_of(object.object_voxels(),
                    [&](std::size_t p) { return is_deletable(object.neighbourhood(p)); });
}

}  // namespace hepatica
