// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tetrahedralize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/quality.h"
#include "core/mesh/tube_field.h"
#include "tests/mesh/random_tree.h"

namespace hepatica {
namespace {

// Volume of the implicit body by counting cells of a quarter of the smallest radius.
double counted_volume_mm3(const VesselTree& tree) {
    std::vector<int> all(tree.segments.size());
    std::iota(all.begin(), all.end(), 0);
    const TubeField field(tree, all, {});
    const double step = 0.25 * field.smallest_radius_mm();
    double inside = 0.0;
    for (double z = field.lower_mm().z(); z < field.upper_mm().z(); z += step)
        for (double y = field.lower_mm().y(); y < field.upper_mm().y(); y += step)
            for (double x = field.lower_mm().x(); x < field.upper_mm().x(); x += step)
                inside += field.distance_mm({x, y, z}) < 0.0 ? 1.0 : 0.0;
    return inside * step * step * step;
}

double distance_to_nearest_vertex_mm(const TetMesh& mesh, const Vec3& point) {
    double nearest = 1e300;
    for (const Vec3& vertex : mesh.vertices_mm)
        nearest = std::min(nearest, (vertex - point).norm());
    return nearest;
}

class RandomTrees : public testing::TestWithParam<int> {};

TEST_P(RandomTrees, BecomeOneClosedBodyOfTheRightVolumeWithoutSlivers) {
    const VesselTree tree = test::random_tree(static_cast<std::uint64_t>(GetParam()), 4);
    Job job;
    const TetMesh mesh = tetrahedralize(tree, {}, job);
    validate(mesh);  // finite, right-handed, indices in range
    const MeshQuality quality = quality_of(mesh);
    EXPECT_EQ(quality.components, 1);
    EXPECT_TRUE(quality.closed);
    EXPECT_EQ(quality.boundary_components, 1);
    EXPECT_EQ(quality.handles, 0);
    EXPECT_GT(quality.min_dihedral_deg, 10.0);
    EXPECT_NEAR(quality.volume_mm3 / counted_volume_mm3(tree), 1.0, 0.05);
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 0; i < segment.points_mm.size(); ++i)
            EXPECT_LT(distance_to_nearest_vertex_mm(mesh, segment.points_mm[i]),
                      1.3 * segment.radii_mm[i]);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees, testing::Range(1, 9));

// A cone's volume is known in closed form: pi/3 l (a^2 + ab + b^2), and a cap at each end.
TEST(Tetrahedralize, GivesAStraightConeItsVolume) {
    VesselTree tree;
    test::add_node(tree, Vec3::Zero(), 4.0);
    test::add_node(tree, Vec3(0, 0, 80), 3.0);
    VesselSegment segment;
    segment.proximal_node = 0;
    segment.distal_node = 1;
    segment.points_mm = {Vec3::Zero(), Vec3(0, 0, 80)};
    segment.radii_mm = {4.0, 3.0};
    tree.segments = {segment};
    Job job;
    MeshOptions options;
    options.facet_size_in_radii = 0.5;
    options.cell_size_in_radii = 0.5;
    const double closed_form =
        M_PI / 3.0 * 80.0 * (16.0 + 12.0 + 9.0) + 2.0 / 3.0 * M_PI * (64.0 + 27.0);
    EXPECT_NEAR(volume_mm3(tetrahedralize(tree, options, job)) / closed_form, 1.0, 0.03);
}

TEST(Tetrahedralize, KeepsAHairOnAThickTrunk) {
    VesselTree tree;
    test::add_node(tree, Vec3::Zero(), 8.0);
    const int trunk = test::add_vessel(tree, 0, -1, Vec3::UnitZ(), 100.0, 8.0, 7.0);
    const int fork = tree.segments[trunk].distal_node;
    const int hair =
        test::add_vessel(tree, fork, trunk, Vec3(1, 0, 1).normalized(), 60.0, 0.4, 0.3);
    Job job;
    const TetMesh mesh = tetrahedralize(tree, {}, job);
    EXPECT_EQ(quality_of(mesh).components, 1);
    EXPECT_TRUE(quality_of(mesh).closed);
    for (const Vec3& point : tree.segments[hair].points_mm) {
        const bool inside_trunk = (point - tree.nodes[fork].position_mm).norm() < 8.0;
        if (!inside_trunk) {
            EXPECT_LT(distance_to_nearest_vertex_mm(mesh, point), 0.6);
        }
    }
}

TEST(Tetrahedralize, MakesOneBodyOfEachComponentAndATorusOfALoop) {
    VesselTree two = test::random_tree(1, 3);
    const VesselTree other = test::random_tree(2, 3);
    const int nodes = static_cast<int>(two.nodes.size());
    const int segments = static_cast<int>(two.segments.size());
    two.nodes.insert(two.nodes.end(), other.nodes.begin(), other.nodes.end());
    for (VesselSegment segment : other.segments) {  // in the same place: bodies stay separate
        segment.proximal_node += nodes;
        segment.distal_node += nodes;
        if (segment.parent >= 0) segment.parent += segments;
        two.segments.push_back(segment);
    }
    Job job;
    EXPECT_EQ(quality_of(tetrahedralize(two, {}, job)).components, 2);

    VesselTree ring;
    test::add_node(ring, Vec3(30, 0, 0), 3.0);
    test::add_node(ring, Vec3(-30, 0, 0), 3.0);
    for (const double side : {1.0, -1.0}) {
        VesselSegment half;
        half.proximal_node = side > 0 ? 0 : 1;
        half.distal_node = side > 0 ? 1 : 0;
        half.parent = side > 0 ? -1 : 0;
        half.closes_loop = side < 0;
        for (int i = 0; i <= 20; ++i) {
            const double angle = (i / 20.0 + (side > 0 ? 0.0 : 1.0)) * M_PI;
            half.points_mm.push_back(30.0 * Vec3(std::cos(angle), std::sin(angle), 0.0));
            half.radii_mm.push_back(3.0);
        }
        ring.segments.push_back(half);
    }
    const MeshQuality torus = quality_of(tetrahedralize(ring, {}, job));
    EXPECT_EQ(torus.handles, 1);
    EXPECT_TRUE(torus.closed);
    EXPECT_NEAR(torus.volume_mm3 / (2.0 * M_PI * M_PI * 30.0 * 9.0), 1.0, 0.05);
}

TEST(Tetrahedralize, GivesTheSameBytesEveryTimeAndForAnyNumberOfThreads) {
    const VesselTree tree = test::random_tree(7, 4);
    Job job;
    const TetMesh first = tetrahedralize(tree, {}, job);
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const TetMesh again = tetrahedralize(tree, {}, job);
        EXPECT_EQ(first.tetrahedra, again.tetrahedra);
        EXPECT_EQ(first.vertices_mm, again.vertices_mm);
    }
}

TEST(Tetrahedralize, ComesNearTheNumberAskedFor) {
    const VesselTree tree = test::random_tree(3, 4);
    Job job;
    MeshOptions options;
    options.target_tetrahedra = 8000;
    const auto count = static_cast<double>(tetrahedralize(tree, options, job).tetrahedra.size());
    EXPECT_NEAR(count / 8000.0, 1.0, 0.35);
}

// A number of tetrahedra takes several passes, each of which began at 0 again.
TEST(Tetrahedralize, TellsProgressThatNeverGoesBack) {
    for (const int target : {0, 2000}) {
        Job job;
        double before = 0.0;
        int reports = 0;
        job.observe([&](JobEvent event) {
            if (event != JobEvent::progress) return;
            const double now = job.progress().fraction;
            EXPECT_GE(now, before) << target;
            before = now;
            ++reports;
        });
        MeshOptions options;
        options.target_tetrahedra = target;
        tetrahedralize(test::random_tree(3, 2), options, job);
        EXPECT_GT(reports, 10) << target;
        EXPECT_GT(before, 0.1) << target;
        EXPECT_LE(before, 1.0) << target;
    }
}

TEST(Tetrahedralize, StopsSoonAfterACancel) {
    const VesselTree tree = test::random_tree(3, 6);
    Job job;
    MeshOptions options;
    options.facet_size_in_radii = 0.35;
    options.cell_size_in_radii = 0.35;
    constexpr int last = 50;  // of the times at which it asks
    int asked = 0;
    job.observe([&](JobEvent) {
        if (++asked == last) job.cancel();
    });
    EXPECT_THROW(tetrahedralize(tree, options, job), Cancelled);
    EXPECT_LT(asked, last + 3);
}

// Its surface alone would have a thousand million points.
TEST(Tetrahedralize, RefusesAVesselAMillionTimesLongerThanWide) {
    VesselTree tree = test::random_tree(1, 1);
    for (VesselSegment& segment : tree.segments)
        for (double& radius_mm : segment.radii_mm) radius_mm = 1e-7;
    Job job;
    EXPECT_THROW(tetrahedralize(tree, {}, job), InputError);
}

TEST(Tetrahedralize, RefusesAVesselThatIsThinBehindAWideBeginning) {
    VesselTree tree = test::random_tree(1, 1);
    for (VesselSegment& segment : tree.segments)
        std::fill(segment.radii_mm.begin() + 1, segment.radii_mm.end(), 1e-5);
    Job job;
    job.cancel();  // what is not refused is not meshed either
    EXPECT_THROW(tetrahedralize(tree, {}, job), InputError);
    MeshOptions options;
    options.minimum_radius_mm = 0.5;
    EXPECT_THROW(tetrahedralize(tree, options, job), Cancelled);
}

// A case.json may state any number; boxes of 1e300 mm have no volume that is a number.
TEST(Tetrahedralize, RefusesALeastRadiusThatNoVesselHas) {
    Job job;
    job.cancel();  // what is not refused is not meshed either
    for (const double radius_mm : {1e300, std::numeric_limits<double>::infinity(), 51.0, -1.0,
                                   std::numeric_limits<double>::quiet_NaN()}) {
        MeshOptions options;
        options.minimum_radius_mm = radius_mm;
        EXPECT_THROW(tetrahedralize(test::random_tree(1, 1), options, job), InputError)
            << radius_mm;
    }
    MeshOptions options;
    options.minimum_radius_mm = 50.0;
    EXPECT_THROW(tetrahedralize(test::random_tree(1, 1), options, job), Cancelled);
}

TEST(Tetrahedralize, RefusesAnEmptyTreeAndSizesThatTearTubes) {
    Job job;
    EXPECT_THROW(tetrahedralize(VesselTree{}, {}, job), InputError);
    MeshOptions options;
    options.facet_size_in_radii = 2.0;
    EXPECT_THROW(tetrahedralize(test::random_tree(1, 1), options, job), InputError);
}

}  // namespace
}  // namespace hepatica
