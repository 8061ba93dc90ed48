// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/stroke_line.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace hepatica {
namespace {

// In points.
constexpr double half_width = 1.75;
constexpr double rim_width = 1.75;

}  // namespace

StrokeLine::StrokeLine(vtkRenderer& renderer)
    : points_(vtkSmartPointer<vtkPoints>::New()),
      quads_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      polydata_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor2D>::New()) {
    colours_->SetNumberOfComponents(3);
    polydata_->SetPoints(points_);
    polydata_->SetPolys(quads_);
    polydata_->GetCellData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(polydata_);
    actor_->SetMapper(mapper);
    actor_->SetVisibility(false);
    renderer.AddActor2D(actor_);
}

void StrokeLine::add_band(const std::array<double, 2>& from, const std::array<double, 2>& to,
                          double low, double high, const Colour& colour) {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const double left_x = -(to[1] - from[1]) / length, left_y = (to[0] - from[0]) / length;
    const auto corner = [&](const std::array<double, 2>& at, double aside) {
        return points_->InsertNextPoint(at[0] + aside * left_x, at[1] + aside * left_y, 0);
    };
    quads_->InsertNextCell(
        {corner(from, low), corner(to, low), corner(to, high), corner(from, high)});
    for (const double channel : colour)
        colours_->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * channel)));
}

void StrokeLine::update(const Place& place, double point) {
    points_->Reset();
    quads_->Reset();
    colours_->Reset();
    const auto from = ends_mm_ ? place((*ends_mm_)[0]) : std::nullopt;
    const auto to = ends_mm_ ? place((*ends_mm_)[1]) : std::nullopt;
    const double length =
        from && to ? std::hypot((*to)[0] - (*from)[0], (*to)[1] - (*from)[1]) : 0.0;
    actor_->SetVisibility(length > 0.0);
    if (!(length > 0.0)) return;
    const double inner = half_width * point, outer = inner + rim_width * point;
    const double cap = rim_width * point / length;
    const auto along = [&](double share) {
        return std::array{(*from)[0] + share * ((*to)[0] - (*from)[0]),
                          (*from)[1] + share * ((*to)[1] - (*from)[1])};
    };
    add_band(*from, *to, -inner, inner, palette::grab_line);
    add_band(along(-cap), along(1.0 + cap), -outer, -inner, palette::rim);
    add_band(along(-cap), along(1.0 + cap), inner, outer, palette::rim);
    add_band(along(-cap), *from, -inner, inner, palette::rim);
    add_band(*to, along(1.0 + cap), -inner, inner, palette::rim);
    points_->Modified();
    quads_->Modified();
    colours_->Modified();
    polydata_->Modified();
}

}  // namespace hepatica
