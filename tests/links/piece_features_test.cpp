// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/links/piece_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/parallel.h"
#include "tests/links/drawn_lines.h"

namespace hepatica {
namespace {

constexpr int size = 48;
constexpr double spacing_mm = 0.5;

std::size_t index_of(std::string_view name) {
    const auto at = std::ranges::find(piece_feature_names, name);
    EXPECT_NE(at, piece_feature_names.end()) << name;
    return static_cast<std::size_t>(at - piece_feature_names.begin());
}

// A line along x through the middle of a cube in a liver that fills it but for its outer voxels.
struct Scene {
    LineEvidence evidence{FloatVolume(test::cubes(size, spacing_mm)), 2.0, 5.0};
    Mask liver{test::cubes(size, spacing_mm)};
    Mask line{test::cubes(size, spacing_mm)};
    std::vector<LinePiece> pieces;

    // Brightness by the distances across the line in mm.
    template <class Brightness>
    explicit Scene(Brightness&& brightness) {
        const int middle = size / 2;
        for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
            const Index3 at = liver.grid.index_of(i);
            evidence.rise.voxels[i] = static_cast<float>(
                brightness((at[1] - middle) * spacing_mm, (at[2] - middle) * spacing_mm));
            liver.voxels[i] =
                *std::ranges::min_element(at) > 0 && *std::ranges::max_element(at) < size - 1;
        }
        test::draw_along_x(line, 8, size - 9, middle, middle);
        pieces = line_pieces(line, test::thickened(line, 2.0), 100.0);
    }

    PieceFeatures features() const {
        Job job;
        const PieceImage image{evidence, liver, Vec3(0.7, 0.7, 2.0), 20.0};
        return piece_features(pieces, image, job).at(0);
    }
    double feature(std::string_view name) const { return features()[index_of(name)]; }
};

Scene tube() {
    return Scene([](double y, double z) { return std::hypot(y, z) < 1.3 ? 10.0 : 0.0; });
}
Scene sheet() {
    return Scene([](double y, double) { return std::abs(y) < 1.3 ? 10.0 : 0.0; });
}
Scene edge() {
    return Scene([](double y, double) { return y < 1.3 ? 10.0 : 0.0; });
}

TEST(PieceFeatures, NamesAreDifferent) {
    EXPECT_EQ(std::set(piece_feature_names.begin(), piece_feature_names.end()).size(),
              piece_feature_names.size());
}

TEST(PieceFeatures, OfATubeAreThoseThatWereDrawn) {
    const Scene scene = tube();
    EXPECT_NEAR(scene.feature("rise mean"), 5.0, 1e-6);
    EXPECT_NEAR(scene.feature("rise low"), 5.0, 1e-6);
    EXPECT_NEAR(scene.feature("rise of contrast"), 0.5, 1e-6);
    EXPECT_NEAR(scene.feature("line short"), 2.0, 1e-6);
    EXPECT_NEAR(scene.feature("line middle"), 2.0, 1e-6);
    EXPECT_NEAR(scene.feature("ring half"), 5.0, 1e-6);
    EXPECT_NEAR(scene.feature("ring all"), 5.0, 1e-6);
    EXPECT_NEAR(scene.feature("ring dark"), 0.0, 1e-6);
    EXPECT_NEAR(scene.feature("length"), 15.5, 1e-6);
    EXPECT_NEAR(scene.feature("straightness"), 1.0, 1e-6);
    EXPECT_NEAR(scene.feature("free ends"), 2.0, 1e-6);
    EXPECT_NEAR(scene.feature("neighbours"), 0.0, 1e-6);
    EXPECT_NEAR(scene.feature("component length"), 15.5, 1e-6);
    EXPECT_NEAR(scene.feature("contrast"), 10.0, 1e-6);
    EXPECT_NEAR(scene.feature("false line"), 2.5, 1e-6);
    EXPECT_NEAR(scene.feature("slices"), 2.0, 1e-6);
    EXPECT_NEAR(scene.feature("voxel"), std::cbrt(0.98), 1e-6);
    EXPECT_NEAR(scene.feature("radius in voxels"), scene.feature("radius") / scene.feature("voxel"),
                1e-6);
}

// The distance to the nearest of the six sides, of each point.
TEST(PieceFeatures, DepthIsThatBelowTheLiversSurface) {
    const Scene scene = tube();
    double sum = 0.0, least = 1e9;
    for (int x = 8; x <= size - 9; ++x) {
        const double depth =
            spacing_mm * std::min({x, size - 1 - x, size / 2, size - 1 - size / 2});
        sum += depth;
        least = std::min(least, depth);
    }
    EXPECT_NEAR(scene.feature("depth mean"), sum / (size - 16), 1e-5);
    EXPECT_NEAR(scene.feature("depth least"), least, 1e-5);
}

TEST(PieceFeatures, ASheetAndAnEdgeAreBrightOnPartsOfTheRing) {
    EXPECT_GT(tube().feature("ring three quarters"), 4.9);
    EXPECT_LT(sheet().feature("ring all"), 0.1);
    EXPECT_GT(sheet().feature("ring half"), 4.9);
    EXPECT_LT(edge().feature("ring three quarters"), 0.1);
    EXPECT_LT(edge().feature("ring half"), 0.1);
}

TEST(PieceFeatures, ADarkSideIsSeen) {
    const Scene beside_duct([](double y, double z) {
        return std::hypot(y, z) < 1.3 ? 10.0 : y > 0.0 && std::abs(z) < 2.5 ? -8.0 : 0.0;
    });
    EXPECT_LT(beside_duct.feature("ring dark"), -3.0);
}

// An image that is as much brighter as it is noisier shows the same.
TEST(PieceFeatures, AreRelativeToNoiseAndContrast) {
    Scene scene([](double y, double z) { return 12.0 * std::exp(-0.3 * (y * y + z * z)) - 1.0; });
    Job job;
    const auto before =
        piece_features(scene.pieces, {scene.evidence, scene.liver, Vec3::Ones(), 20.0}, job);
    for (float& v : scene.evidence.rise.voxels) v *= 4.0f;
    scene.evidence.deviation_hu *= 4.0;
    scene.evidence.false_line_hu *= 4.0;
    const auto after =
        piece_features(scene.pieces, {scene.evidence, scene.liver, Vec3::Ones(), 80.0}, job);
    for (std::size_t k = 0; k < piece_feature_names.size(); ++k)
        EXPECT_NEAR(before[0][k], after[0][k], 1e-4 * (1.0 + std::abs(before[0][k])))
            << piece_feature_names[k];
}

TEST(PieceFeatures, GoOnWhereTheLineGoesOn) {
    Scene scene = tube();
    scene.pieces = line_pieces(scene.line, test::thickened(scene.line, 2.0), 5.0);
    ASSERT_EQ(scene.pieces.size(), 4u);
    Job job;
    const auto features =
        piece_features(scene.pieces, {scene.evidence, scene.liver, Vec3::Ones(), 20.0}, job);
    for (const PieceFeatures& f : features) {
        EXPECT_NEAR(f[index_of("alignment")], 1.0, 1e-6);
        EXPECT_NEAR(f[index_of("neighbour rise")], 1.0, 1e-6);
        EXPECT_NEAR(f[index_of("component length")], 15.5, 1e-5);
        EXPECT_NEAR(f[index_of("link length")], 15.5, 1e-5);
        EXPECT_LT(f[index_of("length")], 5.01);
    }
}

TEST(PieceFeatures, DoNotDependOnTheNumberOfThreads) {
    const Scene scene = edge();
    const PieceFeatures many = scene.features();
    const ThreadLimit one(1);
    EXPECT_EQ(many, scene.features());
}

}  // namespace
}  // namespace hepatica
