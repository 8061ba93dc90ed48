// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the tool in the hand, and what it feels; what the vessels touch; whether they tear,
// and how they are torn.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/flow_units.h"
#include "ui/tool_hand.h"

class QCheckBox;
class QLabel;

namespace hepatica {

class DecimalSpinBox;

class ToolPanel : public QWidget {
  public:
    struct Callbacks {
        std::function<void(const ToolSize&)> resize;
        std::function<void(const UseTear&)> use_tear;
        std::function<void(const UseContact&)> use_contact;
        std::function<void(bool)> show_warnings;
        // What vessels shall touch in free play from now on.
        std::function<void(const UseContact&)> contact_chosen = [](const UseContact&) {};
    };
    explicit ToolPanel(Callbacks callbacks, QWidget* parent = nullptr);

    ToolSize size() const;
    // The tear factor that is chosen, with tearing switched on.
    UseTear tear() const;
    // What vessels touch in free play until the user chooses otherwise.
    void set_wanted_contact(const UseContact& contact) { wanted_contact_ = contact; }
    double cut_line_strength() const;
    bool shows_warnings() const;
    void show_tear(const std::optional<TearView>& tear);
    // What the vessels of a frame touch; not yet where it is older than what was chosen last.
    void show_contact(const Frame& frame);
    void set_units(FlowUnits units);  // of the bleeding
    // A simulation has begun. In free play vessels touch and tear where the user wants it; a lesson
    // says itself whether they do.
    void begin_play(bool free);
    // Whether touching and tearing may be switched.
    void allow_settings(bool allowed);
    // Empty where no tool is in the hand.
    void show_kind(const std::string& kind);
    // The force on the tool; without a tool, that of the hand that pulls.
    void show_force(const std::optional<ToolView>& tool, const std::optional<GrabView>& hand);

  private:
    QWidget* make_size();
    QWidget* make_contact();
    void choose_contact();
    UseContact contact() const;
    QWidget* make_tear();

    DecimalSpinBox* radius_ = nullptr;
    DecimalSpinBox* length_ = nullptr;
    QLabel* force_ = nullptr;
    QLabel* grip_ = nullptr;
    QLabel* help_ = nullptr;
    Callbacks callbacks_;
    QCheckBox* touch_each_other_ = nullptr;
    QCheckBox* obstacles_ = nullptr;
    DecimalSpinBox* friction_ = nullptr;
    QCheckBox* tears_ = nullptr;
    QCheckBox* warnings_ = nullptr;
    DecimalSpinBox* tear_factor_ = nullptr;
    DecimalSpinBox* line_strength_ = nullptr;
    QLabel* torn_ = nullptr;
    std::optional<TearView> shown_tear_;
    bool free_play_ = true;
    bool allowed_ = true;
    bool wanted_tear_ = false;                   // in free play
    std::optional<UseContact> wanted_contact_;   // likewise
    std::optional<UseContact> asked_;            // which no frame shows yet
    std::uint64_t asked_at_ = 0, shown_at_ = 0;  // steps of the frames that were shown
    FlowUnits units_ = FlowUnits::computed;
};

}  // namespace hepatica
