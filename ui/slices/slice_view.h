// SPDX-License-Identifier: GPL-3.0-or-later
// A slice of the patient's CT with the vessels over it, and its mouse and keyboard control:
//
//   left click or drag    the crosshair      wheel                the slice (Shift: ten)
//   right drag            grey: width, level middle drag          pan
//   Ctrl + wheel          zoom               double-click         enlarge, and back
//   arrow keys            the crosshair      Page up, Page down   the slice
// Corrections: a left click, or Enter at the crosshair, corrects the vessel there.
// Painting: a left drag leads the brush, Enter dabs at the crosshair, + and - change the radius,
// Delete takes the last stroke back, Escape all of them.
// Measuring: a left click, or Enter at the crosshair, sets a point; Delete removes the last one,
// Escape ends it.
// Drawing a vessel: likewise, the crosshair follows each click, and Enter at the last place draws
// the vessel.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "render/label_places.h"
#include "ui/slices/segment_overlay.h"
#include "ui/slices/slice_scene.h"

namespace hepatica {

// UI thread only; the scene must outlive it.
class SliceView : public QWidget {
  public:
    SliceView(SliceScene& scene, SliceDirection direction, QWidget* parent = nullptr);

    SliceDirection direction() const { return direction_; }
    // Index of the slice through the crosshair; -1 without a CT.
    int slice() const;
    // Patient coordinates (mm) to widget coordinates, projected onto the slice, and back.
    QPointF place_of(const Vec3& position_mm) const;
    Vec3 to_mm(const QPointF& place) const;
    // The image below crosshair and letters, one pixel per voxel; null without a CT.
    const QImage& picture();

    // Bars cover this many points at the top and bottom; text is kept clear of them.
    void keep_clear(int top, int bottom);
    // The area for text.
    QRectF room_for_words() const;
    // Where the values of measurements were painted last.
    const std::vector<QRectF>& measure_labels() const { return measure_labels_; }
    // Where the segments' numbers were painted last.
    struct NumberLabel {
        int segment = 0;
        QRectF place;
    };
    const std::vector<NumberLabel>& number_labels() const { return number_labels_; }

    void on_hover(std::function<void(const Vec3&)> tell) { hover_ = std::move(tell); }
    // Receives the result of a measurement, or why a click had none.
    void on_say(std::function<void(const QString&)> say) { say_ = std::move(say); }
    // Receives the place in the CT where something is to be corrected.
    void on_correct(std::function<void(const Vec3&)> correct) { correct_ = std::move(correct); }
    void on_double_click(std::function<void()> tell) { double_click_ = std::move(tell); }

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    SliceStack stack() const { return {scene_.ct().grid, direction_}; }
    void show_whole_of_another_ct();
    // Moves the crosshair by whole slices.
    void step(int slices);
    // Moves the crosshair within its slice, by voxels.
    void nudge(int columns, int rows);
    double points_per_mm() const;
    bool sets_points_with(const QKeyEvent& event) const;
    void measure_by_key(int key);
    void draw_by_key(int key);
    void correct_by_key(int key);
    void brush_by_key(int key);
    void seed_by_key(int key);
    void set_place(const Vec3& position_mm);
    bool measuring() const { return scene_.measurements().chosen().has_value(); }
    bool drawing() const { return scene_.pen().taken(); }
    // Whether a click does more than move the crosshair.
    bool works() const {
        return measuring() || drawing() || scene_.corrects() || brushing() || seeding();
    }
    bool seeding() const { return scene_.seeds().taken().has_value(); }
    bool brushing() const { return scene_.brushing(); }
    void measure(const Vec3& position_mm);
    void say(const std::string& text) const;
    bool is_here(const Vec3& point_mm, double reach_mm) const;
    void paint_line(QPainter& painter, const QPolygonF& line) const;
    void paint_pen(QPainter& painter) const;
    void paint_seeds(QPainter& painter) const;
    void paint_brush(QPainter& painter) const;
    void paint_measurement(QPainter& painter, const Measurement& measurement, LabelPlaces& labels);
    void paint_label(QPainter& painter, const QPointF& at, const QString& text,
                     LabelPlaces& labels);
    void paint_measurements(QPainter& painter);
    QRectF room_for_labels() const;
    static void write_outlined(QPainter& painter, const QRectF& box, Qt::Alignment where,
                               const QString& text, const QColor& colour);
    void paint_segment_numbers(QPainter& painter);
    void paint_centrelines(QPainter& painter) const;
    void paint_pointed_out(QPainter& painter) const;
    void paint_crosshair(QPainter& painter) const;
    void paint_words(QPainter& painter) const;
    void paint_focus(QPainter& painter) const;

    SliceScene& scene_;
    SliceDirection direction_;
    int covered_top_ = 0, covered_bottom_ = 0;
    std::function<void(const Vec3&)> hover_;
    std::function<void(const QString&)> say_;
    std::optional<QPointF> mouse_;  // over the slice while there is a brush
    std::function<void(const Vec3&)> correct_;
    std::function<void()> double_click_;
    QImage picture_;
    std::vector<SegmentNumber> segment_numbers_;  // places in pixels of picture_
    // Key of picture_: scrolling in one direction does not repaint the other two.
    std::uint64_t picture_version_ = 0;
    int picture_slice_ = -1;
    std::weak_ptr<const Volume> seen_ct_;  // that zoom and shift belong to
    double zoom_ = 1.0;                    // 1: the slice fits the widget
    QPointF shift_;                        // of the slice's centre from the widget's
    std::vector<QRectF> measure_labels_;
    std::vector<NumberLabel> number_labels_;
    QPointF last_;                             // last mouse position while a button is down
    std::optional<Vec3> crosshair_before_mm_;  // the last press of the left button
    double wheel_rest_ = 0;                    // unused part of a wheel notch
};

}  // namespace hepatica
