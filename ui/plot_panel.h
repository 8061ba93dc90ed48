// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of an injection and of a tear beside the picture, with the drug's clock and what
// happened in them; saved as picture or table.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "render/chart.h"
#include "ui/flow_units.h"

class QPainter;
class QPushButton;

namespace hepatica {

// Something that happened at a place of the x axis.
struct PlotEvent {
    double x = 0.0;
    QString text;
    bool operator==(const PlotEvent&) const = default;
};

// One chart in the window's own colours.
class PlotView : public QWidget {
  public:
    explicit PlotView(QWidget* parent = nullptr);

    void set_chart(const Chart& chart);
    const Chart& chart() const { return chart_; }
    // A vertical line at this place of the x axis; none where it is empty.
    void set_marker(std::optional<double> x);
    // Dashed lines with their words beside them.
    void set_events(std::vector<PlotEvent> events);
    const std::vector<PlotEvent>& events() const { return events_; }

    QSize sizeHint() const override { return {360, 190}; }

    // The words above the curves and below them as they are drawn, each with its place: the y
    // axis' title, the curves' names, the x axis' title. Too long ones go on in a second line, and
    // what that does not hold either is cut with an ellipsis.
    struct Title {
        QRectF place;
        QString text;
        int curve = -1;  // whose name it is; -1: of an axis
    };
    std::vector<Title> titles() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paint_axes(QPainter& painter) const;
    void paint_curves(QPainter& painter) const;
    void paint_dots(QPainter& painter, const Curve& curve) const;
    void paint_crosses(QPainter& painter, const Curve& curve) const;
    void paint_titles(QPainter& painter) const;
    void paint_events(QPainter& painter) const;
    std::vector<Title> names_below(qreal top) const;
    QRectF frame() const;
    QPointF place(double x, double y) const;

    static constexpr std::size_t most_dots = 12;
    Chart chart_;
    std::optional<double> marker_;
    std::vector<PlotEvent> events_;
    qreal head_ = 22.0;   // height of what stands above the frame
    double x_end_ = 1.0;  // axes begin at 0
    double y_end_ = 1.0;
};

class PlotPanel : public QWidget {
  public:
    explicit PlotPanel(QWidget* parent = nullptr);

    void set_charts(const Chart& left, const Chart& right);
    // The chart of a tear and what happened in it; none: nothing tears, and it is not shown.
    void set_tear(const std::optional<Chart>& chart, std::vector<PlotEvent> events);
    void clear();
    // Of pressures; what is shown and saved follows at once.
    void set_units(FlowUnits units);
    const PlotView& tear() const { return *tear_; }
    const Chart& left() const { return left_->chart(); }
    const Chart& right() const { return right_->chart(); }
    void set_time(std::optional<double> time_s);

    // Throw InputError where the file cannot be written.
    void save_picture(const QString& file);
    void save_table(const QString& file);

    std::function<void(bool picture)> on_save;  // the user asked for a file

  private:
    void show_some();

    PlotView* left_;
    PlotView* right_;
    PlotView* tear_;
    Chart pressure_;  // the left one as it was given
    FlowUnits units_ = FlowUnits::computed;
    bool injected_ = false, tears_ = false;
    QPushButton* save_picture_;
    QPushButton* save_table_;
};

// Up to six round values from 0 to at least `largest` > 0, the last one the axis' end.
std::vector<double> axis_ticks(double largest);

}  // namespace hepatica
