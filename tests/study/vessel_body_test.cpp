// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies of the studies, held to what their header says of them.
#include "core/study/vessel_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/study/pull_trial.h"
#include "core/study/reference_beam.h"
#include "core/study/timing.h"

namespace hepatica {
namespace {

TEST(StudyBar, IsAsSlenderAsAskedAndClampedAtItsBeginning) {
    const BodyDescription bar = study_bar(5.0, 2);
    EXPECT_EQ(bar.mesh.tetrahedra.size(), 6u * 10u * 2u * 2u);
    EXPECT_NEAR(volume_mm3(bar.mesh), 30.0 * 36.0, 1e-9);
    Vec3 low = bar.mesh.vertices_mm[0], high = low;
    ASSERT_EQ(bar.fixed.size(), bar.mesh.vertices_mm.size());
    for (std::size_t v = 0; v < bar.fixed.size(); ++v) {
        const Vec3& x = bar.mesh.vertices_mm[v];
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
        EXPECT_EQ(bar.fixed[v] != 0, x.x() == 0.0);
    }
    EXPECT_LT((low - Vec3(0, -3, -3)).norm() + (high - Vec3(30, 3, 3)).norm(), 1e-12);
    for (int n = 0; n < bar.skeleton.size(); ++n) {
        EXPECT_NEAR(bar.skeleton.positions_mm[n].tail<2>().norm(), 0.0, 1e-12);
        EXPECT_NEAR(bar.skeleton.radii_mm[n], 3.0, 1e-12);
    }
    EXPECT_LT(clamp_mm(bar).norm(), 1e-12);
    const Vec3 far = bar.mesh.vertices_mm[furthest_vertex(bar)];
    EXPECT_EQ(far.x(), 30.0);
    EXPECT_NEAR(std::abs(far.y()), 3.0, 1e-12);
}

TEST(StudyBar, WithoutAClampIsMeasuredFromTheOrigin) {
    BodyDescription bar = study_bar(5.0, 1);
    bar.fixed.assign(bar.fixed.size(), 0);
    EXPECT_EQ(clamp_mm(bar), Vec3(0, 0, 0));
}

// Murray's law halves the cube of the radius at each fork; planes of forks alternate.
TEST(StudyTree, ForksByMurraysLawInAlternatingPlanes) {
    const VesselTree tree = study_tree(4, 6.0);
    ASSERT_EQ(tree.segments.size(), 15u);
    ASSERT_EQ(tree.nodes.size(), 16u);
    validate(tree);
    EXPECT_NEAR(length_mm(tree.segments[0]), 60.0, 1e-9);
    EXPECT_NEAR(tree.segments[0].radii_mm[0], 6.0, 1e-12);
    std::vector<int> children(15, 0);
    const auto direction_of = [](const VesselSegment& s) {
        return Vec3((s.points_mm.back() - s.points_mm.front()).normalized());
    };
    std::vector<std::vector<int>> of(15);
    for (int s = 1; s < 15; ++s) {
        const VesselSegment& child = tree.segments[s];
        const VesselSegment& parent = tree.segments[child.parent];
        of[child.parent].push_back(s);
        EXPECT_EQ(child.proximal_node, parent.distal_node);
        EXPECT_EQ(child.points_mm.front(), parent.points_mm.back());
        EXPECT_NEAR(std::pow(child.radii_mm[0] / parent.radii_mm[0], 3), 0.5, 1e-12);
        EXPECT_NEAR(length_mm(child) / child.radii_mm[0], 14.0, 1e-9);
    }
    for (int s = 0; s < 7; ++s) {
        ASSERT_EQ(of[s].size(), 2u);
        const Vec3 before = direction_of(tree.segments[s]),
                   left = direction_of(tree.segments[of[s][0]]),
                   right = direction_of(tree.segments[of[s][1]]);
        EXPECT_NEAR(std::acos(before.dot(left)), 0.65, 1e-9);
        EXPECT_NEAR(std::acos(before.dot(right)), 0.55, 1e-9);
        EXPECT_NEAR(std::acos(left.dot(right)), 1.2, 1e-9);  // to either side, in one plane
        const Vec3 plane = left.cross(right).normalized();
        for (const int child : of[s]) {
            if (of[child].empty()) continue;
            const Vec3 next = direction_of(tree.segments[of[child][0]])
                                  .cross(direction_of(tree.segments[of[child][1]]))
                                  .normalized();
            EXPECT_NEAR(plane.dot(next), 0.0, 1e-9);
        }
    }
}

TEST(LedAround, IsACircleOfTwoMillimetresThatBeginsAtTheVertex) {
    const Vec3 start(5, 6, 7), middle = start + Vec3(0, 0, 2);
    EXPECT_LT((led_around(3, start, 0).target_mm - start).norm(), 1e-12);
    for (const int frame : {0, 7, 31, 90}) {
        const Grab grab = led_around(3, start, frame);
        EXPECT_EQ(grab.vertices[0], 3);
        EXPECT_NEAR((grab.target_mm - middle).norm(), 2.0, 1e-12);
        EXPECT_EQ(grab.target_mm.x(), start.x());
        EXPECT_NEAR((led_around(3, start, frame + 1).target_mm - grab.target_mm).norm(), 0.1, 1e-4);
    }
    EXPECT_GT(led_around(3, start, 5).target_mm.y(), start.y());
}

// The bar's axis becomes an arc of its own length; what lies inside of it is shortened.
TEST(Bent, IsAnArcInThePlaneOfXAndY) {
    const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {20, 0, 1}, {20, 3, 2}, {0, -2, 0}};
    const std::vector<Vec3> arc = bent(points, M_PI / 2.0);
    const double radius = 20.0 / (M_PI / 2.0);
    const Vec3 centre(0, radius, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 arm = arc[i] - Vec3(0, radius, arc[i].z());
        EXPECT_NEAR(arm.norm(), radius - points[i].y(), 1e-12);
        EXPECT_NEAR(std::atan2(arm.x(), -arm.y()), points[i].x() / radius, 1e-12);
        EXPECT_EQ(arc[i].z(), points[i].z());
    }
    EXPECT_LT((arc[4] - points[4]).norm(), 1e-12);  // the clamped end stays
}

TEST(ReferenceBeam, SwingsWithThePeriodOfEulerAndBernoulli) {
    // 200 mm of 40 mm square, 1 MPa, 1 g/ml: f = 1.875^2 / (2 pi) sqrt(E h^2 / (12 rho L^4)).
    const double h = 40.0, l = 200.0, e = 1e6, rho = 1e-3;
    const double frequency =
        1.8751041 * 1.8751041 / (2.0 * M_PI) * std::sqrt(e * h * h / (12.0 * rho * l * l * l * l));
    EXPECT_NEAR(first_period_s(BeamSpec{}) * frequency, 1.0, 1e-5);
}

TEST(ReferenceBeam, MeasuresTheMeanFallOfItsEnd) {
    const BeamSpec spec{.cells = {2, 1, 1}};
    for (const char* element : {"corotated", "hexahedron"}) {
        const BodyDescription body = clamped_beam(spec, discretisation_of(element));
        EXPECT_EQ(body.hexahedra.size(), std::string(element) == "hexahedron" ? 2u : 0u);
        EXPECT_EQ(std::ranges::count(body.fixed, 1), 4);
        std::vector<Vec3> fallen = body.mesh.vertices_mm;
        for (Vec3& x : fallen) x.z() -= x.x() * (1.0 + x.y() / 100.0) / 100.0;
        // 2 mm at one side, 2.8 mm at the other
        EXPECT_NEAR(tip_deflection_mm(spec, body.mesh.vertices_mm, fallen), 2.4, 1e-12);
    }
}

TEST(Quantile, IsTheValueThatAShareLiesBelow) {
    const std::vector<double> values{5, 1, 4, 2, 3};
    EXPECT_EQ(quantile(values, 0.0), 1.0);
    EXPECT_EQ(quantile(values, 0.5), 3.0);
    EXPECT_EQ(quantile(values, 0.75), 4.0);
    EXPECT_EQ(quantile(values, 1.0), 5.0);
    EXPECT_EQ(quantile({7.0}, 0.95), 7.0);
}

TEST(MotionError, IsRelativeToTheMotionOfTheReference) {
    const CentrelineMotion reference{{3, 0, 0}, {0, 4, 0}};
    EXPECT_EQ(motion_error(reference, reference), 0.0);
    EXPECT_NEAR(motion_error({{0, 0, 0}, {0, 0, 0}}, reference), 1.0, 1e-15);
    EXPECT_NEAR(motion_error({{3, 0, 1}, {0, 4, 2}}, reference), std::sqrt(5.0) / 5.0, 1e-15);
}

}  // namespace
}  // namespace hepatica
