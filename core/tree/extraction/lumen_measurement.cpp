// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts cross-sections along all links in parallel, centres the links, places forks, and turns
// section areas into smooth radii.
#include "core/tree/extraction/lumen_measurement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <set>

#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/fork_placement.h"
#include "core/tree/extraction/lumen_radius.h"

namespace hepatica {

namespace {

constexpr double least_contrast_hu = 15.0;  // below this the CT does not show a lumen

// Lumens of these radii show their full contrast in the middle, but are not the great vessels,
// where blood from several sources mixes. Where there are too few, the widest are used.
constexpr double wide_voxels = 3.5;
constexpr double very_wide_voxels = 7.0;
constexpr std::size_t enough_stations = 40;

struct Stations {
    std::vector<CrossSection> sections;  // one per point of the link
    std::vector<double> trust;           // 0 or more
};

double radius_of_area(double area_mm2) {
    return std::sqrt(area_mm2 / std::numbers::pi);
}

// Turns the staircase of voxels into a curve with points a voxel apart.
void smooth_link(VesselLink& link, double voxel_mm) {
    Centreline curve{smooth_curve(link.points_mm, 1.5 * voxel_mm, true), link.radii_mm};
    curve = resampled(curve, voxel_mm);
    link.points_mm = std::move(curve.points_mm);
    link.radii_mm = std::move(curve.radii_mm);
}

class Measurement {
  public:
    Measurement(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                const std::function<void(double)>& progress, double contrast_hu)
        : graph_(graph),
          vessels_(vessels),
          ct_(ct),
          progress_(progress),
          known_contrast_hu_(contrast_hu),
          voxel_mm_(std::cbrt(vessels.grid.spacing_mm.prod())),
          at_node_(links_of_nodes(graph)),
          stations_(graph.links.size()) {}

    void run() {
        for_each_link([&](std::size_t id) {
            smooth_link(graph_.links[id], voxel_mm_);
            cut_sections(id);
            centre(id);
            cut_sections(id);
        });
        place_forks(graph_, reliable_points(), voxel_mm_);
        for_each_link([&](std::size_t id) {
            VesselLink& link = graph_.links[id];
            const Centreline even = resampled(
                {smooth_curve(link.points_mm, voxel_mm_, true), link.radii_mm}, voxel_mm_);
            link.points_mm = even.points_mm;
            link.radii_mm = even.radii_mm;
            cut_sections(id);
        });
        if (ct_ != nullptr) find_contrasts();
        for_each_link([&](std::size_t id) { set_radii(id); });
        for (VesselNode& node : graph_.nodes) node.radius_mm = 0.0;
        for (const VesselLink& link : graph_.links) {
            double& from = graph_.nodes[link.from].radius_mm;
            double& to = graph_.nodes[link.to].radius_mm;
            from = std::max(from, link.radii_mm.front());
            to = std::max(to, link.radii_mm.back());
        }
    }

  private:
    template <class Work>
    void for_each_link(const Work& work) {
        parallel_blocks(graph_.links.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t id = begin; id < end; ++id) {
                report();
                work(id);
                ++links_done_;
            }
        });
    }

    // Also allows cancelling.
    void report() const {
        const double all = rounds * static_cast<double>(graph_.links.size());
        progress_(std::min(1.0, links_done_ / all));
    }

    bool is_fork(int node) const { return at_node_[node].size() >= 3; }

    void cut_sections(std::size_t id) {
        const VesselLink& link = graph_.links[id];
        Stations& stations = stations_[id];
        const std::vector<Vec3> directions = tangents(link.points_mm, 2.5 * voxel_mm_);
        const std::vector<double> at_mm = arclengths_mm(link.points_mm);
        stations.sections.clear();
        stations.trust.clear();
        for (std::size_t i = 0; i < link.points_mm.size(); ++i) {
            if (i % sections_per_report == 0) report();
            const CrossSection section =
                cross_section(vessels_, ct_, link.points_mm[i], directions[i],
                              2.0 * link.radii_mm[i] + 2.0 * voxel_mm_);
            double trust = section.inside ? section.usable_share * section.roundness + 1e-3 : 1e-6;
            // In the node's lumen the section is that of the fork.
            if (is_fork(link.from) && at_mm[i] < graph_.nodes[link.from].radius_mm) trust *= 1e-3;
            if (is_fork(link.to) && at_mm.back() - at_mm[i] < graph_.nodes[link.to].radius_mm)
                trust *= 1e-3;
            stations.sections.push_back(section);
            stations.trust.push_back(trust);
        }
    }

    std::vector<std::vector<std::uint8_t>> reliable_points() const {
        std::vector<std::vector<std::uint8_t>> reliable(stations_.size());
        for (std::size_t id = 0; id < stations_.size(); ++id)
            for (const CrossSection& section : stations_[id].sections)
                reliable[id].push_back(section.inside && section.usable_share == 1.0 &&
                                       section.roundness > 0.5);
        return reliable;
    }

    // Moves the points to the centroids of their sections and smooths again.
    void centre(std::size_t id) {
        VesselLink& link = graph_.links[id];
        const Stations& stations = stations_[id];
        std::vector<Vec3> centred = link.points_mm;
        for (std::size_t i = 1; i + 1 < centred.size(); ++i) {
            const CrossSection& section = stations.sections[i];
            if (section.inside && section.usable_share == 1.0 && section.roundness > 0.4)
                centred[i] += section.offset_mm;
        }
        link.points_mm = smooth_curve(centred, 2.0 * voxel_mm_, true);
        Centreline curve = resampled({link.points_mm, link.radii_mm}, voxel_mm_);
        link.points_mm = std::move(curve.points_mm);
        link.radii_mm = std::move(curve.radii_mm);
    }

    static bool shows_lumen(const CrossSection& section) {
        return section.inside && section.has_background && section.usable_share > 0.5;
    }

    bool is_wide(double radius_mm) const {
        return radius_mm >= wide_voxels * voxel_mm_ && radius_mm <= very_wide_voxels * voxel_mm_;
    }

    // The contrast of each link and system, from vessels wide enough to show it in full.
    void find_contrasts() {
        std::map<VascularSystem, std::vector<std::pair<double, double>>> seen;  // radius, contrast
        wide_contrasts_.resize(graph_.links.size());
        for (std::size_t id = 0; id < graph_.links.size(); ++id)
            for (std::size_t i = 0; i < stations_[id].sections.size(); ++i) {
                const CrossSection& section = stations_[id].sections[i];
                if (!shows_lumen(section) || stations_[id].trust[i] < 0.1) continue;
                const double radius = radius_of_area(section.mask_area_mm2);
                const double contrast = section.centre_hu - section.background_hu;
                seen[graph_.links[id].system].emplace_back(radius, contrast);
                if (is_wide(radius)) wide_contrasts_[id].push_back(contrast);
            }
        for (auto& [system, pairs] : seen) contrast_hu_[system] = contrast_of_wide(pairs);
    }

    double contrast_of_wide(std::vector<std::pair<double, double>>& radii_and_contrasts) const {
        std::ranges::sort(radii_and_contrasts, std::greater<>());
        std::vector<double> wide;
        for (const auto& [radius, contrast] : radii_and_contrasts)
            if (is_wide(radius)) wide.push_back(contrast);
        if (wide.size() >= enough_stations) return median(wide);
        wide.clear();
        for (std::size_t i = 0; i < std::min(enough_stations, radii_and_contrasts.size()); ++i)
            wide.push_back(radii_and_contrasts[i].second);
        return median(wide);
    }

    // The contrast of a link: that of the nearest wide lumens along the graph, because touching
    // portal and hepatic veins form one graph but differ in contrast; where there are too few, the
    // known contrast or that of the system.
    double contrast_of_link(std::size_t id) const {
        using Reached = std::pair<double, int>;  // distance along the graph, node
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
        std::set<int> nodes_done;
        std::set<int> links_done{static_cast<int>(id)};
        std::vector<double> contrasts = wide_contrasts_[id];
        const VascularSystem system = graph_.links[id].system;
        next.emplace(0.0, graph_.links[id].from);
        next.emplace(0.0, graph_.links[id].to);
        while (!next.empty() && contrasts.size() < enough_stations) {
            const auto [distance, node] = next.top();
            next.pop();
            if (!nodes_done.insert(node).second) continue;
            for (const int other : at_node_[node]) {
                const VesselLink& link = graph_.links[other];
                if (link.system != system) continue;
                if (links_done.insert(other).second)
                    contrasts.insert(contrasts.end(), wide_contrasts_[other].begin(),
                                     wide_contrasts_[other].end());
                next.emplace(distance + length_mm(link), link.from == node ? link.to : link.from);
            }
        }
        if (contrasts.size() >= enough_stations) return median(contrasts);
        if (known_contrast_hu_ > 0.0) return known_contrast_hu_;
        const auto of_system = contrast_hu_.find(system);
        return of_system == contrast_hu_.end() ? 0.0 : of_system->second;
    }

    // Very wide vessels have their own contrast, others that of their link.
    double contrast_at(const CrossSection& section, double of_link) const {
        const double own = section.centre_hu - section.background_hu;
        const double voxels = radius_of_area(section.mask_area_mm2) / voxel_mm_;
        const double share = std::clamp(voxels - very_wide_voxels + 1.0, 0.0, 1.0);
        return own >= least_contrast_hu ? of_link + share * (own - of_link) : of_link;
    }

    void set_radii(std::size_t id) {
        VesselLink& link = graph_.links[id];
        const Stations& stations = stations_[id];
        const double contrast_hu = ct_ != nullptr ? contrast_of_link(id) : 0.0;
        const bool by_ct = contrast_hu >= least_contrast_hu;
        std::vector<double> backgrounds, known;
        for (const CrossSection& section : stations.sections) {
            backgrounds.push_back(section.background_hu);
            known.push_back(shows_lumen(section) ? 1.0 : 0.0);
        }
        backgrounds = smooth_values(link.points_mm, backgrounds, known, 6.0 * voxel_mm_);
        std::vector<double> radii;
        for (std::size_t i = 0; i < stations.sections.size(); ++i) {
            const CrossSection& section = stations.sections[i];
            double area = section.mask_area_mm2;
            if (by_ct && shows_lumen(section)) {
                const double excess = section.intensity - backgrounds[i] * section.covered_area_mm2;
                const double full_hu = contrast_at(section, contrast_hu);
                area = std::clamp(excess / full_hu, 0.3 * area, 3.0 * area);
            }
            radii.push_back(section.inside ? radius_of_area(area) : link.radii_mm[i]);
        }
        radii = median_values(link.points_mm, radii, stations.trust, 4.0 * voxel_mm_);
        radii = smooth_values(link.points_mm, radii, stations.trust, 3.0 * voxel_mm_);
        for (std::size_t i = 0; i < radii.size(); ++i)
            link.radii_mm[i] = std::max(radii[i], 0.25 * voxel_mm_);
    }

    VesselGraph& graph_;
    const Mask& vessels_;
    const Volume* ct_;
    static constexpr double rounds = 3.0;
    static constexpr std::size_t sections_per_report = 64;  // some milliseconds
    const std::function<void(double)>& progress_;
    std::atomic<int> links_done_ = 0;  // over all rounds
    double known_contrast_hu_;         // 0: not known
    double voxel_mm_;
    std::vector<std::vector<int>> at_node_;
    std::vector<Stations> stations_;
    std::map<VascularSystem, double> contrast_hu_;     // of each system
    std::vector<std::vector<double>> wide_contrasts_;  // of each link
};

}  // namespace

void measure_lumen(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                   const std::function<void(double)>& progress, double contrast_hu) {
    Measurement(graph, vessels, ct, progress, contrast_hu).run();
}

std::array<Vec3, 6> places_beside(const Vec3& point_mm, double radius_mm, double voxel_mm) {
    const double away_mm = 2.0 * radius_mm + 3.0 * voxel_mm;
    std::array<Vec3, 6> places;
    for (int a = 0; a < 6; ++a)
        places[a] = point_mm + (a % 2 == 0 ? away_mm : -away_mm) * Vec3::Unit(a / 2);
    return places;
}

}  // namespace hepatica
