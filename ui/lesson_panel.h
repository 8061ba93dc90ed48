// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainee sees of a lesson: the present step, how its goal and the limits stand, a hint on
// demand, and in the end whether it is passed, with the way to a report.
#pragma once

#include <QWidget>
#include <functional>

#include "core/lesson/lesson_run.h"
#include "ui/flow_units.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace hepatica {

class LessonPanel : public QWidget {
  public:
    struct Ways {
        std::function<void()> again;      // from the beginning
        std::function<void()> leave;      // back to free play
        std::function<void()> report;     // of the attempt
        std::function<void()> look_back;  // on the attempt
        std::function<void()> attempts;   // all of them at this lesson
        std::function<void()> next = {};  // the lesson of the course that comes after it
        std::function<void(const QString&)> name = {};  // the trainee is called so from now on
    };

    explicit LessonPanel(Ways ways, QWidget* parent = nullptr);

    // From here on this lesson is shown. `doubts`: whether it fits the patient, a sentence each.
    void begin(const Lesson& lesson, const std::vector<std::string>& doubts = {});
    // The lesson that comes after it in its course; empty: none does.
    void set_next(const std::string& lesson);
    void set_name(const QString& name);
    // For what is shown from the next standing on.
    void set_units(FlowUnits units) { units_ = units; }
    // `clock_stands`: nothing was done yet, or nothing since the end.
    void show_standing(const LessonStanding& standing, bool clock_stands = false);

  private:
    QLayout* make_name();
    void show_step(const LessonStanding& standing);
    void show_end(const LessonStanding& standing);

    Lesson lesson_;
    FlowUnits units_ = FlowUnits::computed;
    std::size_t hinted_step_ = static_cast<std::size_t>(-1);  // whose hint is open
    std::size_t shown_step_ = 0;
    QLabel* title_;
    QLabel* about_;
    QLabel* doubts_;
    QLabel* clock_;
    QLabel* step_;
    QLabel* goal_;
    QProgressBar* hold_;
    QLabel* hint_;
    QPushButton* hint_button_;
    QLabel* limits_;
    QLabel* pass_;
    QLabel* end_;
    QPushButton* next_;
    QPushButton* report_;
    QPushButton* look_back_;
    QPushButton* attempts_;
    QLineEdit* name_;
    std::string next_lesson_;
};

}  // namespace hepatica
