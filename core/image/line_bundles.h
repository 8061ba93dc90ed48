// SPDX-License-Identifier: GPL-3.0-or-later
// Line-by-line filters at the speed of memory: neighbouring lines along one axis are gathered side
// by side, filtered together and written back.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "core/base/job.h"
#include "core/base/parallel.h"
#include "core/image/volume.h"

namespace hepatica {

inline constexpr int line_lanes = 32;
using Lanes = std::array<float, line_lanes>;  // one sample of each of the lines

// The lines along `axis`, in bundles of neighbouring lines. Lanes beyond the border of the image
// keep their previous content.
class LineBundles {
  public:
    LineBundles(FloatVolume& image, int axis)
        : image_(image),
          axis_(axis),
          across_(axis == 0 ? 1 : 0),
          rest_(axis == 2 ? 1 : 2),
          per_row_((image.grid.dims[across_] + line_lanes - 1) / line_lanes),
          strides_{1, static_cast<std::size_t>(image.grid.dims[0]), image.grid.offset(0, 0, 1)} {}

    std::size_t count() const {
        return static_cast<std::size_t>(per_row_) * image_.grid.dims[rest_];
    }
    void load(std::size_t bundle, std::vector<Lanes>& line) const {
        line.resize(image_.grid.dims[axis_]);
        visit(bundle, line, [](const float& voxel, float& sample) { sample = voxel; });
    }
    void store(std::size_t bundle, std::vector<Lanes>& line) const {
        visit(bundle, line, [](float& voxel, const float& sample) { voxel = sample; });
    }

  private:
    template <class Move>
    void visit(std::size_t bundle, std::vector<Lanes>& line, const Move& move) const {
        const int first = static_cast<int>(bundle % per_row_) * line_lanes;
        const int width = std::min(line_lanes, image_.grid.dims[across_] - first);
        float* start =
            image_.voxels.data() + first * strides_[across_] + bundle / per_row_ * strides_[rest_];
        if (axis_ == 0) {  // contiguous in memory: one lane after the other
            for (int l = 0; l < width; ++l)
                for (std::size_t i = 0; i < line.size(); ++i)
                    move(start[l * strides_[1] + i], line[i][l]);
        } else {
            for (std::size_t i = 0; i < line.size(); ++i)
                for (int l = 0; l < width; ++l) move(start[i * strides_[axis_] + l], line[i][l]);
        }
    }

    FloatVolume& image_;
    int axis_;
    int across_;
    int rest_;
    int per_row_;
    std::array<std::size_t, 3> strides_;
};

// Calls filter(line, filtered) for every bundle of `from` along the axis, in parallel, and stores
// `filtered` in the same bundle of `to`, whose lines may have another length. make_filter() makes
// one filter, with its scratch memory, per block of bundles. Reports the progress of this axis as
// the axis-th third of the stage or its part.
template <class MakeFilter>
void filter_lines(FloatVolume& from, FloatVolume& to, int axis, Job& job,
                  const MakeFilter& make_filter) {
    const LineBundles sources(from, axis), targets(to, axis);
    const JobPart part(job, axis / 3.0, (axis + 1) / 3.0);
    std::atomic<std::size_t> done{0};
    constexpr std::size_t block = 16;
    parallel_blocks(sources.count(), block, [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> line, filtered(static_cast<std::size_t>(to.grid.dims[axis]));
        auto filter = make_filter();
        for (std::size_t b = begin; b < end; ++b) {
            sources.load(b, line);
            filter(line, filtered);
            targets.store(b, filtered);
        }
        const std::size_t until_now = done += end - begin;
        job.advance(static_cast<double>(until_now) / static_cast<double>(sources.count()));
    });
}

// The same in place: filter(line) for every bundle.
template <class MakeFilter>
void filter_lines(FloatVolume& image, int axis, Job& job, const MakeFilter& make_filter) {
    filter_lines(image, image, axis, job, [&] {
        return [filter = make_filter()](std::vector<Lanes>& line,
                                        std::vector<Lanes>& filtered) mutable {
            filter(line);
            filtered.swap(line);
        };
    });
}

}  // namespace hepatica
