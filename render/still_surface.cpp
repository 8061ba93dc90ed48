// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/still_surface.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "render/surface_geometry.h"

namespace hepatica {

vtkSmartPointer<vtkPolyData> still_surface(const TriangleMesh& surface) {
    Frame frame;
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(surface.triangles);
    frame.positions_mm.reserve(3 * surface.vertices_mm.size());
    for (const Vec3& vertex : surface.vertices_mm) {
        for (int axis = 0; axis < 3; ++axis) {
            frame.positions_mm.push_back(static_cast<float>(vertex[axis]));
        }
    }
    SurfaceGeometry geometry;
    geometry.update(frame);

    vtkNew<vtkFloatArray> positions;
    vtkNew<vtkFloatArray> normals;
    vtkNew<vtkCellArray> cells;
    for (vtkFloatArray* array : {positions.Get(), normals.Get()}) array->SetNumberOfComponents(3);
    for (const float value : geometry.positions_mm()) positions->InsertNextValue(value);
    for (const float value : geometry.normals()) normals->InsertNextValue(value);
    for (const auto& [a, b, c] : geometry.triangles()) cells->InsertNextCell({a, b, c});
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    auto polydata = vtkSmartPointer<vtkPolyData>::New();
    polydata->SetPoints(points);
    polydata->SetPolys(cells);
    polydata->GetPointData()->SetNormals(normals);
    return polydata;
}

}  // namespace hepatica
