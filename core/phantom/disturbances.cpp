// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the disturbances from smooth random fields, balls, discs and lines.
#include "core/phantom/disturbances.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/phantom/phantom_random.h"
#include "core/phantom/phantom_range.h"

namespace hepatica {

namespace {

constexpr double perfusion_mm = 30.0;
constexpr double streaming_mm = 12.0;
constexpr double thinnest_companion_mm = 0.4;
constexpr double companion_gap_mm = 0.5;
constexpr double rim_mm = 2.0;
constexpr double softness_mm = 1.0;
constexpr double fissure_hu = -190.0;

// One stream of random numbers for each disturbance, so that they are independent of each other.
enum Stream : std::uint64_t {
    perfusion = 101,
    mottle,
    streaming,
    tumours,
    fissures,
    noise,
    streaks
};

std::uint64_t stream_seed(std::uint64_t seed, Stream stream) {
    return scrambled(scrambled(seed) + stream);
}

void scale_to_unit_deviation(FloatVolume& field) {
    constexpr std::size_t block = 65536;
    const auto count = static_cast<double>(field.voxels.size());
    const auto sum_of = [&](auto&& term) {
        return parallel_sum(field.voxels.size(), block, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t i = begin; i < end; ++i) sum += term(field.voxels[i]);
            return sum;
        });
    };
    const double mean = sum_of([](double v) { return v; }) / count;
    const double variance = sum_of([&](double v) { return (v - mean) * (v - mean); }) / count;
    const double scale = variance > 0.0 ? 1.0 / std::sqrt(variance) : 0.0;
    for (float& v : field.voxels) v = static_cast<float>((v - mean) * scale);
}

FloatVolume white_noise(const Grid& grid, std::uint64_t seed) {
    FloatVolume field(grid);
    const std::uint64_t start = scrambled(seed);
    parallel_blocks(field.voxels.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) field.voxels[i] = normal_deviate(start + i);
    });
    return field;
}

// Blends each voxel's tissue, but not its lumen, towards `hu` by the share that `share_of` returns.
template <class ShareOf>
void blend(FloatVolume& image, const Image<std::uint8_t>& lumen, double hu, ShareOf&& share_of,
           Job& job) {
    const Grid& grid = image.grid;
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        std::size_t i = grid.offset(0, 0, static_cast<int>(z));
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x, ++i) {
                const double share = share_of(grid.to_mm(x, y, static_cast<int>(z)), i);
                if (share <= 0.0) continue;
                const double tissue = share * (1.0 - lumen.voxels[i] / 64.0);
                image.voxels[i] += static_cast<float>(tissue * (hu - image.voxels[i]));
            }
    });
}

double softly_inside(double distance_mm) {
    return std::clamp(0.5 - distance_mm / softness_mm, 0.0, 1.0);
}

std::vector<Vec3> places_in(const Mask& liver, int count, PhantomRandom& random) {
    std::vector<Vec3> places;
    const Grid& grid = liver.grid;
    for (int tries = 0; static_cast<int>(places.size()) < count && tries < 10000; ++tries) {
        const Index3 at{static_cast<int>(random.uniform() * grid.dims[0]),
                        static_cast<int>(random.uniform() * grid.dims[1]),
                        static_cast<int>(random.uniform() * grid.dims[2])};
        if (liver.at(at[0], at[1], at[2])) places.push_back(grid.to_mm(at[0], at[1], at[2]));
    }
    return places;
}

void draw_tumours(FloatVolume& image, const Mask& liver, const Image<std::uint8_t>& lumen,
                  const Disturbances& disturbances, double parenchyma_hu, std::uint64_t seed,
                  Job& job) {
    PhantomRandom random(stream_seed(seed, Stream::tumours));
    for (const Vec3& centre : places_in(liver, disturbances.tumours, random)) {
        const double radius = random.uniform(4.0, 18.0);
        const auto distance = [&](const Vec3& p, std::size_t i) {
            return liver.voxels[i] ? (p - centre).norm() - radius : 2.0 * softness_mm;
        };
        const double within = parenchyma_hu + disturbances.tumour_hu;
        const double rim = parenchyma_hu + disturbances.tumour_rim_hu;
        if (disturbances.tumour_rim_hu != 0.0)
            blend(
                image, lumen, rim,
                [&](const Vec3& p, std::size_t i) {
                    return softly_inside(std::abs(distance(p, i)) - 0.5 * rim_mm);
                },
                job);
        blend(
            image, lumen, within,
            [&](const Vec3& p, std::size_t i) {
                return softly_inside(distance(p, i) + 0.5 * rim_mm);
            },
            job);
    }
}

// Draws sheets of fat: discs around random points of the liver.
void draw_fissures(FloatVolume& image, const Mask& liver, const Image<std::uint8_t>& lumen,
                   const Disturbances& disturbances, double parenchyma_hu, std::uint64_t seed,
                   Job& job) {
    PhantomRandom random(stream_seed(seed, Stream::fissures));
    for (const Vec3& centre : places_in(liver, disturbances.fissures, random)) {
        const Vec3 normal = random.point(Vec3::Constant(-1.0), Vec3::Constant(1.0)).normalized();
        const double reach = random.uniform(10.0, 35.0);
        const double half_width = random.uniform(0.3, 1.5);
        blend(
            image, lumen, parenchyma_hu + fissure_hu,
            [&](const Vec3& p, std::size_t i) {
                if (!liver.voxels[i]) return 0.0;
                const Vec3 q = p - centre;
                const double off = std::abs(q.dot(normal)) - half_width;
                return off > softness_mm ? 0.0 : softly_inside(std::max(off, q.norm() - reach));
            },
            job);
    }
}

void add_field(FloatVolume& image, const FloatVolume& field, double deviation_hu,
               const std::function<double(std::size_t)>& share_of) {
    parallel_blocks(image.voxels.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            image.voxels[i] += static_cast<float>(deviation_hu * share_of(i)) * field.voxels[i];
    });
}

}  // namespace

void validate(const Disturbances& d) {
    require_range("perfusion in HU", d.perfusion_hu, 0.0, 100.0);
    require_range("mottle in HU", d.mottle_hu, 0.0, 100.0);
    require_range("mottle in mm", d.mottle_mm, 0.5, 10.0);
    require_range("tumours", d.tumours, 0, 20);
    require_range("tumour in HU", d.tumour_hu, -150.0, 150.0);
    require_range("tumour's rim in HU", d.tumour_rim_hu, -150.0, 150.0);
    require_range("fissures", d.fissures, 0, 10);
    require_range("artery's share", d.artery_share, 0.0, 0.8);
    require_range("artery in HU", d.artery_hu, 0.0, 300.0);
    require_range("duct's share", d.duct_share, 0.0, 0.8);
    require_range("duct in HU", d.duct_hu, -150.0, 0.0);
    require_range("streaming in HU", d.streaming_hu, 0.0, 50.0);
    if (d.noise_correlation_mm != 0.0)
        require_range("correlation of the noise in mm", d.noise_correlation_mm, 0.2, 3.0);
    require_range("sharpness of the noise", d.noise_sharpness, 0.0, 1.0);
    require_range("streaks", d.streaks, 0, 40);
    require_range("streaks in HU", d.streak_hu, 0.0, 100.0);
    require_range("point spread along z in mm", d.slice_spread_sigma_mm, 0.0, 5.0);
}

FloatVolume smooth_field(const Grid& grid, double correlation_mm, std::uint64_t seed, Job& job) {
    // Computed on a grid as coarse as the field allows, then interpolated.
    const Vec3 coarse = grid.spacing_mm.cwiseMax(Vec3::Constant(correlation_mm / 3.0));
    FloatVolume field = white_noise(respaced(grid, coarse), seed);
    gaussian_smooth(field, Vec3::Constant(correlation_mm), job);
    scale_to_unit_deviation(field);
    return same_grid(field.grid, grid) ? field : resample(field, grid, Interpolation::cubic, job);
}

VesselTree companions(const VesselTree& tree, double share, const Vec3& side,
                      VascularSystem system) {
    VesselTree beside;
    std::vector<int> node_of(tree.nodes.size(), -1), segment_of(tree.segments.size(), -1);
    const auto moved = [&](const Vec3& p, double radius_mm) {
        return Vec3(p + ((1.0 + share) * radius_mm + companion_gap_mm) * side);
    };
    const auto node = [&](int id) {
        if (node_of[id] < 0) {
            node_of[id] = static_cast<int>(beside.nodes.size());
            const VesselNode& from = tree.nodes[id];
            beside.nodes.push_back({moved(from.position_mm, from.radius_mm),
                                    std::max(share * from.radius_mm, thinnest_companion_mm)});
        }
        return node_of[id];
    };
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const VesselSegment& from = tree.segments[i];
        const bool reached = from.parent < 0 || segment_of[from.parent] >= 0;
        const double thinnest = *std::ranges::min_element(from.radii_mm);
        if (from.system != VascularSystem::portal || !reached ||
            share * thinnest < thinnest_companion_mm)
            continue;
        VesselSegment to = from;
        to.system = system;
        to.proximal_node = node(from.proximal_node);
        to.distal_node = node(from.distal_node);
        to.parent = from.parent < 0 ? -1 : segment_of[from.parent];
        for (std::size_t k = 0; k < to.points_mm.size(); ++k) {
            to.points_mm[k] = moved(from.points_mm[k], from.radii_mm[k]);
            to.radii_mm[k] = share * from.radii_mm[k];
        }
        to.points_mm.front() = beside.nodes[to.proximal_node].position_mm;
        to.points_mm.back() = beside.nodes[to.distal_node].position_mm;
        segment_of[i] = static_cast<int>(beside.segments.size());
        beside.segments.push_back(std::move(to));
    }
    return beside;
}

void disturb_tissue(FloatVolume& image, const Mask& liver, const Image<std::uint8_t>& lumen,
                    const Disturbances& d, double parenchyma_hu, std::uint64_t seed, Job& job) {
    const auto tissue = [&](std::size_t i) {
        return liver.voxels[i] ? 1.0 - lumen.voxels[i] / 64.0 : 0.0;
    };
    if (d.perfusion_hu > 0.0)
        add_field(image,
                  smooth_field(image.grid, perfusion_mm, stream_seed(seed, Stream::perfusion), job),
                  d.perfusion_hu, tissue);
    if (d.mottle_hu > 0.0)
        add_field(image,
                  smooth_field(image.grid, d.mottle_mm, stream_seed(seed, Stream::mottle), job),
                  d.mottle_hu, tissue);
    draw_tumours(image, liver, lumen, d, parenchyma_hu, seed, job);
    draw_fissures(image, liver, lumen, d, parenchyma_hu, seed, job);
    if (d.streaming_hu > 0.0)
        add_field(image,
                  smooth_field(image.grid, streaming_mm, stream_seed(seed, Stream::streaming), job),
                  d.streaming_hu, [&](std::size_t i) { return lumen.voxels[i] / 64.0; });
}

FloatVolume correlated_noise(const Grid& grid, const Disturbances& d, std::uint64_t seed,
                             Job& job) {
    constexpr double slower = 2.5;  // times the correlation: scale of the part that a sharp kernel
                                    // removes
    FloatVolume field = white_noise(grid, stream_seed(seed, Stream::noise));
    const double sigma = d.noise_correlation_mm;
    gaussian_smooth(field, {sigma, sigma, 0.5 * sigma}, job);
    if (d.noise_sharpness > 0.0) {
        FloatVolume slow = field;
        gaussian_smooth(slow, Vec3::Constant(slower * sigma), job);
        for (std::size_t i = 0; i < field.voxels.size(); ++i)
            field.voxels[i] -= static_cast<float>(d.noise_sharpness) * slow.voxels[i];
    }
    scale_to_unit_deviation(field);
    return field;
}

void add_streaks(FloatVolume& image, const Disturbances& d, std::uint64_t seed) {
    PhantomRandom random(stream_seed(seed, Stream::streaks));
    const Grid& grid = image.grid;
    for (int k = 0; k < d.streaks; ++k) {
        const double angle = random.uniform(0.0, std::numbers::pi);
        const Vec3 normal(std::cos(angle), std::sin(angle), 0.0);
        // One draw a statement, the last axis first: within one expression each compiler would draw
        // in an order of its own.
        const double at_z = random.uniform() * grid.dims[2];
        const double at_y = random.uniform() * grid.dims[1];
        const double at_x = random.uniform() * grid.dims[0];
        const Vec3 through = grid.to_mm(Vec3(at_x, at_y, at_z));
        const double width_mm = random.uniform(0.8, 3.0), high_mm = random.uniform(1.0, 6.0);
        const double height_hu = random.uniform(-1.0, 1.0) * d.streak_hu;
        for (int z = 0; z < grid.dims[2]; ++z) {
            if (std::abs(grid.to_mm(0, 0, z)[2] - through[2]) > high_mm) continue;
            for (int y = 0; y < grid.dims[1]; ++y)
                for (int x = 0; x < grid.dims[0]; ++x) {
                    const double u = (grid.to_mm(x, y, z) - through).dot(normal) / width_mm;
                    if (std::abs(u) < 4.0)
                        image.at(x, y, z) += static_cast<float>(height_hu * std::exp(-0.5 * u * u));
                }
        }
    }
}

}  // namespace hepatica
