// SPDX-License-Identifier: GPL-3.0-or-later
// Closing of the liver, threshold on the smoothed intensity, opening, and reconstruction from the
// liver's own vessels, all in a box around the hilum.
#include "core/segmentation/hilum_vessels.h"

#include <algorithm>
#include <cmath>

#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/section.h"
#include "core/segmentation/vessel_growth.h"

namespace hepatica {

namespace {

// The fissure holds the trunk, 10 to 16 mm wide, with the fat and the bile ducts around it.
constexpr double fissure_mm = 30.0, reach_mm = 30.0;
constexpr double narrowest_mm = 1.5;
constexpr double vessel_smoothing_mm = 0.8;
// How far outside the box a voxel can influence the result: twice the radius of the opening plus
// eight standard deviations of the smoothing.
constexpr double local_mm = 2.0 * narrowest_mm + 8.0 * vessel_smoothing_mm;
// Shares of a vessel's rise over the tissue. Bone and contrast medium in the bowel lie above
// most_rise. Where fat surrounds a vessel, least_rise places its wall some 0.6 mm too far inside.
constexpr double least_rise = 0.5, most_rise = 2.0;
constexpr double least_section_mm2 = 10.0;  // the smallest cross-section of a trunk

bool nearer_than_cava(const Vec3& p, const Hilum& hilum) {
    const double away = (p - hilum.at_mm).norm();
    const Vec3& top = hilum.confluence_mm;
    const Vec3 beside(top.x(), top.y(), std::min(p.z(), top.z()));
    return away < reach_mm && away < (p - beside).norm();
}

// The voxels around the hilum in which vessels are sought, plus one on each side, so that adjacent
// vessels of the liver are included.
IndexBox box_about(const Hilum& hilum, const Grid& grid) {
    const Vec3 middle = grid.to_index(hilum.at_mm);
    IndexBox box;
    for (int a = 0; a < 3; ++a) {
        const double reach = reach_mm / grid.spacing_mm[a] + 1.0;
        const double last = grid.dims[a];
        box.begin[a] = static_cast<int>(std::clamp(std::floor(middle[a] - reach), 0.0, last));
        box.end[a] = static_cast<int>(std::clamp(std::ceil(middle[a] + reach) + 1.0, 0.0, last));
    }
    return box;
}

// The images cropped around the hilum, with enough margin for smoothing and opening to give the
// same result as in the whole image.
struct Surroundings {
    Mask liver, vessels, fissures, bright;
};

Mask fissures_in(const IndexBox& box, const Hilum& hilum, const Mask& liver, Job& job) {
    Mask fissures = close_in(liver, fissure_mm, box, job);
    const Grid& grid = fissures.grid;
    for (std::size_t i = 0; i < fissures.voxels.size(); ++i) {
        if (fissures.voxels[i] == 0) continue;
        const auto [x, y, z] = grid.index_of(i);
        const int in_x = x + box.begin[0], in_y = y + box.begin[1], in_z = z + box.begin[2];
        fissures.voxels[i] = liver.at(in_x, in_y, in_z) == 0 &&
                             nearer_than_cava(liver.grid.to_mm(in_x, in_y, in_z), hilum);
    }
    return fissures;
}

Mask as_bright_as_vessels(FloatVolume intensity, const Hilum& hilum, Job& job) {
    gaussian_smooth(intensity, Vec3::Constant(vessel_smoothing_mm), job);
    const double rise = hilum.vessel_hu - hilum.parenchyma_hu;
    const double low = hilum.parenchyma_hu + least_rise * rise;
    const double high = hilum.parenchyma_hu + most_rise * rise;
    Mask bright(intensity.grid);
    for (std::size_t i = 0; i < bright.voxels.size(); ++i)
        bright.voxels[i] = intensity.voxels[i] > low && intensity.voxels[i] < high;
    return bright;
}

Surroundings surroundings_in(const IndexBox& box, const LiverFrame& frame, const Mask& vessels,
                             const Hilum& hilum, Job& job) {
    return {crop(frame.liver, box), crop(vessels, box), fissures_in(box, hilum, frame.liver, job),
            as_bright_as_vessels(crop(frame.intensity, box), hilum, job)};
}

// Voxels of the fissures in wide vessels that are connected with vessels of the liver.
Mask wide_vessels(const Surroundings& near, Job& job) {
    Mask wide(near.vessels.grid);
    for (std::size_t i = 0; i < wide.voxels.size(); ++i)
        wide.voxels[i] = near.vessels.voxels[i] != 0 ||
                         (near.fissures.voxels[i] != 0 && near.bright.voxels[i] != 0);
    wide = open(wide, narrowest_mm, job);
    Mask known = wide;
    for (std::size_t i = 0; i < known.voxels.size(); ++i)
        known.voxels[i] = wide.voxels[i] != 0 && near.vessels.voxels[i] != 0;
    Mask found = hysteresis(known, wide, 0.0, job);
    for (std::size_t i = 0; i < found.voxels.size(); ++i)
        if (near.fissures.voxels[i] == 0) found.voxels[i] = 0;
    return found;
}

std::optional<Vec3> trunk_of(const Mask& found, const Surroundings& near, Job& job) {
    Mask beyond = open(near.bright, narrowest_mm, job);
    for (std::size_t i = 0; i < beyond.voxels.size(); ++i)
        if (near.liver.voxels[i] != 0) beyond.voxels[i] = 0;
    const std::optional<Section> section = largest_section(found, beyond);
    if (section && section->area_mm2 >= least_section_mm2) return section->middle_mm;
    return std::nullopt;
}

}  // namespace

HilumVessels hilum_vessels(const LiverFrame& frame, const Mask& vessels, const Hilum& hilum,
                           Job& job) {
    HilumVessels result{Mask(vessels.grid), std::nullopt};
    const IndexBox inner = box_about(hilum, vessels.grid);
    if (inner.empty()) return result;
    const IndexBox box = grow_box(inner, vessels.grid, local_mm);
    const Surroundings near = surroundings_in(box, frame, vessels, hilum, job);
    const Mask found = wide_vessels(near, job);
    result.trunk_mm = trunk_of(found, near, job);
    paste(found, box.begin, result.vessels);
    return result;
}

}  // namespace hepatica
