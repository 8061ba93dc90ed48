// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/phantom_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hepatica {

namespace {

constexpr double gap_mm = 1.5;                   // free tissue between vessels that do not meet
constexpr int branches_tried = 24;               // nearest ones, per new end
constexpr double smallest_sibling_angle = 0.93;  // cosine: 21 degrees

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a;
    const double share = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return (a + share * edge - p).norm();
}

struct Pull {
    Vec3 towards;
    double weight;
};

// Point that minimises the weighted sum of distances (Weiszfeld's iteration).
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

    std::vector<GrownBranch> grow(Job& job) {
        plant_root();
        double spread_mm = 0.45 * std::cbrt((request_.high - request_.low).prod());
        int failures = 0;
        for (int ends = 1; ends < request_.ends && spread_mm > 0.5;) {
            job.throw_if_cancelled();
            const bool added = try_new_end(spread_mm * std::cbrt(1.0 / ends));
            if (added) {
                ++ends;
                failures = 0;
            } else if (++failures == 12) {
                spread_mm *= 0.93;
                failures = 0;
            }
        }
        return std::move(branches_);
    }

  private:
    double radius_mm(int ends) const {
        return request_.root_radius_mm * relative_radius_[ends] /
               relative_radius_[branches_.front().ends];
    }
    double section(int ends) const { return relative_radius_[ends] * relative_radius_[ends]; }

    bool inside(const Vec3& a, const Vec3& b, double radius) const {
        const int samples = std::max(2, static_cast<int>((b - a).norm() / 4.0));
        for (int i = 1; i <= samples; ++i)
            if (request_.depth_mm(a + (b - a) * i / samples) < radius + gap_mm) return false;
        return true;
    }

    // The first branch ends at the deepest of some random points that is not far from the entry.
    void plant_root() {
        Vec3 best = request_.root;
        double best_depth = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < 400; ++i) {
            const Vec3 p = random_.point(request_.low, request_.high);
            const double distance = (p - request_.root).norm();
            if (distance < 25.0 || distance > 40.0) continue;
            const double depth = request_.depth_mm(p);
            if (depth > best_depth) {
                best = p;
                best_depth = depth;
            }
        }
        branches_.push_back({-1, {-1, -1}, request_.root, best, 1});
    }

    bool try_new_end(double free_mm) {
        const Vec3 end = random_.point(request_.low, request_.high);
        if (request_.depth_mm(end) < 5.0) return false;
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

    bool fits(const Proposal& proposal, const Vec3& end) const {
        const GrownBranch& b = branches_[proposal.branch];
        const Vec3& f = proposal.bifurcation;
        const double stem = radius_mm(b.ends + 1);
        const double shortest = std::max(2.0 * stem, 3.0);
        if ((f - b.begin).norm() < shortest || (b.end - f).norm() < shortest ||
            (end - f).norm() < shortest)
            return false;
        const Vec3 to_old = (b.end - f).normalized();
        const Vec3 to_new = (end - f).normalized();
        const Vec3 back = (b.begin - f).normalized();
        if (to_old.dot(to_new) > smallest_sibling_angle || to_new.dot(back) > 0.5) return false;
        return inside(b.begin, f, stem) && inside(f, b.end, radius_mm(b.ends)) &&
               inside(f, end, radius_mm(1)) && clear(proposal, end);
    }

    // Do the three new stretches keep away from all vessels that they do not meet?
    bool clear(const Proposal& proposal, const Vec3& end) const {
        const GrownBranch& old = branches_[proposal.branch];
        const Vec3& f = proposal.bifurcation;
        const std::array<Capsule, 3> parts{{{old.begin, f, radius_mm(old.ends + 1)},
                                            {f, old.end, radius_mm(old.ends)},
                                            {f, end, radius_mm(1)}}};
        const auto too_near = [&](const Capsule& part, const Capsule& other) {
            return distance_between(part.begin, part.end, other.begin, other.end) <
                   part.radius + other.radius + gap_mm;
        };
        for (const Capsule& part : parts)
            for (const Capsule& obstacle : request_.obstacles)
                if (too_near(part, obstacle)) return false;
        for (std::size_t i = 0; i < branches_.size(); ++i) {
            if (static_cast<int>(i) == proposal.branch) continue;
            const GrownBranch& b = branches_[i];
            const Capsule other{b.begin, b.end, radius_mm(b.ends)};
            const bool at_begin = b.end == old.begin || b.begin == old.begin;
            const bool at_end = b.begin == old.end;
            if ((!at_begin && too_near(parts[0], other)) ||
                (!at_end && too_near(parts[1], other)) || too_near(parts[2], other))
                return false;
        }
        return true;
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
    std::vector<double> relative_radius_;  // n^(1/m): of a branch with n ends beyond it
    std::vector<GrownBranch> branches_;
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

std::vector<GrownBranch> grow_tree(const GrowthRequest& request, PhantomRandom& random, Job& job) {
    return Grower(request, random).grow(job);
}

}  // namespace hepatica
