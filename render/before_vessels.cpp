// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/before_vessels.h"

#include <vtkActor.h>
#include <vtkShaderProperty.h>

namespace hepatica {

void draw_before_vessels(vtkActor& actor) {
    // Maps the depth into the nearest hundredth of the depth range.
    actor.GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                                          R"(//VTK::PositionVC::Impl
  gl_Position.z = mix(-gl_Position.w, gl_Position.z, 0.01);
)",
                                                          false);
}

}  // namespace hepatica
