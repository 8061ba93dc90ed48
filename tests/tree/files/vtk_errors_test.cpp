// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/files/vtk_errors.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "core/tree/files/tree_io.h"
#include "tests/support/small_disk.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

void write_nowhere(vtkXMLPolyDataWriter* writer) {
    const auto file = std::filesystem::path(testing::TempDir()) / "no such folder" / "a.vtp";
    vtkNew<vtkPolyData> nothing;
    writer->SetInputData(nothing);
    writer->SetFileName(file.c_str());
    writer->Write();
}

TEST(VtkErrors, AreHeardAndNotPrintedWhileSomebodyHears) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    testing::internal::CaptureStderr();
    {
        VtkErrors errors(writer);
        EXPECT_FALSE(errors.any());
        write_nowhere(writer);
        EXPECT_TRUE(errors.any());
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    testing::internal::CaptureStderr();
    write_nowhere(writer);
    EXPECT_NE(testing::internal::GetCapturedStderr(), "") << "what VTK does otherwise";
}

// Our message names the file; VTK told of its own pipeline.
TEST(VtkErrors, OfATreeOnAFullDiskAreSaidInOurWordsAlone) {
    const auto file = std::filesystem::path(testing::TempDir()) / "hepatica_full_disk.vtp";
    testing::internal::CaptureStderr();
    std::string problem;
    try {
        const test::DiskOf full(1000);
        write_tree_vtp(file, test::forked_tree());
    } catch (const InputError& error) {
        problem = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(problem.find(file.string()), std::string::npos) << problem;
}

}  // namespace
}  // namespace hepatica
