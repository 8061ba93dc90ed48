// SPDX-License-Identifier: GPL-3.0-or-later
// A file of VTK's XML formats (VTP, VTU) as plain arrays: text, base64 or raw, inline or appended,
// of either byte order, uncompressed or compressed by zlib or LZ4. VTK's own readers take the sizes
// and counts that a file states at their word and write beyond their memory; here each is held
// against the bytes that are there, and only arrays that somebody asks for are read.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vector.h"
#include "core/tree/files/vtk_document.h"

namespace hepatica {

// Each cell as the numbers of its points.
struct VtkCells {
    std::vector<int> points;
    std::vector<std::size_t> ends;  // in points, of each cell

    std::size_t size() const { return ends.size(); }
    std::span<const int> operator[](std::size_t cell) const {
        const std::size_t begin = cell == 0 ? 0 : ends[cell - 1];
        return std::span(points).subspan(begin, ends[cell] - begin);
    }
};

// All functions throw InputError that names the file, the array and the value that is wrong.
class VtkFile {
  public:
    // Reads the file into memory; its arrays stay as they are until asked for. `type` is that of
    // the file: "PolyData" or "UnstructuredGrid".
    VtkFile(const std::filesystem::path& file, std::string_view type);

    std::size_t point_count() const;
    std::vector<Vec3> points() const;

    // kind: "Verts", "Lines", "Strips", "Polys" or "Cells". Every number is that of a point.
    std::size_t cell_count(const char* kind) const;
    VtkCells cells(const char* kind) const;
    // VTK's number for the kind of each of "Cells".
    std::vector<double> cell_types() const;

    // Of "PointData", "CellData" and "FieldData". An array of points or cells has a value for each
    // of them; cells are numbered kind by kind in the order above.
    std::vector<std::string> names_of_numbers(const char* data) const;  // one number per tuple
    bool has(const char* data, std::string_view name) const;
    // None where there is no such array of one number, or of texts, per tuple.
    std::optional<std::vector<double>> numbers(const char* data, std::string_view name) const;
    std::optional<std::vector<std::string>> texts(const char* data, std::string_view name) const;

  private:
    vtkXMLDataElement* part(const char* data) const;
    vtkXMLDataElement* array(const char* data, std::string_view name) const;
    std::optional<std::size_t> tuples(const char* data, vtkXMLDataElement* array) const;

    VtkDocument document_;
    vtkXMLDataElement* whole_ = nullptr;  // the element called by the type
    vtkXMLDataElement* piece_ = nullptr;  // the one with the points
};

}  // namespace hepatica
