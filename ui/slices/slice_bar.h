// SPDX-License-Identifier: GPL-3.0-or-later
// Above the slices: presets of the grey window, how the vessels are drawn over the CT, what a click
// measures or draws, and what lies under the mouse.
#pragma once

#include <QWidget>

#include "ui/slices/slice_scene.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace hepatica {

// UI thread; the scene must outlive it.
class SliceBar : public QWidget {
  public:
    explicit SliceBar(SliceScene& scene, QWidget* parent = nullptr);

    void show_place(const Vec3& position_mm);
    void say(const QString& text);  // until the mouse moves on

  private:
    QWidget* segment_choice();
    QWidget* click_choice();
    QWidget* draw_button();
    void follow_click();
    void follow_window();

    SliceScene& scene_;
    QComboBox* presets_;
    QLabel* place_;
    QComboBox* click_ = nullptr;  // what a click is for
    QPushButton* draw_ = nullptr;
};

}  // namespace hepatica
