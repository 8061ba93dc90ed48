// SPDX-License-Identifier: GPL-3.0-or-later
// The primal-dual iteration of Chambolle and Pock on the whole grid, in parallel over slices.
#include "core/segmentation/organ_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/parallel.h"

namespace hepatica {

namespace {

constexpr std::size_t slices_a_block = 2;

class Solver {
  public:
    Solver(const BorderCost& cost, const Mask& start)
        : cost_(cost),
          grid_(start.grid),
          inside_(grid_),
          dual_{FloatVolume(grid_), FloatVolume(grid_), FloatVolume(grid_)} {
        for (std::size_t i = 0; i < start.voxels.size(); ++i)
            inside_.voxels[i] = start.voxels[i] != 0 ? 1.0f : 0.0f;
        ahead_ = inside_;
        const double cube_mm = std::cbrt(grid_.spacing_mm.prod());
        float squares = 0.0f;
        for (std::size_t a = 0; a < 3; ++a) {
            stretch_[a] =
                static_cast<float>(cube_mm / grid_.spacing_mm[static_cast<Eigen::Index>(a)]);
            squares += stretch_[a] * stretch_[a];
        }
        step_ =
            0.99f / (2.0f * std::sqrt(squares));  // the norm of the gradient is below 2 |stretch|
    }

    void iterate() {
        each_slice([this](int z) { ascend(z); });
        each_slice([this](int z) { descend(z); });
    }

    const FloatVolume& inside() const { return inside_; }

  private:
    template <class Body>
    void each_slice(const Body& body) {
        parallel_blocks(static_cast<std::size_t>(grid_.dims[2]), slices_a_block,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t z = begin; z < end; ++z) body(static_cast<int>(z));
                        });
    }

    // Gradient ascent of the dual field of one slice, projected onto |p| <= weight of the area.
    void ascend(int z) {
        const auto& [nx, ny, nz] = grid_.dims;
        const std::size_t row = grid_.offset(0, 1, 0), slice = grid_.offset(0, 0, 1);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::size_t i = grid_.offset(x, y, z);
                const float here = ahead_.voxels[i];
                std::array<float, 3> p{dual_[0].voxels[i], dual_[1].voxels[i], dual_[2].voxels[i]};
                if (x + 1 < nx) p[0] += step_ * stretch_[0] * (ahead_.voxels[i + 1] - here);
                if (y + 1 < ny) p[1] += step_ * stretch_[1] * (ahead_.voxels[i + row] - here);
                if (z + 1 < nz) p[2] += step_ * stretch_[2] * (ahead_.voxels[i + slice] - here);
                const float squares = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
                const float most = cost_.area.voxels[i];
                const float scale = squares > most * most ? most / std::sqrt(squares) : 1.0f;
                for (std::size_t a = 0; a < 3; ++a) dual_[a].voxels[i] = scale * p[a];
            }
    }

    // Gradient descent of the primal field of one slice, clamped to [0, 1], with over-relaxation.
    void descend(int z) {
        const auto& [nx, ny, nz] = grid_.dims;
        const std::size_t row = grid_.offset(0, 1, 0), slice = grid_.offset(0, 0, 1);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::size_t i = grid_.offset(x, y, z);
                const auto change = [&](std::size_t a, int at, std::size_t back) {
                    const FloatVolume& dual = dual_[a];
                    return stretch_[a] * (dual.voxels[i] - (at > 0 ? dual.voxels[i - back] : 0.0f));
                };
                const float divergence = change(0, x, 1) + change(1, y, row) + change(2, z, slice);
                const float moved = std::clamp(
                    inside_.voxels[i] + step_ * (divergence - cost_.inside.voxels[i]), 0.0f, 1.0f);
                ahead_.voxels[i] = 2.0f * moved - inside_.voxels[i];
                inside_.voxels[i] = moved;
            }
    }

    const BorderCost& cost_;
    Grid grid_;
    FloatVolume inside_, ahead_;
    std::array<FloatVolume, 3> dual_;
    std::array<float, 3> stretch_{};
    float step_ = 0.0f;
};

}  // namespace

Mask fit_border(const BorderCost& cost, const Mask& start, int iterations, Job& job) {
    Solver solver(cost, start);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        job.throw_if_cancelled();
        solver.iterate();
    }
    Mask organ(start.grid);
    for (std::size_t i = 0; i < organ.voxels.size(); ++i)
        organ.voxels[i] = solver.inside().voxels[i] > 0.5f;
    return organ;
}

}  // namespace hepatica
