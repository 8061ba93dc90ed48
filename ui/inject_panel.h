// SPDX-License-Identifier: GPL-3.0-or-later
// How the next injection is made, and the drug's clock: play, pause, back and forth, speed. Whether
// the drug runs is what the newest frame says; the panel keeps no state of its own.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "core/scene/frame.h"
#include "core/session/command.h"
#include "ui/flow_units.h"

class QComboBox;
class QLabel;
class QLayout;
class QPushButton;
class QSlider;

namespace hepatica {

class DecimalSpinBox;

class InjectPanel : public QWidget {
  public:
    explicit InjectPanel(std::function<void(Command)> post, QWidget* parent = nullptr);

    // The injection as set in the panel, at this point.
    InjectDrug injection_at(const Vec3& point_mm) const;

    // Follows the simulation; cheap enough for every frame.
    void show_drug(const DrugView& drug);
    // What lies under the mouse; empty for nothing.
    void show_hover(const QString& text);
    void toggle_playing();
    // Of what is shown and typed; an injection is given in grams per second all the same.
    void set_units(FlowUnits units);
    std::function<void(FlowUnits)> on_units;  // the user chose others, which are set already
    // A simulation has begun. In free play it is told what the user had chosen there before; a
    // lesson and a review have a speed of their own.
    void begin_play(bool free);
    // The one of this second phase, as a lesson asks for it; empty: what is chosen stays.
    void choose_drug(const std::string& second_phase);
    // Whether the drug's clock and its speed may be set.
    void allow_settings(bool allowed);

  private:
    void choose_preset(int index);
    double density_g_mm3() const;  // of what is injected
    double mass_flow_g_s() const;
    void show_flow_range();
    QWidget* make_settings();
    QWidget* make_clock();
    QLayout* make_units();
    void ask_for_time(double time_s);
    void ask_for_speed(double factor);
    void show_speed(double factor);
    void show_pace();

    std::function<void(Command)> post_;
    QComboBox* preset_ = nullptr;
    QLabel* source_ = nullptr;
    DecimalSpinBox* flow_ = nullptr;  // in units_
    QLabel* flow_label_ = nullptr;
    QComboBox* units_choice_ = nullptr;
    FlowUnits units_ = FlowUnits::computed;
    DecimalSpinBox* void_fraction_ = nullptr;
    DecimalSpinBox* viscosity_ = nullptr;
    QComboBox* model_ = nullptr;
    QLabel* hover_ = nullptr;
    QPushButton* play_ = nullptr;
    QSlider* time_ = nullptr;
    QLabel* time_label_ = nullptr;
    DecimalSpinBox* speed_ = nullptr;
    QLabel* pace_ = nullptr;  // what the speed means
    DrugView drug_;           // of the newest frame
    // What the slider asked for and no frame has shown yet: until then frames do not move it.
    std::optional<double> asked_time_s_;
    std::optional<double> asked_speed_;  // likewise, of the field
    double chosen_speed_;                // by the user in free play
    bool free_play_ = true;
    bool settings_allowed_ = true;
};

}  // namespace hepatica
