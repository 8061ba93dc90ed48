// SPDX-License-Identifier: GPL-3.0-or-later
// Bilateral filter (OpenCV), threshold, fast marching and discs of the centreline, layer by layer.
#include "core/segmentation/multi_layer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"
#include "core/segmentation/fast_marching.h"

namespace hepatica {

namespace {

constexpr int bilateral_diameter = 7;           // pixels
constexpr double bilateral_sigma_pixels = 1.5;  // in space
constexpr double bilateral_deviations = 2.5;    // in intensity, of the noise
constexpr double section_deviations = 3.0;      // above the median, after the filter
constexpr double shortest_chain_mm = 10.0;
constexpr double smallest_chain_mm3 = 60.0;

// Edge-aware smoothing of every layer.
FloatVolume smoothed_layers(const TissueContrast& tissue, Job& job) {
    FloatVolume smooth(tissue.excess.grid);
    const Index3& dims = smooth.grid.dims;
    for (int z = 0; z < dims[2]; ++z) {
        job.advance(0.4 * z / dims[2]);
        // cv::Mat takes no const data; the filter only reads it.
        const cv::Mat layer(dims[1], dims[0], CV_32F,
                            const_cast<float*>(&tissue.excess.voxels[smooth.grid.offset(0, 0, z)]));
        cv::Mat out(dims[1], dims[0], CV_32F, &smooth.voxels[smooth.grid.offset(0, 0, z)]);
        cv::bilateralFilter(layer, out, bilateral_diameter, bilateral_deviations * tissue.noise_hu,
                            bilateral_sigma_pixels);
    }
    return smooth;
}

// The cross-sections of one layer, as a grid of its own.
Mask sections_of(const FloatVolume& smooth, const Mask& liver, int z, double threshold) {
    Grid grid = smooth.grid;
    grid.origin_mm = grid.to_mm(0, 0, z);
    grid.dims[2] = 1;
    Mask sections(grid);
    const std::size_t first = smooth.grid.offset(0, 0, z);
    for (std::size_t i = 0; i < sections.voxels.size(); ++i)
        sections.voxels[i] = liver.voxels[first + i] != 0 &&
                             smooth.voxels[first + i] > static_cast<float>(threshold);
    return sections;
}

// Draws the inscribed disc of every centreline point into the volume: the layer as its centreline
// and radii describe it, without the fringe that no inscribed disc reaches.
void assemble(const Mask& centreline, const FloatVolume& distance, int z, Mask& volume) {
    const Grid& grid = centreline.grid;
    const double h = grid.spacing_mm[0];
    for (int y = 0; y < grid.dims[1]; ++y)
        for (int x = 0; x < grid.dims[0]; ++x) {
            const std::size_t i = grid.offset(x, y, 0);
            if (!centreline.voxels[i]) continue;
            // A pixel belongs to the disc if its centre does; the boundary lies between pixels.
            const double radius = distance.voxels[i] / h;
            const int reach = static_cast<int>(radius);
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    if (dx * dx + dy * dy <= radius * radius && grid.contains(x + dx, y + dy, 0))
                        volume.at(x + dx, y + dy, z) = 1;
        }
}

// Connected chains of cross-sections that are long and large enough to be a vessel.
Mask long_chains(const Mask& volume, const Job& job) {
    const Components chains = connected_components(volume, Connectivity::all26, job);
    const Grid& grid = volume.grid;
    std::vector<Index3> low(chains.sizes.size() + 1, grid.dims);
    std::vector<Index3> high(chains.sizes.size() + 1, Index3{-1, -1, -1});
    for_each_voxel_in_order(volume.voxels.size(), job, [&](std::size_t i) {
        const std::uint32_t chain = chains.labels.voxels[i];
        if (chain == 0) return;
        const Index3 at = grid.index_of(i);
        for (std::size_t a = 0; a < 3; ++a) {
            low[chain][a] = std::min(low[chain][a], at[a]);
            high[chain][a] = std::max(high[chain][a], at[a]);
        }
    });
    std::vector<std::uint8_t> kept(chains.sizes.size() + 1, 0);
    const double voxel_mm3 = grid.spacing_mm.prod();
    for (std::size_t c = 1; c < kept.size(); ++c) {
        Vec3 extent;
        for (std::size_t a = 0; a < 3; ++a)
            extent[static_cast<Eigen::Index>(a)] = high[c][a] - low[c][a] + 1;
        kept[c] = extent.cwiseProduct(grid.spacing_mm).norm() >= shortest_chain_mm &&
                  static_cast<double>(chains.sizes[c - 1]) * voxel_mm3 >= smallest_chain_mm3;
    }
    Mask mask(grid);
    for_each_voxel(mask.voxels.size(), job,
                   [&](std::size_t i) { mask.voxels[i] = kept[chains.labels.voxels[i]]; });
    return mask;
}

}  // namespace

Detection detect_by_layers(const TissueContrast& tissue, const Mask& liver, Job& job) {
    FloatVolume smooth = smoothed_layers(tissue, job);
    const RobustSpread spread = robust_spread(smooth, tissue.interior, job);
    const double threshold =
        tissue.threshold_hu.value_or(spread.median + section_deviations * spread.deviation);
    Detection detection{Mask(liver.grid), Mask(liver.grid)};
    for (int z = 0; z < liver.grid.dims[2]; ++z) {
        const auto share = [&](int done) { return 0.4 + 0.6 * done / liver.grid.dims[2]; };
        const JobPart part(job, share(z), share(z + 1));
        const Mask sections = sections_of(smooth, liver, z, threshold);
        const FloatVolume distance = distance_from_boundary(sections, MarchingOrder::second, job);
        const Mask centreline = front_collisions(distance);
        std::copy(centreline.voxels.begin(), centreline.voxels.end(),
                  detection.centreline.voxels.begin() +
                      static_cast<std::ptrdiff_t>(liver.grid.offset(0, 0, z)));
        assemble(centreline, distance, z, detection.vessels);
        job.advance(1.0);
    }
    detection.vessels = long_chains(detection.vessels, job);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i)
        if (!detection.vessels.voxels[i]) detection.centreline.voxels[i] = 0;
    return detection;
}

}  // namespace hepatica
