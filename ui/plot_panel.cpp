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
#include "ui/theme.h"
#include "ui/words.h"

namespace hepatica {
namespace {

QColor grid_line(const QPalette& palette) {
    QColor faint = palette.color(QPalette::Text);
    faint.setAlphaF(0.2f);
    return faint;
}

// Curves of points alone, which mark failures, are red like events.
QColor colour_of(const Chart& chart, std::size_t curve, const PlotColours& colours) {
    if (chart.curves[curve].points_only) return colours.event;
    return colours.curves.at(curve % colours.curves.size());
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

constexpr qreal side_margin = 4.0;
constexpr qreal title_height = 18.0;

// One line, or two of which the second is elided if it is too long.
QStringList in_lines(const QString& text, const QFontMetrics& letters, qreal wide) {
    const int most = static_cast<int>(wide);
    if (letters.horizontalAdvance(text) <= most) return {text};
    qsizetype end = text.lastIndexOf(' ');
    while (end > 0 && letters.horizontalAdvance(text.left(end)) > most)
        end = text.lastIndexOf(' ', end - 1);
    if (end <= 0) return {letters.elidedText(text, Qt::ElideRight, most)};
    return {text.left(end), letters.elidedText(text.mid(end + 1), Qt::ElideRight, most)};
}

// Bottom of all titles except the last, which stands at the foot.
qreal head_of(const std::vector<PlotView::Title>& titles) {
    qreal end = 0.0;
    for (std::size_t i = 0; i + 1 < titles.size(); ++i)
        end = std::max(end, titles[i].place.bottom());
    return end;
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

const PlotColours& PlotView::colours() const {
    return plot_colours_on(palette().color(QPalette::Base));
}

QRectF PlotView::frame() const {
    const qreal top = head_ + 4.0;
    return QRectF(58, top, width() - 74.0, height() - 38.0 - top);
}

QPointF PlotView::place(double x, double y) const {
    const QRectF area = frame();
    return {area.left() + area.width() * x / x_end_, area.bottom() - area.height() * y / y_end_};
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    head_ = head_of(titles());
    paint_axes(painter);
    paint_events(painter);  // before the curves, which are never hidden
    if (!chart_.curves.empty()) paint_curves(painter);
    paint_titles(painter);
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
}

void PlotView::paint_curves(QPainter& painter) const {
    for (std::size_t c = 0; c < chart_.curves.size(); ++c) {
        const Curve& curve = chart_.curves[c];
        painter.setPen(QPen(colour_of(chart_, c, colours()), 2.0));
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
    painter.setPen(QPen(colours().time, 1.5));
    painter.drawLine(place(*marker_, 0), place(*marker_, y_end_));
}

// Each of few points is marked, and a single one has no line.
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

// To the right of the y axis title if there is room, else in rows of their own.
std::vector<PlotView::Title> PlotView::names_below(qreal top) const {
    std::vector<Title> names;
    const QFontMetrics letters = fontMetrics();
    const qreal widest = width() - 2.0 * side_margin;
    qreal right = width() - side_margin;
    for (std::size_t c = chart_.curves.size(); c-- > 0;) {
        const QString name = letters.elidedText(translated(chart_.curves[c].name), Qt::ElideRight,
                                                static_cast<int>(widest));
        const qreal wide = letters.horizontalAdvance(name);
        if (right - wide < side_margin) {
            right = width() - side_margin;
            top += title_height;
        }
        names.push_back({QRectF(right - wide, top, wide, title_height), name, static_cast<int>(c)});
        right -= wide + 12.0;
    }
    return names;
}

std::vector<PlotView::Title> PlotView::titles() const {
    const qreal wide = width() - 2.0 * side_margin;
    std::vector<Title> titles;
    qreal top = 2.0;
    for (const QString& line : in_lines(translated(chart_.y_label), fontMetrics(), wide)) {
        titles.push_back({QRectF(side_margin, top, wide, title_height), line, -1});
        top += title_height;
    }
    if (chart_.curves.size() > 1) {
        const qreal beside = titles.size() == 1
                                 ? side_margin + fontMetrics().horizontalAdvance(titles[0].text)
                                 : wide;
        std::vector<Title> names = names_below(2.0);
        const bool fits = std::ranges::all_of(names, [&](const Title& name) {
            return name.place.top() < title_height && name.place.left() > beside + 12.0;
        });
        if (!fits) names = names_below(top);
        titles.insert(titles.end(), names.begin(), names.end());
    }
    const QString below = fontMetrics().elidedText(translated(chart_.x_label), Qt::ElideRight,
                                                   static_cast<int>(wide));
    titles.push_back({QRectF(side_margin, height() - 20.0, wide, 16.0), below, -1});
    return titles;
}

void PlotView::paint_titles(QPainter& painter) const {
    const std::vector<Title> all = titles();
    for (const Title& title : all) {
        painter.setPen(title.curve < 0
                           ? palette().color(QPalette::Text)
                           : colour_of(chart_, static_cast<std::size_t>(title.curve), colours()));
        const bool is_x = &title == &all.back();
        painter.drawText(title.place, is_x ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter,
                         title.text);
    }
}

std::vector<PlotView::EventText> PlotView::event_texts() const {
    constexpr qreal apart = 6.0;
    constexpr double most_rows = 3.0;
    const QRectF area = frame();
    const QFontMetrics letters = fontMetrics();
    const qreal row_height = letters.height();
    const double fit = std::clamp(area.height() / row_height, 0.0, most_rows);
    const auto rows = static_cast<std::size_t>(fit);
    std::vector<EventText> texts;
    std::vector<qreal> row_ends(rows, 0.0);
    for (const PlotEvent& event : events_) {
        if (event.x < 0.0 || event.x > x_end_) continue;
        const QString text =
            letters.elidedText(event.text, Qt::ElideRight, static_cast<int>(area.width()));
        const qreal wide = letters.horizontalAdvance(text);
        const qreal left = std::min(place(event.x, 0).x() + 4.0, area.right() - wide);
        const auto row = std::ranges::find_if(row_ends, [left](qreal end) { return end <= left; });
        if (row == row_ends.end()) continue;
        *row = left + wide + apart;
        const auto above = static_cast<qreal>(row - row_ends.begin());
        texts.push_back({QRectF(left, area.top() + above * row_height, wide, row_height), text});
    }
    return texts;
}

// Texts stand on a ground, so that no event's line strikes them through.
void PlotView::paint_events(QPainter& painter) const {
    painter.setPen(QPen(colours().event, 1.2, Qt::DashLine));
    for (const PlotEvent& event : events_)
        if (event.x >= 0.0 && event.x <= x_end_)
            painter.drawLine(place(event.x, 0), place(event.x, y_end_));
    painter.setPen(colours().event);
    for (const EventText& event : event_texts()) {
        painter.fillRect(event.place, palette().base());
        painter.drawText(event.place, Qt::AlignLeft | Qt::AlignVCenter, event.text);
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

// Empty charts of an injection are shown if there is nothing else.
void PlotPanel::show_some() {
    left_->setVisible(injected_ || !tears_);
    right_->setVisible(injected_ || !tears_);
    tear_->setVisible(tears_);
    save_picture_->setEnabled(injected_ || tears_);
    save_table_->setEnabled(injected_ || tears_);
}

void PlotPanel::clear() {
    clear_injection();
    set_tear({}, {});
}

void PlotPanel::clear_injection() {
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
    show_some();
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
    constexpr double scale = 3.0;  // resolution for print
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
