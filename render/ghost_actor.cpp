// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ghost_actor.h"

#include <vtkActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <locale>
#include <sstream>
#include <string>

#include "render/actor_settings.h"
#include "render/still_surface.h"

namespace hepatica {
namespace {

// Opacity rises towards the silhouette: the outline shows the shape, and the vessels inside remain
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
    look.SetOpacity(0.5);  // below 1, so that VTK draws it in its translucent pass
    look.BackfaceCullingOn();
    actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                              shader_of(ghost), false);
    actor_->SetVisibility(false);
}

void GhostActor::set_surface(const TriangleMesh& surface) {
    mapper_->SetInputData(still_surface(surface));
    empty_ = surface.triangles.empty();
    apply_visibility();
}

void GhostActor::set_visible(bool visible) {
    visible_ = visible;
    apply_visibility();
}

void GhostActor::set_clip(vtkPlane* plane) {
    clip_by(plane, *mapper_, *actor_);
}

void GhostActor::apply_visibility() {
    actor_->SetVisibility(shows());
}

}  // namespace hepatica
