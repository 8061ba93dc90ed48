// SPDX-License-Identifier: GPL-3.0-or-later
// Above the slices: presets of the grey window, how the vessels are drawn over the CT, what a click
// measures, and what lies under the mouse.
#pragma once

#include <QWidget>

#include "ui/slices/slice_scene.h"

class QComboBox;
class QLabel;

namespace hepatica {

// UI thread; the scene must outlive it.
class SliceBar : public QWidget {
  public:
    explicit SliceBar(SliceScene& scene, QWidget* parent = nullptr);

    void show_place(const Vec3& position_mm);
    void say(const QString& text);  // until the mouse moves on

  private:
    QWidget* segment_choice();
    QWidget* measuring_choice();
    void follow_window();

    SliceScene& scene_;
    QComboBox* presets_;
    QLabel* place_;
};

}  // namespace hepatica
