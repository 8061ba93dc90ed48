// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/hilum_vessels.h"

#include <algorithm>

#include "core/image/filters.h"
#include "core/image/morphology.h"
#include "core/image/section.h"
#include "core/segmentation/liver_region.h"
#include "core/segmentation/vessel_growth.h"

namespace hepatica {

namespace {

// The trunk, 10 to 16 mm wide, with the fat and the ducts around it.
constexpr double fissure_mm = 30.0, reach_mm = 30.0;
constexpr double narrowest_mm = 1.5;
constexpr double vessel_smoothing_mm = 0.8;
// Of a vessel's rise over the tissue; above the second lie bone and contrast medium in bowels.
// Where fat lies around a vessel, the first draws its wall some 0.6 mm too far inside.
constexpr double least_rise = 0.5, most_rise = 2.0;
constexpr double least_section_mm2 = 10.0;  // of a trunk

bool nearer_than_cava(const Vec3& p, const Hilum& hilum) {
    const double away = (p - hilum.at_mm).norm();
    const Vec3& top = hilum.confluence_mm;
    const Vec3 beside(top.x(), top.y(), std::min(p.z(), top.z()));
    return away < reach_mm && away < (p - beside).norm();
}

Mask fissures_at(const Hilum& hilum, const Mask& liver, Job& job) {
    Mask fissures = close_liver(liver, fissure_mm, job);
    for (std::size_t i = 0; i < fissures.voxels.size(); ++i) {
        if (fissures.voxels[i] == 0) continue;
        const auto [x, y, z] = fissures.grid.index_of(i);
        fissures.voxels[i] =
            liver.voxels[i] == 0 && nearer_than_cava(fissures.grid.to_mm(x, y, z), hilum);
    }
    return fissures;
}

Mask as_bright_as_vessels(const LiverFrame& frame, const Hilum& hilum, Job& job) {
    FloatVolume smooth = frame.intensity;
    gaussian_smooth(smooth, Vec3::Constant(vessel_smoothing_mm), job);
    const double rise = hilum.vessel_hu - hilum.parenchyma_hu;
    const double low = hilum.parenchyma_hu + least_rise * rise;
    const double high = hilum.parenchyma_hu + most_rise * rise;
    Mask bright(smooth.grid);
    for (std::size_t i = 0; i < bright.voxels.size(); ++i)
        bright.voxels[i] = smooth.voxels[i] > low && smooth.voxels[i] < high;
    return bright;
}

}  // namespace

HilumVessels hilum_vessels(const LiverFrame& frame, const Mask& vessels, const Hilum& hilum,
                           Job& job) {
    const Mask fissures = fissures_at(hilum, frame.liver, job);
    const Mask bright = as_bright_as_vessels(frame, hilum, job);
    Mask wide(vessels.grid);
    for (std::size_t i = 0; i < wide.voxels.size(); ++i)
        wide.voxels[i] =
            vessels.voxels[i] != 0 || (fissures.voxels[i] != 0 && bright.voxels[i] != 0);
    wide = open(wide, narrowest_mm, job);
    Mask known = wide;
    for (std::size_t i = 0; i < known.voxels.size(); ++i)
        known.voxels[i] = wide.voxels[i] != 0 && vessels.voxels[i] != 0;
    HilumVessels found{hysteresis(known, wide, 0.0), std::nullopt};
    for (std::size_t i = 0; i < fissures.voxels.size(); ++i)
        if (fissures.voxels[i] == 0) found.vessels.voxels[i] = 0;
    Mask beyond = open(bright, narrowest_mm, job);
    for (std::size_t i = 0; i < beyond.voxels.size(); ++i)
        if (frame.liver.voxels[i] != 0) beyond.voxels[i] = 0;
    const std::optional<Section> section = largest_section(found.vessels, beyond);
    if (section && section->area_mm2 >= least_section_mm2) found.trunk_mm = section->middle_mm;
    return found;
}

}  // namespace hepatica
