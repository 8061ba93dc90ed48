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
#include <vtkXMLPolyDataWriter.h>

#include <fstream>
#include <nlohmann/json.hpp>

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
    const VesselTree tree = read_tree_vtp(folder / "tree_portal.vtp", {.space = PatientSpace::lps});
    validate(tree);
    ASSERT_EQ(roots(tree).size(), 1u);
    EXPECT_EQ(tree.segments.size(), 519u);
    EXPECT_NEAR(tree.segments[0].radii_mm[0], 5.86407, 1e-5);
    EXPECT_LT((tree.segments[0].points_mm[0] - Vec3(108.0, 91.8, 64.8)).norm(), 1e-3);
    EXPECT_EQ(bifurcation_count(tree) + 1, end_count(tree) - 1);
}

// One line from (1,2,3) to (1,2,43) as another program writes it.
std::filesystem::path foreign_vtp(const std::string& space, bool with_radii) {
    std::ofstream out(scratch("foreign.vtp"));
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PolyData>\n";
    if (!space.empty()) {
        out << "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
               "format=\"ascii\">";
        for (const char c : space) out << int{c} << ' ';
        out << "0</Array></FieldData>\n";
    }
    out << "<Piece NumberOfPoints=\"2\" NumberOfVerts=\"0\" NumberOfLines=\"1\" "
           "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>";
    if (with_radii)
        out << "<DataArray type=\"Float64\" Name=\"MaximumInscribedSphereRadius\" "
               "format=\"ascii\">3 2</DataArray>";
    out << "</PointData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
           "format=\"ascii\">1 2 3 1 2 43</DataArray></Points>\n"
           "<Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1"
           "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">2"
           "</DataArray></Lines>\n</Piece></PolyData></VTKFile>\n";
    return scratch("foreign.vtp");
}

std::string refusal_of(const std::filesystem::path& file, const TreeFileFacts& facts) {
    try {
        read_tree(file, facts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// A mirrored liver was taken for one in LPS once.
TEST(TreeVtp, OfAnotherProgramIsTurnedIntoLpsOrMustBeStated) {
    const auto begin_of = [](const VesselTree& tree) { return tree.segments[0].points_mm[0]; };
    for (const char* ras : {"RAS", "SPACE=RAS"})
        EXPECT_EQ(begin_of(read_tree(foreign_vtp(ras, true))), Vec3(-1, -2, 3)) << ras;
    EXPECT_EQ(begin_of(read_tree(foreign_vtp("LPS", true))), Vec3(1, 2, 3));
    const std::string message = refusal_of(foreign_vtp("", true), {});
    EXPECT_NE(message.find("--tree-space"), std::string::npos) << message;
    EXPECT_EQ(begin_of(read_tree(foreign_vtp("", true), {.space = PatientSpace::ras})),
              Vec3(-1, -2, 3));
    EXPECT_EQ(begin_of(read_tree(foreign_vtp("", true), {.space = PatientSpace::lps})),
              Vec3(1, 2, 3));
    EXPECT_NE(refusal_of(foreign_vtp("RAS", true), {.space = PatientSpace::lps}), "");
    EXPECT_NE(refusal_of(foreign_vtp("XYZ", true), {}).find("\"XYZ\""), std::string::npos);
}

// Its own file as another program saves it again, in RAS: turned as a whole.
TEST(TreeVtp, OfItsOwnInRasIsTurnedBack) {
    const VesselTree tree = forked_tree();
    write_tree_vtp(scratch("own.vtp"), tree);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(scratch("own.vtp").c_str());
    reader->Update();
    vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("SPACE"))
        ->SetValue(0, "RAS");
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(scratch("ras.vtp").c_str());
    writer->SetInputData(reader->GetOutput());
    writer->Write();
    const VesselTree turned = read_tree_vtp(scratch("ras.vtp"));
    EXPECT_EQ(turned.segments[0].points_mm[0],
              Vec3(-1, -1, 1).cwiseProduct(tree.segments[0].points_mm[0]));
    EXPECT_EQ(turned.nodes[0].position_mm, Vec3(-1, -1, 1).cwiseProduct(tree.nodes[0].position_mm));
}

// Every vessel was given a radius of 1 mm once.
TEST(TreeVtp, WithoutRadiiIsRefusedUnlessOneIsStated) {
    const std::string message = refusal_of(foreign_vtp("LPS", false), {});
    EXPECT_NE(message.find("MaximumInscribedSphereRadius or Radius"), std::string::npos) << message;
    const VesselTree tree = read_tree(foreign_vtp("LPS", false), {.radius_mm = 2.5});
    EXPECT_EQ(tree.segments[0].radii_mm, (std::vector<double>{2.5, 2.5}));
    EXPECT_NE(refusal_of(foreign_vtp("LPS", true), {.radius_mm = 2.5}), "");
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

TEST(TreeJson, AFileThatSaysToBeSomethingElseIsRefusedByValue) {
    const auto file = scratch("changed.json");
    write_tree_json(file, forked_tree());
    std::ifstream in(file);
    const nlohmann::json good = nlohmann::json::parse(in);
    const auto problem_of = [&](const nlohmann::json& json) -> std::string {
        write_text(file, json.dump());
        try {
            read_tree(file);
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), file.string());
            EXPECT_NE(error.remedy(), "");
            return error.problem();
        }
        return "";
    };
    const auto with = [&](const char* place, const nlohmann::json& value) {
        nlohmann::json changed = good;
        changed[nlohmann::json::json_pointer(place)] = value;
        return changed;
    };
    EXPECT_EQ(problem_of(with("/format", "a street map")), "is of the format \"a street map\"");
    EXPECT_EQ(problem_of(with("/space", "RAS")), "has its axes in space \"RAS\"");
    EXPECT_EQ(problem_of(with("/space", 3)), "has its axes in space 3");
    EXPECT_EQ(problem_of(with("/nodes/1/radius_mm", -2.0)), "has a node of radius -2 mm");
    EXPECT_EQ(problem_of(with("/nodes/1/radius_mm", 0.0)), "has a node of radius 0 mm");
    const std::string four = problem_of(with("/nodes/1/position_mm", {1.0, 2.0, 3.0, 4.0}));
    EXPECT_NE(four.find("must be three numbers, but is a list of 4"), std::string::npos) << four;
}

TEST(TreeJson, AFileThatSaysNeitherItsFormatNorItsSpaceIsRead) {
    const auto file = scratch("silent.json");
    write_tree_json(file, forked_tree());
    std::ifstream in(file);
    nlohmann::json json = nlohmann::json::parse(in);
    json.erase("format");
    json.erase("space");
    write_text(file, json.dump());
    expect_equal(read_tree(file), forked_tree());
}

// As the phantom wrote its truth before systems had names: 0 the portal vein, 1 the hepatic veins.
// A reconstruction of that time meant nobody's system by 0 and the portal vein by 1.
void expect_refused_in_words(const std::filesystem::path& file) {
    try {
        read_tree(file);
        FAIL() << file;
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), file.string());
        EXPECT_NE(error.problem().find("counts its vascular systems from 0"), std::string::npos);
        EXPECT_NE(error.remedy().find("phantom"), std::string::npos);
    }
}

void write_vtp_without_names(const std::filesystem::path& file, const std::vector<int>& systems) {
    write_tree_vtp(file, forked_tree());
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* lines = reader->GetOutput();
    lines->GetCellData()->RemoveArray("SystemName");
    lines->GetCellData()->RemoveArray("Confidence");
    for (std::size_t s = 0; s < systems.size(); ++s)
        lines->GetCellData()->GetArray("System")->SetComponent(static_cast<vtkIdType>(s), 0,
                                                               systems[s]);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(lines);
    ASSERT_NE(writer->Write(), 0);
}

TEST(TreeVtp, OfAnOlderVersionThatCountsItsSystemsFromZeroIsRefusedInWords) {
    const auto file = scratch("old.vtp");
    const std::size_t segments = forked_tree().segments.size();
    std::vector<int> systems(segments, 0);
    write_vtp_without_names(file, systems);  // one system, of which nothing is said
    for (const VesselSegment& segment : read_tree(file).segments)
        EXPECT_EQ(segment.system, VascularSystem::unknown);
    systems.back() = 1;
    write_vtp_without_names(file, systems);
    expect_refused_in_words(file);
    // The case that it lies in says what its numbers mean.
    EXPECT_EQ(read_tree_vtp(file, {.in_case = true}).segments.back().system,
              VascularSystem::portal);
    systems.assign(segments, 2);
    write_vtp_without_names(file, systems);
    EXPECT_EQ(read_tree(file).segments.front().system, VascularSystem::hepatic);
}

TEST(TreeJson, OfAnOlderVersionThatCountsItsSystemsFromZeroIsRefusedInWords) {
    const auto file = scratch("old.json");
    write_tree_json(file, forked_tree());
    std::ifstream in(file);
    nlohmann::json json = nlohmann::json::parse(in);
    for (nlohmann::json& segment : json["segments"]) {
        segment.erase("system_name");
        segment["system"] = 0;
    }
    write_text(file, json.dump());
    EXPECT_EQ(read_tree(file).segments.front().system, VascularSystem::unknown);
    json["segments"].back()["system"] = 1;
    write_text(file, json.dump());
    expect_refused_in_words(file);
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

// A fork's point is written once, with the segment that ends there.
TEST(TreeSwc, HoldsEveryPointOnce) {
    const VesselTree tree = forked_tree();
    write_tree(scratch("count.swc"), tree);
    std::ifstream in(scratch("count.swc"));
    std::size_t samples = 0, beginnings = 0, expected = 0;
    for (std::string line; std::getline(in, line);) {
        samples += !line.starts_with('#');
        beginnings += line.ends_with(" -1");
    }
    for (const VesselSegment& segment : tree.segments)
        expected += segment.points_mm.size() - (segment.parent < 0 ? 0 : 1);
    EXPECT_EQ(samples, expected);
    EXPECT_EQ(beginnings, 1u);
}

TEST(TreeSwc, MayBeStatedToBeInRas) {
    write_text(scratch("ras.swc"), "1 1 1 2 3 1 -1\n2 1 1 2 9 1 1\n");
    EXPECT_EQ(read_tree(scratch("ras.swc"), {.space = PatientSpace::ras}).segments[0].points_mm[0],
              Vec3(-1, -2, 3));
}

// What contradicts the format was passed over: a tree said to be in RAS was read as it is in LPS.
TEST(TreeFiles, WhatContradictsTheirFormatIsRefused) {
    for (const char* name : {"fact.swc", "fact.json"}) {
        write_tree(scratch(name), forked_tree());
        EXPECT_EQ(refusal_of(scratch(name), {}), "") << name;
        const std::string radius = refusal_of(scratch(name), {.radius_mm = 2.5});
        EXPECT_NE(radius.find("radii of its own"), std::string::npos) << name << radius;
    }
    EXPECT_EQ(refusal_of(scratch("fact.json"), {.space = PatientSpace::lps}), "");
    const std::string space = refusal_of(scratch("fact.json"), {.space = PatientSpace::ras});
    EXPECT_NE(space.find("its axes are LPS"), std::string::npos) << space;
}

TEST(TreeSwc, LoopsAndSystemsComeBack) {
    VesselGraph graph = forked_graph();
    graph.links.push_back(straight_link(graph, 2, 4, 1.0, 1.0));
    for (const auto& p : {Vec3(60, 0, 0), Vec3(60, 30, 0)}) graph.nodes.push_back({p, 2.0});
    graph.links.push_back(straight_link(graph, 6, 7, 2.0, 1.5, VascularSystem::hepatic));
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

// Types 5 and 6 mean forks and ends in the files of some tracers, and 5 was unknown in ours before
// they named their types.
TEST(TreeSwc, ReadsSystemsOnlyWhereTheFileNamesThem) {
    const std::string samples = "1 5 0 0 0 2 -1\n2 5 0 1 0 2 1\n";
    write_text(scratch("foreign.swc"), samples);
    EXPECT_EQ(read_tree(scratch("foreign.swc")).segments.at(0).system, VascularSystem::unknown);
    write_text(scratch("own.swc"),
               "# Types: 5 portal vein, 6 hepatic veins, 7 artery, 0 unknown.\n" + samples);
    EXPECT_EQ(read_tree(scratch("own.swc")).segments.at(0).system, VascularSystem::portal);
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

// -1 is the parent of a root, and 0 a number like any other.
TEST(TreeSwc, SamplesMayBeCountedFromZero) {
    const std::string samples[] = {"0 2 0 0 0 2 -1\n1 2 0 5 0 1.5 0\n2 2 0 9 0 1 1\n",
                                   "1 2 0 0 0 2 -1\n2 2 0 5 0 1.5 1\n3 2 0 9 0 1 2\n"};
    VesselTree trees[2];
    for (int i = 0; i < 2; ++i) {
        write_text(scratch("counted.swc"), samples[i]);
        trees[i] = read_tree(scratch("counted.swc"));
        ASSERT_EQ(trees[i].segments.size(), 1u);
    }
    EXPECT_EQ(trees[0].segments[0].points_mm, trees[1].segments[0].points_mm);
    EXPECT_EQ(trees[0].segments[0].points_mm.size(), 3u);
    EXPECT_EQ(trees[0].segments[0].radii_mm, trees[1].segments[0].radii_mm);
}

TEST(TreeFiles, OfNoPatientAreRefusedByValue) {
    const auto says = [](const char* name, const std::string& text) -> std::string {
        write_text(scratch(name), text);
        try {
            read_tree(scratch(name));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const std::string far = says("far.swc", "1 1 0 0 0 1 -1\n2 1 0 1e21 0 1 1\n");
    EXPECT_NE(far.find("1e+21"), std::string::npos) << far;
    const std::string hair = says("hair.swc", "1 1 0 0 0 1 -1\n2 1 0 9 0 1e-30 1\n");
    EXPECT_NE(hair.find("radius 1e-30 mm"), std::string::npos) << hair;
    VesselTree tree = forked_tree();
    tree.segments[0].points_mm[1].x() = 3e9;  // 3,000 km
    write_tree(scratch("far.vtp"), tree);
    write_tree(scratch("far.json"), tree);
    for (const char* name : {"far.vtp", "far.json"}) try {
            read_tree(scratch(name));
            ADD_FAILURE() << name << " was read";
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find("3e+09"), std::string::npos) << error.what();
        }
}

// Samples at one position are one point, and a vessel has two.
TEST(TreeFiles, WithoutAVesselAreRefused) {
    write_text(scratch("dot.swc"), "1 1 0 0 0 1 -1\n2 1 0 0 0.0001 1 1\n");
    write_text(scratch("dot.json"), R"({"version": 1, "nodes": [], "segments": []})");
    for (const char* name : {"dot.swc", "dot.json"}) {
        const std::string refusal = refusal_of(scratch(name), {});
        EXPECT_NE(refusal.find("holds no vessel"), std::string::npos) << name << ": " << refusal;
    }
}

// Whether there is such a file is not known then.
TEST(TreeFiles, ThatCannotBeLookedUpAreRefusedWithTheReason) {
    for (const char* extension : {".vtp", ".swc", ".json"}) {
        const std::string refusal = refusal_of(scratch(std::string(300, 'x') + extension), {});
        EXPECT_NE(refusal.find("cannot be opened (File name too long)"), std::string::npos)
            << refusal;
    }
    EXPECT_THROW(read_tree_vtp(scratch(std::string(300, 'x') + ".vtp")), InputError);
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

// Each sample has a parent, and none of them has a root.
TEST(TreeSwc, RefusesSamplesThatAreTheirOwnAncestors) {
    const std::filesystem::path file = scratch("ring.swc");
    for (const char* ring : {"1 0 0 0 0 1 2\n2 0 5 0 0 1 1\n", "1 0 0 0 0 1 1\n2 0 5 0 0 1 1\n",
                             "1 0 0 0 0 1 -1\n2 0 5 0 0 1 1\n3 0 9 0 0 1 5\n4 0 9 9 0 1 3\n"
                             "5 0 9 9 9 1 4\n"}) {
        write_text(file, ring);
        try {
            read_tree_swc(file);
            ADD_FAILURE() << ring;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find("its own ancestor"), std::string::npos)
                << error.problem();
        }
    }
}

}  // namespace hepatica
