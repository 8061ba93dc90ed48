// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/halo_actor.h"

#include <vtkActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <iterator>

#include "render/actor_settings.h"

namespace hepatica {
namespace {

const char* const widen = R"(//VTK::PositionVC::Impl
  gl_Position = MCDCMatrix *
      vec4(vertexMC.xyz + haloBehind + haloWidth * gl_Position.w * normalMC, vertexMC.w);
)";

const char* const colour_as_background = R"(//VTK::Light::Impl
  gl_FragData[0] =
      vec4(mix(haloBottom, haloTop, gl_FragCoord.y / max(haloHeight, 1.0)), 1.0);
)";

}  // namespace

HaloActor::HaloActor(vtkPolyData& surface)
    : mapper_(vtkSmartPointer<vtkOpenGLPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
    mapper_->SetInputData(&surface);
    mapper_->ScalarVisibilityOff();
    // Must equal the setting in DrawnSurface, or the arrays would be uploaded twice.
    mapper_->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->FrontfaceCullingOn();
    actor_->SetPickable(false);
    vtkShaderProperty* shader = actor_->GetShaderProperty();
    shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, widen, false);
    shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, colour_as_background, false);
    set_place(0.0, Vec3::Zero());
    set_background({}, {}, 1);
}

void HaloActor::set_place(double mm_per_depth, const Vec3& behind_mm) {
    vtkUniforms* uniforms = actor_->GetShaderProperty()->GetVertexCustomUniforms();
    uniforms->SetUniformf("haloWidth", static_cast<float>(mm_per_depth));
    const float behind[] = {static_cast<float>(behind_mm.x()), static_cast<float>(behind_mm.y()),
                            static_cast<float>(behind_mm.z())};
    uniforms->SetUniform3f("haloBehind", behind);
}

void HaloActor::set_background(const Colour& top, const Colour& bottom, int height) {
    vtkUniforms* uniforms = actor_->GetShaderProperty()->GetFragmentCustomUniforms();
    const auto set = [uniforms](const char* name, const Colour& colour) {
        float channels[3];
        std::ranges::transform(colour, std::begin(channels),
                               [](double channel) { return static_cast<float>(channel); });
        uniforms->SetUniform3f(name, channels);
    };
    set("haloTop", top);
    set("haloBottom", bottom);
    uniforms->SetUniformf("haloHeight", static_cast<float>(height));
}

void HaloActor::set_clip(vtkPlane* plane) {
    clip_by(plane, *mapper_);
}

}  // namespace hepatica
