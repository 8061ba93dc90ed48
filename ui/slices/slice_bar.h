// SPDX-License-Identifier: GPL-3.0-or-later
// Above the slices: presets of the grey window, how the vessels are drawn over the CT, what a click
// measures or draws, and what lies under the mouse.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/slices/slice_scene.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace hepatica {

// UI thread; the scene must outlive it.
class SliceBar : public QWidget {
  public:
    // `correction`: what a click would correct.
    SliceBar(SliceScene& scene, std::function<QString()> correction, QWidget* parent = nullptr);

    // What lies there, below what was said last while clicks are for something.
    void show_place(const Vec3& position_mm);
    // Until the mouse moves on, or while clicks are for something until the next word about it.
    void say(const QString& text);

  private:
    QWidget* segment_choice();
    QWidget* click_choice();
    QWidget* draw_button();
    void add_brush(QHBoxLayout& row);
    QWidget* tumour_choice();
    void follow_tumours();
    void follow_brush();
    void choose_click(int index);
    int chosen_click() const;
    QString guidance() const;
    void follow_click();
    void follow_window();

    SliceScene& scene_;
    std::function<QString()> correction_;
    QString said_;
    QComboBox* presets_;
    QLabel* place_;
    QComboBox* click_ = nullptr;  // what a click is for
    QPushButton* draw_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;  // of the brush
    QPushButton* remake_ = nullptr;
    QComboBox* tumour_ = nullptr;  // which one is painted or erased
};

}  // namespace hepatica
