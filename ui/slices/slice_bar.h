// SPDX-License-Identifier: GPL-3.0-or-later
// The bar above the slices: grey window presets, display of the vessels over the CT, what a click
// measures, draws or paints, and what lies under the mouse.
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

// UI thread only; the scene must outlive it.
class SliceBar : public QWidget {
  public:
    // `correction` returns what a click would correct, in words.
    SliceBar(SliceScene& scene, std::function<QString()> correction, QWidget* parent = nullptr);

    // Shows what lies at this place, below the last message if clicks do more than move the
    // crosshair.
    void show_place(const Vec3& position_mm);
    // Shown until the mouse moves, or, if clicks do more than move the crosshair, until the next
    // message.
    void say(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;  // keys of the list

  private:
    void fill_presets();
    QWidget* opacity_slider();
    QWidget* centreline_choice();
    QWidget* segment_choice();
    QWidget* click_choice();
    QWidget* draw_button();
    QWidget* vessel_radius();
    QWidget* seed_button();
    void add_brush(QHBoxLayout& row);
    QWidget* tumour_choice();
    void follow_tumours();
    void follow_brush();
    void choose_click(int index);
    int chosen_click() const;
    QString guidance() const;
    QString guidance_of_seeds() const;
    void follow_click();
    void follow_window();

    SliceScene& scene_;
    std::function<QString()> correction_;
    QString said_;
    QComboBox* presets_;
    QLabel* place_;
    QComboBox* click_ = nullptr;  // what a click does
    QPushButton* draw_ = nullptr;
    QPushButton* reconstruct_ = nullptr;       // with the seeds
    QDoubleSpinBox* vessel_radius_ = nullptr;  // of the vessel that is drawn
    QDoubleSpinBox* radius_ = nullptr;         // of the brush
    QPushButton* remake_ = nullptr;
    QComboBox* tumour_ = nullptr;  // the one that is painted or erased
};

}  // namespace hepatica
