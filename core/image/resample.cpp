// SPDX-License-Identifier: GPL-3.0-or-later
// Separable interpolation with nearest, linear or Catmull-Rom weights, in parallel over slices.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/image/memory_limit.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

// The neighbours along one axis and their weights.
struct Taps {
    std::array<int, 4> index{};
    std::array<float, 4> weight{};
    int count = 1;
};

Taps taps_at(double position, int size, Interpolation how) {
    const double inside = std::clamp(position, 0.0, static_cast<double>(size - 1));
    Taps taps;
    if (how == Interpolation::nearest) {
        taps.index[0] = static_cast<int>(std::floor(inside + 0.5));
        taps.weight[0] = 1.0f;
        return taps;
    }
    const int base = std::min(static_cast<int>(inside), std::max(0, size - 2));
    const auto t = static_cast<float>(inside - base);
    const auto neighbour = [&](int offset) { return std::clamp(base + offset, 0, size - 1); };
    if (how == Interpolation::linear) {
        taps = {{neighbour(0), neighbour(1), 0, 0}, {1.0f - t, t, 0, 0}, 2};
    } else {
        const float t2 = t * t;
        const float t3 = t2 * t;
        taps.index = {neighbour(-1), neighbour(0), neighbour(1), neighbour(2)};
        taps.weight = {0.5f * (-t3 + 2 * t2 - t), 0.5f * (3 * t3 - 5 * t2 + 2),
                       0.5f * (-3 * t3 + 4 * t2 + t), 0.5f * (t3 - t2)};
        taps.count = 4;
    }
    return taps;
}

template <class T>
float value_at(const Image<T>& image, const Taps& x, const Taps& y, const Taps& z) {
    float sum = 0.0f;
    for (int k = 0; k < z.count; ++k)
        for (int j = 0; j < y.count; ++j) {
            const T* row = image.voxels.data() + image.grid.offset(0, y.index[j], z.index[k]);
            float line = 0.0f;
            for (int i = 0; i < x.count; ++i)
                line += x.weight[i] * static_cast<float>(row[x.index[i]]);
            sum += z.weight[k] * y.weight[j] * line;
        }
    return sum;
}

// Source index of each target voxel: index = first + step * i.
struct IndexMap {
    Vec3 first;
    Mat3 step;
    bool aligned;  // each target axis runs along the source axis of the same number

    IndexMap(const Grid& source, const Grid& target) {
        first = source.to_index(target.origin_mm);
        for (int a = 0; a < 3; ++a)
            step.col(a) = source.to_index(target.to_mm(Vec3::Unit(a))) - first;
        const Mat3 off_axis = step - Mat3(step.diagonal().asDiagonal());
        const Vec3 reach(target.dims[0], target.dims[1], target.dims[2]);
        aligned = (off_axis.cwiseAbs() * reach).maxCoeff() < 1e-6;
    }
};

template <class T, class Finish>
Image<T> resample_image(const Image<T>& source, const Grid& target, Interpolation how, Job& job,
                        const Finish& finish) {
    require_memory(bytes_of(target.dims[0], target.dims[1], target.dims[2], sizeof(T)),
                   "resampled image");
    Image<T> result = filled_image(target, T{}, job);
    const IndexMap map(source.grid, target);
    const Index3& size = source.grid.dims;
    std::vector<Taps> columns;  // for an aligned target, the same for every row
    for (int x = 0; map.aligned && x < target.dims[0]; ++x)
        columns.push_back(taps_at(map.first[0] + x * map.step(0, 0), size[0], how));
    std::atomic<int> done{0};
    parallel_blocks(target.dims[2], 1, [&](std::size_t slice, std::size_t) {
        const int z = static_cast<int>(slice);
        job.advance(static_cast<double>(done++) / target.dims[2]);
        for (int y = 0; y < target.dims[1]; ++y) {
            T* row = &result.at(0, y, z);
            const Vec3 start = map.first + y * map.step.col(1) + z * map.step.col(2);
            Taps across = taps_at(start[1], size[1], how);
            Taps up = taps_at(start[2], size[2], how);
            for (int x = 0; x < target.dims[0]; ++x) {
                if (map.aligned) {
                    row[x] = finish(value_at(source, columns[x], across, up));
                    continue;
                }
                const Vec3 p = start + x * map.step.col(0);
                row[x] = finish(value_at(source, taps_at(p[0], size[0], how),
                                         taps_at(p[1], size[1], how), taps_at(p[2], size[2], how)));
            }
        }
    });
    return result;
}

std::int16_t to_hu(float value) {
    constexpr float low = std::numeric_limits<std::int16_t>::min();
    constexpr float high = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::lround(std::clamp(value, low, high)));
}

// Whether all of a grid's voxels have their centres in another one.
bool covers(const Grid& whole, const Grid& part) {
    for (int corner = 0; corner < 8; ++corner) {
        const auto along = [&](std::size_t a) { return (corner >> a & 1) ? part.dims[a] - 1 : 0; };
        if (!holds(whole, part.to_mm(along(0), along(1), along(2)))) return false;
    }
    return true;
}

}  // namespace

Grid respaced(const Grid& grid, const Vec3& spacing_mm) {
    Grid fine = grid;
    fine.spacing_mm = spacing_mm;
    Vec3 centre_index;
    Vec3 half_steps;
    for (int a = 0; a < 3; ++a) {
        if (!(spacing_mm[a] > 0.0) || !std::isfinite(spacing_mm[a]))
            throw InputError("is " + number_text(spacing_mm[a]), "voxel spacing in mm",
                             "Choose a spacing above 0");
        const double count = std::round(grid.dims[a] * grid.spacing_mm[a] / spacing_mm[a]);
        if (count > 32767.0)
            throw InputError("is " + number_text(spacing_mm[a]) + ", which makes " +
                                 fixed_text(count, 0) + " voxels along an axis",
                             "voxel spacing in mm", "Choose a coarser spacing");
        fine.dims[a] = std::max(1, static_cast<int>(count));
        centre_index[a] = 0.5 * (grid.dims[a] - 1);
        half_steps[a] = 0.5 * (fine.dims[a] - 1);
    }
    fine.origin_mm =
        grid.to_mm(centre_index) - fine.direction * half_steps.cwiseProduct(spacing_mm);
    return fine;
}

Volume resample(const Volume& volume, const Grid& target, Interpolation how, Job& job) {
    return resample_image(volume, target, how, job, to_hu);
}

FloatVolume resample(const FloatVolume& volume, const Grid& target, Interpolation how, Job& job) {
    return resample_image(volume, target, how, job, [](float value) { return value; });
}

Mask resample(const Mask& mask, const Grid& target, Interpolation how, Job& job) {
    // The value of a label must not influence its border.
    Mask inside = filled_image(mask.grid, std::uint8_t{0}, job);
    for_each_voxel(mask.voxels.size(), job,
                   [&](std::size_t i) { inside.voxels[i] = mask.voxels[i] != 0 ? 1 : 0; });
    return resample_image(inside, target, how, job, [](float value) {
        return static_cast<std::uint8_t>(value >= 0.5f ? 1 : 0);
    });
}

Mask resample_within(const Mask& mask, const Grid& target, Job& job) {
    Mask found = resample(mask, target, Interpolation::linear, job);
    if (covers(mask.grid, target)) return found;
    for_each_voxel(found.voxels.size(), job, [&](std::size_t i) {
        if (found.voxels[i] == 0) return;
        const auto [x, y, z] = target.index_of(i);
        if (!holds(mask.grid, target.to_mm(x, y, z))) found.voxels[i] = 0;
    });
    return found;
}

}  // namespace hepatica
