// SPDX-License-Identifier: GPL-3.0-or-later
// One short pull as a trainee makes it, the same on every mesh of a body, and where the centreline
// goes meanwhile: what the settings of the dial are compared by.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

// The hand takes the vessel three fifths of the way from a fixed root to the furthest tip and moves
// sideways by 30 mm within half a second, and back in another.
class Pull {
  public:
    static constexpr int frames = 60;
    static constexpr double distance_mm = 30.0;

    // Throws InputError where the body has no skeleton or nothing of it is fixed.
    explicit Pull(const BodyDescription& body);

    // The hand's springs on any mesh of the same body at the end of a frame (from 0): together as
    // stiff as a piece of the vessel one radius long, shared among the vertices within one and a
    // half radii by the volume around them, so that the mesh does not matter.
    std::vector<Grab> grabs(const BodyDescription& body, int frame) const;

    const Vec3& place_mm() const { return place_mm_; }

  private:
    Vec3 place_mm_, way_;
    double radius_mm_ = 0.0;
};

// Points of a body's centreline, found again in each of its meshes.
class CentrelineProbes {
  public:
    // Each point in the tetrahedron that holds it, or holds it most nearly.
    CentrelineProbes(const std::vector<Vec3>& points_mm, const TetMesh& mesh);

    std::vector<Vec3> places_mm(std::span<const Vec3> vertices_mm) const;

  private:
    struct Probe {
        std::array<int, 4> vertices;
        std::array<double, 4> weights;
    };
    std::vector<Probe> probes_;
};

// Displacement of every probe after every frame, one frame after the other.
using CentrelineMotion = std::vector<Vec3>;

struct MotionDifference {
    double relative = 0.0;    // rms_mm over the root mean square of the reference's displacements
    double rms_mm = 0.0;      // root mean square over frames and probes
    double largest_mm = 0.0;  // of any probe in any frame
};

// Of two motions with as many frames and probes, of which the reference is not at rest all the
// time.
MotionDifference motion_difference(std::span<const Vec3> motion, std::span<const Vec3> reference);
// The relative one.
double motion_error(const CentrelineMotion& motion, const CentrelineMotion& reference);

}  // namespace hepatica
