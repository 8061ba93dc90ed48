// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the judged region with distance maps, dilation and closing.
#include "core/accuracy/judged_region.h"

#include "core/image/morphology.h"
#include "core/segmentation/liver_region.h"

namespace hepatica {

namespace {

// Closes the channels that vessels leave in an expert's liver mask.
constexpr double closing_mm = 8.0;

void unite(Mask& mask, const Mask& with) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] |= with.voxels[i] != 0;
}

// The voxels of a mask that lie deeper than depth_mm below its surface.
Mask deeper_than(const Mask& mask, double depth_mm, Job& job) {
    // The nearest background voxel's centre lies half a voxel beyond the surface.
    const double to_background_mm = depth_mm + 0.5 * mask.grid.spacing_mm.minCoeff();
    const FloatVolume distance = signed_distance(mask, job);
    Mask deep(mask.grid);
    for (std::size_t i = 0; i < deep.voxels.size(); ++i)
        deep.voxels[i] = mask.voxels[i] != 0 && distance.voxels[i] < -to_background_mm;
    return deep;
}

}  // namespace

Mask near_cava(const Mask* hepatic, const Mask* cava, const CavaNeighbourhood& size, Job& job) {
    Mask near(hepatic != nullptr ? hepatic->grid : cava != nullptr ? cava->grid : Grid{});
    if (hepatic != nullptr)
        unite(near, dilate(deeper_than(*hepatic, size.radius_mm, job), size.reach_mm, job));
    if (cava != nullptr) unite(near, dilate(*cava, size.beside_mm, job));
    return near;
}

Mask judged_region(const Mask* liver, const Mask& left_out, Job& job) {
    Mask judged = liver != nullptr ? close_liver(*liver, closing_mm, job) : Mask(left_out.grid, 1);
    for (std::size_t i = 0; i < judged.voxels.size(); ++i)
        if (left_out.voxels[i] != 0) judged.voxels[i] = 0;
    return judged;
}

}  // namespace hepatica
