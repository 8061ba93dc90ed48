// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_panel.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "render/annotations.h"
#include "ui/core_words.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {
namespace {

const QColor marker_line(0xff, 0xc4, 0x66);
const QColor event_line(0xff, 0x6b, 0x5e);

QColor grid_line(const QPalette& palette) {
    QColor faint = palette.color(QPalette::Text);
    faint.setAlphaF(0.2f);
    return faint;
}

// Those of Okabe and Ito's that stand out on a dark ground: sky blue, orange, purple, green. Points
// alone are what went wrong.
QColor colour_of(const Chart& chart, std::size_t curve) {
    if (chart.curves[curve].points_only) return event_line;
    constexpr std::array<std::size_t, 4> bright{4, 5, 3, 2};
    const Colour colour = curve_colour(bright[curve % bright.size()]);
    return QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                            static_cast<float>(colour[2]));
}

double largest_of(const Chart& chart, std::vector<double> Curve::*values) {
    double largest = 0.0;
    for (const Curve& curve : chart.curves) {
        for (const double value : curve.*values) {
            if (std::isfinite(value)) largest = std::max(largest, value);
        }
    }
    return largest > 0.0 ? largest : 1.0;
}

}  // namespace

std::vector<double> axis_ticks(double largest) {
    // The smallest round step of which five reach the end: see round_length_below().
    const double step = 1.0 / round_length_below(5.0 / largest * (1.0 + 1e-9));
    std::vector<double> ticks{0.0};
    for (int i = 1; ticks.back() < largest * (1.0 - 1e-9); ++i) ticks.push_back(step * i);
    return ticks;
}

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(220, 140);
}

void PlotView::set_chart(const Chart& chart) {
    chart_ = chart;
    x_end_ = axis_ticks(largest_of(chart, &Curve::x)).back();
    y_end_ = axis_ticks(largest_of(chart, &Curve::y)).back();
    update();
}

void PlotView::set_marker(std::optional<double> x) {
    if (x == marker_) return;
    marker_ = x;
    update();
}

void PlotView::set_events(std::vector<PlotEvent> events) {
    if (events == events_) return;
    events_ = std::move(events);
    update();
}

QRectF PlotView::frame() const {
    return QRectF(58, 26, width() - 74.0, height() - 64.0);
}

QPointF PlotView::place(double x, double y) const {
    const QRectF area = frame();
    return {area.left() + area.width() * x / x_end_, area.bottom() - area.height() * y / y_end_};
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paint_axes(painter);
    if (!chart_.curves.empty()) paint_curves(painter);
    if (chart_.curves.size() > 1) paint_names(painter);
    paint_events(painter);
}

void PlotView::paint_axes(QPainter& painter) const {
    const QRectF area = frame();
    for (const double x : axis_ticks(x_end_)) {
        const QPointF foot = place(x, 0);
        painter.setPen(grid_line(palette()));
        painter.drawLine(foot, QPointF(foot.x(), area.top()));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(foot.x() - 30, foot.y() + 3, 60, 16), Qt::AlignCenter,
                         QLocale().toString(x));
    }
    for (const double y : axis_ticks(y_end_)) {
        const QPointF foot = place(0, y);
        painter.setPen(grid_line(palette()));
        painter.drawLine(foot, QPointF(area.right(), foot.y()));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(0, foot.y() - 8, area.left() - 6, 16),
                         Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(y));
    }
    painter.drawText(QRectF(area.left(), 4, area.width(), 18), Qt::AlignLeft,
                     translated(chart_.y_label));
    painter.drawText(QRectF(area.left(), height() - 20.0, area.width(), 16), Qt::AlignCenter,
                     translated(chart_.x_label));
}

void PlotView::paint_curves(QPainter& painter) const {
    for (std::size_t c = 0; c < chart_.curves.size(); ++c) {
        const Curve& curve = chart_.curves[c];
        painter.setPen(QPen(colour_of(chart_, c), 2.0));
        if (curve.points_only) {
            paint_crosses(painter, curve);
            continue;
        }
        QPainterPath path;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!std::isfinite(curve.y[i])) continue;
            const QPointF point = place(curve.x[i], curve.y[i]);
            path.elementCount() == 0 ? path.moveTo(point) : path.lineTo(point);
        }
        painter.drawPath(path);
        if (curve.x.size() <= most_dots) paint_dots(painter, curve);
    }
    if (!marker_ || *marker_ < 0.0 || *marker_ > x_end_) return;
    painter.setPen(QPen(marker_line, 1.5));
    painter.drawLine(place(*marker_, 0), place(*marker_, y_end_));
}

// Of few points each counts, and a single one has no line.
void PlotView::paint_dots(QPainter& painter, const Curve& curve) const {
    painter.setBrush(painter.pen().color());
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.y[i])) painter.drawEllipse(place(curve.x[i], curve.y[i]), 2.5, 2.5);
    painter.setBrush(Qt::NoBrush);
}

void PlotView::paint_crosses(QPainter& painter, const Curve& curve) const {
    constexpr double arm = 5.0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!std::isfinite(curve.y[i])) continue;
        const QPointF at = place(curve.x[i], curve.y[i]);
        painter.drawLine(at - QPointF(arm, arm), at + QPointF(arm, arm));
        painter.drawLine(at - QPointF(arm, -arm), at + QPointF(arm, -arm));
    }
}

// To the right above the curves, each in its colour.
void PlotView::paint_names(QPainter& painter) const {
    qreal right = frame().right();
    for (std::size_t c = chart_.curves.size(); c-- > 0;) {
        const QString name = translated(chart_.curves[c].name);
        const qreal wide = painter.fontMetrics().horizontalAdvance(name);
        painter.setPen(colour_of(chart_, c));
        painter.drawText(QRectF(right - wide, 4, wide, 18), Qt::AlignLeft, name);
        right -= wide + 12;
    }
}

// Their words stand in the first row that is free there.
void PlotView::paint_events(QPainter& painter) const {
    constexpr int row_height = 15;
    std::vector<qreal> row_ends;
    for (const PlotEvent& event : events_) {
        if (event.x < 0.0 || event.x > x_end_) continue;
        const QPointF foot = place(event.x, 0);
        const qreal wide = painter.fontMetrics().horizontalAdvance(event.text);
        const qreal left = std::min(foot.x() + 4, frame().right() - wide);
        std::size_t row = 0;
        while (row < row_ends.size() && row_ends[row] > left) ++row;
        if (row == row_ends.size()) row_ends.push_back(0);
        row_ends[row] = left + wide + 6;
        painter.setPen(QPen(event_line, 1.2, Qt::DashLine));
        painter.drawLine(foot, QPointF(foot.x(), frame().top()));
        painter.setPen(event_line);
        painter.drawText(
            QRectF(left, frame().top() + static_cast<qreal>(row) * row_height, wide, row_height),
            Qt::AlignLeft | Qt::AlignVCenter, event.text);
    }
}

PlotPanel::PlotPanel(QWidget* parent)
    : QWidget(parent),
      left_(new PlotView(this)),
      right_(new PlotView(this)),
      tear_(new PlotView(this)),
      save_picture_(new QPushButton(Words::tr("Save picture…"), this)),
      save_table_(new QPushButton(Words::tr("Save table…"), this)) {
    auto* row = new QHBoxLayout(this);
    row->addWidget(left_, 1);
    row->addWidget(right_, 1);
    row->addWidget(tear_, 1);
    auto* buttons = new QVBoxLayout;
    buttons->addWidget(save_picture_);
    buttons->addWidget(save_table_);
    buttons->addStretch(1);
    row->addLayout(buttons);
    connect(save_picture_, &QPushButton::clicked, this, [this] { on_save(true); });
    connect(save_table_, &QPushButton::clicked, this, [this] { on_save(false); });
    clear();
}

void PlotPanel::set_charts(const Chart& left, const Chart& right) {
    pressure_ = left;
    left_->set_chart(in_units(pressure_, units_));
    right_->set_chart(right);
    injected_ = true;
    show_some();
}

void PlotPanel::set_tear(const std::optional<Chart>& chart, std::vector<PlotEvent> events) {
    tears_ = chart.has_value();
    tear_->set_chart(chart.value_or(Chart{}));
    tear_->set_events(std::move(events));
    show_some();
}

// Empty charts of an injection stand where there is nothing else to show.
void PlotPanel::show_some() {
    left_->setVisible(injected_ || !tears_);
    right_->setVisible(injected_ || !tears_);
    tear_->setVisible(tears_);
    save_picture_->setEnabled(injected_ || tears_);
    save_table_->setEnabled(injected_ || tears_);
}

void PlotPanel::clear() {
    pressure_ = {Words::id("Pressure at the catheter"),
                 Words::id("Time (s)"),
                 Words::id("Pressure at the catheter (Pa)"),
                 {}};
    left_->set_chart(in_units(pressure_, units_));
    right_->set_chart({Words::id("Delivery"),
                       Words::id("Time (s)"),
                       Words::id("Drug that has passed the ends (%)"),
                       {}});
    set_time({});
    injected_ = false;
    set_tear({}, {});
}

void PlotPanel::set_units(FlowUnits units) {
    units_ = units;
    left_->set_chart(in_units(pressure_, units_));
}

void PlotPanel::set_time(std::optional<double> time_s) {
    left_->set_marker(time_s);
    right_->set_marker(time_s);
}

void PlotPanel::save_picture(const QString& file) {
    constexpr double scale = 3.0;  // fit for print
    QRect shown;
    for (const PlotView* view : {left_, right_, tear_})
        if (!view->isHidden()) shown |= view->geometry();
    QImage picture(shown.size() * scale, QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    render(&picture, QPoint(), QRegion(shown));
    write_file_atomically(to_path(file), [&](const std::filesystem::path& temporary) {
        if (!picture.save(to_text(temporary), "PNG")) {
            throw InputError(Words::id("the plots cannot be written"), file.toStdString(),
                             Words::id("choose a folder you may write to, on a disk with room"));
        }
    });
}

void PlotPanel::save_table(const QString& file) {
    std::string text;
    for (const PlotView* view : {left_, right_, tear_})
        if (!view->isHidden()) text += to_csv(view->chart());
    write_text_atomically(to_path(file), text);
}

}  // namespace hepatica
