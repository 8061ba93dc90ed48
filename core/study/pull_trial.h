// SPDX-License-Identifier: GPL-3.0-or-later
// A short pull by a trainee, the same on every mesh of a body, and the motion of the centreline
// meanwhile. The dial's settings are compared by it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/stepper/stepper.h"

namespace hepatica {

// The hand holds the vessel three fifths of the way from a fixed root to the furthest tip, moves
// sideways by 30 mm within half a second, and back in another.
class Pull {
  public:
    static constexpr int frames = 60;
    static constexpr double distance_mm = 30.0;

    // Throws InputError where the body has no skeleton or nothing of it is fixed.
    explicit Pull(const BodyDescription& body);

    // The hand's springs on any mesh of the same body at the end of a frame, counted from 0.
    // Together they are as stiff as a piece of the vessel one radius long, distributed over the
    // vertices within one and a half radii by their volume, so that the mesh does not matter.
    std::vector<Grab> grabs(const BodyDescription& body, int frame) const;

    const Vec3& place_mm() const { return place_mm_; }

  private:
    Vec3 place_mm_, way_;
    double radius_mm_ = 0.0;
};

// Points of a body's centreline, located in one of its meshes.
class CentrelineProbes {
  public:
    // Locates each point in the tetrahedron that contains it, or comes closest to it.
    CentrelineProbes(const std::vector<Vec3>& points_mm, const TetMesh& mesh);

    std::vector<Vec3> places_mm(std::span<const Vec3> vertices_mm) const;

  private:
    struct Probe {
        std::array<int, 4> vertices;
        std::array<double, 4> weights;
    };
    std::vector<Probe> probes_;
};

// Displacements of all probes after each frame, frame by frame.
using CentrelineMotion = std::vector<Vec3>;

struct MotionDifference {
    double relative = 0.0;    // rms_mm over the root mean square of the reference's displacements
    double rms_mm = 0.0;      // root mean square over frames and probes
    double largest_mm = 0.0;  // of any probe in any frame
};

// Both motions must have the same number of frames and probes; the reference must move.
MotionDifference motion_difference(std::span<const Vec3> motion, std::span<const Vec3> reference);
// Throws InputError where nothing moves, because no error is relative to that.
void require_movement(const CentrelineMotion& reference);
// MotionDifference::relative.
double motion_error(const CentrelineMotion& motion, const CentrelineMotion& reference);

}  // namespace hepatica
