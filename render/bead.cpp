// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bead.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "render/actor_settings.h"

namespace hepatica {

vtkSmartPointer<vtkActor> new_bead() {
    constexpr double radius_points = 4.0;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radius_points);
    sphere->SetThetaResolution(20);
    sphere->SetPhiResolution(14);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto bead = vtkSmartPointer<vtkActor>::New();
    bead->SetMapper(mapper);
    bead->GetProperty()->SetLighting(false);
    give_colour(*bead, palette::grab_line);
    bead->SetVisibility(false);
    return bead;
}

}  // namespace hepatica
