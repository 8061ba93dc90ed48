// SPDX-License-Identifier: GPL-3.0-or-later
// List of the lessons that go with a case of the library, separated into those for this patient and
// those for any patient. A double click, Enter or the button begins one.
#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <vector>

#include "ui/shelved_lessons.h"

class QPushButton;
class QTreeWidget;

namespace hepatica {

// UI thread only.
class CaseLessons : public QWidget {
  public:
    using Begin = std::function<void(const ShelvedLesson&)>;
    explicit CaseLessons(Begin begin, QWidget* parent = nullptr);

    // Lessons in the order of lessons_of(). `can_begin`: the case can be opened.
    void show_lessons(std::vector<ShelvedLesson> lessons, bool can_begin);

  private:
    const ShelvedLesson* chosen() const;
    void begin_chosen();
    void follow_choice();

    Begin begin_;
    std::vector<ShelvedLesson> lessons_;
    bool can_begin_ = false;
    QTreeWidget* list_;
    QPushButton* start_;
};

}  // namespace hepatica
