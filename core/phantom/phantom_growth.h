// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained constructive optimisation (Schreiner and Buxbaum, IEEE Trans Biomed Eng 1993;40:482;
// Karch et al., Comput Biol Med 1999;29:19): ends are added one by one, each where the blood volume
// of the whole tree grows least, at the bifurcation point that minimises it. All ends carry the
// same flow Q, and radii follow Murray's law r^m ~ Q, so that every branch's radius is known from
// the number of ends beyond it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/base/vector.h"
#include "core/phantom/phantom_random.h"

namespace hepatica {

// A straight vessel that others keep clear of.
struct StraightVessel {
    Vec3 begin = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    double radius = 0.0;
};

// Shortest distance between two line segments.
double distance_between(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

// A straight branch of the growing tree.
struct GrownBranch {
    int parent = -1;
    std::array<int, 2> children{-1, -1};  // both or none
    Vec3 begin = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    int ends = 1;  // ends of the tree at or beyond this branch's end
};

struct GrowthRequest {
    Vec3 root = Vec3::Zero();
    Vec3 low = Vec3::Zero();  // box around the domain
    Vec3 high = Vec3::Zero();
    std::function<double(const Vec3&)> depth_mm;  // below the domain's surface; positive inside
    int ends = 64;
    double root_radius_mm = 6.0;
    double murray_exponent = 3.0;
};

// Grows one tree for each request in turn, so that they interlace: after one has doubled its ends,
// the next one grows. Branch 0 of each tree is its root. Branches keep clear of each other, of the
// other trees and of the surface. A tree may get fewer ends than requested where no more fit.
// Throws InputError where the domain is too thin; Cancelled.
std::vector<std::vector<GrownBranch>> grow_trees(std::span<const GrowthRequest> requests,
                                                 PhantomRandom& random, Job& job);

}  // namespace hepatica
