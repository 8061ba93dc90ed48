// SPDX-License-Identifier: GPL-3.0-or-later
// Lesson editor page for the steps, in order: text, hint, the tool to be used, goal, how long the
// goal must hold, and limits during the step.
#pragma once

#include "ui/lesson_editor/lesson_page.h"

class QComboBox;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace hepatica {

class BoundsTable;
class DecimalSpinBox;

class StepsPage : public LessonPage {
  public:
    explicit StepsPage(Changes changes);

  protected:
    void fill(const Lesson& lesson) override;

  private:
    QWidget* make_list();
    QWidget* make_step();
    void make_tools();
    void fill_step();
    void set(const std::string& field, const std::function<void(LessonStep&)>& change);
    void add();
    void remove();
    void move(int by);

    Lesson shown_;
    std::size_t step_ = 0;  // index of the chosen step
    QListWidget* list_;
    QPushButton *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    QPlainTextEdit* text_;
    QLineEdit* hint_;
    QComboBox* tool_;
    DecimalSpinBox* hold_;
    BoundsTable* goal_;
    BoundsTable* limits_;
};

}  // namespace hepatica
