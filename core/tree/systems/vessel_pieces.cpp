// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts links into pieces, groups nodes into forks, and measures brightness, taper and fork arms.
#include "core/tree/systems/vessel_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/median.h"
#include "core/image/interpolation.h"
#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double piece_mm = 4.0;
constexpr double arm_mm = 5.0;  // length over which an arm's direction and radius are measured
constexpr std::size_t arm_pieces = 3;   // pieces over which its brightness is averaged
constexpr double least_taper_mm = 6.0;  // shorter links show no taper
constexpr std::size_t least_taper_points = 8;

// Brightness of each point of each link, relative to the median of points of its radius.
class Brightness {
  public:
    Brightness(const VesselGraph& graph, const Volume* ct) {
        for (const VesselLink& link : graph.links) {
            std::vector<double>& values = of_link_.emplace_back(link.points_mm.size(), 0.0);
            if (ct == nullptr) continue;
            for (std::size_t k = 0; k < values.size(); ++k)
                values[k] = interpolate(*ct, link.points_mm[k]);
        }
        if (ct != nullptr) subtract_expectation(graph);
    }

    const std::vector<double>& of(int link) const { return of_link_[link]; }

  private:
    // Thin vessels are dimmer because they share voxels with tissue. The expectation is the median
    // over classes of radius with equally many points, linear in between.
    void subtract_expectation(const VesselGraph& graph) {
        constexpr std::size_t classes = 8;
        std::vector<std::pair<double, double>> points;  // radius, HU
        for (std::size_t i = 0; i < graph.links.size(); ++i)
            for (std::size_t k = 0; k < of_link_[i].size(); ++k)
                points.emplace_back(graph.links[i].radii_mm[k], of_link_[i][k]);
        if (points.size() < 2 * classes) return;
        std::ranges::sort(points);
        std::vector<double> radii, levels;
        for (std::size_t c = 0; c < classes; ++c) {
            std::vector<double> r, hu;
            for (std::size_t k = c * points.size() / classes; k < (c + 1) * points.size() / classes;
                 ++k) {
                r.push_back(points[k].first);
                hu.push_back(points[k].second);
            }
            radii.push_back(median(std::move(r)));
            levels.push_back(median(std::move(hu)));
        }
        const auto expected = [&](double radius) {
            const auto above = std::ranges::upper_bound(radii, radius) - radii.begin();
            if (above == 0) return levels.front();
            if (above == std::ssize(radii)) return levels.back();
            const double share =
                (radius - radii[above - 1]) / std::max(radii[above] - radii[above - 1], 1e-9);
            return levels[above - 1] + share * (levels[above] - levels[above - 1]);
        };
        std::vector<double> sizes;
        for (std::size_t i = 0; i < graph.links.size(); ++i)
            for (std::size_t k = 0; k < of_link_[i].size(); ++k) {
                of_link_[i][k] -= expected(graph.links[i].radii_mm[k]);
                sizes.push_back(std::abs(of_link_[i][k]));
            }
        constexpr double deviations_per_median = 1.4826;  // of a normal distribution
        const double deviation = deviations_per_median * median(std::move(sizes));
        if (deviation <= 0.0) return;
        for (std::vector<double>& link : of_link_)
            for (double& value : link) value /= deviation;
    }

    std::vector<std::vector<double>> of_link_;
};

// Slope of log(radius) over relative length, by least squares.
double taper_of(const VesselLink& link, const std::vector<double>& along_mm) {
    const double length = along_mm.back();
    const auto n = static_cast<double>(along_mm.size());
    double mean_s = 0.0, mean_r = 0.0;
    for (std::size_t k = 0; k < along_mm.size(); ++k) {
        mean_s += along_mm[k] / length / n;
        mean_r += std::log(link.radii_mm[k]) / n;
    }
    double above = 0.0, below = 0.0;
    for (std::size_t k = 0; k < along_mm.size(); ++k) {
        const double s = along_mm[k] / length - mean_s;
        above += s * (std::log(link.radii_mm[k]) - mean_r);
        below += s * s;
    }
    return below > 0.0 ? above / below : 0.0;
}

std::vector<int> forks_of_nodes(const VesselGraph& graph, std::vector<std::uint8_t>& within_fork) {
    DisjointSets forks(graph.nodes.size());
    const auto at_node = links_of_nodes(graph);
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const VesselLink& link = graph.links[i];
        if (link.from == link.to || at_node[link.from].size() < 2 || at_node[link.to].size() < 2)
            continue;
        if (length_mm(link) >= std::max(1.0, 2.0 * median(link.radii_mm))) continue;
        within_fork[i] = 1;
        forks.unite(static_cast<std::uint32_t>(link.from), static_cast<std::uint32_t>(link.to));
    }
    std::vector<int> fork;
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n)
        fork.push_back(static_cast<int>(forks.root(n)));
    return fork;
}

// The arm of a link at one of its two ends.
ForkArm arm_of(const VesselLink& link, bool at_from) {
    std::vector<Vec3> points = link.points_mm;
    std::vector<double> radii = link.radii_mm;
    if (!at_from) {
        std::ranges::reverse(points);
        std::ranges::reverse(radii);
    }
    const std::vector<double> along = arclengths_mm(points);
    const auto index_at = [&](double mm) {
        return std::min<std::ptrdiff_t>(std::ranges::lower_bound(along, mm) - along.begin(),
                                        std::ssize(along) - 1);
    };
    std::ptrdiff_t first = index_at(std::min(radii.front(), 0.3 * along.back()));
    const std::ptrdiff_t last = index_at(along[first] + arm_mm);
    if (first == last) first = std::max<std::ptrdiff_t>(0, last - 1);
    ForkArm arm;
    arm.direction = (points[last] - points[first]).normalized();
    arm.position_mm = points[first];
    arm.radius_mm = median<double>({radii.begin() + first, radii.begin() + last + 1});
    return arm;
}

class Cutter {
  public:
    Cutter(const VesselGraph& graph, const Volume* ct)
        : graph_(graph),
          brightness_(graph, ct),
          first_piece_(graph.links.size(), -1),
          piece_count_(graph.links.size(), 0) {}

    PieceGraph cut() {
        out_.within_fork.assign(graph_.links.size(), 0);
        const std::vector<int> fork = forks_of_nodes(graph_, out_.within_fork);
        for (std::size_t i = 0; i < graph_.links.size(); ++i)
            if (out_.within_fork[i] == 0) cut_link(static_cast<int>(i));
        const auto at_node = links_of_nodes(graph_);
        std::map<int, std::vector<ForkArm>> arms;
        for (std::size_t i = 0; i < graph_.links.size(); ++i) {
            if (out_.within_fork[i] != 0) continue;
            const VesselLink& link = graph_.links[i];
            if (at_node[link.from].size() > 1)
                arms[fork[link.from]].push_back(measured_arm(static_cast<int>(i), true));
            if (at_node[link.to].size() > 1)
                arms[fork[link.to]].push_back(measured_arm(static_cast<int>(i), false));
        }
        for (auto& [node, list] : arms)
            if (list.size() > 1) out_.forks.push_back(std::move(list));
        return std::move(out_);
    }

  private:
    void cut_link(int id) {
        const VesselLink& link = graph_.links[id];
        const std::vector<double> along = arclengths_mm(link.points_mm);
        const std::vector<double>& brightness = brightness_.of(id);
        const auto points = static_cast<int>(along.size());
        const int count = std::clamp(static_cast<int>(std::lround(along.back() / piece_mm)), 1,
                                     std::max(1, points - 1));
        double taper = 0.0;
        if (along.back() >= least_taper_mm && along.size() >= least_taper_points)
            taper = taper_of(link, along);
        Vec3 middle = Vec3::Zero();
        for (const Vec3& p : link.points_mm) middle += p / static_cast<double>(points);
        first_piece_[id] = static_cast<int>(out_.pieces.size());
        piece_count_[id] = count;
        for (int k = 0; k < count; ++k) {
            VesselPiece piece;
            piece.link = id;
            piece.first_point = k * (points - 1) / count;
            piece.last_point = (k + 1) * (points - 1) / count;
            piece.length_mm = along[piece.last_point] - along[piece.first_point];
            std::vector<double> radii, values;
            for (int p = piece.first_point; p <= piece.last_point; ++p) {
                radii.push_back(link.radii_mm[p]);
                values.push_back(brightness[p]);
                piece.centre_mm += link.points_mm[p];
            }
            piece.centre_mm /= static_cast<double>(radii.size());
            piece.radius_mm = median(std::move(radii));
            piece.brightness = median(std::move(values));
            piece.link_taper = taper;
            const Vec3 chord = link.points_mm.back() - link.points_mm.front();
            if (chord.norm() > 0.0) piece.link_direction = chord.normalized();
            piece.link_centre_mm = middle;
            if (k > 0)
                out_.passages.push_back({static_cast<int>(out_.pieces.size()) - 1,
                                         static_cast<int>(out_.pieces.size())});
            out_.pieces.push_back(piece);
        }
    }

    ForkArm measured_arm(int id, bool at_from) const {
        const VesselLink& link = graph_.links[id];
        ForkArm arm = arm_of(link, at_from);
        const int count = piece_count_[id];
        const auto piece_at = [&](int k) {
            return first_piece_[id] + (at_from ? k : count - 1 - k);
        };
        arm.piece = piece_at(0);
        arm.node = at_from ? link.from : link.to;
        double sum = 0.0, length = 0.0;
        for (int k = 0; k < std::min<int>(count, arm_pieces); ++k) {
            const VesselPiece& piece = out_.pieces[piece_at(k)];
            sum += piece.length_mm * piece.brightness;
            length += piece.length_mm;
        }
        if (length > 0.0) arm.brightness = sum / length;
        return arm;
    }

    const VesselGraph& graph_;
    Brightness brightness_;
    std::vector<int> first_piece_;  // per link
    std::vector<int> piece_count_;
    PieceGraph out_;
};

}  // namespace

PieceGraph pieces_of(const VesselGraph& graph, const Volume* ct) {
    return Cutter(graph, ct).cut();
}

double bend_between(const ForkArm& a, const ForkArm& b) {
    return std::acos(std::clamp(-a.direction.dot(b.direction), -1.0, 1.0));
}

}  // namespace hepatica
