// SPDX-License-Identifier: GPL-3.0-or-later
// Written by VTK, read by the parser of core/tree/files/vtk_file.h.
#include "core/mesh/mesh_io.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/mesh/surface.h"
#include "core/tree/files/vtk_errors.h"
#include "core/tree/files/vtk_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

vtkNew<vtkPoints> points_of(const std::vector<Vec3>& positions) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
    for (std::size_t v = 0; v < positions.size(); ++v)
        points->SetPoint(static_cast<vtkIdType>(v), positions[v].data());
    return points;
}

template <std::size_t N>
vtkNew<vtkCellArray> cells_of(const std::vector<std::array<int, N>>& cells) {
    vtkNew<vtkCellArray> array;
    array->AllocateExact(static_cast<vtkIdType>(cells.size()),
                         static_cast<vtkIdType>(N) * static_cast<vtkIdType>(cells.size()));
    for (const auto& cell : cells) {
        array->InsertNextCell(static_cast<int>(N));
        for (const int vertex : cell) array->InsertCellPoint(vertex);
    }
    return array;
}

template <class Writer, class Data>
void write(const fs::path& file, Data* data) {
    write_file_atomically(file, [&](const fs::path& temporary) {
        vtkNew<Writer> writer;
        VtkErrors errors(writer);
        writer->SetFileName(temporary.c_str());
        writer->SetInputData(data);
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        const bool written = writer->Write() != 0;
        if (!written || errors.any() || writer->GetErrorCode() != 0 || !fs::exists(temporary))
            throw InputError("cannot be written", file.string(),
                             "Check that the folder may be written and has free space");
    });
}

[[noreturn]] void reject(const fs::path& file, const std::string& problem) {
    throw InputError(problem, file.string(), "Reconstruct the patient again");
}

VtkFile opened(const fs::path& file, std::string_view type) {
    if (!fs::is_regular_file(file)) reject(file, "is missing");
    return VtkFile(file, type);
}

std::vector<Vec3> positions_of(const VtkFile& data, const fs::path& file) {
    std::vector<Vec3> positions = data.points();
    for (const Vec3& position : positions)
        require_in_patient_space(position, "a vertex", file.string());
    return positions;
}

template <std::size_t N>
std::vector<std::array<int, N>> corners_of(const VtkCells& from, const fs::path& file) {
    std::vector<std::array<int, N>> cells(from.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (from[c].size() != N) reject(file, "holds cells of another kind");
        std::ranges::copy(from[c], cells[c].begin());
    }
    return cells;
}

// Adds the file to the place of an error that check() throws.
template <class Check>
void check_content(const fs::path& file, const Check& check) {
    try {
        check();
    } catch (const InputError& error) {
        throw InputError(error.problem(), file.string() + ", " + error.place(), error.remedy());
    }
}

}  // namespace

void write_vtu(const fs::path& file, const TetMesh& mesh) {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points_of(mesh.vertices_mm));
    grid->SetCells(VTK_TETRA, cells_of(mesh.tetrahedra));
    write<vtkXMLUnstructuredGridWriter>(file, grid.Get());
}

void write_vtp(const fs::path& file, const TriangleMesh& surface) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_of(surface.vertices_mm));
    data->SetPolys(cells_of(surface.triangles));
    write<vtkXMLPolyDataWriter>(file, data.Get());
}

TetMesh read_vtu(const fs::path& file) {
    const VtkFile data = opened(file, "UnstructuredGrid");
    TetMesh mesh;
    mesh.vertices_mm = positions_of(data, file);
    mesh.tetrahedra = corners_of<4>(data.cells("Cells"), file);
    if (std::ranges::any_of(data.cell_types(),
                            [](double type) { return type != double{VTK_TETRA}; }))
        reject(file, "holds cells of another kind");
    check_content(file, [&] { validate(mesh); });
    return mesh;
}

TriangleMesh read_vtp(const fs::path& file) {
    const VtkFile data = opened(file, "PolyData");
    TriangleMesh surface;
    surface.vertices_mm = positions_of(data, file);
    surface.triangles = corners_of<3>(data.cells("Polys"), file);
    check_content(file, [&] { validate_closed(surface); });
    return surface;
}

}  // namespace hepatica
