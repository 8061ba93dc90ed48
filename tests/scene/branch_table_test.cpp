// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/branch_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hepatica {
namespace {

// A trunk of 30 mm that narrows from 5 to 3 mm and a branch that turns off by a right angle.
VesselTree bent() {
    VesselTree tree;
    tree.segments.resize(2);
    VesselSegment& trunk = tree.segments[0];
    trunk.system = VascularSystem::portal;
    trunk.points_mm = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(30, 0, 0)};
    trunk.radii_mm = {5.0, 5.0, 3.0};
    VesselSegment& branch = tree.segments[1];
    branch.parent = 0;
    branch.system = VascularSystem::portal;
    branch.system_confidence = 0.75;
    branch.points_mm = {Vec3(30, 0, 0), Vec3(30, 4, 0), Vec3(30, 4, 12)};
    branch.radii_mm = {2.0, 2.0, 2.0};
    return tree;
}

TEST(BranchTable, MeasuresAlongTheCentreline) {
    const std::vector<BranchRow> rows = branch_rows(bent(), {}, {});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[0].length_mm, 30.0, 1e-12);
    EXPECT_NEAR(rows[0].radius_mm, (10 * 5.0 + 20 * 4.0) / 30.0, 1e-12);
    EXPECT_NEAR(rows[1].length_mm, 16.0, 1e-12);
    EXPECT_LT((rows[0].middle_mm - Vec3(15, 0, 0)).norm(), 1e-12);
    EXPECT_LT((rows[1].middle_mm - Vec3(30, 4, 4)).norm(), 1e-12);
    EXPECT_EQ(rows[0].generation, 1);
    EXPECT_EQ(rows[1].generation, 2);
    EXPECT_FALSE(rows[0].flow_share);
}

TEST(BranchTable, AsCsvHasAFieldForEachColumnAndNoneForWhatIsNotKnown) {
    const std::vector<BranchLabel> labels{{0, 0.0}, {7, 0.5}};
    const std::vector<double> shares{1.0, 0.25};
    const std::string known = branch_table_csv(branch_rows(bent(), labels, shares));
    const std::string unknown = branch_table_csv(branch_rows(bent(), {}, {}));
    for (const std::string& csv : {known, unknown}) {
        EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
        EXPECT_EQ(std::ranges::count(csv, ','), 3 * 12);
    }
    EXPECT_NE(known.find("\n2,portal,0.750,2,1,16.000,2.000,7,0.500,0.250000,30.000,4.000,4.000\n"),
              std::string::npos)
        << known;
    EXPECT_NE(unknown.find("\n1,portal,0.000,1,1,30.000,4.333,,,,15.000,0.000,0.000\n"),
              std::string::npos)
        << unknown;
}

}  // namespace
}  // namespace hepatica
