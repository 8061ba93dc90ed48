// SPDX-License-Identifier: GPL-3.0-or-later
// The dial between speed and accuracy with the error that it costs, what makes the steps, and what
// acts on the body.
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

// The panel is the only place that keeps what the user has chosen. A frame may be older than the
// last choice, so a frame changes the figures here, never a choice.
class QualityPanel : public QWidget {
  public:
    explicit QualityPanel(std::function<void(Command)> post, QWidget* parent = nullptr);

    void show_statistics(const FrameStatistics& statistics);

    // Tells a simulation that has just begun what the user had chosen before: a corrected patient
    // is played on as the former one was.
    void post_choices();

    // What makes the steps, by a name that BackEnds knows: shown as chosen, and told when the user
    // chooses another.
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
    QLabel* device_ = nullptr;
    QCheckBox* gravity_ = nullptr;
    QCheckBox* tether_ = nullptr;
    DecimalSpinBox* wall_ = nullptr;
};

// "1.2 %" from 0.012; as many digits as mean something.
QString percent_text(double share);

// What the error of a setting is measured against, for a tooltip.
QString words_of_reference(const std::string& reference);

}  // namespace hepatica
