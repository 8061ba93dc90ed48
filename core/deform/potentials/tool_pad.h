// SPDX-License-Identifier: GPL-3.0-or-later
// The pad between a tool and a surface. Its pressure p g/(1 - g), with g = 1 - d/h at the gap d <
// h, is integrated over the surface at rest by points on the triangles. A point that represents the
// area A stores
//   A p h (-g - ln(1 - g)),    whose force is A p g/(1 - g):
// linear at first and without bound as the gap closes, so that every equilibrium is free of
// penetration. Where d <= 0 the energy is infinite. The points are so close that between them a
// triangle comes nearer to the tool by at most an eighth of the pad, even where it is stretched by
// half (unless the limit of cuts per edge is reached); this eighth is subtracted from the gaps.
#pragma once

#include <vector>

#include "core/deform/potentials/pad_point.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

// A point of the surface in the pad.
struct PadContact {
    int part = 0;        // of the tool
    double along = 0.0;  // position along that part's axis, from 0 to 1
    int triangle = 0;
    std::array<double, 3> weights{};  // of the triangle's corners
    Vec3 normal = Vec3::Zero();       // from the tool to the surface, of length 1
    Vec3 at_mm = Vec3::Zero();
    double force_un = 0.0;  // along the normal on the surface, > 0
    double stiffness_un_per_mm = 0.0;
    double energy_nj = 0.0;
};

PadCapsule pad_capsule(const Capsule& shape);

// Thread-safe: const access only.
class ToolPad {
  public:
    // How far a triangle may bulge into the pad between its points, as a share of the pad.
    static constexpr double dip_of_pad = 0.125;

    ToolPad(SurfacePatches surface, std::span<const Vec3> rest_mm);

    const SurfacePatches& surface() const { return surface_; }
    // Contacts of a tool whose parts have these shapes, ordered by part, triangle and point.
    std::vector<PadContact> contacts(const Tool& tool, std::span<const Capsule> shapes,
                                     std::span<const Vec3> positions_mm) const;
    // All points that may be in the pad at either of two positions of the surface, in that order.
    std::vector<PadPoint> points_near(const Tool& tool, std::span<const Capsule> shapes,
                                      std::span<const Vec3> positions_mm,
                                      std::span<const Vec3> other_positions_mm) const;
    // The gap between the tool and the nearest triangle: negative inside, the largest double beyond
    // the pad.
    double least_gap_mm(const Tool& tool, std::span<const Vec3> positions_mm) const;

  private:
    void add_points_of(int triangle, const Tool& tool, double radius_mm, int part,
                       std::vector<PadPoint>& points) const;
    // `points` is scratch memory.
    void add_contacts_of(int triangle, const Tool& tool, const Capsule& shape, int part,
                         std::span<const Vec3> positions_mm, std::vector<PadPoint>& points,
                         std::vector<PadContact>& found) const;
    std::vector<std::vector<int>> triangles_near(const Tool& tool, std::span<const Capsule> shapes,
                                                 std::span<const Vec3> positions_mm) const;

    SurfacePatches surface_;
    std::vector<double> area_mm2_, longest_edge_mm_;  // of each triangle at rest
};

}  // namespace hepatica
