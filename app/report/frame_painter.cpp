// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/frame_painter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "render/bleeding_actor.h"
#include "render/palette.h"

namespace hepatica {

namespace {

QColor to_qt(const Colour& colour, double light = 1.0) {
    return QColor::fromRgbF(static_cast<float>(light * colour[0]),
                            static_cast<float>(light * colour[1]),
                            static_cast<float>(light * colour[2]));
}

// Orthographic projection from the front: in LPS the patient's left is on the right and the head is
// up.
class FrontView {
  public:
    explicit FrontView(const FramePainting& how) {
        const Vec3 size = how.box_mm[1] - how.box_mm[0];
        scale_ =
            std::min(how.width / std::max(size.x(), 1.0), how.height / std::max(size.z(), 1.0));
        centre_ = 0.5 * (how.box_mm[0] + how.box_mm[1]);
        middle_ = QPointF(0.5 * how.width, 0.5 * how.height);
    }
    QPointF operator()(const Vec3& p) const {
        return middle_ + scale_ * QPointF(p.x() - centre_.x(), centre_.z() - p.z());
    }
    double px(double mm) const { return scale_ * mm; }

  private:
    double scale_ = 1.0;
    Vec3 centre_ = Vec3::Zero();
    QPointF middle_;
};

// The value of a vertex; where the values are those of the untorn body alone, that of the vertex
// that it comes from. `otherwise` where there is none.
float value_at(const std::vector<float>& values, const Frame& frame, int vertex, float otherwise) {
    for (const int at : {vertex, frame.origin_of(vertex)})
        if (static_cast<std::size_t>(at) < values.size())
            return values[static_cast<std::size_t>(at)];
    return otherwise;
}

Colour colour_of(const Frame& frame, const FramePainting& how, int vertex) {
    const DrugView& drug = frame.drug;
    if (drug.arrival_s) {
        constexpr float never = std::numeric_limits<float>::infinity();
        const double arrival_s = value_at(*drug.arrival_s, frame, vertex, never);
        if (arrival_s <= drug.time_s)
            return palette::drug(std::sqrt(arrival_s / std::max(drug.end_s, 1e-9)));
    }
    const auto shown = static_cast<std::size_t>(vertex);
    const bool open = frame.tear && frame.tear->rims && shown < frame.tear->rims->size();
    if (open && (*frame.tear->rims)[shown] != 0) return palette::torn;
    const auto origin = static_cast<std::size_t>(frame.origin_of(vertex));
    const bool wanted = origin < how.target.size() && how.target[origin] != 0;
    const Colour at_rest =
        wanted ? palette::drug_target()
               : palette::vessel_system(origin < how.systems.size() ? how.systems[origin]
                                                                    : VascularSystem::unknown);
    const Colour own = drug.had_reached(shown) ? palette::reached_before() : at_rest;
    const bool loaded = frame.tear && frame.tear->loads;
    return loaded ? palette::warning(own, value_at(*frame.tear->loads, frame, vertex, 0.0F)) : own;
}

// Paints far triangles first; the back has the larger y.
void paint_surface(QPainter& painter, const Frame& frame, const FramePainting& how,
                   const FrontView& view) {
    const auto& triangles = *frame.surface;
    std::vector<double> depth;
    for (const auto& t : triangles)
        depth.push_back(frame.place_mm(t[0]).y() + frame.place_mm(t[1]).y() +
                        frame.place_mm(t[2]).y());
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](auto a, auto b) { return depth[a] > depth[b]; });
    for (const std::size_t i : order) {
        const auto& t = triangles[i];
        const Vec3 a = frame.place_mm(t[0]), b = frame.place_mm(t[1]), c = frame.place_mm(t[2]);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        const double light = 0.35 + 0.65 * std::abs(normal.dot(Vec3(-0.3, -0.85, 0.43)));
        const QColor colour = to_qt(colour_of(frame, how, t[0]), std::min(1.0, 1.15 * light));
        painter.setPen(QPen(colour, 0.6));
        painter.setBrush(colour);
        const QPointF corners[] = {view(a), view(b), view(c)};
        painter.drawPolygon(corners, 3);
    }
}

// As in the window: a tenth of the volume, and translucent.
void paint_blood(QPainter& painter, const TearView& tear, const FrontView& view) {
    constexpr float opacity = 0.55F;
    QColor colour = to_qt(palette::bleeding);
    colour.setAlphaF(opacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (const LeakView& leak : tear.leaks) {
        const double radius_px = view.px(radius_of_pool_mm(leak.share * tear.leaked_g));
        painter.drawEllipse(view(leak.at_mm), radius_px, radius_px);
    }
}

void paint_hand(QPainter& painter, const Frame& frame, const FrontView& view) {
    // Drawn twice, because a bright tool needs an outline on paper.
    const auto draw_tool = [&](const QColor& colour, double around_px) {
        for (const ToolView::Part& part : frame.tool->parts) {
            const double width = 2.0 * (view.px(part.radius_mm) + around_px);
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(view(part.from_mm), view(part.to_mm) + QPointF(0.01, 0.0));
        }
    };
    if (frame.tool) draw_tool(to_qt(palette::outline), 1.5);
    if (frame.tool) draw_tool(to_qt(palette::tool), 0.0);
    if (!frame.grab) return;
    painter.setPen(QPen(to_qt(palette::grab_line), 3.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(view(frame.grab->point_mm), view(frame.grab->target_mm));
    painter.setBrush(to_qt(palette::grab_line));
    painter.drawEllipse(view(frame.grab->point_mm), 4.0, 4.0);
}

}  // namespace

std::array<Vec3, 2> box_of(const Frame& frame) {
    const auto [low, high] = frame.box_mm();
    const Vec3 around = 0.1 * (high - low);
    return {low - around, high + around};
}

QImage paint(const Frame& frame, const FramePainting& how) {
    QImage image(how.width, how.height, QImage::Format_RGB32);
    image.fill(Qt::white);  // paper
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const FrontView view(how);
    if (frame.surface) paint_surface(painter, frame, how, view);
    if (frame.tear) paint_blood(painter, *frame.tear, view);
    painter.setBrush(Qt::NoBrush);
    paint_hand(painter, frame, view);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] :
         {std::pair(palette::outline, 5.0), std::pair(palette::torn_circle, 2.5)}) {
        painter.setPen(QPen(to_qt(colour), width));
        for (const Vec3& mark : how.marks_mm) painter.drawEllipse(view(mark), 14.0, 14.0);
    }
    return image;
}

}  // namespace hepatica
