// SPDX-License-Identifier: GPL-3.0-or-later
// Draws branches as cubic Hermite curves with sway, and straightens those that would touch others.
#include "core/phantom/phantom_centrelines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hepatica {

namespace {

constexpr double taper_per_mm = 0.003;   // share of the radius lost per mm to side branches that
                                         // are not drawn
constexpr double smallest_taper = 0.85;  // least ratio of the radii of a segment's ends
constexpr double branch_free_mm = 0.8;   // kept free between vessels that do not meet

// How a branch deviates from its straight chord.
struct Bend {
    Vec3 begin_tangent = Vec3::Zero();  // unit
    Vec3 end_tangent = Vec3::Zero();
    Vec3 sway_a = Vec3::Zero();  // mm, of a half and a whole wave; both vanish at the ends
    Vec3 sway_b = Vec3::Zero();
};

Vec3 direction(const GrownBranch& branch) {
    return (branch.end - branch.begin).normalized();
}

// The mean direction of flow at the node where a branch ends.
Vec3 direction_at_end(std::span<const GrownBranch> branches, const GrownBranch& branch) {
    Vec3 sum = branch.ends * direction(branch);
    for (const int child : branch.children)
        if (child >= 0) sum += branches[child].ends * direction(branches[child]);
    return sum.normalized();
}

Vec3 across(const Vec3& unit, double angle) {
    Vec3 helper = Vec3::Zero();
    Eigen::Index thinnest = 0;
    unit.cwiseAbs().minCoeff(&thinnest);
    helper[thinnest] = 1.0;
    const Vec3 a = unit.cross(helper).normalized();
    const Vec3 b = unit.cross(a);
    return std::cos(angle) * a + std::sin(angle) * b;
}

// A vector across the chord, of at most this share of its length. The size is drawn first, then the
// angle: both draws in one expression would come in an order that each compiler chooses.
Vec3 draw_sway(const Vec3& chord, double length, double most, PhantomRandom& random) {
    const double share = random.uniform(0.0, most);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    return across(chord, angle) * share * length;
}

Bend draw_bend(std::span<const GrownBranch> branches, const GrownBranch& branch,
               PhantomRandom& random) {
    const Vec3 chord = direction(branch);
    const double length = (branch.end - branch.begin).norm();
    Bend bend;
    // A side branch leaves its parent abruptly, the main continuation follows it.
    const double follows =
        branch.parent < 0 ? 0.0
                          : 0.8 * branch.ends / static_cast<double>(branches[branch.parent].ends);
    const Vec3 incoming =
        branch.parent < 0 ? chord : direction_at_end(branches, branches[branch.parent]);
    bend.begin_tangent = (follows * incoming + (1.0 - follows) * chord).normalized();
    bend.end_tangent = (0.6 * direction_at_end(branches, branch) + 0.4 * chord).normalized();
    bend.sway_a = draw_sway(chord, length, 0.05, random);
    bend.sway_b = draw_sway(chord, length, 0.03, random);
    return bend;
}

// Cubic Hermite curve plus sway; `amount` 0 gives the chord.
Vec3 point_on(const GrownBranch& branch, const Bend& bend, double amount, double u) {
    const Vec3 chord = branch.end - branch.begin;
    const Vec3 straight = branch.begin + u * chord;
    const double length = chord.norm();
    const double v = 1.0 - u;
    const Vec3 bent =
        u * v *
        (v * (length * bend.begin_tangent - chord) - u * (length * bend.end_tangent - chord));
    const double fade = 4.0 * u * v;
    const double wave = std::sin(2.0 * std::numbers::pi * u);
    const Vec3 sway = fade * fade * bend.sway_a + fade * wave * bend.sway_b;
    return straight + amount * (bent + sway);
}

std::vector<Vec3> points_on(const GrownBranch& branch, const Bend& bend, double amount,
                            double spacing_mm) {
    const double length = (branch.end - branch.begin).norm();
    const int pieces = std::max(2, static_cast<int>(std::ceil(length / spacing_mm)));
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(point_on(branch, bend, amount, static_cast<double>(i) / pieces));
    points.front() = branch.begin;
    points.back() = branch.end;
    return points;
}

std::vector<double> tapering_radii(const std::vector<Vec3>& points, double begin_radius_mm) {
    std::vector<double> along{0.0};
    for (std::size_t i = 1; i < points.size(); ++i)
        along.push_back(along.back() + (points[i] - points[i - 1]).norm());
    const double taper = std::max(smallest_taper, 1.0 - taper_per_mm * along.back());
    std::vector<double> radii;
    for (const double s : along)
        radii.push_back(begin_radius_mm * (1.0 - (1.0 - taper) * s / along.back()));
    return radii;
}

void append_vessels(std::vector<StraightVessel>& vessels, const VesselSegment& segment) {
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i)
        vessels.push_back({segment.points_mm[i - 1], segment.points_mm[i],
                           std::max(segment.radii_mm[i - 1], segment.radii_mm[i])});
}

class SystemBuilder {
  public:
    SystemBuilder(VesselTree& tree, std::span<const GrownBranch> branches,
                  const CentrelineRequest& request)
        : tree_(tree), branches_(branches), request_(request), segment_of_(branches.size(), -1) {
        append_chords(chords_, branches, request);
    }

    void build(PhantomRandom& random) {
        tree_.nodes.push_back({branches_[0].begin, request_.root_radius_mm});
        // Parents before children; the stack holds the branches still to be appended.
        std::vector<Pending> pending{
            {0, static_cast<int>(tree_.nodes.size()) - 1, -1, request_.root_radius_mm}};
        while (!pending.empty()) {
            const Pending next = pending.back();
            pending.pop_back();
            const int id = append(next, random);
            push_children(pending, next.branch, id);
        }
    }

  private:
    struct Pending {
        int branch;
        int proximal_node;
        int parent;
        double begin_radius_mm;
    };

    int append(const Pending& next, PhantomRandom& random) {
        const GrownBranch& branch = branches_[next.branch];
        const Bend bend = draw_bend(branches_, branch, random);
        VesselSegment segment;
        segment.proximal_node = next.proximal_node;
        segment.distal_node = static_cast<int>(tree_.nodes.size());
        segment.parent = next.parent;
        segment.system = request_.system;
        const std::vector<StraightVessel> others = neighbours(next.branch);
        for (const double amount : {1.0, 0.7, 0.4, 0.2, 0.0}) {
            segment.points_mm = points_on(branch, bend, amount, request_.point_spacing_mm);
            segment.radii_mm = tapering_radii(segment.points_mm, next.begin_radius_mm);
            if (is_clear(segment, others)) break;
        }
        tree_.nodes.push_back({branch.end, segment.radii_mm.back()});
        tree_.segments.push_back(segment);
        const int id = static_cast<int>(tree_.segments.size()) - 1;
        segment_of_[next.branch] = id;
        return id;
    }

    void push_children(std::vector<Pending>& pending, int branch, int id) const {
        const GrownBranch& parent = branches_[branch];
        const VesselSegment& segment = tree_.segments[id];
        for (const int child : parent.children) {
            if (child < 0) continue;
            const double share = static_cast<double>(branches_[child].ends) / parent.ends;
            pending.push_back(
                {child, segment.distal_node, id,
                 segment.radii_mm.back() * std::pow(share, 1.0 / request_.murray_exponent)});
        }
    }

    // Whether any bent form of the branch can come near the vessel (by their bounding balls).
    bool in_reach(int branch, const StraightVessel& other) const {
        const GrownBranch& b = branches_[branch];
        const double reach = 0.8 * (b.end - b.begin).norm() + chords_[branch].radius +
                             0.8 * (other.end - other.begin).norm() + other.radius + branch_free_mm;
        return (b.begin + b.end - other.begin - other.end).norm() < 2.0 * reach;
    }

    // The vessels that the branch has to keep clear of: obstacles, drawn vessels, and the chords of
    // branches not yet drawn.
    std::vector<StraightVessel> neighbours(int branch) const {
        std::vector<StraightVessel> near;
        for (const StraightVessel& obstacle : request_.obstacles)
            if (in_reach(branch, obstacle)) near.push_back(obstacle);
        for (std::size_t i = 0; i < branches_.size(); ++i) {
            const int other = static_cast<int>(i);
            const StraightVessel& chord = chords_[i];
            if (other == branch || meet(other, branch) || !in_reach(branch, chord)) continue;
            if (segment_of_[i] >= 0)
                append_vessels(near, tree_.segments[segment_of_[i]]);
            else
                near.push_back(chord);
        }
        return near;
    }

    static bool is_clear(const VesselSegment& segment, const std::vector<StraightVessel>& others) {
        for (std::size_t i = 0; i < segment.points_mm.size(); ++i) {
            const Vec3& p = segment.points_mm[i];
            for (const StraightVessel& other : others)
                if (distance_between(p, p, other.begin, other.end) <
                    segment.radii_mm[i] + other.radius + branch_free_mm)
                    return false;
        }
        return true;
    }

    bool meet(int a, int b) const {
        return branches_[a].parent == b || branches_[b].parent == a ||
               (branches_[a].parent >= 0 && branches_[a].parent == branches_[b].parent);
    }

    VesselTree& tree_;
    std::span<const GrownBranch> branches_;
    const CentrelineRequest& request_;
    std::vector<StraightVessel> chords_;
    std::vector<int> segment_of_;  // of each branch; -1 while it is not drawn
};

}  // namespace

void append_system(VesselTree& tree, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request, PhantomRandom& random) {
    SystemBuilder(tree, branches, request).build(random);
    set_strahler_orders(tree);
}

void append_chords(std::vector<StraightVessel>& vessels, std::span<const GrownBranch> branches,
                   const CentrelineRequest& request) {
    for (const GrownBranch& branch : branches) {
        const double share = static_cast<double>(branch.ends) / branches.front().ends;
        vessels.push_back(
            {branch.begin, branch.end,
             request.root_radius_mm * std::pow(share, 1.0 / request.murray_exponent)});
    }
}

std::vector<StraightVessel> straight_vessels_of(const VesselTree& tree) {
    std::vector<StraightVessel> vessels;
    for (const VesselSegment& segment : tree.segments) append_vessels(vessels, segment);
    return vessels;
}

}  // namespace hepatica
