// SPDX-License-Identifier: GPL-3.0-or-later
// Fast marching on a grid with anisotropic spacing: a priority queue of arrivals and the upwind
// quadratic of Sethian, O(n log n) in the number of voxels reached.
#include "core/segmentation/fast_marching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "core/base/parallel.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// One front on one grid. Voxels that are set before the march are its starting values. Voxels are
// settled in the order of their arrival, ties by index, so the result is deterministic.
class Front {
  public:
    Front(const Grid& grid, MarchingOrder order)
        : grid_(grid), order_(order), time_(grid, never), known_(grid.count(), 0) {
        stride_ = {1, static_cast<std::size_t>(grid.dims[0]),
                   static_cast<std::size_t>(grid.dims[0]) * static_cast<std::size_t>(grid.dims[1])};
    }

    void set(std::size_t voxel, float time) {
        time_.voxels[voxel] = time;
        queue_.push({time, voxel});
    }

    // slowness(voxel) = 1 / speed; infinity closes the voxel. `expected`: number of voxels, for the
    // progress only.
    template <class Slowness>
    void march(const Slowness& slowness, std::size_t expected, Job& job) {
        std::size_t arrived = 0;
        while (!queue_.empty()) {
            const Arrival next = queue_.top();
            queue_.pop();
            if (known_[next.voxel]) continue;
            known_[next.voxel] = 1;
            if (++arrived % 16384 == 0)
                job.advance(
                    std::min(1.0, static_cast<double>(arrived) /
                                      static_cast<double>(std::max<std::size_t>(expected, 1))));
            const Index3 at = grid_.index_of(next.voxel);
            for (int axis = 0; axis < 3; ++axis)
                for (const int side : {-1, 1}) {
                    const int moved = at[static_cast<std::size_t>(axis)] + side;
                    if (moved < 0 || moved >= grid_.dims[static_cast<std::size_t>(axis)]) continue;
                    const std::size_t voxel =
                        side < 0 ? next.voxel - stride_[static_cast<std::size_t>(axis)]
                                 : next.voxel + stride_[static_cast<std::size_t>(axis)];
                    if (known_[voxel]) continue;
                    const float s = slowness(voxel);
                    if (!std::isfinite(s)) continue;
                    const float time = solve(voxel, s);
                    if (time < time_.voxels[voxel]) set(voxel, time);
                }
        }
    }

    // The arrival times; infinity where the front did not come.
    FloatVolume take() { return std::move(time_); }

  private:
    struct Arrival {
        float time;
        std::size_t voxel;
        bool operator<(const Arrival& other) const {  // the earliest on top
            return time != other.time ? time > other.time : voxel > other.voxel;
        }
    };
    // weight (T - value)^2 is the contribution of one axis to |grad T|^2.
    struct Term {
        double value;
        double weight;
    };

    float value_if_known(std::size_t voxel) const {
        return known_[voxel] ? time_.voxels[voxel] : never;
    }

    // The upwind term of one axis; false where neither neighbour has been reached.
    bool upwind(std::size_t voxel, const Index3& at, std::size_t axis, Term& term) const {
        const std::size_t step = stride_[axis];
        const float before = at[axis] > 0 ? value_if_known(voxel - step) : never;
        const float after = at[axis] + 1 < grid_.dims[axis] ? value_if_known(voxel + step) : never;
        const bool from_before = before <= after;
        const float near = from_before ? before : after;
        if (near == never) return false;
        const double h = grid_.spacing_mm[static_cast<Eigen::Index>(axis)];
        term = {near, 1.0 / (h * h)};
        if (order_ == MarchingOrder::first) return true;
        const bool inside = from_before ? at[axis] > 1 : at[axis] + 2 < grid_.dims[axis];
        if (!inside) return true;
        const float far = value_if_known(from_before ? voxel - 2 * step : voxel + 2 * step);
        // Second order: (3 T - 4 near + far) / 2h, used only where the front came along the axis.
        if (far <= near) term = {(4.0 * near - far) / 3.0, 9.0 / (4.0 * h * h)};
        return true;
    }

    float solve(std::size_t voxel, double slowness) const {
        const Index3 at = grid_.index_of(voxel);
        std::array<Term, 3> terms{};
        std::size_t count = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Term term{};
            if (!upwind(voxel, at, axis, term)) continue;
            std::size_t place = count++;  // sorted by value
            for (; place > 0 && term.value < terms[place - 1].value; --place)
                terms[place] = terms[place - 1];
            terms[place] = term;
        }
        // Solves sum of weight (T - value)^2 = slowness^2, adding the axes in the order of their
        // values as long as T is above the next one.
        double a = 0.0;
        double b = 0.0;
        double c = -slowness * slowness;
        double time = never;
        for (std::size_t k = 0; k < count; ++k) {
            if (time <= terms[k].value) break;
            a += terms[k].weight;
            b += terms[k].weight * terms[k].value;
            c += terms[k].weight * terms[k].value * terms[k].value;
            const double root = b * b - a * c;
            if (root < 0.0) break;
            time = (b + std::sqrt(root)) / a;
        }
        return static_cast<float>(time);
    }

    Grid grid_;
    MarchingOrder order_;
    FloatVolume time_;
    std::vector<std::uint8_t> known_;
    std::array<std::size_t, 3> stride_{};
    std::priority_queue<Arrival> queue_;
};

// Distance to the plane that crosses the axes gap[axis] mm away (infinity: it does not cross that
// axis).
float distance_to_plane(const std::array<double, 3>& gap) {
    double sum = 0.0;
    for (const double g : gap) sum += 1.0 / (g * g);
    return static_cast<float>(1.0 / std::sqrt(sum));
}

// Marches from the boundary of the object inwards; gap_to(voxel, neighbour, spacing) is the
// distance in mm from the voxel to the boundary, towards a neighbour outside the object.
template <class Inside, class Gap>
FloatVolume march_inwards(const Grid& grid, MarchingOrder order, const Inside& inside,
                          const Gap& gap_to, Job& job) {
    Front front(grid, order);
    std::size_t objects = 0;
    std::size_t voxel = 0;
    const std::array<std::size_t, 3> stride{
        1, static_cast<std::size_t>(grid.dims[0]),
        static_cast<std::size_t>(grid.dims[0]) * static_cast<std::size_t>(grid.dims[1])};
    for (int z = 0; z < grid.dims[2]; ++z) {
        job.throw_if_cancelled();
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x, ++voxel) {
                if (!inside(voxel)) continue;
                ++objects;
                const Index3 at{x, y, z};
                std::array<double, 3> gap;
                gap.fill(std::numeric_limits<double>::infinity());
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double h = grid.spacing_mm[static_cast<Eigen::Index>(axis)];
                    const auto look = [&](bool exists, std::size_t neighbour) {
                        if (!exists || inside(neighbour)) return;
                        gap[axis] = std::min(gap[axis], gap_to(voxel, neighbour, h));
                    };
                    look(at[axis] > 0, voxel - stride[axis]);
                    look(at[axis] + 1 < grid.dims[axis], voxel + stride[axis]);
                }
                const double nearest = *std::ranges::min_element(gap);
                if (std::isfinite(nearest)) front.set(voxel, distance_to_plane(gap));
            }
    }
    front.march([&](std::size_t i) { return inside(i) ? 1.0f : never; }, objects, job);
    FloatVolume distance = front.take();
    for_each_voxel(distance.voxels.size(), job, [&](std::size_t i) {
        if (distance.voxels[i] == never) distance.voxels[i] = 0.0f;
    });
    return distance;
}

}  // namespace

FloatVolume distance_from_boundary(const Mask& object, MarchingOrder order, Job& job) {
    return march_inwards(
        object.grid, order, [&](std::size_t i) { return object.voxels[i] != 0; },
        [](std::size_t, std::size_t, double spacing) { return 0.5 * spacing; }, job);
}

FloatVolume distance_from_level_set(const FloatVolume& level, MarchingOrder order, Job& job) {
    const auto gap = [&](std::size_t inner, std::size_t outer, double spacing) {
        const double a = level.voxels[inner];
        const double b = level.voxels[outer];
        return std::max(1e-6, spacing * a / (a - b));
    };
    return march_inwards(
        level.grid, order, [&](std::size_t i) { return level.voxels[i] > 0.0f; }, gap, job);
}

FloatVolume arrival_times(const FloatVolume& speed, const std::vector<std::size_t>& starts,
                          MarchingOrder order, Job& job) {
    Front front(speed.grid, order);
    for (const std::size_t start : starts) front.set(start, 0.0f);
    front.march(
        [&](std::size_t i) { return speed.voxels[i] > 0.0f ? 1.0f / speed.voxels[i] : never; },
        speed.grid.count(), job);
    return front.take();
}

Mask front_collisions(const FloatVolume& distance, double slope) {
    const Grid& grid = distance.grid;
    Mask collisions(grid);
    const std::array<std::size_t, 3> stride{
        1, static_cast<std::size_t>(grid.dims[0]),
        static_cast<std::size_t>(grid.dims[0]) * static_cast<std::size_t>(grid.dims[1])};
    parallel_blocks(
        static_cast<std::size_t>(grid.dims[2]), 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin * stride[2]; i < end * stride[2]; ++i) {
                const float here = distance.voxels[i];
                if (here <= 0.0f) continue;
                const Index3 at = grid.index_of(i);
                double squared = 0.0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (grid.dims[axis] == 1) continue;
                    // One-sided at the boundary, because the distance outside is 0 and not
                    // negative.
                    const auto value = [&](bool exists, std::size_t neighbour) {
                        return exists ? distance.voxels[neighbour] : 0.0f;
                    };
                    const float before = value(at[axis] > 0, i - stride[axis]);
                    const float after = value(at[axis] + 1 < grid.dims[axis], i + stride[axis]);
                    const double h = grid.spacing_mm[static_cast<Eigen::Index>(axis)];
                    double d = 0.0;
                    if (before > 0.0f && after > 0.0f)
                        d = (after - before) / (2.0 * h);
                    else if (before > 0.0f || after > 0.0f)
                        d = (std::max(before, after) - here) / h;
                    squared += d * d;
                }
                if (squared < slope * slope) collisions.voxels[i] = 1;
            }
        });
    return collisions;
}

}  // namespace hepatica
