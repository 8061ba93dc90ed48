// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tool_icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace hepatica {
namespace {

// Paints into a square of 16 x 16.
using Draw = void (*)(QPainter&);

const QColor vessel(0x8f, 0x86, 0xd8), touch(0x1f, 0xc4, 0xac);

// The colour of text on buttons, which is visible in every theme.
QColor bright() {
    return QGuiApplication::palette().color(QPalette::ButtonText);
}

QPen pen(const QColor& colour, double width) {
    return {QBrush(colour), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void draw_pull(QPainter& p) {
    p.setPen(pen(vessel, 3.0));
    QPainterPath path(QPointF(1.5, 13.5));
    path.quadTo(QPointF(8, 2), QPointF(14.5, 13.5));
    p.drawPath(path);
    p.setPen(pen(touch, 1.6));
    p.drawLine(QPointF(8, 8), QPointF(8, 1.5));
    p.drawPolyline(QPolygonF({QPointF(5.5, 4), QPointF(8, 1.5), QPointF(10.5, 4)}));
}

void draw_inject(QPainter& p) {
    p.setPen(Qt::NoPen);
    p.setBrush(QColor(0xfe, 0x99, 0x29));
    QPainterPath drop(QPointF(8, 1));
    drop.cubicTo(QPointF(10, 5), QPointF(13, 7.5), QPointF(13, 10.5));
    drop.cubicTo(QPointF(13, 16.5), QPointF(3, 16.5), QPointF(3, 10.5));
    drop.cubicTo(QPointF(3, 7.5), QPointF(6, 5), QPointF(8, 1));
    p.drawPath(drop);
}

void draw_edit(QPainter& p) {
    p.setPen(pen(bright(), 1.8));
    p.drawLine(QPointF(3, 13), QPointF(12, 4));
    p.drawLine(QPointF(10, 2.5), QPointF(13.5, 6));
    p.setPen(pen(vessel, 1.8));
    p.drawLine(QPointF(2, 14.5), QPointF(7, 14.5));
}

void draw_ball(QPainter& p) {
    QRadialGradient shine(QPointF(6, 5.5), 8.0);
    shine.setColorAt(0.0, Qt::white);
    shine.setColorAt(1.0, QColor(0x77, 0x80, 0x8c));
    p.setPen(Qt::NoPen);
    p.setBrush(shine);
    p.drawEllipse(QPointF(8, 8), 5.5, 5.5);
}

void draw_rod(QPainter& p) {
    p.setPen(pen(QColor(0x77, 0x80, 0x8c), 5.5));
    p.drawLine(QPointF(12, 12.5), QPointF(4.5, 4));
    p.setPen(pen(bright(), 2.0));
    p.drawLine(QPointF(11, 12), QPointF(4.2, 4.4));
}

void draw_forceps(QPainter& p) {
    p.setPen(pen(bright(), 2.0));
    p.drawPolyline(QPolygonF({QPointF(13.5, 13.5), QPointF(7, 10.5), QPointF(2, 4.5)}));
    p.drawPolyline(QPolygonF({QPointF(13.5, 13.5), QPointF(10.5, 7), QPointF(4.5, 2)}));
}

void draw_hook(QPainter& p) {
    p.setPen(pen(bright(), 2.4));
    p.drawPolyline(QPolygonF({QPointF(13.5, 13.5), QPointF(4.5, 4.5), QPointF(9.5, 2.5)}));
}

void draw_blade(QPainter& p) {
    p.setPen(Qt::NoPen);
    p.setBrush(bright());
    p.drawPolygon(QPolygonF({QPointF(2, 14), QPointF(9.5, 4), QPointF(12, 6.5)}));
    p.setPen(pen(QColor(0x77, 0x80, 0x8c), 2.6));
    p.drawLine(QPointF(11, 5), QPointF(14, 2));
}

void draw_cut_line(QPainter& p) {
    p.setPen(pen(vessel, 4.0));
    p.drawLine(QPointF(2, 11), QPointF(14, 5));
    QPen dashed = pen(bright(), 1.6);
    dashed.setDashPattern({1.5, 1.8});
    p.setPen(dashed);
    p.drawLine(QPointF(5, 2), QPointF(11, 14));
}

void draw_ruler(QPainter& p) {
    p.setPen(pen(bright(), 1.6));
    p.drawPolygon(QPolygonF(
        {QPointF(1.5, 10.5), QPointF(10.5, 1.5), QPointF(14.5, 5.5), QPointF(5.5, 14.5)}));
    for (const double at : {4.0, 6.25, 8.5})
        p.drawLine(QPointF(at, 12.0 - at), QPointF(at + 1.8, 13.8 - at));
}

Draw draw_of(ActionId id) {
    switch (id) {
        case ActionId::pull_mode:
            return draw_pull;
        case ActionId::inject_mode:
            return draw_inject;
        case ActionId::edit_mode:
            return draw_edit;
        case ActionId::sphere_tool:
            return draw_ball;
        case ActionId::capsule_tool:
            return draw_rod;
        case ActionId::forceps_tool:
            return draw_forceps;
        case ActionId::hook_tool:
            return draw_hook;
        case ActionId::cut_mode:
            return draw_blade;
        case ActionId::weaken_mode:
            return draw_cut_line;
        case ActionId::measure_distance:
            return draw_ruler;
        default:
            return nullptr;
    }
}

class PaintedIcon : public QIconEngine {
  public:
    explicit PaintedIcon(Draw draw) : draw_(draw) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (mode == QIcon::Disabled) painter->setOpacity(0.4);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / 16.0, rect.height() / 16.0);
        draw_(*painter);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        PaintedIcon::paint(&painter, QRect(QPoint(), size), mode, state);
        return picture;
    }
    QIconEngine* clone() const override { return new PaintedIcon(draw_); }

  private:
    Draw draw_;
};

}  // namespace

QIcon icon_of(ActionId id) {
    const Draw draw = draw_of(id);
    return draw != nullptr ? QIcon(new PaintedIcon(draw)) : QIcon();
}

}  // namespace hepatica
