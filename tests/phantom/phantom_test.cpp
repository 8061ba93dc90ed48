// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phantom/phantom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/morphology.h"
#include "core/phantom/phantom_growth.h"
#include "core/phantom/phantom_scan.h"

namespace hepatica {
namespace {

PhantomOptions small_options(std::uint64_t seed) {
    PhantomOptions options;
    options.seed = seed;
    options.generations = 4;
    options.dims = {104, 84, 80};
    options.spacing_mm = {2.0, 2.0, 2.0};
    return options;
}

Phantom made(const PhantomOptions& options) {
    Job job;
    return make_phantom(options, job);
}

TEST(Phantom, ObeysMurraysLawAtEveryBifurcation) {
    for (const double exponent : {2.5, 3.0})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            PhantomOptions options = small_options(seed);
            options.murray_exponent = exponent;
            options.systems = 2;
            const VesselTree tree = made(options).tree;
            ASSERT_NO_THROW(validate(tree));
            const auto children_of = children(tree);
            int bifurcations = 0;
            for (std::size_t i = 0; i < tree.segments.size(); ++i) {
                if (children_of[i].empty()) continue;
                ++bifurcations;
                double sum = 0.0;
                for (const int child : children_of[i])
                    sum += std::pow(tree.segments[child].radii_mm.front(), exponent);
                const double stem = std::pow(tree.segments[i].radii_mm.back(), exponent);
                EXPECT_NEAR(sum / stem, 1.0, 1e-9);
                EXPECT_EQ(children_of[i].size(), 2u);
            }
            EXPECT_EQ(bifurcations, bifurcation_count(tree));
        }
}

TEST(Phantom, HasTheEndsThatWereAskedFor) {
    for (const int generations : {1, 3, 6}) {
        PhantomOptions options = small_options(3);
        options.generations = generations;
        for (const int systems : {1, 2}) {
            options.systems = systems;
            const VesselTree tree = made(options).tree;
            EXPECT_EQ(roots(tree).size(), static_cast<std::size_t>(systems));
            EXPECT_EQ(end_count(tree), systems * ((1 << generations) + 1));  // ends and the roots
            for (const int root : roots(tree)) EXPECT_GE(tree.segments[root].strahler_order, 2);
        }
    }
}

TEST(Phantom, TapersWithoutStepsAndStaysSmooth) {
    const VesselTree tree = made(small_options(5)).tree;
    for (const VesselSegment& s : tree.segments)
        for (std::size_t i = 1; i < s.points_mm.size(); ++i) {
            EXPECT_LE(s.radii_mm[i], s.radii_mm[i - 1]);
            if (i + 1 == s.points_mm.size()) continue;
            const Vec3 before = (s.points_mm[i] - s.points_mm[i - 1]).normalized();
            const Vec3 after = (s.points_mm[i + 1] - s.points_mm[i]).normalized();
            EXPECT_GT(before.dot(after), 0.6);  // no kinks
        }
}

// Vessels that do not meet in a node leave tissue between them, across systems too.
TEST(Phantom, VesselsKeepClearOfEachOther) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        PhantomOptions options = small_options(seed);
        options.systems = 2;
        options.generations = 5;
        const VesselTree tree = made(options).tree;
        const auto meet = [](const VesselSegment& a, const VesselSegment& b) {
            return a.proximal_node == b.proximal_node || a.proximal_node == b.distal_node ||
                   a.distal_node == b.proximal_node;
        };
        int touching = 0;
        for (std::size_t i = 0; i < tree.segments.size(); ++i)
            for (std::size_t j = i + 1; j < tree.segments.size(); ++j) {
                const VesselSegment& a = tree.segments[i];
                const VesselSegment& b = tree.segments[j];
                if (meet(a, b)) continue;
                double gap_mm = std::numeric_limits<double>::infinity();
                for (std::size_t p = 0; p < a.points_mm.size(); ++p)
                    for (std::size_t q = 0; q < b.points_mm.size(); ++q)
                        gap_mm = std::min(gap_mm, (a.points_mm[p] - b.points_mm[q]).norm() -
                                                      a.radii_mm[p] - b.radii_mm[q]);
                touching += gap_mm < 0.0 ? 1 : 0;
            }
        EXPECT_EQ(touching, 0) << "seed " << seed;
    }
}

TEST(Phantom, VesselsLieInTheLiver) {
    const Phantom phantom = made(small_options(2));
    const Grid& grid = phantom.ct.grid;
    for (const VesselSegment& s : phantom.tree.segments)
        for (const Vec3& p : s.points_mm) {
            const Vec3 at = grid.to_index(p);
            const auto whole = [&](int a) { return static_cast<int>(std::lround(at[a])); };
            ASSERT_TRUE(grid.contains(whole(0), whole(1), whole(2)));
            EXPECT_NE(phantom.liver.at(whole(0), whole(1), whole(2)), 0);
        }
}

// One oblique cone with half balls at its ends, counted in anisotropic voxels.
TEST(LumenShare, AddsUpToTheVolumeOfACone) {
    VesselTree tree;
    tree.nodes = {{{8.3, 9.1, 7.7}, 3.0}, {{25.9, 20.2, 22.4}, 1.8}};
    VesselSegment segment;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    for (int i = 0; i <= 20; ++i) {
        const double u = i / 20.0;
        segment.points_mm.push_back((1 - u) * tree.nodes[0].position_mm +
                                    u * tree.nodes[1].position_mm);
        segment.radii_mm.push_back(3.0 - 1.2 * u);
    }
    tree.segments = {segment};
    const double pi = std::numbers::pi;
    const double length = length_mm(segment);
    const double expected =
        pi * length * (9.0 + 5.4 + 3.24) / 3.0 + 2.0 / 3.0 * pi * (27.0 + 1.8 * 1.8 * 1.8);
    Job job;
    for (const Vec3& spacing : {Vec3(0.5, 0.5, 0.5), Vec3(0.7, 0.7, 1.5), Vec3(1.6, 1.6, 1.6)}) {
        Grid grid;
        grid.spacing_mm = spacing;
        for (int a = 0; a < 3; ++a) grid.dims[a] = static_cast<int>(34.0 / spacing[a]);
        const auto share = lumen_share(tree, grid, std::nullopt, job);
        double volume = 0.0;
        for (const std::uint8_t s : share.voxels) volume += s / 64.0 * spacing.prod();
        EXPECT_NEAR(volume / expected, 1.0, 0.004) << spacing.transpose();
    }
}

TEST(Phantom, MaskHoldsTheVolumeOfItsCones) {
    PhantomOptions options = small_options(4);
    options.dims = {208, 168, 160};
    options.spacing_mm = {1.0, 1.0, 1.0};
    const Phantom phantom = made(options);
    double cones = 0.0;
    for (const VesselSegment& s : phantom.tree.segments)
        for (std::size_t i = 1; i < s.points_mm.size(); ++i) {
            const double a = s.radii_mm[i - 1];
            const double b = s.radii_mm[i];
            cones += std::numbers::pi / 3.0 * (a * a + a * b + b * b) *
                     (s.points_mm[i] - s.points_mm[i - 1]).norm();
        }
    double mask = 0.0;
    for (const std::uint8_t v : phantom.vessels.voxels) mask += v != 0;
    // Branches overlap in their nodes and end in half balls: a few per cent either way.
    EXPECT_NEAR(mask / cones, 1.0, 0.06);
}

struct Sample {
    double mean = 0.0;
    double deviation = 0.0;
    double count = 0.0;
};

Sample sample(const Volume& ct, const Mask& where) {
    Sample s;
    double squares = 0.0;
    for (std::size_t i = 0; i < where.voxels.size(); ++i)
        if (where.voxels[i] != 0) {
            s.mean += ct.voxels[i];
            squares += static_cast<double>(ct.voxels[i]) * ct.voxels[i];
            s.count += 1.0;
        }
    s.mean /= s.count;
    s.deviation = std::sqrt(squares / s.count - s.mean * s.mean);
    return s;
}

Mask parenchyma_of(const Phantom& phantom) {
    Job job;
    Mask inner = erode(phantom.liver, 6.0, job);
    const Mask near_vessels = dilate(phantom.vessels, 6.0, job);
    for (std::size_t i = 0; i < inner.voxels.size(); ++i)
        if (near_vessels.voxels[i] != 0) inner.voxels[i] = 0;
    return inner;
}

TEST(Phantom, HasTheNoiseAndContrastThatWereAskedFor) {
    Job job;
    for (const double noise : {0.0, 10.0, 25.0}) {
        PhantomOptions options = small_options(7);
        options.noise_hu = noise;
        const Phantom phantom = made(options);
        const Sample tissue = sample(phantom.ct, parenchyma_of(phantom));
        ASSERT_GT(tissue.count, 5000.0);
        EXPECT_NEAR(tissue.mean, 110.0, 0.02 * noise + 0.05);
        // Rounding to whole HU adds a twelfth to the variance.
        EXPECT_NEAR(tissue.deviation, noise == 0.0 ? 0.0 : std::hypot(noise, 0.29), 0.03 * noise);
    }
    PhantomOptions options = small_options(7);
    options.generations = 2;
    options.dims = {208, 168, 160};
    options.spacing_mm = {1.0, 1.0, 1.0};
    for (const double contrast : {65.0, 0.0}) {
        options.contrast_hu = contrast;
        const Phantom phantom = made(options);
        const Sample lumen = sample(phantom.ct, erode(phantom.vessels, 2.5, job));
        ASSERT_GT(lumen.count, 100.0);
        EXPECT_NEAR(lumen.mean, 110.0 + contrast, 2.0);
    }
}

// Without blur and noise a voxel's HU is the mean over what it holds.
TEST(Phantom, MixesTissueAndLumenByTheirShares) {
    PhantomOptions options = small_options(9);
    options.noise_hu = 0.0;
    options.point_spread_sigma_mm = 0.0;
    const Phantom phantom = made(options);
    Job job;
    const auto share = lumen_share(phantom.tree, phantom.ct.grid, VascularSystem::portal, job);
    const Mask inner = erode(phantom.liver, 5.0, job);
    int mixed = 0;
    for (std::size_t i = 0; i < inner.voxels.size(); ++i) {
        if (inner.voxels[i] == 0) continue;
        mixed += share.voxels[i] > 0 && share.voxels[i] < 64 ? 1 : 0;
        EXPECT_NEAR(phantom.ct.voxels[i], 110.0 + 65.0 * share.voxels[i] / 64.0, 0.5 + 1e-9);
        EXPECT_EQ(phantom.vessels.voxels[i] != 0, share.voxels[i] >= 32);
    }
    EXPECT_GT(mixed, 1000);
}

TEST(Phantom, TheTrueMaskHoldsTheNumbersOfTheSystems) {
    PhantomOptions options = small_options(3);
    options.systems = 2;
    const Phantom phantom = made(options);
    for (const VesselSegment& segment : phantom.tree.segments) {
        const std::size_t middle = segment.points_mm.size() / 2;
        if (segment.radii_mm[middle] < 2.0 * options.spacing_mm.maxCoeff()) continue;
        const Vec3 index = phantom.vessels.grid.to_index(segment.points_mm[middle]);
        const int found = phantom.vessels.at(static_cast<int>(std::lround(index.x())),
                                             static_cast<int>(std::lround(index.y())),
                                             static_cast<int>(std::lround(index.z())));
        EXPECT_EQ(found, number_of(segment.system));
    }
    for (const int number : {1, 2})
        EXPECT_GT(std::ranges::count(phantom.vessels.voxels, number), 100) << number;
    EXPECT_EQ(phantom.tree.segments.front().system, VascularSystem::portal);
    EXPECT_EQ(phantom.tree.segments.back().system, VascularSystem::hepatic);
}

TEST(Phantom, ShowsAnAdultsAnatomyWhereTheFieldOfViewHoldsIt) {
    PhantomOptions options = small_options(1);
    options.dims = {180, 130, 90};
    const Phantom phantom = made(options);
    double liver_ml = 0.0;
    for (const std::uint8_t v : phantom.liver.voxels) liver_ml += v * 8e-3;
    EXPECT_GT(liver_ml, 1200.0);  // adults: some 1500 mL
    EXPECT_LT(liver_ml, 1800.0);
    const auto hu_at = [&](double x, double y, double z) {
        const Vec3 at = phantom.ct.grid.to_index({x, y, z});
        return phantom.ct.at(static_cast<int>(std::lround(at[0])),
                             static_cast<int>(std::lround(at[1])),
                             static_cast<int>(std::lround(at[2])));
    };
    EXPECT_LT(hu_at(170, -120, 0), -950);        // air
    EXPECT_NEAR(hu_at(0, -105, -20), -100, 45);  // subcutaneous fat
    EXPECT_NEAR(hu_at(100, 36, 12), 122, 45);    // spleen
    EXPECT_GT(hu_at(0, 60, 0), 130);             // vertebra
}

TEST(Phantom, ScalesDownWholeWhereTheFieldOfViewIsSmall) {
    PhantomOptions options = small_options(1);
    const Phantom full = made(options);
    for (double& s : options.spacing_mm) s *= 0.5;
    const double scale = 80.0 / 158.0;  // 80 mm along z hold a liver of 158 mm
    const Phantom half = made(options);
    ASSERT_EQ(half.tree.segments.size(), full.tree.segments.size());
    for (std::size_t i = 0; i < half.tree.nodes.size(); ++i) {
        const VesselNode& small = half.tree.nodes[i];
        const VesselNode& large = full.tree.nodes[i];
        EXPECT_LT((small.position_mm - scale * large.position_mm).norm(), 1e-9);
        // The taper is measured along centrelines that have other points.
        EXPECT_NEAR(small.radius_mm / (scale * large.radius_mm), 1.0, 1e-4);
    }
}

TEST(Phantom, GivesTheSameBytesForAnyNumberOfThreadsAndOthersForOtherSeeds) {
    const auto with_threads = [](int threads, std::uint64_t seed) {
        const ThreadLimit limit(threads);
        return made(small_options(seed));
    };
    const Phantom one = with_threads(1, 6);
    for (const int threads : {2, 4}) {
        const Phantom more = with_threads(threads, 6);
        EXPECT_EQ(one.ct.voxels, more.ct.voxels);
        EXPECT_EQ(one.vessels.voxels, more.vessels.voxels);
        EXPECT_EQ(one.liver.voxels, more.liver.voxels);
        ASSERT_EQ(one.tree.segments.size(), more.tree.segments.size());
        for (std::size_t i = 0; i < one.tree.segments.size(); ++i)
            EXPECT_EQ(one.tree.segments[i].radii_mm, more.tree.segments[i].radii_mm);
    }
    EXPECT_NE(one.vessels.voxels, with_threads(1, 7).vessels.voxels);
}

TEST(Phantom, RefusesOptionsOutsideTheirRange) {
    const auto refused = [](auto change) {
        PhantomOptions options = small_options(1);
        change(options);
        Job job;
        EXPECT_THROW(make_phantom(options, job), InputError);
    };
    refused([](PhantomOptions& o) { o.generations = 0; });
    refused([](PhantomOptions& o) { o.generations = 11; });
    refused([](PhantomOptions& o) { o.systems = 3; });
    refused([](PhantomOptions& o) { o.dims[1] = 8; });
    refused([](PhantomOptions& o) { o.spacing_mm[2] = std::nan(""); });
    refused([](PhantomOptions& o) { o.murray_exponent = 0.0; });
    refused([](PhantomOptions& o) { o.noise_hu = -1.0; });
    refused([](PhantomOptions& o) { o.contrast_hu = -1.0; });
    Job cancelled;
    cancelled.cancel();
    EXPECT_THROW(make_phantom(small_options(1), cancelled), Cancelled);
}

TEST(DistanceBetween, EqualsASearchAlongBothStretches) {
    PhantomRandom random(3);
    for (int round = 0; round < 200; ++round) {
        const auto point = [&] { return random.point({-1, -1, -1}, {1, 1, 1}); };
        const Vec3 a0 = point();
        const Vec3 a1 = round % 5 == 0 ? a0 : point();
        const Vec3 b0 = point();
        const Vec3 b1 = round % 7 == 0 ? b0 + (a1 - a0) : point();  // parallel
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= 200; ++i)
            for (int j = 0; j <= 200; ++j)
                least =
                    std::min(least, (a0 + (a1 - a0) * i / 200 - b0 - (b1 - b0) * j / 200).norm());
        const double found = distance_between(a0, a1, b0, b1);
        EXPECT_LE(found, least + 1e-12);
        EXPECT_NEAR(found, least, 0.02);
    }
}

}  // namespace
}  // namespace hepatica
