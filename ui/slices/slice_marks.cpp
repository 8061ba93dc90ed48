// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a slice view that draws what is measured, drawn and painted in it.
#include <QFontInfo>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/palette.h"
#include "ui/colours.h"
#include "ui/slices/slice_picture.h"
#include "ui/slices/slice_view.h"

namespace hepatica {

// Text with a dark outline, readable on every grey, even on white bone.
void SliceView::write_outlined(QPainter& painter, const QRectF& box, Qt::Alignment where,
                               const QString& text, const QColor& colour) {
    painter.setPen(Qt::black);
    for (const int right : {-1, 0, 1})
        for (const int down : {-1, 0, 1})
            painter.drawText(box.translated(right, down), static_cast<int>(where), text);
    painter.setPen(colour);
    painter.drawText(box, static_cast<int>(where), text);
}

// Whether a point lies within half of `reach_mm` from this slice.
bool SliceView::is_here(const Vec3& point_mm, double reach_mm) const {
    const SliceStack slices = stack();
    const double off = slices.place_of(point_mm).z() - slices.place_of(scene_.crosshair_mm()).z();
    return std::abs(off) * slices.slice_mm() <= 0.5 * reach_mm;
}

void SliceView::paint_line(QPainter& painter, const QPolygonF& line) const {
    for (const auto& [colour, width] :
         {std::pair{QColor(Qt::black), 3.5}, std::pair{colour_of_marks, 1.6}}) {
        painter.setPen(QPen(colour, width));
        painter.drawPolyline(line);
        for (const QPointF& end : line) painter.drawEllipse(end, 2.0, 2.0);
    }
}

// All places of the drawn vessel, which passes through many slices; circled if near this slice.
void SliceView::paint_pen(QPainter& painter) const {
    const std::vector<Vec3>& places = scene_.pen().places_mm();
    if (places.empty()) return;
    QPolygonF line;
    for (const Vec3& place : places) line << place_of(place);
    painter.setBrush(Qt::NoBrush);
    paint_line(painter, line);
    for (const Vec3& place : places)
        if (is_here(place, std::max(1.0, stack().slice_mm())))
            painter.drawEllipse(place_of(place), 5.0, 5.0);
}

// A cross in the colour of its system, in the slices near it.
void SliceView::paint_seeds(QPainter& painter) const {
    constexpr double half = 5.0;
    for (const VesselSeed& seed : scene_.seeds().seeds()) {
        if (!is_here(seed.position_mm, std::max(2.0, stack().slice_mm()))) continue;
        const QPointF at = place_of(seed.position_mm);
        const QColor of_system = qcolor_of(palette::vessel_system(seed.system)).lighter(150);
        for (const auto& [colour, width] :
             {std::pair{QColor(Qt::black), 4.5}, std::pair{of_system, 2.2}}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(at + QPointF(-half, -half), at + QPointF(half, half));
            painter.drawLine(at + QPointF(-half, half), at + QPointF(half, -half));
        }
    }
}

// A circle with the radius of the brush.
void SliceView::paint_brush(QPainter& painter) const {
    if (!brushing() || !mouse_) return;
    const double radius = scene_.brush().radius_mm() * points_per_mm();
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] :
         {std::pair{QColor(Qt::black), 3.0}, std::pair{colour_of_marks, 1.4}}) {
        painter.setPen(QPen(colour, width, scene_.brush_erases() ? Qt::DashLine : Qt::SolidLine));
        painter.drawEllipse(*mouse_, radius, radius);
    }
}

// Shown in the slices near any of its points; a diameter only where the slice cuts the lumen along
// it.
void SliceView::paint_measurement(QPainter& painter, const Measurement& measurement,
                                  LabelPlaces& labels) {
    const auto& points = measurement.points_mm;
    double reach_mm = std::max(1.0, stack().slice_mm());
    if (measurement.kind == MeasurementKind::diameter) reach_mm += (points[1] - points[0]).norm();
    QPolygonF line;
    bool here_at_all = false;
    for (const Vec3& point : points) {
        here_at_all |= is_here(point, reach_mm);
        line << place_of(point);
    }
    if (!here_at_all) return;
    const double seen_mm = QLineF(line.front(), line.back()).length() / points_per_mm();
    if (measurement.kind == MeasurementKind::diameter &&
        seen_mm < 0.5 * (points[1] - points[0]).norm())
        return;
    paint_line(painter, line);
    if (measurement.text.empty()) return;
    paint_label(painter, line.back(), QString::fromStdString(measurement.text), labels);
}

// Letters shrink where the view is narrow; a label without room is left out.
void SliceView::paint_label(QPainter& painter, const QPointF& at, const QString& text,
                            LabelPlaces& labels) {
    constexpr double least_shrunk = 0.6, spare = 2.0;  // spare: for the outline
    const auto wide = [&] { return painter.fontMetrics().horizontalAdvance(text) + 2.0 * spare; };
    painter.save();
    if (const double share = room_for_labels().width() / wide(); share < 1.0) {
        QFont letters = painter.font();
        letters.setPointSizeF(QFontInfo(letters).pointSizeF() * std::max(least_shrunk, share));
        painter.setFont(letters);
    }
    const auto label = labels.place({at.x() + 7.0 - spare, at.y() - 25.0, wide(), 20.0});
    if (label) {
        const QRectF box(label->box.left, label->box.top, label->box.width, label->box.height);
        if (label->evades) {
            painter.setPen(QPen(colour_of_marks, 1.0));
            painter.drawLine(at, QPointF(std::clamp(at.x(), box.left(), box.right()),
                                         std::clamp(at.y(), box.top(), box.bottom())));
        }
        write_outlined(painter, box.adjusted(spare, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignBottom,
                       text, colour_of_marks);
        measure_labels_.push_back(box);
    }
    painter.restore();
}

QRectF SliceView::room_for_labels() const {
    return QRectF(rect()).adjusted(2, 2 + covered_top_, -2, -2 - covered_bottom_);
}

void SliceView::paint_measurements(QPainter& painter) {
    painter.setBrush(Qt::NoBrush);
    measure_labels_.clear();
    const QRectF room = room_for_labels();
    LabelPlaces labels({room.left(), room.top(), room.width(), room.height()});
    for (const Measurement& made : scene_.measurements().made())
        paint_measurement(painter, made, labels);
    if (const Measurement* half = scene_.measurements().half_made())
        paint_measurement(painter, *half, labels);
}

}  // namespace hepatica
