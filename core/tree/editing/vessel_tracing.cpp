// SPDX-License-Identifier: GPL-3.0-or-later
// Traces a vessel twice, first through bright voxels and then through the middle of the lumen
// found, and measures it.
#include "core/tree/editing/vessel_tracing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/patient_space.h"
#include "core/image/filters.h"
#include "core/image/interpolation.h"
#include "core/image/morphology.h"
#include "core/tree/extraction/gap_paths.h"
#include "core/tree/extraction/inscribed_radius.h"
#include "core/tree/extraction/lumen_measurement.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

constexpr double margin_mm = 12.0;        // of CT around the clicks: the widest lumen and a detour
constexpr double smoothing_mm = 0.5;      // against noise
constexpr double least_contrast_hu = 15;  // as for gaps (gap_bridging.cpp)
constexpr double longest_step_mm = 50.0;
constexpr double same_place_mm = 0.5;
constexpr std::size_t voxels_between_checks = 4096;
constexpr double farthest_from_wall_mm = 8.0;  // of an end that is led into a vessel
constexpr double wide_voxels = 3.0;  // radius from which blurring spares the middle of a lumen

std::size_t offset_of(const Grid& grid, const Index3& voxel) {
    return grid.offset(voxel[0], voxel[1], voxel[2]);
}

[[noreturn]] void refuse_one_place() {
    throw InputError("a vessel needs two places at least", "the vessel that is drawn",
                     "Point at its beginning and at its end");
}

std::vector<Vec3> checked(const Volume& ct, const std::vector<Vec3>& clicks_mm) {
    std::vector<Vec3> places;
    for (const Vec3& click : clicks_mm) {
        if (!holds(ct.grid, click))
            throw InputError("the place lies outside of the CT", place_text(click),
                             "Point at the vessel within the image");
        if (!places.empty() && (click - places.back()).norm() < same_place_mm) continue;
        if (!places.empty() && (click - places.back()).norm() > longest_step_mm)
            throw InputError("two places that follow each other are more than 50 mm apart",
                             place_text(click), "Point at places between them");
        places.push_back(click);
    }
    if (places.size() < 2) refuse_one_place();
    return places;
}

IndexBox box_around(const Grid& grid, const std::vector<Vec3>& places_mm) {
    IndexBox box{nearest_voxel(grid, places_mm.front()), nearest_voxel(grid, places_mm.front())};
    for (const Vec3& place : places_mm) {
        const Index3 voxel = nearest_voxel(grid, place);
        for (int a = 0; a < 3; ++a) {
            box.begin[a] = std::min(box.begin[a], voxel[a]);
            box.end[a] = std::max(box.end[a], voxel[a] + 1);
        }
    }
    return grow_box(box, grid, margin_mm);
}

class Tracer {
  public:
    Tracer(Volume ct, std::vector<Vec3> places_mm, Job& job)
        : ct_(std::move(ct)), places_mm_(std::move(places_mm)), job_(job), smooth_(to_float(ct_)) {
        gaussian_smooth(smooth_, Vec3::Constant(smoothing_mm), job_);
        background_hu_ = median(smooth_.voxels);
        std::vector<float> seen;
        for (const Vec3& place : places_mm_) seen.push_back(brightest_beside(place));
        vessel_hu_ = median(std::move(seen));
        if (vessel_hu_ - background_hu_ < least_contrast_hu)
            throw InputError(
                "the CT shows no vessel there that is 15 HU brighter than its "
                "surroundings",
                place_text(places_mm_.front()),
                "Point at the middle of a bright vessel; what the CT does not show "
                "is joined as two vessels are linked");
    }

    Centreline centreline(double blood_contrast_hu) const {
        const std::vector<Index3> through_bright =
            path([this](const Vec3& place) { return brightness(place); }, 0.0);
        // Places in one voxel are one place: a centreline needs two points.
        if (through_bright.size() < 2) refuse_one_place();
        Mask lumen = lumen_around(through_bright);
        // The first path cuts corners along the inner wall; the second is cheap deep in the lumen.
        const FloatVolume outside_mm = signed_distance(lumen, job_);
        const double voxel_mm = std::cbrt(ct_.grid.spacing_mm.prod());
        const std::vector<Index3> voxels = path(
            [&](const Vec3& place) {
                const double depth_mm = std::max(0.0, -interpolate(outside_mm, place));
                return depth_mm / (depth_mm + voxel_mm);
            },
            0.4);
        for (const Index3& voxel : voxels) lumen.voxels[offset_of(ct_.grid, voxel)] = 1;
        return measured(voxels, lumen, blood_contrast_hu);
    }

  private:
    // A click misses the middle of a thin vessel by about a voxel.
    float brightest_beside(const Vec3& place_mm) const {
        const auto [x, y, z] = nearest_voxel(ct_.grid, place_mm);
        float brightest = smooth_.at(x, y, z);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (ct_.grid.contains(x + dx, y + dy, z + dz))
                        brightest = std::max(brightest, smooth_.at(x + dx, y + dy, z + dz));
        return brightest;
    }

    double brightness(const Vec3& position_mm) const {
        const double share =
            (interpolate(smooth_, position_mm) - background_hu_) / (vessel_hu_ - background_hu_);
        return std::clamp(share, 0.0, 1.0);
    }

    Centreline measured(const std::vector<Index3>& voxels, const Mask& lumen,
                        double blood_contrast_hu) const {
        InscribedRadius radius(lumen);
        VesselLink link{0, 1, VascularSystem::unknown, 0.0, {}, {}};
        for (const Index3& voxel : voxels) {
            link.points_mm.push_back(ct_.grid.to_mm(voxel[0], voxel[1], voxel[2]));
            link.radii_mm.push_back(radius.at(voxel));
        }
        VesselGraph graph;
        graph.nodes = {{link.points_mm.front(), link.radii_mm.front()},
                       {link.points_mm.back(), link.radii_mm.back()}};
        graph.links.push_back(std::move(link));
        // The contrast at the clicks is a lower bound, because thin vessels are blurred.
        const double contrast_hu = std::max(blood_contrast_hu, vessel_hu_ - background_hu_);
        measure_lumen(
            graph, lumen, &ct_, [this](double done) { job_.advance(0.8 + 0.2 * done); },
            contrast_hu);
        return {graph.links[0].points_mm, graph.links[0].radii_mm};
    }

    using Brightness = std::function<double(const Vec3&)>;

    // The voxels from click to click; `done` is the share of the work done before.
    std::vector<Index3> path(const Brightness& bright, double done) const {
        std::vector<Index3> voxels;
        for (std::size_t i = 1; i < places_mm_.size(); ++i) {
            add_path(i, bright, voxels);
            job_.advance(done +
                         0.4 * static_cast<double>(i) / static_cast<double>(places_mm_.size() - 1));
        }
        return voxels;
    }

    // Appends the path to one click; its first voxel is there already.
    void add_path(std::size_t to, const Brightness& bright, std::vector<Index3>& voxels) const {
        const Index3 start = nearest_voxel(ct_.grid, places_mm_[to - 1]);
        const Index3 goal = nearest_voxel(ct_.grid, places_mm_[to]);
        if (voxels.empty()) voxels.push_back(start);
        if (start == goal) return;
        // One step needs only a small part of the CT that a long vessel runs through.
        const IndexBox box = box_around(ct_.grid, {places_mm_[to - 1], places_mm_[to]});
        const Grid around = crop(ct_.grid, box);
        const auto within = [&](const Index3& voxel) {
            return Index3{voxel[0] - box.begin[0], voxel[1] - box.begin[1],
                          voxel[2] - box.begin[2]};
        };
        GapSearch search;
        search.grid = &around;
        search.piece_of = [wanted = offset_of(around, within(goal))](std::size_t offset) {
            return offset == wanted ? 1 : -1;
        };
        search.goal_mm = ct_.grid.to_mm(goal[0], goal[1], goal[2]);
        search.brightness = [&](const Vec3& place) {
            if (++asked_ % voxels_between_checks == 0) job_.throw_if_cancelled();
            return bright(place);
        };
        // The box limits the search; a dark path is accepted.
        search.longest_gap_mm = search.longest_cost_mm = std::numeric_limits<double>::infinity();
        const std::vector<GapPath> paths = gap_paths(search, 0, within(start));
        for (std::size_t i = 1; i < paths.front().points_mm.size(); ++i)
            voxels.push_back(nearest_voxel(ct_.grid, paths.front().points_mm[i]));
    }

    // The path, and the voxels connected to it that are brighter than the mean of vessel and
    // surroundings.
    Mask lumen_around(const std::vector<Index3>& path) const {
        Mask lumen(ct_.grid);
        const auto half_hu = static_cast<float>(0.5 * (vessel_hu_ + background_hu_));
        std::vector<Index3> open = path;
        for (const Index3& voxel : path) lumen.voxels[offset_of(ct_.grid, voxel)] = 1;
        while (!open.empty()) {
            const auto [x, y, z] = open.back();
            open.pop_back();
            for (int axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1}) {
                    Index3 next{x, y, z};
                    next[axis] += step;
                    if (!ct_.grid.contains(next[0], next[1], next[2])) continue;
                    const std::size_t offset = offset_of(ct_.grid, next);
                    if (lumen.voxels[offset] != 0 || smooth_.voxels[offset] < half_hu) continue;
                    lumen.voxels[offset] = 1;
                    open.push_back(next);
                }
        }
        return lumen;
    }

    Volume ct_;
    std::vector<Vec3> places_mm_;
    Job& job_;
    FloatVolume smooth_;
    mutable std::size_t asked_ = 0;  // number of brightness queries
    double background_hu_ = 0.0;
    double vessel_hu_ = 0.0;
};

// Twice a voxel, from one point to the other.
std::vector<double> values_along(const Volume& ct, const Vec3& from_mm, const Vec3& to_mm) {
    const double voxel_mm = ct.grid.spacing_mm.minCoeff();
    const int steps = 1 + static_cast<int>(2.0 * (to_mm - from_mm).norm() / voxel_mm);
    std::vector<double> values;
    for (int step = 0; step <= steps; ++step)
        values.push_back(interpolate(ct, from_mm + step * (to_mm - from_mm) / steps));
    return values;
}

// The point of a centreline from which blood reaches `begin_mm`; nullopt: none does.
std::optional<Vec3> place_of_its_blood(const Volume& ct, const VesselTree& tree,
                                       const Vec3& begin_mm, double blood_contrast_hu) {
    const TreePoint nearest = nearest_point(tree, begin_mm);
    const Station station =
        station_at(tree.segments[static_cast<std::size_t>(nearest.segment)], nearest.arclength_mm);
    const double beyond_wall_mm = nearest.distance_mm - station.radius_mm;
    if (beyond_wall_mm <= 0.0 || beyond_wall_mm > farthest_from_wall_mm) return std::nullopt;
    const Vec3& centre_mm = station.position_mm;
    if (!holds(ct.grid, begin_mm) || !holds(ct.grid, centre_mm)) return std::nullopt;
    const Vec3 wall_mm = begin_mm + beyond_wall_mm / nearest.distance_mm * (centre_mm - begin_mm);
    const double blood_hu = median(values_along(ct, wall_mm, centre_mm));
    const bool reached = std::ranges::min(values_along(ct, begin_mm, centre_mm)) >=
                         blood_hu - 0.5 * blood_contrast_hu;
    return reached ? std::optional(centre_mm) : std::nullopt;
}

}  // namespace

std::vector<Vec3> begun_in_vessel(const Volume& ct, const VesselTree& tree,
                                  std::vector<Vec3> clicks_mm, double blood_contrast_hu) {
    if (clicks_mm.empty() || tree.segments.empty() || !(blood_contrast_hu > 0.0)) return clicks_mm;
    if (const auto begin = place_of_its_blood(ct, tree, clicks_mm.front(), blood_contrast_hu))
        clicks_mm.insert(clicks_mm.begin(), *begin);
    return clicks_mm;
}

double blood_contrast_hu(const Volume& ct, const VesselTree& tree) {
    const double voxel_mm = std::cbrt(ct.grid.spacing_mm.prod());
    std::vector<double> inside, around;
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 0; i < segment.points_mm.size(); ++i) {
            const double radius_mm = segment.radii_mm[i];
            if (radius_mm < wide_voxels * voxel_mm) continue;
            inside.push_back(interpolate(ct, segment.points_mm[i]));
            for (const Vec3& p : places_beside(segment.points_mm[i], radius_mm, voxel_mm))
                around.push_back(interpolate(ct, p));
        }
    if (inside.empty()) return 0.0;
    return std::max(0.0, median(std::move(inside)) - median(std::move(around)));
}

Centreline traced_vessel(const Volume& ct, const std::vector<Vec3>& clicks_mm,
                         double blood_contrast_hu, Job& job) {
    job.begin_stage("Following the vessel");
    std::vector<Vec3> places = checked(ct, clicks_mm);
    Volume around = crop(ct, box_around(ct.grid, places));
    return Tracer(std::move(around), std::move(places), job).centreline(blood_contrast_hu);
}

Volume traced_part(const Volume& ct, const std::vector<Vec3>& clicks_mm) {
    return crop(ct, box_around(ct.grid, checked(ct, clicks_mm)));
}

}  // namespace hepatica
