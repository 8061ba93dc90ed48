// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/drug_overlay.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <string>

#include <algorithm>

#include "core/scene/frame.h"
#include "render/palette.h"

namespace hepatica::drug_overlay {
namespace {

const char* const paint_drug = R"(//VTK::Color::Impl
  if (drugEnd > 0.0 && arrivalVS <= drugTime) {
    vec3 drugged = drugColour(sqrt(max(arrivalVS, 0.0) / drugEnd));
    // A bright band marks the front itself; it fades as the drug moves on.
    float age = (drugTime - arrivalVS) / max(0.05 * drugTime, 1e-6);
    drugged = mix(vec3(1.0), drugged, clamp(0.35 + age, 0.0, 1.0));
    diffuseColor = drugged;
    ambientColor = 0.35 * drugged;
  }
)";

const char* const shade = R"(//VTK::Light::Impl
  {
    vec3 toEye = normalize(-vertexVC.xyz);
    float facing = abs(dot(normalVCVSOutput, toEye));
    // A dark outline sets one vessel off from the one behind it; distance fades towards the back.
    gl_FragData[0].rgb *= 0.45 + 0.55 * smoothstep(0.0, 0.55, facing);
    // The inside of a wall, which is seen where the view is opened.
    if (!gl_FrontFacing) gl_FragData[0].rgb *= 0.5;
    float depth = clamp((-vertexVC.z - fadeNear) / max(fadeFar - fadeNear, 1e-3), 0.0, 1.0);
    gl_FragData[0].rgb = mix(gl_FragData[0].rgb, fadeInto, 0.62 * depth);
  }
)";

}  // namespace

void attach(vtkActor& actor, vtkOpenGLPolyDataMapper& mapper) {
    mapper.MapDataArrayToVertexAttribute("arrivalMC", arrival_array,
                                         vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    vtkShaderProperty* shader = actor.GetShaderProperty();
    shader->AddVertexShaderReplacement(
        "//VTK::PositionVC::Dec", true,
        "//VTK::PositionVC::Dec\nin float arrivalMC;\nout float arrivalVS;\n", false);
    shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                       "//VTK::PositionVC::Impl\n  arrivalVS = arrivalMC;\n",
                                       false);
    const std::string declarations =
        "//VTK::PositionVC::Dec\nin float arrivalVS;\n" + palette::drug_glsl();
    shader->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true, declarations, false);
    shader->AddFragmentShaderReplacement("//VTK::Color::Impl", true, paint_drug, false);
    shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, shade, false);
    set_time(actor, DrugView{});
    set_fade(actor, 0.0, 1e6);
    set_distance(actor, palette::distance);
}

void set_time(vtkActor& actor, const DrugView& drug, double least_end_s) {
    vtkUniforms* uniforms = actor.GetShaderProperty()->GetFragmentCustomUniforms();
    const bool shown = drug.arrival_s != nullptr;
    uniforms->SetUniformf("drugTime", shown ? static_cast<float>(drug.time_s) : -1.0f);
    uniforms->SetUniformf("drugEnd",
                          shown ? static_cast<float>(std::max(drug.end_s, least_end_s)) : 0.0f);
}

void set_fade(vtkActor& actor, double near_mm, double far_mm) {
    vtkUniforms* uniforms = actor.GetShaderProperty()->GetFragmentCustomUniforms();
    uniforms->SetUniformf("fadeNear", static_cast<float>(near_mm));
    uniforms->SetUniformf("fadeFar", static_cast<float>(far_mm));
}

void set_distance(vtkActor& actor, const Colour& colour) {
    const float into[] = {static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                          static_cast<float>(colour[2])};
    actor.GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform3f("fadeInto", into);
}

}  // namespace hepatica::drug_overlay
