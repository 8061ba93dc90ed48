// SPDX-License-Identifier: GPL-3.0-or-later
// Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", Theory of Computing
// 8:415 (2012): exact squared distances, one axis after the other, as lower envelopes of parabolas.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/line_bundles.h"
#include "core/image/morphology.h"

namespace hepatica {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Scratch memory of one line.
struct Envelope {
    std::vector<double> value;   // squared distance before
    std::vector<int> apex;       // of the parabolas in the envelope
    std::vector<double> border;  // where each parabola begins to be the lowest

    explicit Envelope(std::size_t n) : value(n), apex(n), border(n) {}

    // Replaces sample i of one lane by the least over j of sample j + (spacing (i - j))^2.
    void transform(std::vector<Lanes>& line, int lane, double spacing) {
        const int n = static_cast<int>(line.size());
        int count = 0;
        const double square = spacing * spacing;
        for (int i = 0; i < n; ++i) {
            value[i] = static_cast<double>(line[i][lane]);
            if (value[i] == infinite) continue;
            double begin = -infinite;
            while (count > 0) {
                const int j = apex[count - 1];
                begin = 0.5 * ((value[i] - value[j]) / (square * (i - j)) + i + j);
                if (begin > border[count - 1]) break;
                --count;
                begin = -infinite;
            }
            apex[count] = i;
            border[count] = begin;
            ++count;
        }
        if (count == 0) return;
        int k = 0;
        for (int i = 0; i < n; ++i) {
            while (k + 1 < count && border[k + 1] < i) ++k;
            const double steps = i - apex[k];
            line[i][lane] = static_cast<float>(value[apex[k]] + square * steps * steps);
        }
    }
};

// Squared distance to the nearest voxel whose object state is `wanted`.
FloatVolume squared_distance(const Mask& mask, bool wanted, Job& job) {
    FloatVolume squares(mask.grid);
    parallel_blocks(mask.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            squares.voxels[i] = (mask.voxels[i] != 0) == wanted ? 0.0f : infinite;
    });
    for (int axis = 0; axis < 3; ++axis)
        filter_lines(squares, axis, job, [&, n = mask.grid.dims[axis]] {
            return [&, envelope = Envelope(n)](std::vector<Lanes>& line) mutable {
                for (int lane = 0; lane < line_lanes; ++lane)
                    envelope.transform(line, lane, mask.grid.spacing_mm[axis]);
            };
        });
    return squares;
}

template <class Change>
void change_each(FloatVolume& image, const Change& change) {
    parallel_blocks(image.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) change(image.voxels[i], i);
    });
}

// Voxels whose squared distance is at most (or more than) the radius squared.
Mask threshold(const FloatVolume& squares, double radius_mm, bool within) {
    // Sums of squares of spacings are rounded: a voxel at exactly the radius belongs to the ball.
    const double limit = radius_mm * radius_mm * (1.0 + 1e-6);
    Mask mask(squares.grid);
    parallel_blocks(mask.voxels.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
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
    return threshold(squared_distance(mask, true, job), radius_mm, true);
}

Mask erode(const Mask& mask, double radius_mm, Job& job) {
    return threshold(squared_distance(mask, false, job), radius_mm, false);
}

Mask close(const Mask& mask, double radius_mm, Job& job) {
    // On a grid wide enough to hold the dilated mask with background around it.
    Grid room = mask.grid;
    IndexBox image;
    for (int a = 0; a < 3; ++a) {
        image.begin[a] = static_cast<int>(std::ceil(radius_mm / room.spacing_mm[a])) + 1;
        image.end[a] = image.begin[a] + mask.grid.dims[a];
        room.dims[a] = image.end[a] + image.begin[a];
    }
    room.origin_mm = mask.grid.to_mm(-image.begin[0], -image.begin[1], -image.begin[2]);
    Mask whole(room);
    for (int z = 0; z < mask.grid.dims[2]; ++z)
        for (int y = 0; y < mask.grid.dims[1]; ++y)
            std::copy_n(&mask.at(0, y, z), mask.grid.dims[0],
                        &whole.at(image.begin[0], y + image.begin[1], z + image.begin[2]));
    Mask closed = crop(erode(dilate(whole, radius_mm, job), radius_mm, job), image);
    closed.grid = mask.grid;  // to the bit
    return closed;
}

Mask open(const Mask& mask, double radius_mm, Job& job) {
    return dilate(erode(mask, radius_mm, job), radius_mm, job);
}

}  // namespace hepatica
