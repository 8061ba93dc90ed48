// SPDX-License-Identifier: GPL-3.0-or-later
// Repeated Gaussian smoothing of the mask and its level set; the surface area by Cauchy-Crofton.
#include "core/segmentation/gaussian_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/vascular_system.h"
#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/segmentation/neighbours.h"
#include "core/segmentation/vessel_growth.h"
#include "core/skeleton/thinning.h"

namespace hepatica {

namespace {

void check(const RefinementOptions& options) {
    if (options.recursions < 0)
        throw InputError(
            "the number of recursions of the refinement is " + std::to_string(options.recursions),
            "refinement", "Use 0 (no refinement) or more.");
    if (!(options.sigma_mm > 0.0))
        throw InputError("the refinement's sigma is " + number_text(options.sigma_mm) + " mm",
                         "refinement", "Use a sigma above 0.");
    if (!(options.level > 0.0 && options.level < 1.0))
        throw InputError("the refinement's level is " + number_text(options.level), "refinement",
                         "Use a level between 0 and 1.");
}

// The bounding box of the object with room for the surface to move.
IndexBox working_box(const Mask& mask, const RefinementOptions& options) {
    const double reach = 3.0 * options.sigma_mm * std::sqrt(options.recursions);
    return grow_box(bounding_box(mask), mask.grid, reach + mask.grid.spacing_mm.maxCoeff());
}

Mask level_set(const Mask& object, const RefinementOptions& options, Job& job) {
    FloatVolume volume(object.grid);
    std::transform(object.voxels.begin(), object.voxels.end(), volume.voxels.begin(),
                   [](std::uint8_t v) { return v ? 1.0f : 0.0f; });
    for (int n = 0; n < options.recursions; ++n)
        gaussian_smooth(volume, Vec3::Constant(options.sigma_mm), job);
    Mask inside(object.grid);
    std::transform(volume.voxels.begin(), volume.voxels.end(), inside.voxels.begin(),
                   [&](float v) { return static_cast<std::uint8_t>(v > options.level); });
    return inside;
}

// The label of the mask if it has only one, else that of an unknown system.
std::uint8_t label_of_islands(const Mask& labels) {
    std::uint8_t only = 0;
    for (const std::uint8_t label : labels.voxels) {
        if (label == 0 || label == only) continue;
        if (only != 0) return static_cast<std::uint8_t>(VascularSystem::unknown);
        only = label;
    }
    return only;
}

// Voxels of the surface keep their label; new ones take the smallest label among their neighbours,
// layer by layer.
Mask labelled(const Mask& surface, const Mask& labels) {
    const Grid& grid = surface.grid;
    Mask result(grid);
    std::vector<std::size_t> pending;
    for (std::size_t i = 0; i < result.voxels.size(); ++i) {
        if (!surface.voxels[i]) continue;
        result.voxels[i] = labels.voxels[i];
        if (!labels.voxels[i]) pending.push_back(i);
    }
    while (!pending.empty()) {
        std::vector<std::pair<std::size_t, std::uint8_t>> found;
        std::vector<std::size_t> still;
        for (const std::size_t i : pending) {
            std::uint8_t best = 0;
            for_each_neighbour(grid, i, [&](std::size_t n) {
                const std::uint8_t label = result.voxels[n];
                if (label && (best == 0 || label < best)) best = label;
            });
            if (best)
                found.emplace_back(i, best);
            else
                still.push_back(i);
        }
        for (const auto& [voxel, label] : found) result.voxels[voxel] = label;
        if (found.empty()) {  // pieces that touch no labelled voxel
            const std::uint8_t label = label_of_islands(labels);
            for (const std::size_t i : still) result.voxels[i] = label;
            break;
        }
        pending.swap(still);
    }
    return result;
}

// The share of the sphere whose directions are nearest to each of the 13 axes; opposite directions
// count as the same axis.
std::array<double, 13> direction_shares(const std::array<Vec3, 13>& directions) {
    constexpr int samples = 20000;
    std::array<double, 13> shares{};
    for (int k = 0; k < samples; ++k) {  // a Fibonacci spiral covers the sphere evenly
        const double z = 1.0 - (2.0 * k + 1.0) / samples;
        const double turn = k * std::numbers::pi * (1.0 + std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 sample(r * std::cos(turn), r * std::sin(turn), z);
        std::size_t best = 0;
        for (std::size_t d = 1; d < directions.size(); ++d)
            if (std::abs(directions[d].dot(sample)) > std::abs(directions[best].dot(sample)))
                best = d;
        shares[best] += 1.0 / samples;
    }
    return shares;
}

}  // namespace

Mask refine(const Mask& mask, const RefinementOptions& options, Job& job) {
    check(options);
    const IndexBox box = working_box(mask, options);
    if (options.recursions == 0 || box.empty()) return mask;
    const Mask labels = crop(mask, box);
    Mask surface = level_set(labels, options, job);
    if (options.keep_thin_branches)
        rejoin(thin(labels, ThinningMethod::queue, job), options.kept_branch_mm, surface, job);
    Mask result(mask.grid);
    paste(labelled(surface, labels), box.begin, result);
    return result;
}

Mask refine(const Mask& mask, int recursions, Job& job) {
    RefinementOptions options;
    options.recursions = recursions;
    return refine(mask, options, job);
}

SurfaceMeasure measure_surface(const Mask& mask) {
    const Grid& grid = mask.grid;
    std::array<Index3, 13> steps;
    std::array<Vec3, 13> directions;
    std::array<double, 13> lengths{};
    const std::array<NeighbourStep, 26> all = neighbour_steps(grid);
    for (std::size_t d = 0; d < 13; ++d) {  // one of each pair of opposite neighbours
        const auto& [step, length_mm] = all[13 + d];
        steps[d] = step;
        lengths[d] = length_mm;
        directions[d] = Vec3(step[0], step[1], step[2]).cwiseProduct(grid.spacing_mm) / length_mm;
    }
    const std::array<double, 13> shares = direction_shares(directions);
    const double cell = grid.spacing_mm.prod();

    SurfaceMeasure measure;
    const auto object = [&](int x, int y, int z) {
        return grid.contains(x, y, z) && mask.voxels[grid.offset(x, y, z)] != 0;
    };
    std::array<std::size_t, 13> crossings{};
    std::size_t voxels = 0;
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x) {
                if (!mask.voxels[grid.offset(x, y, z)]) continue;
                ++voxels;
                for (std::size_t d = 0; d < 13; ++d)
                    for (const int sign : {-1, 1})
                        crossings[d] += !object(x + sign * steps[d][0], y + sign * steps[d][1],
                                                z + sign * steps[d][2]);
            }
    // Cauchy-Crofton: the area is twice the mean, over all directions, of the number of crossings
    // per unit of area normal to the direction.
    for (std::size_t d = 0; d < 13; ++d)
        measure.area_mm2 += 2.0 * shares[d] * static_cast<double>(crossings[d]) * cell / lengths[d];
    measure.volume_mm3 = static_cast<double>(voxels) * cell;
    return measure;
}

}  // namespace hepatica
