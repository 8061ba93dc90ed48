// SPDX-License-Identifier: GPL-3.0-or-later
// The upper abdomen around the phantom's vessels, as implicit surfaces: a liver with its two lobes,
// dome and visceral surface, and what a liver has to be told from (fat, muscle, lung, spleen,
// stomach, kidneys, great vessels, spine, ribs, bowel).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Positions are in an adult's frame: millimetres, LPS, z axis through the spine's column.
// Immutable after construction, so safe to ask from several threads.
class PhantomBody {
  public:
    // The seed varies the liver's surface by a few millimetres.
    PhantomBody(std::uint64_t seed, double parenchyma_hu);

    // About the signed distance to the liver's surface, negative inside; good to some 20 % within
    // 20 mm of the surface.
    double liver_distance_mm(const Vec3& p) const;
    // Without vessels, each border softened over softness_mm. liver_distance_mm is passed in
    // because its caller needs it too.
    double hu(const Vec3& p, double liver_distance_mm, double softness_mm) const;

    // Box that holds every liver of every seed.
    static Vec3 liver_low() { return {-134, -80, -84}; }
    static Vec3 liver_high() { return {70, 84, 74}; }

    // Where the portal vein enters (porta hepatis) and where the hepatic veins leave (at the vena
    // cava), some 5 mm below the surface.
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
    // By how much the liver is pushed aside at each coordinate of each axis, every half millimetre.
    std::array<std::vector<Vec3>, 3> push_;
    std::vector<Loop> bowel_;
};

}  // namespace hepatica
