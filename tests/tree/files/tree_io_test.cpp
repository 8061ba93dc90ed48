// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/tree_io.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/support/test_data.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

std::filesystem::path scratch(const std::string& name) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hepatica_tree_io";
    std::filesystem::create_directories(folder);
    return folder / name;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

}  // namespace

TEST(TreeVtp, ComesBackToTheBit) {
    const VesselTree tree = forked_tree();
    write_tree_vtp(scratch("fork.vtp"), tree);
    expect_equal(read_tree_vtp(scratch("fork.vtp")), tree);
}

TEST(TreeVtp, OpensInVtkWithTheArraysOtherProgramsAskFor) {
    const VesselTree tree = forked_tree();
    write_tree_vtp(scratch("fork.vtp"), tree);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(scratch("fork.vtp").c_str());
    reader->Update();
    vtkPolyData* lines = reader->GetOutput();
    ASSERT_EQ(lines->GetNumberOfLines(), static_cast<vtkIdType>(tree.segments.size()));
    auto* space = vtkStringArray::SafeDownCast(lines->GetFieldData()->GetAbstractArray("SPACE"));
    ASSERT_NE(space, nullptr);
    EXPECT_EQ(space->GetValue(0), "LPS");
    for (const char* name : {"MaximumInscribedSphereRadius", "Radius", "Path", "BranchId",
                             "BifurcationId", "CenterlineId", "CenterlineSectionArea"})
        EXPECT_NE(lines->GetPointData()->GetArray(name), nullptr) << name;
    for (const char* name : {"SegmentId", "ParentId", "StrahlerOrder", "GroupIds", "CenterlineIds",
                             "TractIds", "Blanking"})
        EXPECT_NE(lines->GetCellData()->GetArray(name), nullptr) << name;
    EXPECT_EQ(lines->GetCellData()->GetArray("ParentId")->GetComponent(0, 0), -1);
    EXPECT_EQ(lines->GetCellData()->GetArray("ParentId")->GetComponent(1, 0), 0);
    double first[3];
    lines->GetPoint(0, first);
    EXPECT_EQ(Vec3(first[0], first[1], first[2]), tree.segments[0].points_mm[0]);
    EXPECT_EQ(lines->GetPointData()->GetArray("Radius")->GetComponent(0, 0),
              tree.segments[0].radii_mm[0]);
}

TEST(TreeVtp, TwoWritesGiveTheSameBytes) {
    write_tree_vtp(scratch("a.vtp"), forked_tree());
    write_tree_vtp(scratch("b.vtp"), forked_tree());
    std::ifstream a(scratch("a.vtp")), b(scratch("b.vtp"));
    const std::string text_a(std::istreambuf_iterator<char>(a), {});
    const std::string text_b(std::istreambuf_iterator<char>(b), {});
    EXPECT_FALSE(text_a.empty());
    EXPECT_EQ(text_a, text_b);
}

// Trees of another program: bare two-point lines with a radius per cell.
TEST(TreeVtp, ForeignTreesAreRebuiltFromSharedPoints) {
    const auto folder = shared_data() / "vascusynth";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const VesselTree tree = read_tree_vtp(folder / "tree_portal.vtp");
    validate(tree);
    ASSERT_EQ(roots(tree).size(), 1u);
    EXPECT_EQ(tree.segments.size(), 519u);
    EXPECT_NEAR(tree.segments[0].radii_mm[0], 5.86407, 1e-5);
    EXPECT_LT((tree.segments[0].points_mm[0] - Vec3(108.0, 91.8, 64.8)).norm(), 1e-3);
    EXPECT_EQ(bifurcation_count(tree) + 1, end_count(tree) - 1);
}

TEST(TreeVtp, BadFilesAreRefusedByName) {
    EXPECT_THROW(read_tree_vtp(scratch("none.vtp")), InputError);
    write_text(scratch("text.vtp"), "not a tree");
    EXPECT_THROW(read_tree_vtp(scratch("text.vtp")), InputError);
    write_text(scratch("empty.vtp"), "");
    EXPECT_THROW(read_tree_vtp(scratch("empty.vtp")), InputError);
    write_text(scratch("broken.vtp"),
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
               "byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"2\"");
    try {
        read_tree_vtp(scratch("broken.vtp"));
        FAIL() << "a cut-off file was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), scratch("broken.vtp").string());
    }
    EXPECT_THROW(write_tree_vtp(scratch("text.vtp") / "in_a_file.vtp", forked_tree()), InputError);
}

TEST(TreeVtp, FileCutAnywhereIsRefusedOrWhole) {
    write_tree_vtp(scratch("whole.vtp"), forked_tree());
    std::ifstream in(scratch("whole.vtp"), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (std::size_t size = 0; size < text.size() * 9 / 10; size += 211) {
        write_text(scratch("cut.vtp"), text.substr(0, size));
        EXPECT_THROW(read_tree_vtp(scratch("cut.vtp")), InputError) << size << " bytes";
    }
}

TEST(TreeJson, ComesBackToTheBit) {
    write_tree(scratch("fork.json"), forked_tree());
    expect_equal(read_tree(scratch("fork.json")), forked_tree());
}

TEST(TreeJson, BadFilesAreRefused) {
    for (const char* text :
         {"", "[]", "{\"version\":9}", "{\"version\":1,\"nodes\":[],\"segments\":[{}]}",
          "{\"version\":1,\"nodes\":[{\"position_mm\":[1,2],\"radius_mm\":1}]}"}) {
        write_text(scratch("bad.json"), text);
        EXPECT_THROW(read_tree(scratch("bad.json")), InputError) << text;
    }
}

TEST(TreeSwc, ComesBackButForTheRadiusAtForks) {
    const VesselTree tree = forked_tree();
    write_tree(scratch("fork.swc"), tree);
    const VesselTree back = read_tree(scratch("fork.swc"));
    ASSERT_EQ(back.segments.size(), tree.segments.size());
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        EXPECT_EQ(back.segments[s].points_mm, tree.segments[s].points_mm);
        EXPECT_EQ(back.segments[s].parent, tree.segments[s].parent);
        EXPECT_EQ(back.segments[s].system, tree.segments[s].system);
        EXPECT_EQ(back.segments[s].strahler_order, tree.segments[s].strahler_order);
        EXPECT_TRUE(std::equal(back.segments[s].radii_mm.begin() + 1,
                               back.segments[s].radii_mm.end(),
                               tree.segments[s].radii_mm.begin() + 1));
    }
}

TEST(TreeSwc, LoopsAndSystemsComeBack) {
    VesselGraph graph = forked_graph();
    graph.links.push_back(straight_link(graph, 2, 4, 1.0, 1.0));
    for (const auto& p : {Vec3(60, 0, 0), Vec3(60, 30, 0)}) graph.nodes.push_back({p, 2.0});
    graph.links.push_back(straight_link(graph, 6, 7, 2.0, 1.5, 1));
    join_passing_nodes(graph);
    const VesselTree tree = directed(graph);
    write_tree(scratch("loop.swc"), tree);
    const VesselTree back = read_tree(scratch("loop.swc"));
    ASSERT_EQ(back.segments.size(), tree.segments.size());
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        EXPECT_EQ(back.segments[s].closes_loop, tree.segments[s].closes_loop);
        EXPECT_EQ(back.segments[s].system, tree.segments[s].system);
    }
}

TEST(TreeSwc, ReadsFilesOfOtherPrograms) {
    write_text(scratch("other.swc"),
               "# any comment\n 3 2 0 2.5 0 1 2\n1 1 0 0 0 2 -1 # root\n2 3 0 1.0 0 1.5 1\r\n"
               "4 3 1 2 0 0.5 2\n");
    const VesselTree tree = read_tree(scratch("other.swc"));
    EXPECT_EQ(tree.segments.size(), 3u);
    EXPECT_EQ(tree.segments[0].points_mm.front(), Vec3(0, 0, 0));
    EXPECT_EQ(tree.segments[0].radii_mm.front(), 2.0);
}

TEST(TreeSwc, BadFilesAreRefused) {
    for (const char* text : {"", "1 1 0 0 0 1 -1\n", "1 1 0 0 zero 1 -1\n2 1 0 0 1 1 1\n",
                             "1 1 0 0 0 1 -1\n2 1 0 0 1 1 7\n", "1 1 0 0 0 1 -1\n1 1 0 0 1 1 1\n",
                             "1 1 0 0 0 0 -1\n2 1 0 0 1 -1 1\n", "1 1 0 0 0 1\n"}) {
        write_text(scratch("bad.swc"), text);
        EXPECT_THROW(read_tree(scratch("bad.swc")), InputError) << text;
    }
    EXPECT_THROW(read_tree(scratch("tree.xyz")), InputError);
    EXPECT_THROW(write_tree(scratch("tree.xyz"), forked_tree()), InputError);
    EXPECT_THROW(read_tree(scratch("none.swc")), InputError);
}

}  // namespace hepatica
