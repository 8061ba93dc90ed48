// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of an injection beside the picture, with the drug's clock in them; saved as picture or
// table.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "render/chart.h"

class QPainter;
class QPushButton;

namespace hepatica {

// One chart in the window's own colours.
class PlotView : public QWidget {
  public:
    explicit PlotView(QWidget* parent = nullptr);

    void set_chart(const Chart& chart);
    const Chart& chart() const { return chart_; }
    // A vertical line at this place of the x axis; none where it is empty.
    void set_marker(std::optional<double> x);

    QSize sizeHint() const override { return {360, 190}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paint_axes(QPainter& painter) const;
    void paint_curves(QPainter& painter) const;
    QRectF frame() const;
    QPointF place(double x, double y) const;

    Chart chart_;
    std::optional<double> marker_;
    double x_end_ = 1.0;  // axes begin at 0
    double y_end_ = 1.0;
};

class PlotPanel : public QWidget {
  public:
    explicit PlotPanel(QWidget* parent = nullptr);

    void set_charts(const Chart& left, const Chart& right);
    void clear();
    const Chart& left() const { return left_->chart(); }
    const Chart& right() const { return right_->chart(); }
    void set_time(std::optional<double> time_s);

    // Throw InputError where the file cannot be written.
    void save_picture(const QString& file);
    void save_table(const QString& file);

    std::function<void(bool picture)> on_save;  // the user asked for a file

  private:
    PlotView* left_;
    PlotView* right_;
    QPushButton* save_picture_;
    QPushButton* save_table_;
};

// Up to six round values from 0 to at least `largest` > 0, the last one the axis' end.
std::vector<double> axis_ticks(double largest);

}  // namespace hepatica
