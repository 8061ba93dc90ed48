// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/pull_trial.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/scene/tools/tool_choice.h"

namespace hepatica {
namespace {

constexpr double share_of_the_way = 0.6;  // from the root to the furthest tip
constexpr int frames_out = Pull::frames / 2;
constexpr double reach_radii = 1.5;  // reach of the hand, so that it holds whole cross-sections

std::vector<double> distances_from_roots(const CoarseSkeleton& skeleton) {
    std::vector<double> distance(skeleton.size(), 0.0);
    for (int n = 0; n < skeleton.size(); ++n) {
        const int parent = skeleton.parent[n];
        if (parent >= 0)
            distance[n] = distance[parent] +
                          (skeleton.positions_mm[n] - skeleton.positions_mm[parent]).norm();
    }
    return distance;
}

// The root of each node's tree.
std::vector<int> roots_of(const CoarseSkeleton& skeleton) {
    std::vector<int> root(skeleton.size());
    for (int n = 0; n < skeleton.size(); ++n)
        root[n] = skeleton.parent[n] < 0 ? n : root[skeleton.parent[n]];
    return root;
}

std::vector<char> trees_that_are_fixed(const BodyDescription& body, const std::vector<int>& root) {
    std::vector<char> fixed(root.size(), 0);
    const SkeletonBinding binding = bind_vertices(body.skeleton, body.mesh.vertices_mm);
    for (std::size_t v = 0; v < body.fixed.size(); ++v)
        if (body.fixed[v] != 0) fixed[root[binding.nodes[v][0]]] = 1;
    return fixed;
}

// A quarter of each tetrahedron's volume for each of its corners.
std::vector<double> lumped_volumes(const TetMesh& mesh) {
    std::vector<double> volume(mesh.vertices_mm.size(), 0.0);
    for (const auto& t : mesh.tetrahedra) {
        Mat3 edges;
        for (int a = 0; a < 3; ++a)
            edges.col(a) = mesh.vertices_mm[t[a + 1]] - mesh.vertices_mm[t[0]];
        for (const int v : t) volume[v] += edges.determinant() / 24.0;
    }
    return volume;
}

}  // namespace

Pull::Pull(const BodyDescription& body) {
    const CoarseSkeleton& skeleton = body.skeleton;
    if (skeleton.size() < 2)
        throw InputError("has no skeleton", "the body",
                         "Give it a centreline of two nodes or more");
    const std::vector<double> distance = distances_from_roots(skeleton);
    const std::vector<int> root = roots_of(skeleton);
    const std::vector<char> fixed = trees_that_are_fixed(body, root);
    int tip = -1;
    for (int n = 0; n < skeleton.size(); ++n)
        if (fixed[root[n]] != 0 && (tip < 0 || distance[n] > distance[tip])) tip = n;
    if (tip < 0) throw InputError("nothing of it is fixed", "the body", "Fix the ends of the tree");
    int held = tip;
    while (skeleton.parent[held] >= 0 && distance[held] > share_of_the_way * distance[tip])
        held = skeleton.parent[held];
    const int next = skeleton.parent[held] >= 0 ? skeleton.parent[held] : tip;
    const Vec3 axis = skeleton.positions_mm[held] - skeleton.positions_mm[next];
    int least = 0;
    axis.cwiseAbs().minCoeff(&least);
    place_mm_ = skeleton.positions_mm[held];
    radius_mm_ = skeleton.radii_mm[held];
    way_ = axis.cross(Vec3(Vec3::Unit(least))).normalized();
}

std::vector<Grab> Pull::grabs(const BodyDescription& body, int frame) const {
    const std::vector<double> volume = lumped_volumes(body.mesh);
    std::vector<int> held;
    double held_mm3 = 0.0;
    for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v) {
        if ((body.mesh.vertices_mm[v] - place_mm_).norm() > reach_radii * radius_mm_) continue;
        held.push_back(static_cast<int>(v));
        held_mm3 += volume[v];
    }
    const int frames_from_start = std::min(frame + 1, Pull::frames - frame - 1);
    const double moved = distance_mm * frames_from_start / frames_out;
    const double modulus_pa = body.material.young_modulus_pa;
    std::vector<Grab> grabs(held.size());
    for (std::size_t i = 0; i < held.size(); ++i) {
        const double share = volume[held[i]] / held_mm3;
        grabs[i].vertices[0] = held[i];
        grabs[i].target_mm = body.mesh.vertices_mm[held[i]] + moved * way_;
        grabs[i].stiffness_un_per_mm = share * modulus_pa * std::numbers::pi * radius_mm_;
        grabs[i].force_limit_un =
            share * hand_strain * modulus_pa * std::numbers::pi * radius_mm_ * radius_mm_;
    }
    return grabs;
}

CentrelineProbes::CentrelineProbes(const std::vector<Vec3>& points_mm, const TetMesh& mesh) {
    probes_.resize(points_mm.size());
    std::vector<double> best(points_mm.size(), -std::numeric_limits<double>::infinity());
    for (const auto& corners : mesh.tetrahedra) {
        const Vec3& origin = mesh.vertices_mm[corners[0]];
        Mat3 edges;
        for (int a = 0; a < 3; ++a) edges.col(a) = mesh.vertices_mm[corners[a + 1]] - origin;
        const Mat3 inverse = edges.inverse();
        for (std::size_t p = 0; p < points_mm.size(); ++p) {
            const Vec3 w = inverse * (points_mm[p] - origin);
            const double inside = std::min(w.minCoeff(), 1.0 - w.sum());
            if (!(inside > best[p])) continue;
            best[p] = inside;
            probes_[p] = {corners, {1.0 - w.sum(), w[0], w[1], w[2]}};
        }
    }
}

std::vector<Vec3> CentrelineProbes::places_mm(std::span<const Vec3> vertices_mm) const {
    std::vector<Vec3> places;
    places.reserve(probes_.size());
    for (const Probe& probe : probes_) {
        Vec3 place = Vec3::Zero();
        for (int a = 0; a < 4; ++a) place += probe.weights[a] * vertices_mm[probe.vertices[a]];
        places.push_back(place);
    }
    return places;
}

MotionDifference motion_difference(std::span<const Vec3> motion, std::span<const Vec3> reference) {
    assert(motion.size() == reference.size() && !motion.empty());
    double missed = 0.0, moved = 0.0, furthest = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const double squared = (motion[i] - reference[i]).squaredNorm();
        missed += squared;
        furthest = std::max(furthest, squared);
        moved += reference[i].squaredNorm();
    }
    return {std::sqrt(missed / moved), std::sqrt(missed / static_cast<double>(motion.size())),
            std::sqrt(furthest)};
}

void require_movement(const CentrelineMotion& reference) {
    const bool moves = std::ranges::any_of(
        reference, [](const Vec3& displacement) { return !displacement.isZero(0.0); });
    if (!moves)
        throw InputError("does not move where the hand pulls", "the body",
                         "Name the setting in the scene: its errors cannot be measured");
}

double motion_error(const CentrelineMotion& motion, const CentrelineMotion& reference) {
    return motion_difference(motion, reference).relative;
}

}  // namespace hepatica
