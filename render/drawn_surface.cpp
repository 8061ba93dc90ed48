// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/drawn_surface.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "render/actor_settings.h"
#include "render/drug_overlay.h"

namespace hepatica {

DrawnSurface::DrawnSurface()
    : polydata_(vtkSmartPointer<vtkPolyData>::New()),
      positions_(vtkSmartPointer<vtkFloatArray>::New()),
      normals_(vtkSmartPointer<vtkFloatArray>::New()),
      arrival_(vtkSmartPointer<vtkFloatArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      mapper_(vtkSmartPointer<vtkOpenGLPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()),
      halo_(*polydata_) {
    positions_->SetNumberOfComponents(3);
    normals_->SetNumberOfComponents(3);
    normals_->SetName("normals");
    arrival_->SetName(drug_overlay::arrival_array);
    colours_->SetNumberOfComponents(4);
    colours_->SetName("colours");
    vtkNew<vtkPoints> points;
    points->SetData(positions_);
    polydata_->SetPoints(points);
    polydata_->GetPointData()->SetNormals(normals_);
    polydata_->GetPointData()->SetScalars(colours_);
    polydata_->GetPointData()->AddArray(arrival_);
    mapper_->SetInputData(polydata_);
    mapper_->SetColorModeToDirectScalars();
    // By default VTK shifts and scales positions for precision, which costs a pass over them.
    // Without it, floats of a patient's size in mm are still precise to 0.03 micrometres.
    mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    actor_->SetMapper(mapper_);
    vtkProperty& look = *actor_->GetProperty();
    look.SetAmbient(0.18);
    look.SetDiffuse(0.85);
    look.SetSpecular(0.22);
    look.SetSpecularPower(28.0);
    look.BackfaceCullingOn();
    drug_overlay::attach(*actor_, *mapper_);
}

void DrawnSurface::set_clip(vtkPlane* plane) {
    clip_by(plane, *mapper_, *actor_);
    halo_.set_clip(plane);
}

vtkActor* DrawnSurface::actor() const {
    return actor_;
}

vtkOpenGLPolyDataMapper* DrawnSurface::mapper() const {
    return mapper_;
}

void DrawnSurface::set_triangles(std::span<const std::array<int, 3>> triangles,
                                 std::size_t vertex_count) {
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(static_cast<vtkIdType>(triangles.size()),
                         static_cast<vtkIdType>(3 * triangles.size()));
    for (const auto& [a, b, c] : triangles) cells->InsertNextCell({a, b, c});
    polydata_->SetPolys(cells);
    const auto count = static_cast<vtkIdType>(vertex_count);
    positions_->SetNumberOfTuples(count);
    normals_->SetNumberOfTuples(count);
    arrival_->SetNumberOfTuples(count);
    colours_->SetNumberOfTuples(count);
}

void DrawnSurface::set_positions(std::span<const float> positions_mm,
                                 std::span<const float> normals) {
    std::ranges::copy(positions_mm, positions_->GetPointer(0));
    std::ranges::copy(normals, normals_->GetPointer(0));
    positions_->Modified();
    normals_->Modified();
    polydata_->GetPoints()->Modified();
    polydata_->Modified();
}

void DrawnSurface::set_colours(std::span<const std::uint8_t> rgba) {
    std::ranges::copy(rgba, colours_->GetPointer(0));
    colours_->Modified();
}

void DrawnSurface::set_arrival(std::span<const float> arrival_s) {
    std::ranges::copy(arrival_s, arrival_->GetPointer(0));
    arrival_->Modified();
}

}  // namespace hepatica
