// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phantom/disturbances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/phantom.h"

namespace hepatica {
namespace {

Grid cubes(int size, double spacing_mm) {
    Grid grid;
    grid.dims = {size, size, size};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    return grid;
}

struct Moments {
    double mean = 0.0, deviation = 0.0;
};

Moments moments(const FloatVolume& field) {
    double sum = 0.0, squares = 0.0;
    for (const float v : field.voxels) {
        sum += v;
        squares += static_cast<double>(v) * v;
    }
    const auto n = static_cast<double>(field.voxels.size());
    return {sum / n, std::sqrt(squares / n - sum / n * (sum / n))};
}

// Correlation of a field with itself so many voxels further along x.
double correlation(const FloatVolume& field, int voxels) {
    const Grid& grid = field.grid;
    double sum = 0.0, squares = 0.0;
    for (int z = 0; z < grid.dims[2]; ++z)
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x + voxels < grid.dims[0]; ++x) {
                sum += field.at(x, y, z) * field.at(x + voxels, y, z);
                squares += field.at(x, y, z) * field.at(x, y, z);
            }
    return sum / squares;
}

TEST(SmoothField, HasUnitDeviationAndItsLengthOfCorrelation) {
    Job job;
    const FloatVolume field = smooth_field(cubes(96, 1.0), 3.0, 5, job);
    EXPECT_NEAR(moments(field).mean, 0.0, 0.1);
    EXPECT_NEAR(moments(field).deviation, 1.0, 0.05);
    // White noise after a Gaussian of s is correlated as exp(-d^2 / 4 s^2).
    for (const int distance : {3, 6})
        EXPECT_NEAR(correlation(field, distance), std::exp(-distance * distance / 36.0), 0.06);
}

TEST(CorrelatedNoise, HasUnitDeviationAndLessOfTheSlowWhereItIsSharp) {
    Job job;
    Disturbances plain, sharp;
    plain.noise_correlation_mm = sharp.noise_correlation_mm = 1.0;
    sharp.noise_sharpness = 1.0;
    const FloatVolume soft = correlated_noise(cubes(64, 0.8), plain, 1, job);
    const FloatVolume hard = correlated_noise(cubes(64, 0.8), sharp, 1, job);
    EXPECT_NEAR(moments(soft).deviation, 1.0, 1e-3);
    EXPECT_NEAR(moments(hard).deviation, 1.0, 1e-3);
    EXPECT_GT(correlation(soft, 2), 0.4);
    EXPECT_LT(correlation(hard, 4), correlation(soft, 4) - 0.03);
}

PhantomOptions small_options() {
    PhantomOptions options;
    options.seed = 2;
    options.generations = 4;
    options.systems = 2;
    options.dims = {104, 84, 60};
    options.spacing_mm = {2.0, 2.0, 2.6};
    options.noise_hu = 0.0;
    return options;
}

Phantom made(const Disturbances& disturbances, double noise_hu = 0.0) {
    PhantomOptions options = small_options();
    options.disturbances = disturbances;
    options.noise_hu = noise_hu;
    Job job;
    return make_phantom(options, job);
}

// How far the liver's voxels that are no vessel differ from the clean patient's, on the average.
double change_of_tissue(const Phantom& a, const Phantom& b) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < a.ct.voxels.size(); ++i)
        if (a.liver.voxels[i] && !a.vessels.voxels[i] && !b.vessels.voxels[i]) {
            sum += std::abs(a.ct.voxels[i] - b.ct.voxels[i]);
            ++count;
        }
    return sum / count;
}

TEST(Disturbances, NoneGiveTheCleanPatient) {
    const Phantom clean = made({});
    Disturbances none;
    none.tumour_hu = 30.0;  // of no tumour
    none.duct_hu = -20.0;
    EXPECT_EQ(made(none).ct.voxels, clean.ct.voxels);
}

TEST(Disturbances, EachChangesTheTissueOfTheLiverAndNotItsVessels) {
    const Phantom clean = made({});
    const std::vector<std::function<void(Disturbances&)>> ways{
        [](Disturbances& d) { d.perfusion_hu = 10.0; }, [](Disturbances& d) { d.mottle_hu = 10.0; },
        [](Disturbances& d) { d.tumours = 6; }, [](Disturbances& d) { d.fissures = 6; },
        [](Disturbances& d) { d.duct_share = 0.6; }};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        Disturbances one;
        ways[i](one);
        const Phantom changed = made(one);
        EXPECT_GT(change_of_tissue(clean, changed), 0.05) << i;
        EXPECT_EQ(changed.vessels.voxels, clean.vessels.voxels) << i;
        EXPECT_EQ(changed.tree.segments.size(), clean.tree.segments.size()) << i;
    }
}

// 6 HU of a field show as a mean of |x| = 0.8 * 6 HU.
TEST(Disturbances, MottleIsAsStrongAsItIsAskedFor) {
    Disturbances mottle;
    mottle.mottle_hu = 6.0;
    mottle.mottle_mm = 6.0;  // which the scan's blur hardly touches
    EXPECT_NEAR(change_of_tissue(made({}), made(mottle)), 0.8 * 6.0, 1.0);
}

TEST(Disturbances, StreamingChangesTheVesselsAlone) {
    Disturbances streaming;
    streaming.streaming_hu = 20.0;
    const Phantom clean = made({}), changed = made(streaming);
    double inside = 0.0;
    for (std::size_t i = 0; i < clean.ct.voxels.size(); ++i)
        if (clean.vessels.voxels[i]) inside += std::abs(clean.ct.voxels[i] - changed.ct.voxels[i]);
    EXPECT_GT(inside, 0.0);
    EXPECT_LT(change_of_tissue(clean, changed), 0.3);  // through the blur beside them only
}

TEST(Disturbances, ArteriesAreVesselsOfTheTruth) {
    Disturbances arteries;
    arteries.artery_share = 0.4;
    arteries.artery_hu = 80.0;
    const Phantom patient = made(arteries);
    EXPECT_NO_THROW(validate(patient.tree));
    int segments = 0;
    double off_mm = 0.0;
    for (const VesselSegment& segment : patient.tree.segments) {
        if (segment.system != VascularSystem::artery) continue;
        ++segments;
        for (const double r : segment.radii_mm) EXPECT_GE(r, 0.4 - 1e-9);
        off_mm += (segment.points_mm[1] - patient.tree.segments[0].points_mm[1]).norm();
    }
    EXPECT_GT(segments, 0);
    EXPECT_GT(off_mm, 0.0);
    EXPECT_GT(std::count(patient.vessels.voxels.begin(), patient.vessels.voxels.end(),
                         static_cast<std::uint8_t>(VascularSystem::artery)),
              0);
}

TEST(Companions, RunBesideThePortalVeinWithoutTouchingItWhereTheyCanDoSo) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(30, 0, 0), 2.0}};
    VesselSegment trunk;
    trunk.proximal_node = 0;
    trunk.distal_node = 1;
    trunk.system = VascularSystem::portal;
    trunk.points_mm = {Vec3(0, 0, 0), Vec3(15, 0, 0), Vec3(30, 0, 0)};
    trunk.radii_mm = {3.0, 2.5, 2.0};
    tree.segments = {trunk};
    const VesselTree beside = companions(tree, 0.4, Vec3::UnitZ(), VascularSystem::artery);
    ASSERT_NO_THROW(validate(beside));
    ASSERT_EQ(beside.segments.size(), 1u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(beside.segments[0].radii_mm[i], 0.4 * trunk.radii_mm[i], 1e-12);
        const double gap =
            (beside.segments[0].points_mm[i] - trunk.points_mm[i]).norm() - 1.4 * trunk.radii_mm[i];
        EXPECT_NEAR(gap, 0.5, 1e-9);
    }
    EXPECT_TRUE(companions(tree, 0.1, Vec3::UnitZ(), VascularSystem::artery).segments.empty());
}

// Two branches that leave the root's own node: their companions have that node in common, too.
TEST(Companions, BranchWhereThePortalVeinDoes) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(30, 0, 0), 2.0}, {Vec3(0, 30, 0), 2.0}};
    for (const int end : {1, 2}) {
        VesselSegment branch;
        branch.proximal_node = 0;
        branch.distal_node = end;
        branch.system = VascularSystem::portal;
        branch.points_mm = {tree.nodes[0].position_mm, tree.nodes[end].position_mm};
        branch.radii_mm = {3.0, 2.0};
        tree.segments.push_back(branch);
    }
    const VesselTree beside = companions(tree, 0.4, Vec3::UnitZ(), VascularSystem::artery);
    ASSERT_NO_THROW(validate(beside));
    EXPECT_EQ(beside.nodes.size(), 3u);
    ASSERT_EQ(beside.segments.size(), 2u);
    EXPECT_EQ(beside.segments[0].proximal_node, beside.segments[1].proximal_node);
    EXPECT_NE(beside.segments[0].distal_node, beside.segments[1].distal_node);
}

TEST(Disturbances, StreaksChangeTheScan) {
    Disturbances streaks;
    streaks.streaks = 20;
    streaks.streak_hu = 30.0;
    EXPECT_GT(change_of_tissue(made({}), made(streaks)), 0.02);
}

TEST(Disturbances, GiveTheSameBytesWithOneThread) {
    Disturbances all{.perfusion_hu = 5.0,
                     .mottle_hu = 4.0,
                     .tumours = 3,
                     .tumour_rim_hu = 30.0,
                     .fissures = 2,
                     .artery_share = 0.4,
                     .artery_hu = 60.0,
                     .duct_share = 0.4,
                     .streaming_hu = 5.0,
                     .noise_correlation_mm = 0.7,
                     .noise_sharpness = 0.5,
                     .streaks = 5,
                     .streak_hu = 10.0,
                     .slice_spread_sigma_mm = 1.0};
    const Phantom many = made(all, 12.0);
    const ThreadLimit one(1);
    const Phantom single = made(all, 12.0);
    EXPECT_EQ(many.ct.voxels, single.ct.voxels);
    EXPECT_EQ(many.vessels.voxels, single.vessels.voxels);
}

TEST(Disturbances, ValuesOutsideTheirRangesAreRefused) {
    const std::vector<std::function<void(Disturbances&)>> faults{
        [](Disturbances& d) { d.perfusion_hu = -1.0; },
        [](Disturbances& d) { d.mottle_mm = 0.0; },
        [](Disturbances& d) { d.tumours = 21; },
        [](Disturbances& d) { d.artery_share = 0.9; },
        [](Disturbances& d) { d.duct_hu = 10.0; },
        [](Disturbances& d) { d.noise_correlation_mm = -0.5; },
        [](Disturbances& d) { d.noise_correlation_mm = 0.19; },
        [](Disturbances& d) { d.noise_correlation_mm = 3.1; },
        [](Disturbances& d) { d.noise_correlation_mm = std::nan(""); },
        [](Disturbances& d) { d.noise_sharpness = 1.1; },
        [](Disturbances& d) { d.slice_spread_sigma_mm = std::nan(""); }};
    for (const auto& fault : faults) {
        Disturbances wrong;
        fault(wrong);
        EXPECT_THROW(validate(wrong), InputError);
    }
    for (const double correlation_mm : {0.0, 0.2, 3.0})
        EXPECT_NO_THROW(validate(Disturbances{.noise_correlation_mm = correlation_mm}));
}

}  // namespace
}  // namespace hepatica
