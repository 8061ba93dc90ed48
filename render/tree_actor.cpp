// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tree_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/drug_overlay.h"
#include "render/palette.h"

namespace hepatica {

TreeActor::TreeActor()
    : polydata_(vtkSmartPointer<vtkPolyData>::New()),
      positions_(vtkSmartPointer<vtkFloatArray>::New()),
      normals_(vtkSmartPointer<vtkFloatArray>::New()),
      arrival_(vtkSmartPointer<vtkFloatArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      mapper_(vtkSmartPointer<vtkOpenGLPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
    positions_->SetNumberOfComponents(3);
    normals_->SetNumberOfComponents(3);
    normals_->SetName("normals");
    arrival_->SetName(drug_overlay::arrival_array);
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colours");
    vtkNew<vtkPoints> points;
    points->SetData(positions_);
    polydata_->SetPoints(points);
    polydata_->GetPointData()->SetNormals(normals_);
    polydata_->GetPointData()->SetScalars(colours_);
    polydata_->GetPointData()->AddArray(arrival_);
    mapper_->SetInputData(polydata_);
    mapper_->SetColorModeToDirectScalars();
    // VTK would shift and scale positions for precision, at the cost of a pass over them; floats of
    // a patient's size in mm are precise to 0.03 micrometres without it.
    mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->SetAmbient(0.18);
    actor_->GetProperty()->SetDiffuse(0.85);
    actor_->GetProperty()->SetSpecular(0.22);
    actor_->GetProperty()->SetSpecularPower(28.0);
    drug_overlay::attach(*actor_, *mapper_);
}

bool TreeActor::update(const Frame& frame) {
    const SurfaceGeometry::Change change = surface_.update(frame);
    const bool rebuilt = change == SurfaceGeometry::Change::topology;
    if (rebuilt) {
        upload_topology();
        upload_colours();
    }
    if (change != SurfaceGeometry::Change::none) upload_positions();
    const bool new_drug =
        frame.drug.version != drug_version_ || frame.drug.arrival_s.get() != drug_source_;
    if (rebuilt || new_drug) upload_arrival(frame.drug);
    const bool drug_moved = frame.drug.time_s != drug_time_s_;
    drug_time_s_ = frame.drug.time_s;
    drug_overlay::set_time(*actor_, frame.drug);
    actor_->SetVisibility(!surface_.triangles().empty());
    return change != SurfaceGeometry::Change::none || new_drug || drug_moved;
}

void TreeActor::set_vertex_systems(std::vector<VascularSystem> systems) {
    systems_ = std::move(systems);
    upload_colours();
}

void TreeActor::set_highlight(std::vector<std::uint8_t> highlight) {
    if (highlight == highlight_) return;
    highlight_ = std::move(highlight);
    upload_colours();
}

void TreeActor::set_fade(double near_mm, double far_mm) {
    drug_overlay::set_fade(*actor_, near_mm, far_mm);
}

void TreeActor::upload_topology() {
    rounded_.set_topology(surface_.triangles(), surface_.frame_vertices().size());
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(static_cast<vtkIdType>(rounded_.triangles().size()),
                         static_cast<vtkIdType>(3 * rounded_.triangles().size()));
    for (const auto& [a, b, c] : rounded_.triangles()) cells->InsertNextCell({a, b, c});
    polydata_->SetPolys(cells);
    const auto count = static_cast<vtkIdType>(rounded_.vertex_count());
    positions_->SetNumberOfTuples(count);
    normals_->SetNumberOfTuples(count);
    arrival_->SetNumberOfTuples(count);
    colours_->SetNumberOfTuples(count);
}

void TreeActor::upload_positions() {
    rounded_.update(surface_);
    std::copy(rounded_.positions_mm().begin(), rounded_.positions_mm().end(),
              positions_->GetPointer(0));
    std::copy(rounded_.normals().begin(), rounded_.normals().end(), normals_->GetPointer(0));
    positions_->Modified();
    normals_->Modified();
    polydata_->GetPoints()->Modified();
    polydata_->Modified();
}

void TreeActor::upload_colours() {
    unsigned char* const colours = colours_->GetPointer(0);
    unsigned char* out = colours;
    for (const int vertex : surface_.frame_vertices()) {
        const auto v = static_cast<std::size_t>(vertex);
        const bool lit = v < highlight_.size() && highlight_[v] != 0;
        const VascularSystem system = v < systems_.size() ? systems_[v] : VascularSystem::unknown;
        for (double channel : palette::vessel_system(system)) {
            if (lit) channel = 0.45 * channel + 0.55;
            *out++ = static_cast<unsigned char>(std::lround(255.0 * channel));
        }
    }
    for (const auto& [a, b] : rounded_.edges()) {
        for (int c = 0; c < 3; ++c) {
            *out++ = static_cast<unsigned char>((colours[3 * a + c] + colours[3 * b + c]) / 2);
        }
    }
    colours_->Modified();
}

void TreeActor::upload_arrival(const DrugView& drug) {
    drug_version_ = drug.version;
    drug_source_ = drug.arrival_s.get();
    float* const arrivals = arrival_->GetPointer(0);
    float* out = arrivals;
    for (const int vertex : surface_.frame_vertices()) {
        const auto v = static_cast<std::size_t>(vertex);
        const bool known = drug.arrival_s && v < drug.arrival_s->size();
        const float arrival = known ? (*drug.arrival_s)[v] : drug_overlay::never_s;
        *out++ = std::isfinite(arrival) ? arrival : drug_overlay::never_s;
    }
    for (const auto& [a, b] : rounded_.edges()) *out++ = 0.5f * (arrivals[a] + arrivals[b]);
    arrival_->Modified();
}

}  // namespace hepatica
