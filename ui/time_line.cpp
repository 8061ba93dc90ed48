// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/time_line.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/words.h"

namespace hepatica {
namespace {

constexpr int key_step_ms = 100;
constexpr int page_step_ms = 2000;
constexpr int tick_height = 9;

int to_ms(double at_s) {
    return static_cast<int>(std::lround(1e3 * at_s));
}

}  // namespace

QString clock_text(double at_s) {
    const int tenths = static_cast<int>(std::floor(10.0 * at_s + 1e-6));
    return QString("%1:%2%3%4")
        .arg(tenths / 600)
        .arg(tenths / 10 % 60, 2, 10, QChar('0'))
        .arg(QLocale().decimalPoint())
        .arg(tenths % 10);
}

TimeLine::TimeLine(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, 0);
    setSingleStep(key_step_ms);
    setPageStep(page_step_ms);
    setAccessibleName(Words::tr("Time line of the recording"));
    setToolTip(Words::tr("Click or drag to go to a moment; the coloured ticks are what happened"));
}

void TimeLine::set_end(double end_s) {
    if (to_ms(end_s) != maximum()) setMaximum(to_ms(end_s));
}

void TimeLine::set_read(double read_s) {
    if (std::exchange(read_s_, read_s) != read_s) update();
}

void TimeLine::set_at(double at_s) {
    setValue(to_ms(at_s));
}

void TimeLine::set_ticks(std::vector<Tick> ticks) {
    if (ticks == ticks_) return;
    ticks_ = std::move(ticks);
    update();
}

double TimeLine::place_of(double at_s) const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    const double share = maximum() > 0 ? std::clamp(1e3 * at_s / maximum(), 0.0, 1.0) : 0.0;
    return 0.5 * handle + share * (width() - handle);
}

void TimeLine::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (to_ms(read_s_) < maximum()) {
        const double from = place_of(read_s_), to = place_of(end_s());
        painter.fillRect(QRectF(from, 0.25 * height(), to - from, 0.5 * height()),
                         QBrush(palette().color(QPalette::PlaceholderText), Qt::BDiagPattern));
    }
    for (const Tick& tick : ticks_)
        painter.fillRect(QRectF(place_of(tick.at_s) - 1.0, 0.0, 2.5, tick_height), tick.colour);
}

void TimeLine::go_to(double x) {
    const double from = place_of(0.0), to = place_of(end_s());
    if (to <= from) return;
    setValue(to_ms(std::clamp((x - from) / (to - from), 0.0, 1.0) * end_s()));
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QSlider::mousePressEvent(event);
    setSliderDown(true);
    go_to(event->position().x());
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) go_to(event->position().x());
}

void TimeLine::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) setSliderDown(false);
}

}  // namespace hepatica
