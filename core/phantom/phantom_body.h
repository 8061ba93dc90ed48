// SPDX-License-Identifier: GPL-3.0-or-later
// The upper abdomen around the phantom's vessels as implicit surfaces: a liver with two lobes, dome
// and visceral surface, and the tissues it has to be distinguished from (fat, muscle, lung, spleen,
// stomach, kidneys, great vessels, spine, ribs, bowel).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Positions are millimetres in an adult's frame, LPS, with the z axis along the middle of the
// torso. Immutable after construction, so thread-safe.
class PhantomBody {
  public:
    // The seed varies the liver's surface by a few millimetres.
    PhantomBody(std::uint64_t seed, double parenchyma_hu);

    // Approximate signed distance to the liver's surface, negative inside; within some 20 % at up
    // to 20 mm from the surface.
    double liver_distance_mm(const Vec3& p) const;
    // Intensity at a point, without vessels, each border softened over softness_mm. The caller
    // passes liver_distance_mm because it needs that value too.
    double hu(const Vec3& p, double liver_distance_mm, double softness_mm) const;

    // A box that contains the liver of any seed.
    static Vec3 liver_low() { return {-134, -80, -84}; }
    static Vec3 liver_high() { return {70, 84, 74}; }

    // Where the portal vein enters (porta hepatis) and where the hepatic veins leave (at the vena
    // cava), about 5 mm below the surface.
    Vec3 portal_entry() const;
    Vec3 hepatic_outlet() const;

  private:
    struct Loop {
        Vec3 centre;
        Vec3 radii;
        double content_hu;
    };

    Vec3 wobble(const Vec3& p) const;
    Vec3 first_point_inside(const Vec3& from, const Vec3& to) const;

    double parenchyma_hu_;
    // Displacement of the liver's surface, tabulated along each axis every half millimetre; the
    // displacements of the three axes add up.
    std::array<std::vector<Vec3>, 3> push_;
    std::vector<Loop> bowel_;
};

}  // namespace hepatica
