// SPDX-License-Identifier: GPL-3.0-or-later
// Slider over the time of a play, with a tick at each event, and a bar over what is not read yet. A
// click goes there; arrow keys step by 0.1 s, page keys by 2 s, Home and End go to the ends. UI
// thread only.
#pragma once

#include <QColor>
#include <QSlider>
#include <vector>

namespace hepatica {

class TimeLine : public QSlider {
  public:
    struct Tick {
        double at_s = 0.0;
        QColor colour;
        bool operator==(const Tick&) const = default;
    };

    explicit TimeLine(QWidget* parent = nullptr);

    void set_end(double end_s);
    double end_s() const { return 1e-3 * maximum(); }
    // What is there to be shown; the rest is barred.
    void set_read(double read_s);
    double read_s() const { return read_s_; }
    void set_at(double at_s);
    double at_s() const { return 1e-3 * value(); }
    void set_ticks(std::vector<Tick> ticks);
    const std::vector<Tick>& ticks() const { return ticks_; }
    // Horizontal position of a moment, in points from the left.
    double place_of(double at_s) const;

    QSize sizeHint() const override { return {400, 34}; }
    QSize minimumSizeHint() const override { return {120, 34}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void go_to(double x);

    std::vector<Tick> ticks_;
    double read_s_ = 0.0;
};

// "1:02.5": minutes, seconds and tenths.
QString clock_text(double at_s);

}  // namespace hepatica
