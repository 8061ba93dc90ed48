// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file in VTK's XML formats (VTP, VTU) as plain arrays: text, base64 or raw, inline or
// appended, either byte order, uncompressed or compressed with zlib or LZ4. VTK's own readers trust
// the sizes and counts in a file and write beyond their memory; here each is checked against the
// bytes available, and only requested arrays are read.
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
    std::vector<std::size_t> ends;  // index in `points` one past each cell

    std::size_t size() const { return ends.size(); }
    std::span<const int> operator[](std::size_t cell) const {
        const std::size_t begin = cell == 0 ? 0 : ends[cell - 1];
        return std::span(points).subspan(begin, ends[cell] - begin);
    }
};

// All functions throw InputError that names the file, the array and the value that is wrong.
class VtkFile {
  public:
    // Reads the file into memory; arrays are decoded on request. `type` is the file's required
    // type: "PolyData" or "UnstructuredGrid". Throws where several pieces hold points.
    VtkFile(const std::filesystem::path& file, std::string_view type);

    std::size_t point_count() const;
    std::vector<Vec3> points() const;

    // kind: "Verts", "Lines", "Strips", "Polys" or "Cells". All point numbers are valid.
    std::size_t cell_count(const char* kind) const;
    VtkCells cells(const char* kind) const;
    // VTK's type number of each of "Cells".
    std::vector<double> cell_types() const;

    // `data` is "PointData", "CellData" or "FieldData". An array of points or cells has one value
    // for each; cells are numbered kind by kind in the order above.
    // The arrays that numbers() returns.
    std::vector<std::string> names_of_numbers(const char* data) const;
    bool has(const char* data, std::string_view name) const;
    // None where the first array of that name does not have one number, or one text, per tuple.
    std::optional<std::vector<double>> numbers(const char* data, std::string_view name) const;
    std::optional<std::vector<std::string>> texts(const char* data, std::string_view name) const;

  private:
    vtkXMLDataElement* part(const char* data) const;
    vtkXMLDataElement* array(const char* data, std::string_view name) const;
    std::optional<std::size_t> tuples(const char* data, vtkXMLDataElement* array) const;

    VtkDocument document_;
    vtkXMLDataElement* whole_ = nullptr;  // the element named after the type
    vtkXMLDataElement* piece_ = nullptr;  // the piece with points
};

}  // namespace hepatica
