// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure_label.h"

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <array>
#include <cmath>

#include "render/text_style.h"

namespace hepatica {
namespace {

constexpr int figure_text_size = 13;
constexpr double ground_opacity = 0.75;
constexpr double beside_points = 8.0;  // its ground covers no ball or arrow's head at the point

}  // namespace

FigureLabel::FigureLabel(vtkRenderer& renderer, const Colour& colour)
    : renderer_(renderer), colour_(colour), text_(vtkSmartPointer<vtkTextActor>::New()) {
    text_->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    text_->SetVisibility(false);
    vtkTextProperty& letters = *text_->GetTextProperty();
    letters.SetBackgroundColor(palette::rim[0], palette::rim[1], palette::rim[2]);
    letters.SetBackgroundOpacity(ground_opacity);
    renderer_.AddActor(text_);
}

FigureLabel::~FigureLabel() {
    renderer_.RemoveActor(text_);
}

bool FigureLabel::show(const std::string& text, const Vec3& at_mm) {
    const bool same = text == shown_ && (text.empty() || at_mm == at_mm_);
    if (same) return false;
    shown_ = text;
    at_mm_ = at_mm;
    text_->SetVisibility(!text.empty());
    text_->SetInput(text.c_str());
    return true;
}

void FigureLabel::place(double pixel_ratio, double below_points) {
    if (shown_.empty()) return;
    vtkCamera& camera = *renderer_.GetActiveCamera();
    const Vec3 eye(camera.GetPosition()), forward(camera.GetDirectionOfProjection());
    const bool before_eye = (at_mm_ - eye).dot(forward) > 0.0;
    text_->SetVisibility(before_eye);
    if (!before_eye) return;
    style_text(*text_->GetTextProperty(),
               static_cast<int>(std::lround(figure_text_size * pixel_ratio)), colour_);
    vtkNew<vtkCoordinate> point;
    point->SetCoordinateSystemToWorld();
    point->SetValue(at_mm_.x(), at_mm_.y(), at_mm_.z());
    const double* at = point->GetComputedDoubleDisplayValue(&renderer_);
    const double away = below_points * pixel_ratio;
    stand_inside(*text_, renderer_, at[0] + away + beside_points * pixel_ratio, at[1] - away);
}

std::optional<PictureBox> FigureLabel::box() const {
    if (text_->GetVisibility() == 0) return std::nullopt;
    std::array<double, 2> size{};
    text_->GetSize(&renderer_, size.data());
    const double* place = text_->GetPosition();
    return PictureBox{place[0], place[1], place[0] + size[0], place[1] + size[1]};
}

}  // namespace hepatica
