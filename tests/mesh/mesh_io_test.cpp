// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_io.h"

#include <gtest/gtest.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "tests/mesh/random_tree.h"
#include "tests/support/small_disk.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

class MeshIo : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(MeshIo, ReadsBackWhatItWroteToTheLastBit) {
    Job job;
    const TetMesh mesh = tetrahedralize(test::random_tree(1, 3), {}, job);
    write_vtu(folder_ / "mésh.vtu", mesh);
    const TetMesh back = read_vtu(folder_ / "mésh.vtu");
    EXPECT_EQ(back.vertices_mm, mesh.vertices_mm);
    EXPECT_EQ(back.tetrahedra, mesh.tetrahedra);
    const TriangleMesh surface = surface_of(mesh).mesh;
    write_vtp(folder_ / "surface.vtp", surface);
    EXPECT_EQ(read_vtp(folder_ / "surface.vtp").vertices_mm, surface.vertices_mm);
    EXPECT_EQ(read_vtp(folder_ / "surface.vtp").triangles, surface.triangles);
}

TEST_F(MeshIo, RefusesMissingForeignAndCutFiles) {
    EXPECT_THROW(read_vtu(folder_ / "missing.vtu"), InputError);
    std::ofstream(folder_ / "text.vtu") << "not a mesh";
    EXPECT_THROW(read_vtu(folder_ / "text.vtu"), InputError);
    Job job;
    write_vtu(folder_ / "cut.vtu", tetrahedralize(test::random_tree(1, 2), {}, job));
    fs::resize_file(folder_ / "cut.vtu", fs::file_size(folder_ / "cut.vtu") / 2);
    EXPECT_THROW(read_vtu(folder_ / "cut.vtu"), InputError);
}

TEST_F(MeshIo, RefusesAVertexBeyondTenMetresByValue) {
    Job job;
    TetMesh mesh = tetrahedralize(test::random_tree(1, 1), {}, job);
    for (Vec3& vertex : mesh.vertices_mm) vertex.x() += 3e9;  // 3,000 km
    write_vtu(folder_ / "far.vtu", mesh);
    try {
        read_vtu(folder_ / "far.vtu");
        FAIL() << "was read";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("3e+09"), std::string::npos) << error.what();
    }
}

TEST_F(MeshIo, NamesTheFileAndTheElementOfAMeshThatIsNotSound) {
    const auto place_of = [](const auto& read) {
        try {
            read();
        } catch (const InputError& error) {
            return error.place();
        }
        return std::string("was read");
    };
    TetMesh mesh;
    mesh.vertices_mm = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 3}};  // the second is inverted
    const fs::path body = folder_ / "inverted.vtu";
    write_vtu(body, mesh);
    EXPECT_EQ(place_of([&] { read_vtu(body); }), body.string() + ", tetrahedron 1");
    TriangleMesh surface;
    surface.vertices_mm = mesh.vertices_mm;
    surface.triangles = {{0, 1, 2}};
    const fs::path open = folder_ / "open.vtp";
    write_vtp(open, surface);
    EXPECT_EQ(place_of([&] { read_vtp(open); }), open.string() + ", surface");
}

// Four corners may be a quadrangle: the file says of which kind its cells are.
TEST_F(MeshIo, RefusesFourCornersThatAreNoTetrahedron) {
    Job job;
    write_vtu(folder_ / "mesh.vtu", tetrahedralize(test::random_tree(1, 1), {}, job));
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName((folder_ / "mesh.vtu").c_str());
    reader->Update();
    vtkNew<vtkUnstructuredGrid> quadrangles;
    quadrangles->SetPoints(reader->GetOutput()->GetPoints());
    quadrangles->SetCells(VTK_QUAD, reader->GetOutput()->GetCells());
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName((folder_ / "mesh.vtu").c_str());
    writer->SetInputData(quadrangles);
    ASSERT_NE(writer->Write(), 0);
    EXPECT_THROW(read_vtu(folder_ / "mesh.vtu"), InputError);
}

TEST_F(MeshIo, LeavesNothingWhereItCannotWrite) {
    std::ofstream(folder_ / "file") << "x";
    Job job;
    const TetMesh mesh = tetrahedralize(test::random_tree(1, 1), {}, job);
    EXPECT_THROW(write_vtu(folder_ / "file" / "mesh.vtu", mesh), InputError);
}

// Our message names the file; VTK told of its own pipeline.
TEST_F(MeshIo, IsRefusedOnAFullDiskInOurWordsAlone) {
    Job job;
    const TetMesh mesh = tetrahedralize(test::random_tree(1, 1), {}, job);
    testing::internal::CaptureStderr();
    std::string problem;
    try {
        const test::DiskOf full(1000);
        write_vtu(folder_ / "full.vtu", mesh);
    } catch (const InputError& error) {
        problem = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(problem.find("full.vtu"), std::string::npos) << problem;
}

}  // namespace
}  // namespace hepatica
