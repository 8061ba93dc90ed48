// SPDX-License-Identifier: GPL-3.0-or-later
// Implements constrained constructive optimisation: random ends, the best of the nearest branches,
// and relaxation of bifurcations by Weiszfeld's iteration.
#include "core/phantom/phantom_growth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double gap_mm = 1.5;  // free tissue between vessels that do not meet
constexpr double smallest_spread_mm = 2.0;
constexpr double surface_mm = 4.0;               // ends lie at least this far below the surface
constexpr int branches_tried = 24;               // the nearest ones, for each new end
constexpr double smallest_sibling_angle = 0.93;  // cosine: siblings diverge by 22 degrees or more
constexpr double greatest_turn = 0.4;            // largest cosine between a branch and the way back

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a;
    const double share = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return (a + share * edge - p).norm();
}

struct Pull {
    Vec3 towards;
    double weight;
};

// The point with the least weighted sum of distances (Weiszfeld's iteration).
Vec3 weighted_median(const std::array<Pull, 3>& pulls) {
    Vec3 p = Vec3::Zero();
    double total = 0.0;
    for (const Pull& pull : pulls) {
        p += pull.weight * pull.towards;
        total += pull.weight;
    }
    p /= total;
    for (int iteration = 0; iteration < 40; ++iteration) {
        Vec3 next = Vec3::Zero();
        double sum = 0.0;
        for (const Pull& pull : pulls) {
            const double w = pull.weight / std::max((p - pull.towards).norm(), 1e-6);
            next += w * pull.towards;
            sum += w;
        }
        p = next / sum;
    }
    return p;
}

struct Proposal {
    int branch = -1;
    Vec3 bifurcation = Vec3::Zero();
    double added_volume = 0.0;
};

class Grower {
  public:
    Grower(const GrowthRequest& request, PhantomRandom& random)
        : request_(request), random_(random) {
        for (int n = 0; n <= request.ends + 1; ++n)
            relative_radius_.push_back(std::pow(n, 1.0 / request.murray_exponent));
    }

    // Adds ends until there are `wanted` or no more fit.
    void grow_to(int wanted, const std::vector<StraightVessel>& obstacles, Job& job) {
        obstacles_ = obstacles;
        if (branches_.empty()) plant_root();
        int failures = 0;
        int replanted = 0;
        while (branches_.front().ends < wanted && spread_mm_ > smallest_spread_mm) {
            job.throw_if_cancelled();
            if (try_new_end(spread_mm_ / std::cbrt(branches_.front().ends))) {
                failures = 0;
            } else if (++failures == 40) {
                spread_mm_ *= 0.95;
                failures = 0;
            }
            // A trunk that cannot branch runs into a corner: plant another.
            if (spread_mm_ <= smallest_spread_mm && branches_.front().ends == 1 && ++replanted < 50)
                plant_root();
        }
        relax();
    }

    const std::vector<GrownBranch>& branches() const { return branches_; }

    std::vector<StraightVessel> vessels() const {
        std::vector<StraightVessel> vessels;
        for (const GrownBranch& b : branches_)
            vessels.push_back({b.begin, b.end, radius_mm(b.ends)});
        return vessels;
    }

  private:
    // Radius of a branch once one more end is added.
    double radius_mm(int ends) const {
        return request_.root_radius_mm * relative_radius_[ends] /
               relative_radius_[branches_.front().ends + 1];
    }
    double section(int ends) const { return relative_radius_[ends] * relative_radius_[ends]; }

    bool inside(const Vec3& a, const Vec3& b, double radius) const {
        const int samples = std::max(2, static_cast<int>((b - a).norm() / 4.0));
        for (int i = 1; i <= samples; ++i) {
            const Vec3 p = a + (b - a) * i / samples;
            // The trunk enters through the surface.
            if ((p - request_.root).norm() < 3.0 * request_.root_radius_mm) continue;
            if (request_.depth_mm(p) < radius + gap_mm) return false;
        }
        return true;
    }

    // Estimated with random points.
    double domain_volume() {
        constexpr int points = 4000;
        int inside = 0;
        for (int i = 0; i < points; ++i)
            inside += request_.depth_mm(random_.point(request_.low, request_.high)) > 0.0 ? 1 : 0;
        return (request_.high - request_.low).prod() * std::max(inside, 1) / points;
    }

    // Uniform in the domain, a little below its surface.
    Vec3 random_end() {
        constexpr int most_points = 1'000'000;
        for (int i = 0; i < most_points; ++i) {
            const Vec3 p = random_.point(request_.low, request_.high);
            if (request_.depth_mm(p) > surface_mm) return p;
        }
        throw InputError("is too thin for vessels", "the organ", "Choose a larger one");
    }

    // The first branch ends at the deepest of some random points that are not far from the entry.
    void plant_root() {
        branches_.clear();
        spread_mm_ = std::cbrt(domain_volume());
        Vec3 best = 0.5 * (request_.low + request_.high);
        double best_depth = -std::numeric_limits<double>::infinity();
        int candidates = 0;
        for (int i = 0; i < 5000 && candidates < 12; ++i) {
            const Vec3 p = random_.point(request_.low, request_.high);
            const double distance = (p - request_.root).norm();
            if (distance < 25.0 || distance > 40.0 ||
                !clear_of_obstacles({request_.root, p, request_.root_radius_mm}))
                continue;
            ++candidates;
            if (request_.depth_mm(p) > best_depth) {
                best = p;
                best_depth = request_.depth_mm(p);
            }
        }
        branches_.push_back({-1, {-1, -1}, request_.root, best, 1});
    }

    bool try_new_end(double free_mm) {
        const Vec3 end = random_end();
        std::vector<std::pair<double, int>> near;
        for (std::size_t i = 0; i < branches_.size(); ++i) {
            const double d = distance_to_segment(end, branches_[i].begin, branches_[i].end);
            if (d < free_mm) return false;
            near.emplace_back(d, static_cast<int>(i));
        }
        const std::size_t tried = std::min<std::size_t>(branches_tried, near.size());
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(tried),
                          near.end());
        std::optional<Proposal> best;
        for (std::size_t i = 0; i < tried; ++i) {
            const Proposal proposal = propose(near[i].second, end);
            if (best && proposal.added_volume >= best->added_volume) continue;
            if (fits(proposal, end)) best = proposal;
        }
        if (best) attach(*best, end);
        return best.has_value();
    }

    Proposal propose(int branch, const Vec3& end) const {
        const GrownBranch& b = branches_[branch];
        Proposal proposal;
        proposal.branch = branch;
        proposal.bifurcation = weighted_median(
            {{{b.begin, section(b.ends + 1)}, {b.end, section(b.ends)}, {end, section(1)}}});
        const Vec3& f = proposal.bifurcation;
        proposal.added_volume =
            section(b.ends + 1) * (f - b.begin).norm() + section(b.ends) * (b.end - f).norm() +
            section(1) * (end - f).norm() - section(b.ends) * (b.end - b.begin).norm();
        for (int up = b.parent; up >= 0; up = branches_[up].parent)
            proposal.added_volume +=
                (section(branches_[up].ends + 1) - section(branches_[up].ends)) *
                (branches_[up].end - branches_[up].begin).norm();
        return proposal;
    }

    // A proposed bifurcation with its three branches.
    struct Joint {
        Vec3 begin;
        Vec3 middle;
        std::array<Vec3, 2> ends;
        std::array<int, 2> ends_beyond;
    };

    bool fits(const Proposal& proposal, const Vec3& end) const {
        const GrownBranch& b = branches_[proposal.branch];
        const Joint joint{b.begin, proposal.bifurcation, {b.end, end}, {b.ends, 1}};
        const std::array<int, 1> replaced{proposal.branch};
        return well_shaped(joint) && clear(joint, replaced);
    }

    bool well_shaped(const Joint& joint) const {
        const double stem = radius_mm(joint.ends_beyond[0] + joint.ends_beyond[1]);
        const double shortest = std::max(1.5 * stem, 3.0);
        const Vec3 back = joint.begin - joint.middle;
        const Vec3 a = joint.ends[0] - joint.middle;
        const Vec3 b = joint.ends[1] - joint.middle;
        if (back.norm() < shortest || a.norm() < shortest || b.norm() < shortest) return false;
        if (a.normalized().dot(b.normalized()) > smallest_sibling_angle) return false;
        if (std::max(a.normalized().dot(back.normalized()), b.normalized().dot(back.normalized())) >
            greatest_turn)
            return false;
        return inside(joint.begin, joint.middle, stem) &&
               inside(joint.middle, joint.ends[0], radius_mm(joint.ends_beyond[0])) &&
               inside(joint.middle, joint.ends[1], radius_mm(joint.ends_beyond[1]));
    }

    static bool too_near(const StraightVessel& a, const StraightVessel& b) {
        return distance_between(a.begin, a.end, b.begin, b.end) < a.radius + b.radius + gap_mm;
    }

    bool clear_of_obstacles(const StraightVessel& part) const {
        return std::ranges::none_of(
            obstacles_, [&](const StraightVessel& other) { return too_near(part, other); });
    }

    // Whether the three branches keep clear of all vessels that they do not meet.
    bool clear(const Joint& joint, std::span<const int> replaced) const {
        const std::array<StraightVessel, 3> parts{
            {{joint.begin, joint.middle, radius_mm(joint.ends_beyond[0] + joint.ends_beyond[1])},
             {joint.middle, joint.ends[0], radius_mm(joint.ends_beyond[0])},
             {joint.middle, joint.ends[1], radius_mm(joint.ends_beyond[1])}}};
        if (!std::ranges::all_of(parts,
                                 [&](const StraightVessel& c) { return clear_of_obstacles(c); }))
            return false;
        for (std::size_t i = 0; i < branches_.size(); ++i) {
            if (std::ranges::find(replaced, static_cast<int>(i)) != replaced.end()) continue;
            const GrownBranch& b = branches_[i];
            const StraightVessel other{b.begin, b.end, radius_mm(b.ends)};
            const bool meets_begin = b.end == joint.begin || b.begin == joint.begin;
            if ((!meets_begin && too_near(parts[0], other)) ||
                (b.begin != joint.ends[0] && too_near(parts[1], other)) ||
                (b.begin != joint.ends[1] && too_near(parts[2], other)))
                return false;
        }
        return true;
    }

    // Moves every bifurcation half way towards the point where its branches hold the least blood.
    void relax() {
        for (int sweep = 0; sweep < 8; ++sweep)
            for (std::size_t i = 0; i < branches_.size(); ++i) {
                GrownBranch& stem = branches_[i];
                if (stem.children[0] < 0) continue;
                GrownBranch& a = branches_[stem.children[0]];
                GrownBranch& b = branches_[stem.children[1]];
                const Vec3 best = weighted_median({{{stem.begin, section(stem.ends)},
                                                    {a.end, section(a.ends)},
                                                    {b.end, section(b.ends)}}});
                const Joint moved{
                    stem.begin, 0.5 * (stem.end + best), {a.end, b.end}, {a.ends, b.ends}};
                const std::array<int, 3> replaced{static_cast<int>(i), stem.children[0],
                                                  stem.children[1]};
                if (well_shaped(moved) && clear(moved, replaced))
                    stem.end = a.begin = b.begin = moved.middle;
            }
    }

    void attach(const Proposal& proposal, const Vec3& end) {
        const int lower = static_cast<int>(branches_.size());
        const int fresh = lower + 1;
        GrownBranch continuation = branches_[proposal.branch];
        continuation.parent = proposal.branch;
        continuation.begin = proposal.bifurcation;
        for (const int child : continuation.children)
            if (child >= 0) branches_[child].parent = lower;
        branches_.push_back(continuation);
        branches_.push_back({proposal.branch, {-1, -1}, proposal.bifurcation, end, 1});
        branches_[proposal.branch].end = proposal.bifurcation;
        branches_[proposal.branch].children = {lower, fresh};
        for (int up = proposal.branch; up >= 0; up = branches_[up].parent) ++branches_[up].ends;
    }

    const GrowthRequest& request_;
    PhantomRandom& random_;
    std::vector<double> relative_radius_;  // n^(1/m): relative radius of a branch with n ends
                                           // beyond it
    std::vector<GrownBranch> branches_;
    std::vector<StraightVessel> obstacles_;  // the other trees
    double spread_mm_ = 0.0;  // new ends keep this over the cube root of the number of ends away
};

}  // namespace

double distance_between(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const Vec3 u = a1 - a0;
    const Vec3 v = b1 - b0;
    const Vec3 w = a0 - b0;
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double det = uu * vv - uv * uv;
    double s =
        det > 1e-12 * uu * vv ? std::clamp((uv * v.dot(w) - vv * u.dot(w)) / det, 0.0, 1.0) : 0.0;
    const double t = vv > 0.0 ? std::clamp((uv * s + v.dot(w)) / vv, 0.0, 1.0) : 0.0;
    s = uu > 0.0 ? std::clamp((uv * t - u.dot(w)) / uu, 0.0, 1.0) : 0.0;
    return (a0 + s * u - b0 - t * v).norm();
}

std::vector<std::vector<GrownBranch>> grow_trees(std::span<const GrowthRequest> requests,
                                                 PhantomRandom& random, Job& job) {
    std::vector<Grower> growers;
    int most_ends = 1;
    for (const GrowthRequest& request : requests) {
        growers.emplace_back(request, random);
        most_ends = std::max(most_ends, request.ends);
    }
    for (int ends = 1; ends < 2 * most_ends; ends *= 2)
        for (std::size_t i = 0; i < growers.size(); ++i) {
            std::vector<StraightVessel> obstacles;
            for (std::size_t j = 0; j < growers.size(); ++j)
                if (j != i) std::ranges::copy(growers[j].vessels(), std::back_inserter(obstacles));
            growers[i].grow_to(std::min(ends, requests[i].ends), obstacles, job);
            job.advance(static_cast<double>(ends) / (2.0 * most_ends));
        }
    std::vector<std::vector<GrownBranch>> trees;
    for (const Grower& grower : growers) trees.push_back(grower.branches());
    return trees;
}

}  // namespace hepatica
