// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates confluence, vein angles and branch levels, and evaluates soft half-spaces for the
// segments.
#include "core/tree/territories/couinaud_frame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "core/tree/systems/anatomical_anchors.h"
#include "core/tree/systems/portal_trunk.h"

namespace hepatica {

namespace {

constexpr double one_degree = std::numbers::pi / 180.0;
constexpr double adult_ml = 1500.0;
// Usual angles of an adult's three veins.
constexpr std::array<double, 3> usual_azimuth{25.0 * one_degree, 70.0 * one_degree,
                                              125.0 * one_degree};

double soft(double distance_mm, double width_mm) {
    return 1.0 / (1.0 + std::exp(-distance_mm / width_mm));
}

// In [-120, 240) degrees: the jump lies behind, where no plane is.
double azimuth_about(const Vec3& axis, const Vec3& at) {
    const double turn = std::atan2(axis.y() - at.y(), axis.x() - at.x());
    return turn < -120.0 * one_degree ? turn + 2.0 * std::numbers::pi : turn;
}

double distance_from_axis(const Vec3& axis, const Vec3& at) {
    return std::hypot(at.x() - axis.x(), at.y() - axis.y());
}

// Signed distance to the upright half-plane at `azimuth`, positive towards larger angles.
double beyond_plane_mm(const Vec3& axis, double azimuth, const Vec3& at) {
    const double turn = azimuth_about(axis, at) - azimuth;
    const double away = distance_from_axis(axis, at);
    if (turn > 90.0 * one_degree) return away;
    if (turn < -90.0 * one_degree) return -away;
    return away * std::sin(turn);
}

// Calls visit(middle, length, radius) for each edge of a system's centrelines.
template <class Visit>
void for_edges(const VesselTree& tree, VascularSystem system, Visit&& visit) {
    for (const VesselSegment& segment : tree.segments) {
        if (segment.system != system) continue;
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            const Vec3 &a = segment.points_mm[i - 1], &b = segment.points_mm[i];
            visit(Vec3(0.5 * (a + b)), (b - a).norm(),
                  0.5 * (segment.radii_mm[i - 1] + segment.radii_mm[i]));
        }
    }
}

// Root of the longest hepatic tree, unless it is too far from the usual confluence.
std::optional<Vec3> root_of_hepatic_veins(const VesselTree& tree,
                                          const Eigen::AlignedBox3d& liver_mm) {
    constexpr double farthest_share = 0.25;  // largest distance from the usual position, in shares
                                             // of the box
    std::vector<int> root(tree.segments.size());
    std::vector<double> length(tree.segments.size(), 0.0);
    int longest = -1;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        root[s] = segment.parent < 0 ? static_cast<int>(s) : root[segment.parent];
        if (segment.system != VascularSystem::hepatic || segment.closes_loop) continue;
        length[root[s]] += length_mm(segment);
        if (longest < 0 || length[root[s]] > length[longest]) longest = root[s];
    }
    if (longest < 0) return std::nullopt;
    const Vec3 at = tree.segments[longest].points_mm.front();
    const Vec3 share = (at - liver_mm.min()).cwiseQuotient(liver_mm.sizes());
    if (((share - usual_confluence).cwiseAbs().maxCoeff()) > farthest_share) return std::nullopt;
    return at;
}

// Angles of the three veins: means of the wide hepatic veins around each, by expectation
// maximisation from the usual angles, which keep some weight.
void find_veins(const VesselTree& tree, CouinaudFrame& frame) {
    constexpr double spread = 18.0 * one_degree;
    constexpr double usual_weight = 0.1, known_share = 0.05;
    constexpr int rounds = 5;
    const double near_mm = 15.0 * frame.scale, far_mm = 80.0 * frame.scale;
    frame.vein_azimuth_rad = usual_azimuth;
    for (int round = 0; round < rounds; ++round) {
        std::array<double, 3> weight{}, sum{};
        double all = 0.0;
        for_edges(tree, VascularSystem::hepatic, [&](const Vec3& at, double length, double radius) {
            const double away = distance_from_axis(frame.confluence_mm, at);
            if (away < near_mm || away > far_mm) return;
            const double azimuth = azimuth_about(frame.confluence_mm, at);
            const double w = length * radius * radius;
            all += w;
            std::array<double, 3> likelihood{};
            double total = 1e-3;
            for (std::size_t k = 0; k < 3; ++k) {
                const double off = (azimuth - frame.vein_azimuth_rad[k]) / spread;
                likelihood[k] = std::exp(-0.5 * off * off);
                total += likelihood[k];
            }
            for (std::size_t k = 0; k < 3; ++k) {
                weight[k] += w * likelihood[k] / total;
                sum[k] += w * likelihood[k] / total * azimuth;
            }
        });
        for (std::size_t k = 0; k < 3; ++k) {
            frame.vein_known[k] = weight[k] > known_share * all;
            if (all > 0.0)
                frame.vein_azimuth_rad[k] = (sum[k] + usual_weight * all * usual_azimuth[k]) /
                                            (weight[k] + usual_weight * all);
        }
    }
}

// Centre of the wide portal branches on one side. Weights grow with the fourth power of the radius,
// so that the main branch dominates.
Vec3 main_branch(const VesselTree& tree, const CouinaudFrame& frame, bool left) {
    double weight = 0.0;
    Vec3 sum = Vec3::Zero();
    for_edges(tree, VascularSystem::portal, [&](const Vec3& at, double length, double radius) {
        if (distance_from_axis(frame.bifurcation_mm, at) < 8.0 * frame.scale) return;
        const Vec3& axis = frame.confluence_mm;
        const double inside = left ? beyond_plane_mm(axis, frame.border_azimuth_rad[2], at)
                                   : -beyond_plane_mm(axis, frame.border_azimuth_rad[1], at);
        const double w = length * std::pow(radius, 4.0) * soft(inside, 4.0 * frame.scale);
        weight += w;
        sum += w * at;
    });
    return weight > 0.0 ? Vec3(sum / weight) : frame.bifurcation_mm;
}

double caudate_likelihood(const CouinaudFrame& frame, const Vec3& at) {
    constexpr double most = 0.9;
    const double width = 4.0 * frame.scale;
    const Vec3& cava = frame.confluence_mm;
    const double near = 28.0 * frame.scale - distance_from_axis(cava, at);
    const double left = at.x() - cava.x() + 10.0 * frame.scale;
    const double above = at.z() - frame.bifurcation_mm.z() + 15.0 * frame.scale;
    const double below = cava.z() - 5.0 * frame.scale - at.z();
    return most * soft(near, width) * soft(left, width) * soft(above, width) * soft(below, width);
}

}  // namespace

CouinaudFrame couinaud_frame(const VesselTree& tree, const Eigen::AlignedBox3d& liver_mm,
                             double liver_ml) {
    CouinaudFrame frame;
    frame.scale = std::cbrt(liver_ml / adult_ml);
    frame.trunk = end_of_portal_trunk(tree);
    frame.bifurcation_mm = tree.segments[frame.trunk].points_mm.back();
    frame.confluence_mm = liver_mm.min() + usual_confluence.cwiseProduct(liver_mm.sizes());
    if (const auto root = root_of_hepatic_veins(tree, liver_mm)) {
        frame.confluence_mm = *root;
        frame.confluence_known = true;
    }
    find_veins(tree, frame);
    // The left hepatic vein runs between segments 2 and 3; the umbilical fissure separates them
    // from segment 4.
    constexpr double fissure_share = 0.65;
    frame.border_azimuth_rad = frame.vein_azimuth_rad;
    frame.border_azimuth_rad[2] =
        frame.vein_azimuth_rad[1] +
        fissure_share * (frame.vein_azimuth_rad[2] - frame.vein_azimuth_rad[1]);
    frame.right_branch_mm = main_branch(tree, frame, false);
    frame.left_branch_mm = main_branch(tree, frame, true);
    return frame;
}

std::array<double, couinaud_count> segment_likelihoods(const CouinaudFrame& frame, const Vec3& at) {
    const double width = 4.0 * frame.scale;
    const Vec3& axis = frame.confluence_mm;
    std::array<double, 3> beyond{};
    for (std::size_t k = 0; k < 3; ++k)
        beyond[k] = soft(beyond_plane_mm(axis, frame.border_azimuth_rad[k], at), width);
    const double posterior = 1.0 - beyond[0];
    const double anterior = beyond[0] * (1.0 - beyond[1]);
    const double medial = beyond[0] * beyond[1] * (1.0 - beyond[2]);
    const double lateral = beyond[0] * beyond[1] * beyond[2];
    const double right_up = soft(at.z() - frame.right_branch_mm.z(), width);
    // Segment 2 lies above and behind segment 3.
    const Vec3 from_left = at - frame.left_branch_mm;
    const double left_up = soft((from_left.y() + from_left.z()) / std::numbers::sqrt2, width);
    std::array<double, couinaud_count> likelihood{0.0,
                                                  lateral * left_up,
                                                  lateral * (1.0 - left_up),
                                                  medial,
                                                  anterior * (1.0 - right_up),
                                                  posterior * (1.0 - right_up),
                                                  posterior * right_up,
                                                  anterior * right_up};
    const double caudate = caudate_likelihood(frame, at);
    for (double& one : likelihood) one *= 1.0 - caudate;
    likelihood[0] = caudate;
    double sum = 0.0;
    for (const double one : likelihood) sum += one;
    for (double& one : likelihood) one /= sum;
    return likelihood;
}

}  // namespace hepatica
