// SPDX-License-Identifier: GPL-3.0-or-later
// Panel for the dial between speed and accuracy with its expected error, the back end, and what
// acts on the vessels.
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "core/scene/frame.h"
#include "core/session/command.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;

namespace hepatica {

class DecimalSpinBox;

// UI thread only. Holds the user's choices: a frame may be older than the last choice, so it
// changes figures here but, except for the dial in automatic mode, no choice.
class QualityPanel : public QWidget {
  public:
    explicit QualityPanel(std::function<void(Command)> post, QWidget* parent = nullptr);

    void show_statistics(const FrameStatistics& statistics);

    struct Choices {
        bool automatic = true, gravity = false, tether = true;
        int dial = 50;  // [%]
        double wall_mm = 0.0;
    };
    Choices choices() const;
    // Shows the choices of a simulation that has them already.
    void show_choices(const Choices& choices);
    // Sends the user's choices to a new simulation, so that a corrected patient is played as
    // before.
    void post_choices();

    // Shows this back end, by a name that BackEnds knows, as chosen; on_back_end is called when the
    // user chooses another.
    void show_back_end(const std::string& name);
    std::function<void(const std::string& name)> on_back_end = [](const std::string&) {};

    // Whether what acts on the vessels may be changed.
    void allow_settings(bool allowed);

  private:
    QWidget* make_dial();
    QWidget* make_back_ends(QWidget* parent);
    QWidget* make_body();
    void show_error(const FrameStatistics& statistics);

    std::function<void(Command)> post_;
    QWidget* body_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    QSlider* dial_ = nullptr;
    QLabel* error_ = nullptr;
    QLabel* solver_ = nullptr;
    QComboBox* back_ends_ = nullptr;
    QLabel* now_ = nullptr;  // the heading of device_
    QLabel* device_ = nullptr;
    QCheckBox* gravity_ = nullptr;
    QCheckBox* tether_ = nullptr;
    DecimalSpinBox* wall_ = nullptr;
};

// "1.2 %" from 0.012, with as many digits as are meaningful.
QString percent_text(double share);

// What the error of a setting is measured against, for a tooltip.
QString words_of_reference(const std::string& reference);

}  // namespace hepatica
