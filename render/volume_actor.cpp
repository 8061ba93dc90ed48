// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/volume_actor.h"

#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <utility>

#include "render/actor_settings.h"
#include "render/transfer_function.h"

namespace hepatica {
namespace {

// Sampling of the ray caster on the processor, by VolumeDetail: distance between samples along a
// ray in voxels, and between rays in pixels.
struct Sampling {
    double step;
    double rays_px;
};
constexpr std::array samplings{Sampling{2.0, 5.0}, Sampling{0.75, 2.0}, Sampling{0.5, 1.0}};
constexpr double card_step = 0.5;

// Wraps the voxels without copying them; they must outlive the image.
vtkSmartPointer<vtkImageData> image_of(const Volume& voxels) {
    vtkNew<vtkShortArray> values;
    constexpr int keep = 1;  // VTK does not free the voxels, and only reads them
    values->SetArray(const_cast<std::int16_t*>(voxels.voxels.data()),
                     static_cast<vtkIdType>(voxels.voxels.size()), keep);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(voxels.grid.dims.data());
    image->SetSpacing(voxels.grid.spacing_mm.data());
    image->GetPointData()->SetScalars(values);
    return image;
}

// Direction and origin of the grid as a matrix, because the mappers ignore an image's direction.
vtkSmartPointer<vtkMatrix4x4> placement_of(const Grid& grid) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, grid.direction(row, column));
        matrix->SetElement(row, 3, grid.origin_mm[row]);
    }
    return matrix;
}

// VTK's gradients are differences between neighbouring voxels, hence the factor of the spacing.
vtkSmartPointer<vtkPiecewiseFunction> gradient_opacity(const Volume& voxels) {
    auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
    for (const GradientPoint& point : gradient_function())
        function->AddPoint(point.hu_per_mm * voxels.grid.spacing_mm.mean(), point.share);
    return function;
}

// Works around VTK 9.1, which compares the viewport's size with one that it never set, and keeps an
// aspect of 1 where they happen to be equal; only the ray caster on the processor reads that
// aspect. Setting two different pixel aspects forces it to be computed.
void compute_aspect(vtkRenderer& renderer) {
    for (const double pixel : {2.0, 1.0}) {
        renderer.SetPixelAspect(pixel, 1.0);
        renderer.ComputeAspect();
    }
}

}  // namespace

struct VolumeActor::Drawn {
    std::shared_ptr<const Volume>
        voxels;  // first, so that it is destroyed after everything that reads it
    vtkNew<vtkVolume> volume;
    vtkSmartPointer<vtkVolumeMapper> mapper;
    vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>
        by_processor;  // null where a graphics card draws
};

VolumeActor::VolumeActor(vtkRenderer& renderer) : renderer_(renderer) {}

VolumeActor::~VolumeActor() = default;

void VolumeActor::show(std::shared_ptr<const Volume> voxels) {
    voxels_ = std::move(voxels);
}

bool VolumeActor::set_look(const VolumeLook& look) {
    look_ = look;
    follow_look();
    return !empty();
}

void VolumeActor::set_room(const ViewLook& room) {
    room_ = room;
    follow_look();
}

void VolumeActor::set_clip(vtkPlane* plane) {
    clip_ = plane;
    follow_clip();
}

void VolumeActor::set_detail(VolumeDetail detail) {
    detail_ = detail;
    follow_detail();
}

void VolumeActor::prepare(bool by_card) {
    if (drawn_ && drawn_->voxels != voxels_) {
        renderer_.RemoveVolume(drawn_->volume);  // frees memory of the graphics card
        drawn_.reset();
    }
    if (!drawn_ && voxels_) build(by_card);
}

void VolumeActor::build(bool by_card) {
    drawn_ = std::make_unique<Drawn>();
    drawn_->voxels = voxels_;
    if (by_card) {
        auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
        mapper->AutoAdjustSampleDistancesOff();
        mapper->SetSampleDistance(
            static_cast<float>(card_step * voxels_->grid.spacing_mm.minCoeff()));
        mapper->UseJitteringOn();  // avoids rings where samples of neighbouring rays line up
        drawn_->mapper = mapper;
    } else {
        drawn_->by_processor = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
        drawn_->by_processor->AutoAdjustSampleDistancesOff();
        drawn_->mapper = drawn_->by_processor;
    }
    drawn_->mapper->SetInputData(image_of(*voxels_));
    drawn_->volume->SetMapper(drawn_->mapper);
    drawn_->volume->SetUserMatrix(placement_of(voxels_->grid));
    drawn_->volume->SetPickable(false);
    vtkVolumeProperty& property = *drawn_->volume->GetProperty();
    property.SetInterpolationTypeToLinear();
    property.SetScalarOpacityUnitDistance(1.0);
    property.SetAmbient(0.25);
    property.SetDiffuse(0.9);
    property.SetSpecular(0.1);
    property.SetSpecularPower(10.0);
    follow_look();
    follow_clip();
    follow_detail();
    compute_aspect(renderer_);
    renderer_.AddVolume(drawn_->volume);
}

void VolumeActor::follow_look() {
    if (!drawn_) return;
    const bool maximum = look_.preset == VolumePreset::maximum_intensity;
    if (maximum)
        drawn_->mapper->SetBlendModeToMaximumIntensity();
    else
        drawn_->mapper->SetBlendModeToComposite();
    vtkNew<vtkColorTransferFunction> colours;
    vtkNew<vtkPiecewiseFunction> opacity;
    for (const TransferPoint& point : transfer_function(look_, room_)) {
        colours->AddRGBPoint(point.hu, point.colour[0], point.colour[1], point.colour[2]);
        opacity->AddPoint(point.hu, point.opacity);
    }
    vtkVolumeProperty& property = *drawn_->volume->GetProperty();
    property.SetColor(colours);
    property.SetScalarOpacity(opacity);
    property.SetShade(!maximum);
    if (maximum)
        property.SetGradientOpacity(nullptr);
    else
        property.SetGradientOpacity(gradient_opacity(*drawn_->voxels));
}

void VolumeActor::follow_clip() {
    if (!drawn_) return;
    clip_by(clip_, *drawn_->mapper);
}

void VolumeActor::follow_detail() {
    if (!drawn_ || !drawn_->by_processor) return;
    const Sampling& sampling = samplings[static_cast<std::size_t>(detail_)];
    drawn_->by_processor->SetSampleDistance(
        static_cast<float>(sampling.step * drawn_->voxels->grid.spacing_mm.minCoeff()));
    drawn_->by_processor->SetImageSampleDistance(static_cast<float>(sampling.rays_px));
}

}  // namespace hepatica
