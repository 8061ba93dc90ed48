// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/side_tears.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/flow/tube_law.h"
#include "core/scene/origins_of.h"

namespace hepatica {
namespace {

constexpr double least_gape_mm2 = 0.01;
constexpr double steps_per_octave = 4.0;

// Of a joint, the area whose corners have come apart.
double parted_mm2(const Joint& joint, const OpenJoint& open) {
    return joint.area_mm2 / 3.0 * static_cast<double>(std::ranges::count(open.corners, true));
}

// Open joints that meet at corners that have come apart.
using Crack = std::vector<OpenJoint>;

std::vector<Crack> cracks_of(const TornTopology& topology, const std::vector<OpenJoint>& open,
                             const std::vector<int>& origins) {
    DisjointSets sets(origins.size());
    const auto origin = [&](const OpenJoint& one, int k) {
        const Joint& joint = topology.joints()[static_cast<std::size_t>(one.joint)];
        const auto corner = static_cast<std::size_t>(topology.sides(joint, k)[0]);
        return static_cast<std::uint32_t>(origins[corner]);
    };
    const auto first_open = [](const OpenJoint& one) {
        return static_cast<int>(std::ranges::find(one.corners, true) - one.corners.begin());
    };
    for (const OpenJoint& one : open)
        for (int k = 0; k < 3; ++k)
            if (one.corners[static_cast<std::size_t>(k)])
                sets.unite(origin(one, first_open(one)), origin(one, k));
    std::map<std::uint32_t, Crack> by_root;
    for (const OpenJoint& one : open)
        by_root[sets.root(origin(one, first_open(one)))].push_back(one);
    std::vector<Crack> cracks;
    for (auto& [root, crack] : by_root) cracks.push_back(std::move(crack));
    return cracks;
}

// The edges on the surface of the whole body between vertices of open joints, by the vertices that
// these were split from, ascending.
std::vector<std::array<int, 2>> edges_on_surface(const TornTopology& topology,
                                                 const std::vector<OpenJoint>& open,
                                                 const std::vector<int>& origins) {
    std::vector<std::uint8_t> asked(origins.size(), 0);
    const auto origin = [&](int v) { return origins[static_cast<std::size_t>(v)]; };
    for (const OpenJoint& one : open)
        for (int k = 0; k < 3; ++k) {
            const Joint& joint = topology.joints()[static_cast<std::size_t>(one.joint)];
            asked[static_cast<std::size_t>(origin(topology.sides(joint, k)[0]))] = 1;
        }
    std::vector<std::array<int, 2>> edges;
    const auto tetrahedra = topology.tetrahedra();
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            if (topology.joint_opposite(static_cast<int>(t), i) >= 0) continue;
            const std::array<int, 3>& face = face_corners[static_cast<std::size_t>(i)];
            for (std::size_t k = 0; k < 3; ++k) {
                const auto corner = [&](std::size_t at) {
                    return origin(tetrahedra[t][static_cast<std::size_t>(face[at % 3])]);
                };
                const int a = corner(k), b = corner(k + 1);
                if (asked[static_cast<std::size_t>(a)] != 0 &&
                    asked[static_cast<std::size_t>(b)] != 0)
                    edges.push_back({std::min(a, b), std::max(a, b)});
            }
        }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

class SideSearch {
  public:
    SideSearch(const VesselTree& tree, const Tearing& tearing,
               std::span<const VertexPlace> tetrahedra, double stretch_mm,
               std::span<const ThroughTear> through)
        : tree_(tree),
          topology_(tearing.topology()),
          tetrahedra_(tetrahedra),
          stretch_mm_(stretch_mm),
          through_(through),
          origins_(origins_of(topology_)) {
        const std::vector<OpenJoint> open = tearing.open_joints();
        if (open.empty()) return;
        edges_ = edges_on_surface(topology_, open, origins_);
        for (const Crack& crack : cracks_of(topology_, open, origins_)) add(crack);
    }

    std::vector<SideTear> take() {
        std::vector<SideTear> found;
        for (auto& [place, side] : sides_) {
            const VesselSegment& vessel = tree_.segments[static_cast<std::size_t>(place.first)];
            const double lumen_mm2 = hepatica::lumen_mm2(vessel, side.at.arclength_mm);
            side.most_mm2 = 2.0 * std::min(side.most_mm2, lumen_mm2);
            found.push_back(std::move(side));
        }
        return found;
    }

  private:
    const Joint& joint_of(const OpenJoint& one) const {
        return topology_.joints()[static_cast<std::size_t>(one.joint)];
    }
    const VertexPlace& place_of(int tetrahedron) const {
        return tetrahedra_[static_cast<std::size_t>(tetrahedron)];
    }
    int stretch_of(const TreePoint& at) const {
        return static_cast<int>(std::floor(at.arclength_mm / stretch_mm_));
    }

    static bool has_broken(const Crack& crack) {
        return std::ranges::any_of(crack, [](const OpenJoint& one) {
            return one.corners == std::array<bool, 3>{true, true, true};
        });
    }

    bool reaches_lumen(const Crack& crack) const {
        constexpr double inside = 1.0 - TubeWall{}.thickness_per_radius;
        return std::ranges::any_of(crack, [&](const OpenJoint& one) {
            const auto& [a, b] = joint_of(one).tetrahedra;
            return place_of(a).on_tree.distance_mm + place_of(b).on_tree.distance_mm <
                   inside * (place_of(a).radius_mm + place_of(b).radius_mm);
        });
    }

    bool of_a_through_tear(const Crack& crack) const {
        const auto belongs = [&](const TreePoint& at, const ThroughTear& tear) {
            return at.segment == tear.at.segment &&
                   std::abs(stretch_of(at) - stretch_of(tear.at)) <= 1;
        };
        for (const OpenJoint& one : crack)
            for (const int t : joint_of(one).tetrahedra)
                for (const ThroughTear& tear : through_)
                    if (belongs(place_of(t).on_tree, tear)) return true;
        return false;
    }

    // Projected onto the plane that most of it lies in, so that zigzags do not count.
    double projected_mm2(const Crack& crack) const {
        Mat3 sum = Mat3::Zero();
        for (const OpenJoint& one : crack) {
            const Joint& joint = joint_of(one);
            sum += parted_mm2(joint, one) * joint.normal * joint.normal.transpose();
        }
        const Vec3 normal = Eigen::SelfAdjointEigenSolver<Mat3>(sum).eigenvectors().col(2);
        double area = 0.0;
        for (const OpenJoint& one : crack)
            area += parted_mm2(joint_of(one), one) * std::abs(joint_of(one).normal.dot(normal));
        return area;
    }

    // The mean place of what has parted on the segment that most of it lies on.
    TreePoint middle_of(const Crack& crack) const {
        struct OnSegment {
            double area = 0.0, moment = 0.0;
        };
        std::map<int, OnSegment> segments;
        for (const OpenJoint& one : crack)
            for (const int t : joint_of(one).tetrahedra) {
                const TreePoint& at = place_of(t).on_tree;
                const double area = parted_mm2(joint_of(one), one);
                segments[at.segment].area += area;
                segments[at.segment].moment += area * at.arclength_mm;
            }
        const auto most = std::ranges::max_element(
            segments, {}, [](const auto& entry) { return entry.second.area; });
        return {most->first, most->second.moment / most->second.area, 0.0};
    }

    std::vector<std::array<int, 4>> gaps_of(const Crack& crack) const {
        std::vector<std::array<int, 4>> gaps;
        for (const OpenJoint& one : crack)
            for (int k = 0; k < 3; ++k) {
                const int next = (k + 1) % 3;
                const bool open = one.corners[static_cast<std::size_t>(k)];
                const bool next_open = one.corners[static_cast<std::size_t>(next)];
                if (!open && !next_open) continue;
                const auto [a, c] = topology_.sides(joint_of(one), k);
                const auto [b, d] = topology_.sides(joint_of(one), next);
                const auto [low, high] = std::minmax(
                    {origins_[static_cast<std::size_t>(a)], origins_[static_cast<std::size_t>(b)]});
                if (std::ranges::binary_search(edges_, std::array<int, 2>{low, high}))
                    gaps.push_back({a, b, next_open ? d : b, open ? c : a});
            }
        return gaps;
    }

    void add(const Crack& crack) {
        if (!has_broken(crack) || !reaches_lumen(crack) || of_a_through_tear(crack)) return;
        const std::vector<std::array<int, 4>> gaps = gaps_of(crack);
        if (gaps.empty()) return;
        const TreePoint middle = middle_of(crack);
        const double length = length_mm(tree_.segments[static_cast<std::size_t>(middle.segment)]);
        int stretch = stretch_of(middle);
        if (stretch > 0 && stretch * stretch_mm_ >= length) --stretch;
        const double from = stretch * stretch_mm_;
        SideTear& side = sides_[{middle.segment, stretch}];
        side.at = {middle.segment, 0.5 * (from + std::min(from + stretch_mm_, length)), 0.0};
        side.most_mm2 += projected_mm2(crack);
        side.gaps.insert(side.gaps.end(), gaps.begin(), gaps.end());
    }

    const VesselTree& tree_;
    const TornTopology& topology_;
    std::span<const VertexPlace> tetrahedra_;
    double stretch_mm_;
    std::span<const ThroughTear> through_;
    std::vector<int> origins_;
    std::vector<std::array<int, 2>> edges_;
    std::map<std::pair<int, int>, SideTear> sides_;  // by segment and stretch; areas without lumen
};

}  // namespace

std::vector<SideTear> side_tears(const VesselTree& tree, const Tearing& tearing,
                                 std::span<const VertexPlace> tetrahedra, double stretch_mm,
                                 std::span<const ThroughTear> through) {
    if (tearing.report().joints_broken == 0) return {};
    return SideSearch(tree, tearing, tetrahedra, stretch_mm, through).take();
}

double gape_mm2(const SideTear& tear, std::span<const Vec3> positions_mm) {
    double area = 0.0;
    for (const std::array<int, 4>& gap : tear.gaps) {
        const auto from_first = [&](std::size_t k) -> Vec3 {
            return positions_mm[static_cast<std::size_t>(gap[k])] -
                   positions_mm[static_cast<std::size_t>(gap[0])];
        };
        const Vec3 diagonal = from_first(2);
        area += 0.5 * (from_first(1).cross(diagonal).norm() + diagonal.cross(from_first(3)).norm());
    }
    return area;
}

// The sides of each gap that lie along the crack are the first and the third.
double slit_length_mm(const SideTear& tear, std::span<const Vec3> positions_mm) {
    const auto between = [&](int a, int b) {
        return (positions_mm[static_cast<std::size_t>(a)] -
                positions_mm[static_cast<std::size_t>(b)])
            .norm();
    };
    double length = 0.0;
    for (const auto& [a, b, d, c] : tear.gaps) length += 0.5 * (between(a, b) + between(c, d));
    return length;
}

double opening_mm2(const SideTear& tear, std::span<const Vec3> positions_mm, double held_open_mm2) {
    const double gape = std::max(gape_mm2(tear, positions_mm), held_open_mm2);
    if (!(gape >= least_gape_mm2)) return 0.0;
    const double octaves = std::round(steps_per_octave * std::log2(gape)) / steps_per_octave;
    return std::min(tear.most_mm2, std::exp2(octaves));
}

std::vector<ThroughTear> open_tears(const TornPlaces& torn, std::span<const Vec3> positions_mm,
                                    const HeldOpen& held_open_mm2) {
    std::vector<ThroughTear> tears = torn.through;
    for (const SideTear& side : torn.sides) {
        const double held_mm2 = held_open_mm2(side.at.segment, slit_length_mm(side, positions_mm));
        const double area_mm2 = opening_mm2(side, positions_mm, held_mm2);
        if (area_mm2 > 0.0) tears.push_back({side.at, area_mm2, true});
    }
    return tears;
}

}  // namespace hepatica
