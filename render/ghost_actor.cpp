// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ghost_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>

#include "render/surface_geometry.h"

namespace hepatica {
namespace {

// Opacity rises towards the silhouette: the outline shows the shape, and the vessels inside stay
// visible.
std::string shader_of(const GhostLook& look) {
    std::ostringstream code;
    code.imbue(std::locale::classic());
    code << std::fixed << R"(//VTK::Light::Impl
  {
    float facing = abs(dot(normalVCVSOutput, normalize(-vertexVC.xyz)));
    gl_FragData[0] = vec4(diffuseColor, )"
         << look.facing << " + " << look.rim << R"( * pow(1.0 - facing, 2.5));
  }
)";
    return code.str();
}

}  // namespace

GhostActor::GhostActor(const GhostLook& ghost)
    : mapper_(vtkSmartPointer<vtkOpenGLPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
    actor_->SetMapper(mapper_);
    vtkProperty& look = *actor_->GetProperty();
    look.SetColor(ghost.colour[0], ghost.colour[1], ghost.colour[2]);
    look.SetOpacity(0.5);  // below 1, so that VTK draws it in the pass for translucent surfaces
    look.BackfaceCullingOn();
    actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                              shader_of(ghost), false);
    actor_->SetVisibility(false);
}

void GhostActor::set_surface(const TriangleMesh& surface) {
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
    vtkNew<vtkPolyData> polydata;
    polydata->SetPoints(points);
    polydata->SetPolys(cells);
    polydata->GetPointData()->SetNormals(normals);
    mapper_->SetInputData(polydata);
    empty_ = geometry.triangles().empty();
    apply_visibility();
}

void GhostActor::set_visible(bool visible) {
    visible_ = visible;
    apply_visibility();
}

void GhostActor::set_clip(vtkPlane* plane) {
    mapper_->RemoveAllClippingPlanes();
    if (plane) mapper_->AddClippingPlane(plane);
    actor_->GetProperty()->SetBackfaceCulling(plane == nullptr);
}

void GhostActor::apply_visibility() {
    actor_->SetVisibility(visible_ && !empty_);
}

}  // namespace hepatica
