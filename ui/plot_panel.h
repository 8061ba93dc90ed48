// SPDX-License-Identifier: GPL-3.0-or-later
// Panel with the charts of an injection and of a tear, with the drug's time and events marked;
// saved as picture or table. UI thread only.
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

struct PlotColours;

// An event at a place of the x axis.
struct PlotEvent {
    double x = 0.0;
    QString text;
    bool operator==(const PlotEvent&) const = default;
};

// A chart in the window's colours.
class PlotView : public QWidget {
  public:
    explicit PlotView(QWidget* parent = nullptr);

    void set_chart(const Chart& chart);
    const Chart& chart() const { return chart_; }
    // A vertical line at this place of the x axis; nullopt: none.
    void set_marker(std::optional<double> x);
    // Dashed lines with their texts beside them, as far as there is room.
    void set_events(std::vector<PlotEvent> events);
    const std::vector<PlotEvent>& events() const { return events_; }

    QSize sizeHint() const override { return {360, 190}; }

    // The titles as they are drawn, with their places: y axis, names of the curves, x axis. A long
    // y title takes two lines, and what does not fit is elided.
    struct Title {
        QRectF place;
        QString text;
        int curve = -1;  // index of the curve that it names; -1: an axis
    };
    std::vector<Title> titles() const;

    // The texts of events as they are drawn, with their places: each in the first row that is free,
    // none on another. Those for which there is no row are left out; their lines stay.
    struct EventText {
        QRectF place;
        QString text;
    };
    std::vector<EventText> event_texts() const;

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
    const PlotColours& colours() const;  // of the theme
    QRectF frame() const;
    QPointF place(double x, double y) const;

    static constexpr std::size_t most_dots = 12;
    Chart chart_;
    std::optional<double> marker_;
    std::vector<PlotEvent> events_;
    qreal head_ = 22.0;   // height of the titles above the frame
    double x_end_ = 1.0;  // axes begin at 0
    double y_end_ = 1.0;
};

class PlotPanel : public QWidget {
  public:
    explicit PlotPanel(QWidget* parent = nullptr);

    // The charts of an injection: pressure (left) and delivery (right).
    void set_charts(const Chart& left, const Chart& right);
    // Chart and events of a tear; nullopt: nothing tears, and the chart is hidden.
    void set_tear(const std::optional<Chart>& chart, std::vector<PlotEvent> events);
    void clear_injection();  // its charts are empty again
    void clear();
    // Units of pressures; effective at once for display and files.
    void set_units(FlowUnits units);
    const PlotView& tear() const { return *tear_; }
    const Chart& left() const { return left_->chart(); }
    const Chart& right() const { return right_->chart(); }
    // Marks this time on the drug's clock in both charts; nullopt: no mark.
    void set_time(std::optional<double> time_s);

    // Both throw InputError if the file cannot be written.
    void save_picture(const QString& file);
    void save_table(const QString& file);

    std::function<void(bool picture)> on_save;  // the user asked for a file

  private:
    void show_some();

    PlotView* left_;
    PlotView* right_;
    PlotView* tear_;
    Chart pressure_;  // the left chart in its original units
    FlowUnits units_ = FlowUnits::computed;
    bool injected_ = false, tears_ = false;
    QPushButton* save_picture_;
    QPushButton* save_table_;
};

// At most six round values from 0 to at least `largest` > 0; the last one is the axis' end.
std::vector<double> axis_ticks(double largest);

}  // namespace hepatica
