// SPDX-License-Identifier: GPL-3.0-or-later
// The branch that is chosen in the table is found for every row, and goes with the body.
#include "ui/chosen_branch.h"

#include <gtest/gtest.h>

#include <QTableWidget>

#include "core/scene/surface_anatomy.h"
#include "tests/ui/fake_window_test.h"
#include "ui/body_anchors.h"

namespace hepatica {
namespace {

// A trunk of 30 mm, a piece of 4 mm and a vessel that goes on, all 8 mm in radius, and vertices on
// a wall that is nearer to the long ones everywhere: it bulges where the short one is.
std::shared_ptr<const PatientCase> short_wide_branch() {
    auto patient = std::make_shared<PatientCase>();
    const auto add = [&](double from_mm, double to_mm, int parent) {
        VesselSegment segment;
        segment.points_mm = {Vec3(0, 0, from_mm), Vec3(0, 0, to_mm)};
        segment.radii_mm = {8.0, 8.0};
        segment.parent = parent;
        patient->tree.segments.push_back(segment);
    };
    add(0, 30, -1);
    add(30, 34, 0);
    add(34, 60, 1);
    for (const double z : {0.0, 10.0, 20.0, 29.0, 36.0, 45.0, 60.0})
        for (const double x : {-8.0, 8.0}) patient->mesh.vertices_mm.emplace_back(x, 0, z);
    return patient;
}

Frame frame_of(const PatientCase& patient, const Vec3& moved_mm) {
    Frame frame;
    for (const Vec3& vertex : patient.mesh.vertices_mm)
        for (const double at : Vec3(vertex + moved_mm))
            frame.positions_mm.push_back(static_cast<float>(at));
    return frame;
}

TEST(ChosenBranch, has_a_line_where_no_vertex_belongs_to_it) {
    const auto patient = short_wide_branch();
    Job job;
    const SurfaceAnatomy anatomy(patient->tree, patient->mesh.vertices_mm, job);
    ASSERT_EQ(std::ranges::count(anatomy.vertices_of(1), 1), 0);
    ChosenBranch chosen;
    EXPECT_TRUE(chosen.line_in(frame_of(*patient, Vec3::Zero())).empty());
    chosen.choose(1, patient);
    const std::vector<Vec3> line = chosen.line_in(frame_of(*patient, Vec3::Zero()));
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.front(), Vec3(0, 0, 30));
    EXPECT_EQ(line.back(), Vec3(0, 0, 34));
    for (std::size_t i = 1; i < line.size(); ++i)
        EXPECT_LE((line[i] - line[i - 1]).norm(), ChosenBranch::spacing_mm + 1e-9);
    const std::vector<Vec3> moved = chosen.line_in(frame_of(*patient, Vec3(1, 2, 3)));
    ASSERT_EQ(moved.size(), line.size());
    EXPECT_LT((moved.back() - Vec3(1, 2, 37)).norm(), 1e-5) << "with the body";
    chosen.forget();
    EXPECT_EQ(chosen.branch(), -1);
    EXPECT_TRUE(chosen.line_in(frame_of(*patient, Vec3::Zero())).empty());
    chosen.choose(3, patient);
    EXPECT_EQ(chosen.branch(), -1) << "there is none of this number";
}

TEST(BodyAnchors, are_the_nearest_vertices_within_reach) {
    const std::vector<Vec3> vertices_mm{Vec3(0, 0, 0), Vec3(10, 0, 0)};
    EXPECT_EQ(nearest_vertex(vertices_mm, Vec3(7, 0, 0)), 1);
    EXPECT_EQ(nearest_vertex(vertices_mm, Vec3(7, 0, 0), 2.0), -1);
    EXPECT_EQ(nearest_vertex({}, Vec3::Zero()), -1);
    Frame frame;
    frame.positions_mm = {0, 0, 0, 10, 0, 5};
    EXPECT_EQ(displacement_mm(1, vertices_mm, frame), Vec3(0, 0, 5));
    EXPECT_EQ(displacement_mm(-1, vertices_mm, frame), Vec3::Zero());
    EXPECT_EQ(displacement_mm(2, vertices_mm, frame), Vec3::Zero());
}

class ChosenInTable : public testing::FakeWindowTest {};

TEST_F(ChosenInTable, has_a_line_a_mark_and_an_entry_for_every_row) {
    open_built_in();
    window_.actions()[ActionId::toggle_branches].trigger();
    auto* table = window_.findChild<QTableWidget*>("branches");
    ASSERT_TRUE(testing::wait_for([&] { return table->rowCount() > 0; }));
    const SceneView& scene = window_.view().scene();
    EXPECT_FALSE(scene.legend().branch_line);
    for (int row = 0; row < table->rowCount(); ++row) {
        table->setCurrentCell(row, 0);
        EXPECT_TRUE(scene.legend().branch_line) << row;
        EXPECT_EQ(scene.marks().size(), 1u) << row;
    }
}

}  // namespace
}  // namespace hepatica
