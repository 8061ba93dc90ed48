// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a lesson, one after another: what is said, its goal, how long it is to be held, and
// the limits while it lasts.
#pragma once

#include "ui/lesson_editor/lesson_page.h"

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
    void fill_step();
    void set(const std::string& field, const std::function<void(LessonStep&)>& change);
    void add();
    void remove();
    void move(int by);

    Lesson shown_;
    std::size_t step_ = 0;  // that is chosen
    QListWidget* list_;
    QPushButton *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    QPlainTextEdit* text_;
    QLineEdit* hint_;
    DecimalSpinBox* hold_;
    BoundsTable* goal_;
    BoundsTable* limits_;
};

}  // namespace hepatica
