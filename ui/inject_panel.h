// SPDX-License-Identifier: GPL-3.0-or-later
// Panel for the next injection and the drug's clock: play, pause, time, speed. Whether the drug
// runs is taken from the newest frame.
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

// UI thread only.
class InjectPanel : public QWidget {
  public:
    explicit InjectPanel(std::function<void(Command)> post, QWidget* parent = nullptr);

    // The injection set in the panel, at this point (mm).
    InjectDrug injection_at(const Vec3& point_mm) const;

    // Follows the simulation; cheap enough for every frame.
    void show_drug(const DrugView& drug);
    // What lies under the mouse; empty for nothing.
    void show_hover(const QString& text);
    void toggle_playing();
    // Units that are shown and typed; an injection is always given in g/s.
    void set_units(FlowUnits units);
    FlowUnits units() const { return units_; }
    // As set_units(), by the user: here or in the menu.
    void choose_units(FlowUnits units);
    std::function<void(FlowUnits)> on_units;  // called after the user chose other units
    // A simulation begins. In free play the user's chosen speed is sent to it; lessons and reviews
    // have a speed of their own.
    void begin_play(bool free);
    // A lesson begins: chooses the first preset with this second phase, as it asks for; unknown or
    // empty: none. Free play and the next lesson begin with the injection that was set before.
    void choose_drug(const std::string& second_phase);
    // Whether the drug's clock and speed may be set.
    void allow_settings(bool allowed);

  private:
    void choose_preset(int index);
    void give_back();              // what was set before a lesson
    double density_g_mm3() const;  // of the injected mixture
    double mass_flow_g_s() const;
    void set_mass_flow(double g_s);
    void show_flow_range();
    void show_mass_flow();
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
    QLabel* mass_flow_ = nullptr;  // beside the volume flow
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
    QLabel* pace_ = nullptr;  // explains the speed
    DrugView drug_;           // of the newest frame
    // Time requested by the slider and not yet shown by a frame; until then frames do not move the
    // slider.
    std::optional<double> asked_time_s_;
    std::optional<double> asked_speed_;  // likewise for the speed field
    double chosen_speed_;                // by the user in free play
    struct Chosen {
        int preset, model;
        double void_fraction, mass_flow_g_s, viscosity_mpa_s;
    };
    std::optional<Chosen> before_lesson_;  // while a lesson is played or looked back on
    bool free_play_ = true;
    bool settings_allowed_ = true;
};

}  // namespace hepatica
