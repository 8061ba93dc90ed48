// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a cross-section with 24 rays from the centreline point.
#include "core/tree/extraction/lumen_radius.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/median.h"
#include "core/image/interpolation.h"

namespace hepatica {

namespace {

constexpr int ray_count = 24;
constexpr double rim_voxels = 2.0;           // beyond the mask, where blurring spreads intensity
constexpr double surroundings_voxels = 4.5;  // beyond the mask: outer border of the background
constexpr double longest_ray = 1.6;  // relative to the median: longer rays run into a branch

struct Ray {
    Vec3 direction;
    double wall_mm = 0.0;   // where the mask ends
    double clear_mm = 0.0;  // no other vessel begins before this
    bool usable = true;
};

class Section {
  public:
    Section(const Mask& mask, const Volume* ct, const Vec3& point_mm, const Vec3& direction)
        : mask_(mask),
          ct_(ct),
          point_mm_(point_mm),
          voxel_mm_(std::cbrt(mask.grid.spacing_mm.prod())),
          step_mm_(0.25 * mask.grid.spacing_mm.minCoeff()) {
        const Vec3 u = direction.unitOrthogonal();
        const Vec3 v = direction.cross(u);
        for (int k = 0; k < ray_count; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / ray_count;
            rays_[k].direction = std::cos(angle) * u + std::sin(angle) * v;
        }
    }

    CrossSection measure(double reach_mm) {
        CrossSection section;
        section.inside = interpolate(mask_, point_mm_) >= 0.5;
        if (!section.inside) return section;
        // No ray through the mask is longer than its grid's diagonal.
        const Index3& dims = mask_.grid.dims;
        const Vec3 extent_mm = Vec3(dims[0], dims[1], dims[2]).cwiseProduct(mask_.grid.spacing_mm);
        for (Ray& ray : rays_) find_wall(ray, std::min(reach_mm, extent_mm.norm()));
        choose_usable(section);
        measure_mask(section);
        if (ct_ != nullptr) measure_ct(section);
        return section;
    }

  private:
    double mask_at(const Ray& ray, double t) const {
        return interpolate(mask_, point_mm_ + t * ray.direction);
    }
    double hu_at(const Ray& ray, double t) const {
        return interpolate(*ct_, point_mm_ + t * ray.direction);
    }

    void find_wall(Ray& ray, double reach_mm) const {
        double before = mask_at(ray, 0.0);
        double t = step_mm_;
        for (; t < reach_mm; t += step_mm_) {
            const double value = mask_at(ray, t);
            if (value < 0.5) {
                ray.wall_mm = t - step_mm_ * (0.5 - value) / (before - value);
                break;
            }
            before = value;
        }
        if (ray.wall_mm == 0.0) ray.wall_mm = reach_mm;
        // The next vessel's blur begins a voxel and a half before its mask.
        ray.clear_mm = ray.wall_mm + surroundings_voxels * voxel_mm_;
        for (t = ray.wall_mm + voxel_mm_; t < ray.clear_mm + 1.5 * voxel_mm_; t += 2.0 * step_mm_)
            if (mask_at(ray, t) >= 0.5) ray.clear_mm = t - 1.5 * voxel_mm_;
    }

    void choose_usable(CrossSection& section) {
        std::vector<double> walls;
        for (const Ray& ray : rays_) walls.push_back(ray.wall_mm);
        const double limit = longest_ray * median(std::move(walls)) + 0.5 * voxel_mm_;
        int usable = 0;
        double shortest = limit, longest = 0.0;
        for (Ray& ray : rays_) {
            ray.usable = ray.wall_mm <= limit;
            if (!ray.usable) continue;
            ++usable;
            shortest = std::min(shortest, ray.wall_mm);
            longest = std::max(longest, ray.wall_mm);
        }
        section.usable_share = static_cast<double>(usable) / ray_count;
        section.roundness = shortest / longest;
    }

    double scale(const CrossSection& section) const {
        return 2.0 * std::numbers::pi / (ray_count * section.usable_share);
    }

    void measure_mask(CrossSection& section) const {
        Vec3 moment = Vec3::Zero();
        double area = 0.0;
        for (const Ray& ray : rays_) {
            if (!ray.usable) continue;
            const double r = ray.wall_mm;
            area += r * r / 2.0;
            moment += r * r * r / 3.0 * ray.direction;
        }
        section.mask_area_mm2 = area * scale(section);
        section.offset_mm = moment / area;
    }

    void measure_ct(CrossSection& section) const {
        double covered = 0.0, sum = 0.0, centre = 0.0, centre_weight = 0.0;
        for (const Ray& ray : rays_) {
            if (!ray.usable) continue;
            for (double t = 0.5 * step_mm_; t < ray.wall_mm; t += step_mm_) {
                // The last step ends at the wall.
                const double width = std::min(step_mm_, ray.wall_mm - (t - 0.5 * step_mm_));
                const double hu = hu_at(ray, t);
                covered += t * width;
                sum += hu * t * width;
                if (t > 0.4 * ray.wall_mm) continue;
                centre += hu * t;
                centre_weight += t;
            }
        }
        // In the rim the median over the rays counts: a neighbouring vessel outside the mask
        // affects only a few of them.
        for (double s = 0.5 * step_mm_; s < rim_voxels * voxel_mm_; s += step_mm_) {
            const auto [weight, hu] = rim_at(s);
            covered += weight * step_mm_;
            sum += weight * hu * step_mm_;
        }
        section.covered_area_mm2 = covered * scale(section);
        section.intensity = sum * scale(section);
        section.centre_hu = centre_weight > 0.0 ? centre / centre_weight : 0.0;
        measure_surroundings(section);
    }

    // Sum of the distances and median intensity of the clear rays at a distance beyond the wall.
    std::pair<double, double> rim_at(double beyond_mm) const {
        double weight = 0.0;
        std::vector<double> values;
        for (const Ray& ray : rays_) {
            const double t = ray.wall_mm + beyond_mm;
            if (!ray.usable || t > ray.clear_mm) continue;
            weight += t;
            values.push_back(hu_at(ray, t));
        }
        if (values.empty()) return {0.0, 0.0};
        return {weight, median(values)};
    }

    void measure_surroundings(CrossSection& section) const {
        std::vector<double> values;
        for (const Ray& ray : rays_) {
            if (!ray.usable) continue;
            for (double t = ray.wall_mm + rim_voxels * voxel_mm_; t < ray.clear_mm;
                 t += 0.5 * voxel_mm_)
                values.push_back(hu_at(ray, t));
        }
        section.has_background = values.size() >= 12;
        if (section.has_background) section.background_hu = median(values);
    }

    const Mask& mask_;
    const Volume* ct_;
    Vec3 point_mm_;
    double voxel_mm_;
    double step_mm_;
    std::array<Ray, ray_count> rays_;
};

}  // namespace

CrossSection cross_section(const Mask& mask, const Volume* ct, const Vec3& point_mm,
                           const Vec3& direction, double reach_mm) {
    return Section(mask, ct, point_mm, direction).measure(reach_mm);
}

}  // namespace hepatica
