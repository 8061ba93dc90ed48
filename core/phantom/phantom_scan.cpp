// SPDX-License-Identifier: GPL-3.0-or-later
// Samples lumens with 64 bits per voxel, draws the tissue, disturbs and blurs it, and adds noise.
#include "core/phantom/phantom_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/phantom/phantom_random.h"

namespace hepatica {

namespace {

// One edge of a centreline, in continuous voxel indices times the spacing, so that the axes are the
// grid's and lengths are millimetres.
struct Cone {
    Vec3 begin;
    Vec3 edge;
    double inverse_square;
    double begin_radius;
    double radius_change;

    double distance(const Vec3& p) const {
        const Vec3 q = p - begin;
        const double share = std::clamp(q.dot(edge) * inverse_square, 0.0, 1.0);
        return (q - share * edge).norm() - (begin_radius + share * radius_change);
    }
    double low(int axis) const {
        return std::min(begin[axis] - begin_radius,
                        begin[axis] + edge[axis] - begin_radius - radius_change);
    }
    double high(int axis) const {
        return std::max(begin[axis] + begin_radius,
                        begin[axis] + edge[axis] + begin_radius + radius_change);
    }
};

std::vector<Cone> cones_of(const VesselTree& tree, const Grid& grid,
                           std::optional<VascularSystem> system) {
    std::vector<Cone> cones;
    for (const VesselSegment& segment : tree.segments) {
        if (system && segment.system != *system) continue;
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            const Vec3 a = grid.to_index(segment.points_mm[i - 1]).cwiseProduct(grid.spacing_mm);
            const Vec3 b = grid.to_index(segment.points_mm[i]).cwiseProduct(grid.spacing_mm);
            cones.push_back({a, b - a, 1.0 / (b - a).squaredNorm(), segment.radii_mm[i - 1],
                             segment.radii_mm[i] - segment.radii_mm[i - 1]});
        }
    }
    return cones;
}

// The 4 x 4 x 4 sample points of a voxel, relative to its centre.
std::array<Vec3, 64> sample_offsets(const Vec3& spacing) {
    std::array<Vec3, 64> offsets;
    for (int i = 0; i < 64; ++i)
        offsets[i] =
            Vec3((i & 3) - 1.5, ((i >> 2) & 3) - 1.5, (i >> 4) - 1.5).cwiseProduct(spacing / 4.0);
    return offsets;
}

constexpr std::uint64_t whole_voxel = ~std::uint64_t{0};

class SliceSampler {
  public:
    SliceSampler(const Grid& grid, const std::vector<Cone>& cones)
        : grid_(grid),
          cones_(cones),
          offsets_(sample_offsets(grid.spacing_mm)),
          half_diagonal_(0.5 * grid.spacing_mm.norm()) {}

    // One bit per sample point, so that the union does not depend on the order of the cones.
    void sample(int z, std::vector<std::uint64_t>& bits) const {
        std::ranges::fill(bits, 0);
        for (const Cone& cone : cones_) {
            const auto [z0, z1] = range(cone, 2);
            if (z < z0 || z > z1) continue;
            const auto [x0, x1] = range(cone, 0);
            const auto [y0, y1] = range(cone, 1);
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    add(cone, Vec3(x, y, z).cwiseProduct(grid_.spacing_mm),
                        bits[grid_.offset(x, y, 0)]);
        }
    }

  private:
    std::pair<int, int> range(const Cone& cone, int axis) const {
        const double spacing = grid_.spacing_mm[axis];
        return {
            std::max(0, static_cast<int>(std::floor(cone.low(axis) / spacing))),
            std::min(grid_.dims[axis] - 1, static_cast<int>(std::ceil(cone.high(axis) / spacing)))};
    }

    void add(const Cone& cone, const Vec3& centre, std::uint64_t& bits) const {
        if (bits == whole_voxel) return;
        const double distance = cone.distance(centre);
        if (distance > half_diagonal_) return;
        if (distance < -half_diagonal_) {
            bits = whole_voxel;
            return;
        }
        for (int i = 0; i < 64; ++i)
            if (cone.distance(centre + offsets_[i]) <= 0.0) bits |= std::uint64_t{1} << i;
    }

    const Grid& grid_;
    const std::vector<Cone>& cones_;
    std::array<Vec3, 64> offsets_;
    double half_diagonal_;
};

float clean_voxel(const PhantomOptions& options, double base_hu, int portal, int hepatic) {
    // Where two lumens overlap, the one that fills more of the voxel counts.
    (hepatic > portal ? portal : hepatic) =
        std::min(std::min(portal, hepatic), 64 - std::max(portal, hepatic));
    const double portal_hu = options.parenchyma_hu + options.contrast_hu;
    const double hepatic_hu =
        options.parenchyma_hu + options.hepatic_contrast_hu.value_or(0.85 * options.contrast_hu);
    const double tissue = std::max(0, 64 - portal - hepatic) / 64.0;
    return static_cast<float>(base_hu * tissue + portal_hu * portal / 64.0 +
                              hepatic_hu * hepatic / 64.0);
}

FloatVolume draw_clean(Phantom& phantom, const PhantomBody& body, const PhantomOptions& options,
                       double scale, Job& job) {
    const Grid& grid = phantom.vessels.grid;
    const Image<std::uint8_t> portal = lumen_share(phantom.tree, grid, VascularSystem::portal, job);
    const Image<std::uint8_t> hepatic =
        options.systems > 1 ? lumen_share(phantom.tree, grid, VascularSystem::hepatic, job)
                            : Image<std::uint8_t>(grid);
    FloatVolume image(grid);
    phantom.liver = Mask(grid);
    const double softness_mm = std::cbrt(grid.spacing_mm.prod()) / scale;
    std::atomic<int> done{0};
    parallel_blocks(grid.dims[2], 1, [&](std::size_t first, std::size_t) {
        const int z = static_cast<int>(first);
        job.throw_if_cancelled();
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x) {
                const std::size_t i = grid.offset(x, y, z);
                const Vec3 p = grid.to_mm(x, y, z) / scale;
                const double liver_mm = body.liver_distance_mm(p);
                if (phantom.vessels.voxels[i] != 0)
                    phantom.vessels.voxels[i] = static_cast<std::uint8_t>(
                        hepatic.voxels[i] > portal.voxels[i] ? VascularSystem::hepatic
                                                             : VascularSystem::portal);
                phantom.liver.voxels[i] = liver_mm <= 0.0 || phantom.vessels.voxels[i] ? 1 : 0;
                image.voxels[i] = clean_voxel(options, body.hu(p, liver_mm, softness_mm),
                                              portal.voxels[i], hepatic.voxels[i]);
            }
        job.advance(static_cast<double>(++done) / grid.dims[2]);
    });
    return image;
}

// Neighbours in a slice have correlated noise, as in a reconstructed CT: white noise weighted (w,
// 1, w) along x and y and scaled to a standard deviation of 1.
constexpr float neighbour_weight = 0.35f;

void draw_noise(std::uint64_t seed, const Grid& grid, int z, std::vector<float>& noise) {
    const int nx = grid.dims[0];
    const int ny = grid.dims[1];
    const std::size_t row = static_cast<std::size_t>(nx) + 2;
    std::vector<float> white(row * (static_cast<std::size_t>(ny) + 2));
    const std::uint64_t start = scrambled(seed) + static_cast<std::uint64_t>(z) * white.size();
    for (std::size_t i = 0; i < white.size(); ++i) white[i] = normal_deviate(start + i);
    const float w = neighbour_weight;
    const float unit = 1.0f / (1.0f + 2.0f * w * w);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            const float* p = white.data() + row * y + x;
            float rows[3];
            for (int k = 0; k < 3; ++k, p += row) rows[k] = w * p[0] + p[1] + w * p[2];
            noise[grid.offset(x, y, 0)] = unit * (w * rows[0] + rows[1] + w * rows[2]);
        }
}

void add_noise_and_round(const FloatVolume& image, const PhantomOptions& options, Volume& ct,
                         Job& job) {
    const Grid& grid = image.grid;
    const std::size_t slice = grid.offset(0, 0, 1);
    const auto noise_hu = static_cast<float>(options.noise_hu);
    const bool correlated = noise_hu > 0.0f && options.disturbances.noise_correlation_mm > 0.0;
    const FloatVolume whole = correlated
                                  ? correlated_noise(grid, options.disturbances, options.seed, job)
                                  : FloatVolume();
    parallel_blocks(grid.dims[2], 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        std::vector<float> noise(slice, 0.0f);
        if (correlated)
            std::copy_n(&whole.voxels[z * slice], slice, noise.data());
        else if (noise_hu > 0.0f)
            draw_noise(options.seed, grid, static_cast<int>(z), noise);
        for (std::size_t i = 0; i < slice; ++i) {
            const float hu = image.voxels[z * slice + i] + noise_hu * noise[i];
            ct.voxels[z * slice + i] =
                static_cast<std::int16_t>(std::lround(std::clamp(hu, -1024.0f, 3071.0f)));
        }
    });
}

// Adds a tree with nodes of its own.
void append(VesselTree& tree, const VesselTree& other) {
    const auto nodes = static_cast<int>(tree.nodes.size());
    const auto segments = static_cast<int>(tree.segments.size());
    tree.nodes.insert(tree.nodes.end(), other.nodes.begin(), other.nodes.end());
    for (VesselSegment segment : other.segments) {
        segment.proximal_node += nodes;
        segment.distal_node += nodes;
        if (segment.parent >= 0) segment.parent += segments;
        tree.segments.push_back(std::move(segment));
    }
}

// Draws the arteries and ducts beside the portal vein and disturbs the tissue.
void disturb(Phantom& phantom, const PhantomOptions& options, FloatVolume& image, Job& job) {
    const Disturbances& d = options.disturbances;
    if (d == Disturbances{}) return;
    const Vec3 side = Vec3(0.6, -0.64, 0.48);  // arteries lie on this side of the portal vein,
                                               // ducts on the other
    const auto draw = [&](const VesselTree& tree, double hu) {
        const Image<std::uint8_t> share = lumen_share(tree, image.grid, std::nullopt, job);
        for (std::size_t i = 0; i < share.voxels.size(); ++i) {
            if (share.voxels[i] == 0 || phantom.vessels.voxels[i]) continue;
            const double hu_there = options.parenchyma_hu + hu;
            image.voxels[i] +=
                static_cast<float>(share.voxels[i] / 64.0 * (hu_there - image.voxels[i]));
            if (hu > 0.0 && share.voxels[i] >= 32)
                phantom.vessels.voxels[i] = static_cast<std::uint8_t>(VascularSystem::artery);
        }
    };
    if (d.duct_share > 0.0)
        draw(companions(phantom.tree, d.duct_share, -side, VascularSystem::unknown), d.duct_hu);
    VesselTree arteries;
    if (d.artery_share > 0.0 && d.artery_hu > 0.0) {
        arteries = companions(phantom.tree, d.artery_share, side, VascularSystem::artery);
        draw(arteries, d.artery_hu);
    }
    append(phantom.tree, arteries);
    disturb_tissue(image, phantom.liver, lumen_share(phantom.tree, image.grid, std::nullopt, job),
                   d, options.parenchyma_hu, options.seed, job);
}

}  // namespace

Image<std::uint8_t> lumen_share(const VesselTree& tree, const Grid& grid,
                                std::optional<VascularSystem> system, Job& job) {
    const std::vector<Cone> cones = cones_of(tree, grid, system);
    const SliceSampler sampler(grid, cones);
    Image<std::uint8_t> share(grid);
    const std::size_t slice = grid.offset(0, 0, 1);
    parallel_blocks(grid.dims[2], 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        std::vector<std::uint64_t> bits(slice);
        sampler.sample(static_cast<int>(z), bits);
        for (std::size_t i = 0; i < slice; ++i)
            share.voxels[z * slice + i] = static_cast<std::uint8_t>(std::popcount(bits[i]));
    });
    return share;
}

void scan(Phantom& phantom, const PhantomBody& body, const PhantomOptions& options, double scale,
          Job& job) {
    job.begin_stage("Drawing the body");
    FloatVolume image = draw_clean(phantom, body, options, scale, job);
    disturb(phantom, options, image, job);
    job.begin_stage("Scanning");
    const double sigma = options.point_spread_sigma_mm;
    gaussian_smooth(
        image, {sigma, sigma, std::hypot(sigma, options.disturbances.slice_spread_sigma_mm)}, job);
    add_streaks(image, options.disturbances, options.seed);
    phantom.ct = Volume(image.grid);
    add_noise_and_round(image, options, phantom.ct, job);
}

}  // namespace hepatica
