// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/touch_bodies.h"

#include <array>
#include <cmath>

#include "core/study/vessel_body.h"

namespace hepatica {
namespace {

constexpr int waves = 3;

// A displacement whose gradient is at most `steepness`, so that nothing folds over for values below
// 1.
class Waves {
  public:
    Waves(std::mt19937_64& random, double length_mm, double steepness) {
        for (Wave& wave : waves_) {
            const auto direction = [&] {
                Vec3 d;
                for (int c = 0; c < 3; ++c) d[c] = uniform(random, -1.0, 1.0);
                return Vec3(d / std::max(d.norm(), 0.1));
            };
            wave.number_per_mm = 2.0 * M_PI / length_mm * direction();
            wave.amplitude_mm = steepness * length_mm / (2.0 * M_PI * waves) * direction();
            wave.phase = uniform(random, 0.0, 2.0 * M_PI);
        }
    }
    Vec3 moved(const Vec3& x) const {
        Vec3 y = x;
        for (const Wave& wave : waves_)
            y += std::sin(wave.number_per_mm.dot(x) + wave.phase) * wave.amplitude_mm;
        return y;
    }

  private:
    struct Wave {
        Vec3 number_per_mm, amplitude_mm;
        double phase = 0.0;
    };
    std::array<Wave, waves> waves_;
};

}  // namespace

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

VesselTree random_study_tree(std::mt19937_64& random) {
    const double radius = uniform(random, 2.0, 5.0);
    VesselTree tree = study_tree(1 + static_cast<int>(uniform(random, 0.0, 4.0)), radius);
    const double length_mm = uniform(random, 12.0, 40.0) * radius;
    const Waves bend(random, length_mm, 0.5);
    for (VesselNode& node : tree.nodes) node.position_mm = bend.moved(node.position_mm);
    for (VesselSegment& segment : tree.segments)
        for (Vec3& x : segment.points_mm) x = bend.moved(x);
    return tree;
}

VesselTree open_knot(double radius_mm) {
    constexpr int pieces = 80;
    constexpr double size_mm = 4.0, begin = 0.25, end = 2.0 * M_PI - 0.25;
    VesselSegment vessel;
    for (int k = 0; k <= pieces; ++k) {
        const double t = begin + (end - begin) * k / pieces;
        vessel.points_mm.emplace_back(size_mm * (std::sin(t) + 2.0 * std::sin(2.0 * t)),
                                      size_mm * (std::cos(t) - 2.0 * std::cos(2.0 * t)),
                                      -size_mm * std::sin(3.0 * t));
        vessel.radii_mm.push_back(radius_mm);
    }
    VesselTree tree;
    tree.nodes = {{vessel.points_mm.front(), radius_mm}, {vessel.points_mm.back(), radius_mm}};
    vessel.proximal_node = 0;
    vessel.distal_node = 1;
    tree.segments.push_back(vessel);
    return tree;
}

}  // namespace hepatica
