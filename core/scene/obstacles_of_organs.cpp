// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/obstacles_of_organs.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/image/filters.h"
#include "core/image/mask.h"
#include "core/image/morphology.h"
#include "core/image/share_inside.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/scene/level_surface.h"

namespace hepatica {
namespace {

constexpr double cells_in_diameter = 10.0, finest_mm = 1.0, coarsest_mm = 4.0;
constexpr double smoothing = 0.5;  // of a cell
constexpr double reach = 4.0;      // in units of the smoothing: nothing of the surface is cut off

constexpr double closed_mm = 6.0, closed_spacing_mm = 2.0;

Mask part_of(const Mask& organ, const IndexBox& box, double margin_mm) {
    return crop(organ, grow_box(box, organ.grid, margin_mm));
}

// The vessels may be cut out of a liver mask: tunnels as wide as a portal vein are closed.
Mask closed_liver(const Mask& liver) {
    Job job;
    const Mask part = part_of(liver, bounding_box(liver), 2.0 * closed_mm);
    const Vec3 spacing = part.grid.spacing_mm.cwiseMax(Vec3::Constant(closed_spacing_mm));
    return close(resample(part, respaced(part.grid, spacing), Interpolation::linear, job),
                 closed_mm, job);
}

// The surface of the nonzero voxels with holes filled; empty where nothing remains.
TriangleMesh smooth_surface(const Mask& organ) {
    const IndexBox box = bounding_box(organ);
    if (box.empty()) return {};
    Job job;
    const Mask part = fill_holes(part_of(organ, box, reach * coarsest_mm));
    const auto voxels = static_cast<double>(object_count(part));
    const double diameter_mm =
        std::cbrt(6.0 / M_PI * voxels * std::abs(part.grid.spacing_mm.prod()));
    const double cell_mm = std::clamp(diameter_mm / cells_in_diameter, finest_mm, coarsest_mm);
    const auto surface = [&](double smoothing_mm) {
        return level_surface(
            with_border(share_inside(part, smoothing_mm, Vec3::Constant(cell_mm), job)));
    };
    TriangleMesh smooth = surface(smoothing * cell_mm);
    return smooth.triangles.empty() ? surface(0.0) : smooth;  // too small to be smoothed
}

}  // namespace

std::vector<Obstacle> obstacles_in(const Mask& organs) {
    std::vector<Obstacle> all;
    const auto add = [&](const Mask& organ, SurfaceKind kind) {
        TriangleMesh surface = smooth_surface(organ);
        if (!surface.triangles.empty()) all.push_back({std::move(surface), kind});
    };
    if (organs.voxels.empty()) return all;
    if (const Mask liver = liver_of(organs); !liver.voxels.empty())
        add(closed_liver(liver), SurfaceKind::shell);
    for (const Tumour& tumour : tumours_in(organs)) {
        Mask one = organs;
        const std::uint8_t label = label_of_tumour(tumour.number);
        for (std::uint8_t& voxel : one.voxels) voxel = voxel == label ? 1 : 0;
        add(one, SurfaceKind::solid);
    }
    return all;
}

std::shared_ptr<const Obstacles> obstacles_for(const PatientCase& patient,
                                               const std::optional<ContactSpec>& contact) {
    if (!contact || contact->obstacles == WantedObstacles::none) return nullptr;
    Obstacles obstacles{obstacles_in(organs_of(patient))};
    if (!obstacles.all.empty()) return std::make_shared<const Obstacles>(std::move(obstacles));
    if (contact->obstacles == WantedObstacles::known) return nullptr;
    const std::string where = patient.voxels_at.empty()
                                  ? patient.source.name.empty() ? "the case" : patient.source.name
                                  : (patient.voxels_at / "organs.nii.gz").string();
    throw InputError(
        "holds neither a liver nor a tumour that vessels could touch", where,
        "Leave \"obstacles\": true out of the scene's contact, or reconstruct the case "
        "with a liver or tumours");
}

}  // namespace hepatica
