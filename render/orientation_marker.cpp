// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/orientation_marker.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>

#include <algorithm>

#include "core/base/vector.h"

namespace hepatica {

OrientationMarker::OrientationMarker(vtkRenderWindow& window) : window_(window) {
    vtkNew<vtkAnnotatedCubeActor> cube;
    cube->SetXPlusFaceText("L");
    cube->SetXMinusFaceText("R");
    cube->SetYPlusFaceText("P");
    cube->SetYMinusFaceText("A");
    cube->SetZPlusFaceText("S");
    cube->SetZMinusFaceText("I");
    cube->SetZFaceTextRotation(90);
    cube->SetFaceTextScale(0.6);
    cube->GetCubeProperty()->SetColor(0.30, 0.34, 0.40);
    cube->GetTextEdgesProperty()->SetColor(0.12, 0.14, 0.17);
    for (vtkProperty* face : {cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(),
                              cube->GetYPlusFaceProperty(), cube->GetYMinusFaceProperty(),
                              cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty()}) {
        face->SetColor(0.90, 0.92, 0.95);
        face->SetLighting(false);
    }
    renderer_->AddActor(cube);
    renderer_->SetLayer(1);
    renderer_->InteractiveOff();
    window_.SetNumberOfLayers(2);
    window_.AddRenderer(renderer_);
}

OrientationMarker::~OrientationMarker() {
    window_.RemoveRenderer(renderer_);
}

double OrientationMarker::inset(const PictureSize& size) {
    return 8.0 * size.pixel_ratio;
}

double OrientationMarker::right_edge(const PictureSize& size) {
    return inset(size) + std::min(84.0 * size.pixel_ratio, 0.25 * size.height);
}

void OrientationMarker::update(vtkCamera& camera, const PictureSize& size) {
    const double from_edge = inset(size), far_edge = right_edge(size);
    const double foot = size.covered_bottom;
    const double width = std::max(size.width, 1);
    const double height = std::max(size.height, 1);
    renderer_->SetViewport(from_edge / width, std::min(1.0, (foot + from_edge) / height),
                           std::min(1.0, far_edge / width),
                           std::min(1.0, (foot + far_edge) / height));
    const Vec3 from = -4.2 * Vec3(camera.GetDirectionOfProjection());
    vtkCamera& eye = *renderer_->GetActiveCamera();
    eye.SetFocalPoint(0, 0, 0);
    eye.SetPosition(from.x(), from.y(), from.z());
    eye.SetViewUp(camera.GetViewUp());
    eye.SetViewAngle(24.0);
    renderer_->ResetCameraClippingRange();
}

}  // namespace hepatica
