// SPDX-License-Identifier: GPL-3.0-or-later
// Panel for the tool in the hand and the force on it, what the vessels touch, whether they tear,
// and how far they are torn.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/flow_units.h"
#include "ui/tool_hand.h"

class QCheckBox;
class QLabel;

namespace hepatica {

class DecimalSpinBox;

// UI thread only.
class ToolPanel : public QWidget {
  public:
    struct Callbacks {
        std::function<void(const ToolSize&)> resize;
        std::function<void(const UseTear&)> use_tear;
        std::function<void(const UseContact&)> use_contact;
        std::function<void(bool)> show_warnings;
        // The user chose what vessels touch in free play.
        std::function<void(const UseContact&)> contact_chosen = [](const UseContact&) {};
    };
    explicit ToolPanel(Callbacks callbacks, QWidget* parent = nullptr);

    ToolSize size() const;
    // The chosen tear factor, with tearing switched on.
    UseTear tear() const;
    // What vessels touch in free play until the user chooses otherwise.
    void set_wanted_contact(const UseContact& contact) { wanted_contact_ = contact; }
    // Share of the strength that remains along a drawn line, 0 to 1.
    double cut_line_strength() const;
    bool shows_warnings() const;
    void show_tear(const std::optional<TearView>& tear);
    // Shows what the vessels of a frame touch, unless the frame is older than the last choice.
    void show_contact(const Frame& frame);
    void set_units(FlowUnits units);  // of the bleeding
    // A simulation begins. In free play vessels touch and tear as the user chose; a lesson sets
    // that itself.
    void begin_play(bool free);
    // A free play is shown again that has its settings.
    void go_on();
    // Shows the tear factor of a lesson's scene until free play begins; none: as the user chose.
    void show_tear_factor(std::optional<double> of_lesson);
    // Whether contact and tearing may be changed.
    void allow_settings(bool allowed);
    // The kind is empty if there is no tool. `line_help`: how lines are drawn, while the mouse
    // draws them.
    void show_kind(const std::string& kind, const QString& line_help = {});
    // The force on the tool; without a tool, that of the pulling hand.
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
    std::optional<double> wanted_tear_factor_;   // likewise, while a lesson's is shown
    std::optional<UseContact> wanted_contact_;   // likewise
    std::optional<UseContact> asked_;            // no frame shows it yet
    std::uint64_t asked_at_ = 0, shown_at_ = 0;  // steps of shown frames
    FlowUnits units_ = FlowUnits::computed;
};

}  // namespace hepatica
