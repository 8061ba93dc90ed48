// SPDX-License-Identifier: GPL-3.0-or-later
// Weights border voxels by the area of their open faces and compares distance maps with the
// tolerance.
#include "core/accuracy/surface_dice.h"

#include "core/image/morphology.h"

namespace hepatica {

namespace {

// Area in mm^2 of the faces of an object voxel next to background.
double open_area(const Mask& mask, const Index3& voxel) {
    const Vec3& spacing = mask.grid.spacing_mm;
    double area = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
            Index3 beside = voxel;
            beside[axis] += step;
            if (!mask.grid.contains(beside[0], beside[1], beside[2]) ||
                mask.at(beside[0], beside[1], beside[2]) == 0)
                area += spacing.prod() / spacing[axis];
        }
    return area;
}

Image<float> surface_of(const Mask& mask) {
    Image<float> area(mask.grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        if (mask.voxels[i] != 0)
            area.voxels[i] = static_cast<float>(open_area(mask, mask.grid.index_of(i)));
    return area;
}

struct Area {
    double near = 0.0, all = 0.0;
};

// The judged area of one surface: the part that has the other one near, and all of it.
Area area_near(const Image<float>& surface, const Image<float>& other, const Mask& judged,
               double tolerance_mm, Job& job) {
    Mask border(other.grid);
    for (std::size_t i = 0; i < border.voxels.size(); ++i)
        border.voxels[i] = other.voxels[i] > 0.0f;
    const FloatVolume distance = distance_to(border, job);
    Area area;
    for (std::size_t i = 0; i < surface.voxels.size(); ++i) {
        if (judged.voxels[i] == 0 || surface.voxels[i] == 0.0f) continue;
        area.all += surface.voxels[i];
        // Rounding must not decide where the tolerance is a whole number of voxels.
        if (distance.voxels[i] <= tolerance_mm + 1e-4) area.near += surface.voxels[i];
    }
    return area;
}

}  // namespace

double surface_dice(const Mask& a, const Mask& b, const Mask& judged, double tolerance_mm,
                    Job& job) {
    const Image<float> of_a = surface_of(a), of_b = surface_of(b);
    const Area first = area_near(of_a, of_b, judged, tolerance_mm, job);
    const Area second = area_near(of_b, of_a, judged, tolerance_mm, job);
    const double all = first.all + second.all;
    return all > 0.0 ? (first.near + second.near) / all : 1.0;
}

}  // namespace hepatica
