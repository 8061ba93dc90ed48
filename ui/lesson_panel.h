// SPDX-License-Identifier: GPL-3.0-or-later
// Panel of a lesson for the trainee: the present step, how its goal and the limits stand, a hint on
// demand, and at the end the result and a way to the report.
#pragma once

#include <QWidget>
#include <functional>
#include <span>

#include "core/lesson/lesson_run.h"
#include "ui/flow_units.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace hepatica {

// UI thread only.
class LessonPanel : public QWidget {
  public:
    struct Ways {
        std::function<void()> again;                    // start the attempt again
        std::function<void()> leave;                    // return to free play
        std::function<void()> report;                   // write a report of the attempt
        std::function<void()> look_back;                // review the attempt
        std::function<void()> attempts;                 // all attempts at this lesson
        std::function<void()> next = {};                // begin the next lesson of the course
        std::function<void(const QString&)> name = {};  // the trainee's new name
        std::function<void(const QString&)> step = {};  // a later step begins, in words
        // How these tools are used by keys, which follows every hint.
        std::function<QString(std::span<const LessonTool>)> by_keys = {};
        // The name of a tool with the key that takes it.
        std::function<QString(LessonTool)> tool_and_key = {};
    };

    // What the view shows: the lesson's play, the review of its recording, or something else, such
    // as free play after it.
    enum class InView { play, review, other };

    explicit LessonPanel(Ways ways, QWidget* parent = nullptr);

    // Shows this lesson. `doubts`: sentences on whether it fits the patient.
    void begin(const Lesson& lesson, const std::vector<std::string>& doubts = {});
    // Whether the lesson is tried from its editor: such an attempt is not kept.
    void set_trial(bool trial) { trial_ = trial; }
    // The next lesson of the course; empty: there is none.
    void set_next(const std::string& lesson);
    // How the course stands, shown once the attempt has ended; empty: nothing is said of it.
    void set_course_standing(const QString& words);
    void set_name(const QString& name);
    // Takes effect with the next standing.
    void set_units(FlowUnits units) { units_ = units; }
    // `clock_stands`: nothing was done yet, or nothing since the end.
    void show_standing(const LessonStanding& standing, bool clock_stands = false,
                       InView in_view = InView::play);

  private:
    QString about_clock(const LessonStanding& standing, bool clock_stands, InView in_view) const;
    QLayout* make_name();
    QString words_of_step(std::size_t step) const;
    // That the step is done with a tool that is not in hand; empty where none is missing.
    QString words_of_missing_tool(const LessonStanding& standing) const;
    void show_step(const LessonStanding& standing);
    QString table_of_steps(const LessonStanding& standing) const;
    void show_end(const LessonStanding& standing);

    Lesson lesson_;
    FlowUnits units_ = FlowUnits::computed;
    std::size_t hinted_step_ = static_cast<std::size_t>(-1);  // step whose hint is open
    std::size_t shown_step_ = 0;
    std::function<void(const QString&)> tell_step_;
    std::function<QString(std::span<const LessonTool>)> by_keys_;
    std::function<QString(LessonTool)> tool_and_key_;
    QLabel* title_;
    QLabel* about_;
    QLabel* doubts_;
    QLabel* clock_;
    QLabel* step_;
    QLabel* tool_;
    QLabel* goal_;
    QProgressBar* hold_;
    QLabel* hint_;
    QPushButton* hint_button_;
    QLabel* limits_;
    QLabel* pass_;
    QLabel* end_;
    QLabel* course_;
    QPushButton* next_;
    QPushButton* report_;
    QPushButton* look_back_;
    QPushButton* attempts_;
    QLineEdit* name_;
    std::string next_lesson_;
    bool trial_ = false;
};

}  // namespace hepatica
