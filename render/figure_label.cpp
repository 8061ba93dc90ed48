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
constexpr std::array further_points{0.0, 16.0, 40.0, 72.0};  // where there is no room nearer
// Between its ground and what is kept clear: where it is, to go elsewhere, and to come nearer
// again.
constexpr double staying_points = 1.0, moving_points = 3.0, nearer_points = 10.0;
constexpr int label_sides = 6;

// The label's lower left corner on a side of the point `at`: 0 right, 1 right and below, 2 left, 3
// left and below, 4 above, 5 below. Right and left it stands on the point's level.
std::array<double, 2> corner_beside(int side, const std::array<double, 2>& at,
                                    const std::array<double, 2>& size, double gap) {
    const double x = side < 2 ? gap : side < 4 ? -gap - size[0] : -0.5 * size[0];
    const double y = side == 4 ? gap : side == 5 ? -gap - size[1] : side % 2 == 1 ? -size[1] : 0.0;
    return {at[0] + x, at[1] + y};
}

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
    if (text.empty()) side_ = further_ = 0;
    text_->SetVisibility(!text.empty());
    text_->SetInput(text.c_str());
    return true;
}

void FigureLabel::place(double pixel_ratio, double below_points,
                        std::span<const ThickStretch> keep_clear) {
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
    const double* display = point->GetComputedDoubleDisplayValue(&renderer_);
    const std::array<double, 2> at{display[0], display[1]};
    const double away = below_points * pixel_ratio, gap = away + beside_points * pixel_ratio;
    std::array<double, 2> size{};
    text_->GetSize(&renderer_, size.data());
    const auto stand = [&](int further, int side) {
        const double reach = gap + further_points[static_cast<std::size_t>(further)] * pixel_ratio;
        std::array<double, 2> corner = corner_beside(side, at, size, reach);
        if (side == 0) corner[1] -= away;
        corner = place_inside(corner, size, *text_, renderer_);
        text_->SetPosition(corner[0], corner[1]);
        const bool stays = further == further_ && side == side_;
        const double margin = stays                ? staying_points
                              : further < further_ ? nearer_points
                                                   : moving_points;
        return is_clear_of({corner[0], corner[1], corner[0] + size[0], corner[1] + size[1]},
                           keep_clear, margin * pixel_ratio);
    };
    for (int further = 0; further < static_cast<int>(further_points.size()); ++further)
        for (int turn = 0; turn <= label_sides; ++turn) {
            const int side = turn == 0 ? side_ : turn - 1;
            if (!stand(further, side)) continue;
            side_ = side;
            further_ = further;
            return;
        }
    stand(0, 0);  // no place is free
}

std::optional<PictureBox> FigureLabel::box() const {
    if (text_->GetVisibility() == 0) return std::nullopt;
    std::array<double, 2> size{};
    text_->GetSize(&renderer_, size.data());
    const double* place = text_->GetPosition();
    return PictureBox{place[0], place[1], place[0] + size[0], place[1] + size[1]};
}

}  // namespace hepatica
