// SPDX-License-Identifier: GPL-3.0-or-later
// Files of VTK that say something of themselves which is not so: VTK's reader ended the program, or
// read or wrote beyond its memory.
#include "core/tree/files/vtk_file.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "core/base/error.h"
#include "core/tree/files/tree_io.h"

namespace hepatica {
namespace {

const std::string plain =
    R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><FieldData>)"
    R"(<Array type="String" Name="SPACE" NumberOfTuples="1" format="ascii">76 80 83 0</Array>)"
    R"(</FieldData><Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="1" )"
    R"(NumberOfStrips="0" NumberOfPolys="0"><PointData>)"
    R"(<DataArray type="Float64" Name="Radius" format="ascii">2 2 2</DataArray></PointData>)"
    R"(<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">)"
    R"(0 0 0 0 0 10 0 1 20</DataArray></Points><Lines>)"
    R"(<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>)"
    R"(<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray>)"
    R"(</Lines></Piece></PolyData></VTKFile>)";

std::filesystem::path file_with(const std::string& from, const std::string& to) {
    std::string text = plain;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const auto file = std::filesystem::path(testing::TempDir()) / "vtk_file_test.vtp";
    std::ofstream(file) << text;
    return file;
}

TEST(VtkFile, IsReadWhereAllItSaysIsSo) {
    EXPECT_EQ(read_tree_vtp(file_with("2 2 2", "2 2 3")).segments.size(), 1U);
}

TEST(VtkFile, IsRefusedByWhatItSaysOfItself) {
    for (const auto& [from, to, problem] : std::initializer_list<std::array<const char*, 3>>{
             {R"(Array type="String")", R"(Array kind="String")", "no known type"},
             {R"(Array type="String")", R"(Array type="Strings")", "no known type"},
             {R"(NumberOfTuples="1" format)", R"(NumberOfTuples="1" NumberOfComponents="3" format)",
              "NumberOfComponents of \"3\""},
             {">76 80 83 0<", ">76 0 83 0<", "more texts"},
             {R"(NumberOfComponents="3")", R"(NumberOfComponents="2")", "three coordinates"},
             {R"(NumberOfComponents="3")", "", "three coordinates"},
             {R"(NumberOfPoints="3")", R"(NumberOfPoints="99999999999")", "NumberOfPoints"},
             {R"(NumberOfLines="1")", R"(NumberOfLines="-1")", "NumberOfLines"},
             {R"(NumberOfLines="1")", R"(NumberOfLines="1e0")", "NumberOfLines"},
             {R"(format="ascii">76)", R"(format="plain">76)", "no known format"},
             {R"(format="ascii">76)", R"(>76)", "no known format"},
             {"</VTKFile>", "", "damaged"}}) {
        const auto file = file_with(from, to);
        try {
            check_vtk_xml(file);
            FAIL() << to;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), file.string());
            EXPECT_NE(error.problem().find(problem), std::string::npos) << error.problem();
        }
        EXPECT_THROW(read_tree_vtp(file), InputError) << to;
    }
}

TEST(VtkFile, IsRefusedWhereALineNamesWhatIsNotThere) {
    for (const auto& [from, to, problem] : std::initializer_list<std::array<const char*, 3>>{
             {">0 1 2<", ">0 1 3<", "names point 3 of 3"},
             {">0 1 2<", ">0 -1 2<", "names point -1 of 3"},
             {">3</DataArray></Lines", ">4</DataArray></Lines", ""},
             {">3</DataArray></Lines", ">-3</DataArray></Lines", ""}}) {
        try {
            read_tree_vtp(file_with(from, to));
            FAIL() << to;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find(problem), std::string::npos) << error.problem();
        }
    }
}

}  // namespace
}  // namespace hepatica
