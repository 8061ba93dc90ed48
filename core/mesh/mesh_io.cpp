// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_io.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <string>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/mesh/surface.h"
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

// VTK prints its errors unless somebody listens; here they become the exception's.
vtkSmartPointer<vtkCallbackCommand> error_listener(bool& failed) {
    auto listener = vtkSmartPointer<vtkCallbackCommand>::New();
    listener->SetClientData(&failed);
    listener->SetCallback(
        [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
    return listener;
}

template <class Writer, class Data>
void write(const fs::path& file, Data* data) {
    write_file_atomically(file, [&](const fs::path& temporary) {
        vtkNew<Writer> writer;
        bool failed = false;
        const auto listener = error_listener(failed);
        const unsigned long tag = writer->AddObserver(vtkCommand::ErrorEvent, listener);
        writer->SetFileName(temporary.c_str());
        writer->SetInputData(data);
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        const bool written = writer->Write() != 0;
        writer->RemoveObserver(tag);
        if (!written || failed || writer->GetErrorCode() != 0 || !fs::exists(temporary))
            throw InputError("cannot be written", file.string(),
                             "Check that the folder may be written and has free space");
    });
}

[[noreturn]] void reject(const fs::path& file, const std::string& problem) {
    throw InputError(problem, file.string(), "Reconstruct the patient again");
}

template <class Reader>
vtkSmartPointer<Reader> read(const fs::path& file) {
    if (!fs::is_regular_file(file)) reject(file, "is missing");
    check_vtk_xml(file);
    auto reader = vtkSmartPointer<Reader>::New();
    bool failed = false;
    const auto listener = error_listener(failed);
    const unsigned long tag = reader->AddObserver(vtkCommand::ErrorEvent, listener);
    if (reader->CanReadFile(file.c_str()) == 0) reject(file, "is not a file of this kind");
    reader->SetFileName(file.c_str());
    reader->Update();
    reader->RemoveObserver(tag);
    if (failed || reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
        reject(file, "is damaged");
    return reader;
}

std::vector<Vec3> positions_of(vtkPoints* points, const fs::path& file) {
    std::vector<Vec3> positions(static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (std::size_t v = 0; v < positions.size(); ++v) {
        points->GetPoint(static_cast<vtkIdType>(v), positions[v].data());
        require_in_patient_space(positions[v], "a vertex", file.string());
    }
    return positions;
}

template <std::size_t N>
std::vector<std::array<int, N>> corners_of(vtkCellArray* array, vtkIdType points,
                                           const fs::path& file) {
    check_vtk_cells(array, points, file);
    std::vector<std::array<int, N>> cells;
    cells.reserve(static_cast<std::size_t>(array->GetNumberOfCells()));
    vtkIdType count = 0;
    const vtkIdType* vertices = nullptr;
    for (vtkIdType i = 0; i < array->GetNumberOfCells(); ++i) {
        array->GetCellAtId(i, count, vertices);
        if (count != static_cast<vtkIdType>(N)) reject(file, "holds cells of another kind");
        std::array<int, N> cell{};
        for (std::size_t k = 0; k < N; ++k) cell[k] = static_cast<int>(vertices[k]);
        cells.push_back(cell);
    }
    return cells;
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
    const auto reader = read<vtkXMLUnstructuredGridReader>(file);
    TetMesh mesh;
    mesh.vertices_mm = positions_of(reader->GetOutput()->GetPoints(), file);
    mesh.tetrahedra = corners_of<4>(reader->GetOutput()->GetCells(),
                                    reader->GetOutput()->GetNumberOfPoints(), file);
    validate(mesh);
    return mesh;
}

TriangleMesh read_vtp(const fs::path& file) {
    const auto reader = read<vtkXMLPolyDataReader>(file);
    TriangleMesh surface;
    surface.vertices_mm = positions_of(reader->GetOutput()->GetPoints(), file);
    surface.triangles = corners_of<3>(reader->GetOutput()->GetPolys(),
                                      reader->GetOutput()->GetNumberOfPoints(), file);
    validate_closed(surface);
    return surface;
}

}  // namespace hepatica
