// SPDX-License-Identifier: GPL-3.0-or-later
// Exact Euclidean distance transforms and the morphology based on them. Felzenszwalb and
// Huttenlocher, "Distance transforms of sampled functions", Theory of Computing 8:415 (2012):
// squared distances, one axis after the other, as lower envelopes of parabolas. Linear in the
// voxels.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/line_bundles.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Sums of squared spacings are rounded; the tolerance includes voxels at exactly the radius.
double squared_limit(double radius_mm) {
    return radius_mm * radius_mm * (1.0 + 1e-6);
}

// One row of a mask: for each place the squared distance to the nearest voxel of the row whose
// state is `wanted`. The places begin `first` voxels after the row's first voxel and may lie
// outside the row.
void row_distances(std::span<const std::uint8_t> row, bool wanted, int first, double square,
                   std::span<float> places) {
    const int size = static_cast<int>(row.size()), count = static_cast<int>(places.size());
    constexpr int none = std::numeric_limits<int>::max() / 4;
    const auto is_wanted = [&](int at) { return at >= 0 && at < size && (row[at] != 0) == wanted; };
    const auto squared = [&](int steps) {
        return steps >= none / 2 ? infinite : static_cast<float>(square * steps * steps);
    };
    int last = -none;
    for (int at = std::min(first, 0); at < first + count; ++at) {
        if (is_wanted(at)) last = at;
        if (at >= first) places[at - first] = squared(at - last);
    }
    int next = none;
    for (int at = std::max(first + count, size) - 1; at >= first; --at) {
        if (is_wanted(at)) next = at;
        if (at < first + count)
            places[at - first] = std::min(places[at - first], squared(next - at));
    }
}

// The lower envelope of the parabolas of one line; holds its scratch memory.
class Envelope {
  public:
    Envelope(std::size_t size, double most)
        : value_(size), apex_(size), border_(size + 1), most_(most) {}

    // In one lane, place k becomes the minimum over j of sample j + (spacing (first + k - j))^2.
    // Samples above `most` may count as infinite.
    void transform(const std::vector<Lanes>& line, int lane, double spacing, int first,
                   std::vector<Lanes>& places) {
        const double square = spacing * spacing;
        const int count = lowest(line, lane, square);
        const int size = static_cast<int>(line.size());
        int k = 0;
        for (std::size_t p = 0; p < places.size(); ++p) {
            const int at = first + static_cast<int>(p);
            float& place = places[p][lane];
            if (count == 0) {
                place = infinite;
            } else if (at >= 0 && at < size && value_[at] == 0.0) {
                place = 0.0f;
            } else {
                while (k + 1 < count && border_[k + 1] < at) ++k;
                const double steps = at - apex_[k];
                place = static_cast<float>(value_[apex_[k]] + square * steps * steps);
            }
        }
    }

  private:
    // Finds the parabolas of the envelope, in order; returns their number. A parabola with apex 0
    // between two neighbours with apex 0 is lowest only at its own apex and is left out;
    // transform() handles such places directly.
    int lowest(const std::vector<Lanes>& line, int lane, double square) {
        const int size = static_cast<int>(line.size());
        for (int i = 0; i < size; ++i) {
            const float sample = line[i][lane];
            value_[i] =
                static_cast<double>(sample) > most_ ? infinite : static_cast<double>(sample);
        }
        int count = 0;
        for (int i = 0; i < size; ++i) {
            if (value_[i] == infinite) continue;
            if (i > 0 && i + 1 < size && value_[i] == 0.0 && value_[i - 1] == 0.0 &&
                value_[i + 1] == 0.0)
                continue;
            double begin = -infinite;
            while (count > 0) {
                const int j = apex_[count - 1];
                begin = 0.5 * ((value_[i] - value_[j]) / (square * (i - j)) + i + j);
                if (begin > border_[count - 1]) break;
                --count;
                begin = -infinite;
            }
            apex_[count] = i;
            border_[count] = begin;
            ++count;
        }
        return count;
    }

    std::vector<double> value_;   // squared distance before this axis
    std::vector<int> apex_;       // of the parabolas in the envelope
    std::vector<double> border_;  // where each parabola becomes the lowest
    double most_;
};

// Squared distances on a grid whose first voxel has the index `first` in the mask.
struct PlacedSquares {
    Index3 first{0, 0, 0};
    FloatVolume squares;
};

// The transform along one axis, for the places from `begin` to `end` in indices of the mask.
PlacedSquares transformed(PlacedSquares before, int axis, int begin, int end, double most,
                          Job& job) {
    const Grid& old = before.squares.grid;
    const double spacing = old.spacing_mm[axis];
    const int first = begin - before.first[axis];
    const auto make_filter = [&, size = static_cast<std::size_t>(old.dims[axis])] {
        return [&, envelope = Envelope(size, most)](const std::vector<Lanes>& line,
                                                    std::vector<Lanes>& places) mutable {
            for (int lane = 0; lane < line_lanes; ++lane)
                envelope.transform(line, lane, spacing, first, places);
        };
    };
    if (first == 0 && end - begin == old.dims[axis]) {
        filter_lines(before.squares, before.squares, axis, job, make_filter);
        return before;
    }
    PlacedSquares after{before.first, {}};
    after.first[axis] = begin;
    Grid grid = old;
    grid.dims[axis] = end - begin;
    after.squares = filled_image(grid, 0.0f, job);
    filter_lines(before.squares, after.squares, axis, job, make_filter);
    return after;
}

// The distances along x, in the rows of `rows`, from where.begin[0] to where.end[0].
PlacedSquares squares_in_rows(const Mask& mask, bool wanted, const IndexBox& where,
                              const IndexBox& rows, Job& job) {
    PlacedSquares placed{{where.begin[0], rows.begin[1], rows.begin[2]}, {}};
    Grid grid = mask.grid;
    grid.dims = {where.end[0] - where.begin[0], rows.end[1] - rows.begin[1],
                 rows.end[2] - rows.begin[2]};
    placed.squares = filled_image(grid, 0.0f, job);
    const double square = grid.spacing_mm[0] * grid.spacing_mm[0];
    parallel_blocks(grid.dims[2], 1, [&](std::size_t slice, std::size_t) {
        job.throw_if_cancelled();
        const int z = static_cast<int>(slice);
        for (int y = 0; y < grid.dims[1]; ++y)
            row_distances({&mask.at(0, rows.begin[1] + y, rows.begin[2] + z),
                           static_cast<std::size_t>(mask.grid.dims[0])},
                          wanted, where.begin[0], square,
                          {&placed.squares.at(0, y, z), static_cast<std::size_t>(grid.dims[0])});
    });
    return placed;
}

IndexBox whole(const Grid& grid) {
    return {{0, 0, 0}, grid.dims};
}

// The box widened on each side by enough voxels to cover the distance; not clipped.
IndexBox widened(const IndexBox& box, const Grid& grid, double distance_mm) {
    IndexBox wide;
    for (int a = 0; a < 3; ++a) {
        const int voxels = static_cast<int>(std::ceil(distance_mm / grid.spacing_mm[a])) + 1;
        wide.begin[a] = box.begin[a] - voxels;
        wide.end[a] = box.end[a] + voxels;
    }
    return wide;
}

IndexBox common(const IndexBox& a, const IndexBox& b) {
    IndexBox both;
    for (int axis = 0; axis < 3; ++axis) {
        both.begin[axis] = std::max(a.begin[axis], b.begin[axis]);
        both.end[axis] = std::max(both.begin[axis], std::min(a.end[axis], b.end[axis]));
    }
    return both;
}

// Squared distance to the nearest voxel whose object state is `wanted`, for the places of a box of
// indices that may reach beyond the mask. Exact up to most_mm squared; larger ones are at least
// that.
FloatVolume squared_distance(const Mask& mask, bool wanted, const IndexBox& where, double most_mm,
                             Job& job) {
    const double most = squared_limit(most_mm);
    IndexBox rows = whole(mask.grid);
    if (std::isfinite(most_mm)) rows = common(rows, widened(where, mask.grid, most_mm));
    PlacedSquares placed = squares_in_rows(mask, wanted, where, rows, job);
    for (int axis = 1; axis < 3; ++axis)
        placed =
            transformed(std::move(placed), axis, where.begin[axis], where.end[axis], most, job);
    placed.squares.grid.origin_mm = mask.grid.to_mm(where.begin[0], where.begin[1], where.begin[2]);
    return std::move(placed.squares);
}

FloatVolume squared_distance(const Mask& mask, bool wanted, Job& job) {
    return squared_distance(mask, wanted, whole(mask.grid), infinite, job);
}

template <class Change>
void change_each(FloatVolume& image, const Change& change) {
    parallel_blocks(image.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) change(image.voxels[i], i);
    });
}

// Voxels whose squared distance is at most (`within`) or more than the radius squared.
Mask threshold(const FloatVolume& squares, double radius_mm, bool within, Job& job) {
    const double limit = squared_limit(radius_mm);
    Mask mask(squares.grid);
    parallel_blocks(mask.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
        job.throw_if_cancelled();
        for (std::size_t i = begin; i < end; ++i)
            mask.voxels[i] = (squares.voxels[i] <= limit) == within ? 1 : 0;
    });
    return mask;
}

}  // namespace

FloatVolume distance_to(const Mask& object, Job& job) {
    FloatVolume distance = squared_distance(object, true, job);
    change_each(distance, [](float& d, std::size_t) { d = std::sqrt(d); });
    return distance;
}

FloatVolume signed_distance(const Mask& object, Job& job) {
    FloatVolume distance = distance_to(object, job);
    FloatVolume inside = squared_distance(object, false, job);
    change_each(distance, [&](float& d, std::size_t i) {
        if (object.voxels[i] != 0) d = -std::sqrt(inside.voxels[i]);
    });
    return distance;
}

Mask dilate(const Mask& mask, double radius_mm, Job& job) {
    return threshold(squared_distance(mask, true, whole(mask.grid), radius_mm, job), radius_mm,
                     true, job);
}

Mask erode(const Mask& mask, double radius_mm, Job& job) {
    return threshold(squared_distance(mask, false, whole(mask.grid), radius_mm, job), radius_mm,
                     false, job);
}

Mask close(const Mask& mask, double radius_mm, Job& job) {
    return close_in(mask, radius_mm, whole(mask.grid), job);
}

Mask close_in(const Mask& mask, double radius_mm, const IndexBox& where, Job& job) {
    const Grid part = crop(mask.grid, where);  // clipped; throws InputError if empty
    const IndexBox box = common(where, whole(mask.grid));
    const IndexBox room = widened(box, mask.grid, radius_mm);
    const Mask dilated =
        threshold(squared_distance(mask, true, room, radius_mm, job), radius_mm, true, job);
    IndexBox in_room;
    for (int a = 0; a < 3; ++a) {
        in_room.begin[a] = box.begin[a] - room.begin[a];
        in_room.end[a] = box.end[a] - room.begin[a];
    }
    Mask closed =
        threshold(squared_distance(dilated, false, in_room, radius_mm, job), radius_mm, false, job);
    closed.grid = part;
    return closed;
}

Mask open(const Mask& mask, double radius_mm, Job& job) {
    return dilate(erode(mask, radius_mm, job), radius_mm, job);
}

}  // namespace hepatica
