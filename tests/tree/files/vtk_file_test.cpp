// SPDX-License-Identifier: GPL-3.0-or-later
// Files of VTK that say something of themselves which is not so: VTK's own readers ended the
// program, or read or wrote beyond their memory.
#include "core/tree/files/vtk_file.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/base64.h"
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

// A tree of this program: with the numbers of its one segment, and other radii at its nodes.
std::filesystem::path own_file_with(const std::string& cell_data) {
    const std::string piece =
        R"(</FieldData><Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="1" )"
        R"(NumberOfStrips="0" NumberOfPolys="0">)";
    std::string numbers;
    for (const auto& [name, value] : {std::pair{"SegmentId", "0"},
                                      {"ParentId", "-1"},
                                      {"System", "1"},
                                      {"StrahlerOrder", "1"},
                                      {"ClosesLoop", "0"},
                                      {"ProximalNode", "0"},
                                      {"DistalNode", "1"}})
        numbers += std::string(R"(<DataArray type="Int32" Name=")") + name +
                   R"(" format="ascii">)" + value + "</DataArray>";
    return file_with(piece, R"(<DataArray type="Float64" Name="NodeRadius" NumberOfTuples="2" )"
                            R"(format="ascii">5 6</DataArray>)" +
                                piece + "<CellData>" + cell_data + numbers + "</CellData>");
}

// Of two arrays of one name the first is found, and its texts are no numbers: the file is read like
// one of another program, by the radii of its points.
TEST(VtkFile, IsNotTakenForItsOwnWhereTextsHideItsNumbers) {
    EXPECT_EQ(read_tree_vtp(own_file_with("")).nodes[0].radius_mm, 5.0);
    for (const char* name : {"SegmentId", "System", "DistalNode"}) {
        const std::string text = std::string(R"(<Array type="String" Name=")") + name +
                                 R"(" format="ascii">48 0</Array>)";
        EXPECT_EQ(read_tree_vtp(own_file_with(text)).nodes[0].radius_mm, 2.0) << name;
    }
}

// Edits draw vessels by the radii of nodes.
TEST(VtkFile, OfItsOwnIsRefusedWhereANodeHasNoRadius) {
    for (const char* radius : {"nan", "-5", "inf"}) {
        const std::filesystem::path file = own_file_with("");
        std::ifstream in(file);
        std::string text(std::istreambuf_iterator<char>(in), {});
        text.replace(text.find(">5 6<"), 5, std::string(">") + radius + " 6<");
        std::ofstream(file) << text;
        try {
            read_tree_vtp(file);
            ADD_FAILURE() << radius;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find("a node of radius"), std::string::npos)
                << error.problem();
        }
    }
}

TEST(VtkFile, IsRefusedByWhatItSaysOfItself) {
    for (const auto& [from, to, problem] : std::initializer_list<std::array<const char*, 3>>{
             {R"(Array type="String")", R"(Array kind="String")", "no known type"},
             {R"(Array type="String")", R"(Array type="Strings")", "no known type"},
             {R"(NumberOfTuples="1" format)", R"(NumberOfTuples="1" NumberOfComponents="3" format)",
              "NumberOfComponents of \"3\""},
             {">76 80 83 0<", ">76 0 83 0<", "2 texts instead of 1"},
             {R"(NumberOfComponents="3")", R"(NumberOfComponents="2")", "three coordinates"},
             {R"(NumberOfComponents="3")", "", "three coordinates"},
             {R"(NumberOfPoints="3")", R"(NumberOfPoints="99999999999")", "NumberOfPoints"},
             {R"(NumberOfLines="1")", R"(NumberOfLines="-1")", "NumberOfLines"},
             {R"(NumberOfLines="1")", R"(NumberOfLines="1e0")", "NumberOfLines"},
             {R"(format="ascii">76)", R"(format="plain">76)", "no known format"},
             {R"(format="ascii">76)", R"(>76)", "no known format"},
             {">2 2 2<", ">2 2<", "\"Radius\" has 2 numbers instead of 3"},
             {">2 2 2<", ">2 two 2<", "\"Radius\" has \"two\" in place of a number"},
             {R"(format="ascii">2 2 2)", R"(format="appended" offset="9">)", "an offset of \"9\""},
             {R"(byte_order)", R"(compressor="vtkLZMADataCompressor" byte_order)", "LZMA"},
             {R"(type="PolyData")", R"(type="ImageData")", "type \"ImageData\""},
             {"</PolyData>", R"(<Piece NumberOfPoints="1"></Piece></PolyData>)", "several pieces"},
             {R"(NumberOfPoints="3")", R"(NumberOfPoints="0")", "no points"},
             {R"(Name="offsets")", R"(Name="ends")", "which points its Lines have"},
             {"</VTKFile>", "", "damaged"}}) {
        const auto file = file_with(from, to);
        try {
            read_tree_vtp(file);
            FAIL() << to;
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), file.string());
            EXPECT_NE(error.problem().find(problem), std::string::npos) << error.problem();
        }
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

// Radii in compressed blocks: how many blocks, their size, the size of the last one where it is
// smaller, and what each takes; then the blocks.
std::filesystem::path file_with_blocks(const std::vector<std::uint64_t>& header,
                                       const std::string& blocks) {
    const std::string_view bytes(reinterpret_cast<const char*>(header.data()), 8 * header.size());
    const auto file = file_with(R"(format="ascii">2 2 2)",
                                R"(format="binary">)" + to_base64(bytes) + to_base64(blocks));
    std::ifstream in(file);
    std::string text(std::istreambuf_iterator<char>(in), {});
    text.insert(text.find(" byte_order"),
                R"( header_type="UInt64" compressor="vtkZLibDataCompressor")");
    std::ofstream(file) << text;
    return file;
}

std::string deflated(const std::vector<double>& values) {
    vtkNew<vtkZLibDataCompressor> zlib;
    const auto bytes = vtk::TakeSmartPointer(zlib->Compress(
        reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(double)));
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

// Three radii are 24 bytes. VTK wrote the whole of a last block that was said to be larger than the
// others into what was left of them.
TEST(VtkFile, IsRefusedWhereItsBlocksAreNotTheArray) {
    const std::string one = deflated({2.0}), two = deflated({2.0, 2.0}), no = deflated({});
    const std::string many = deflated(std::vector<double>(1'000'000, 2.0));
    const std::size_t a = one.size(), b = two.size(), m = many.size(), huge = std::size_t{1} << 63;
    EXPECT_EQ(read_tree_vtp(file_with_blocks({2, 16, 8, b, a}, two + one)).segments.size(), 1U);
    EXPECT_EQ(read_tree_vtp(file_with_blocks({3, 8, 0, a, a, a}, one + one + one)).segments.size(),
              1U);
    for (const auto& [header, blocks, problem] :
         std::initializer_list<std::tuple<std::vector<std::uint64_t>, std::string, const char*>>{
             {{2, 8, 8'000'000, a, m}, one + many, "a last block of 8000000 bytes"},
             {{1, 8'000'000, 0, m}, many, "8000000 bytes instead of 24"},
             {{2, 16, 0, b, b}, two + two, "32 bytes instead of 24"},
             {{1, 16, 0, b}, two, "16 bytes instead of 24"},
             {{3, 8, 0, a, a, b}, one + one + two, "a damaged block"},
             {{1, 24, 0, a}, one, "a damaged block"},
             {{1, 24, 0, huge}, one, "bytes where"},
             {{1, 24, 0, 4, huge}, one, "a damaged block"},
             {{3, 8, 0, huge, huge, a}, one, "in 9223372036854775808"},
             {{1, huge, 0, a}, one, "a block of 9223372036854775808 bytes"},
             {{huge, 24, 0, a}, one, "9223372036854775808 blocks"},
             {{1'000'000, 24, 0, a}, one, "states 8000024 bytes"},
             {{2, 8, 0, a, 0}, one, "a block of 8 bytes in 0"},
             {{0, 0, 0}, no, "0 bytes instead of 24"}}) {
        try {
            read_tree_vtp(file_with_blocks(header, blocks));
            FAIL() << problem;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find(problem), std::string::npos)
                << error.problem() << " instead of " << problem;
        }
    }
}

// Taken down by calls of itself, one for each level, a million of them ended the program.
TEST(VtkFile, IsRefusedWhereItsElementsAreNestedWithoutEnd) {
    std::string deep;
    for (int i = 0; i < 1'000'000; ++i) deep += "<a>";
    for (int i = 0; i < 1'000'000; ++i) deep += "</a>";
    EXPECT_THROW(read_tree_vtp(file_with("<PolyData>", deep + "<PolyData>")), InputError);
}

void expect_arrays_of(const VtkFile& file, vtkPolyData* lines) {
    const std::vector<Vec3> points = file.points();
    ASSERT_EQ(std::ssize(points), lines->GetNumberOfPoints());
    const auto radii = file.numbers("PointData", "Radius");
    ASSERT_TRUE(radii);
    for (vtkIdType p = 0; p < std::ssize(points); ++p) {
        EXPECT_EQ(points[p], Vec3(lines->GetPoint(p)));
        EXPECT_EQ((*radii)[p], lines->GetPointData()->GetArray("Radius")->GetComponent(p, 0));
    }
    const VtkCells cells = file.cells("Lines");
    ASSERT_EQ(std::ssize(cells.ends), lines->GetNumberOfLines());
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line) {
        lines->GetCellPoints(line, ids);
        EXPECT_TRUE(std::ranges::equal(cells[line], *ids));
    }
    const auto names = file.texts("FieldData", "Names");
    ASSERT_TRUE(names);
    EXPECT_EQ(*names, (std::vector<std::string>{"LPS", "", "Pfortader, linker Ast"}));
}

// As VTK itself writes and reads them, in each of its ways.
TEST(VtkFile, HasTheArraysThatVtkWrote) {
    vtkNew<vtkPolyData> lines;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> radii;
    radii->SetName("Radius");
    vtkNew<vtkCellArray> cells;
    for (int line = 0; line < 40; ++line) {
        cells->InsertNextCell(25);
        for (int i = 0; i < 25; ++i) {
            cells->InsertCellPoint(points->InsertNextPoint(0.1 * line, 0.3 * i, i * i));
            radii->InsertNextValue(1.0F + 0.1F * static_cast<float>(line));
        }
    }
    lines->SetPoints(points);
    lines->SetLines(cells);
    lines->GetPointData()->AddArray(radii);
    vtkNew<vtkStringArray> names;
    names->SetName("Names");
    for (const char* name : {"LPS", "", "Pfortader, linker Ast"}) names->InsertNextValue(name);
    lines->GetFieldData()->AddArray(names);
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
        for (const bool base64 : {false, true})
            for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4})
                for (const bool wide : {false, true})
                    for (const bool big_endian : {false, true}) {
                        const auto file =
                            std::filesystem::path(testing::TempDir()) / "vtk_file_modes.vtp";
                        vtkNew<vtkXMLPolyDataWriter> writer;
                        writer->SetFileName(file.c_str());
                        writer->SetInputData(lines);
                        writer->SetDataMode(mode);
                        writer->SetEncodeAppendedData(base64);
                        writer->SetCompressorType(compressor);
                        writer->SetBlockSize(1024);
                        if (wide)
                            writer->SetHeaderTypeToUInt64();
                        else
                            writer->SetHeaderTypeToUInt32();
                        if (big_endian) writer->SetByteOrderToBigEndian();
                        ASSERT_NE(writer->Write(), 0);
                        expect_arrays_of(VtkFile(file, "PolyData"), lines);
                    }
}

}  // namespace
}  // namespace hepatica
