// SPDX-License-Identifier: GPL-3.0-or-later
// A page of the lesson editor: shows a part of the lesson, and tells what a person changes in it.
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "core/lesson/lesson.h"

class QBoxLayout;

namespace hepatica {

class LessonPage : public QWidget {
  public:
    struct Changes {
        // Of a value: `field` names it, see LessonDocument::change().
        std::function<void(const std::string& field, const std::function<void(Lesson&)>&)> value;
        // Something came or went: the page is shown anew. Other pages are when they are turned to.
        std::function<void(const std::function<void(Lesson&)>&)> shape;
    };
    explicit LessonPage(Changes changes) : changes_(std::move(changes)) {}

    void show_lesson(const Lesson& lesson) {
        showing_ = true;
        fill(lesson);
        showing_ = false;
    }

  protected:
    bool showing() const { return showing_; }
    // While it fills itself nothing that its fields tell counts as a person's.
    virtual void fill(const Lesson& lesson) = 0;
    void change_value(const std::string& field, const std::function<void(Lesson&)>& change) {
        if (!showing_) changes_.value(field, change);
    }
    void change_shape(const std::function<void(Lesson&)>& change) {
        if (!showing_) changes_.shape(change);
    }

  private:
    Changes changes_;
    bool showing_ = false;
};

// Removes the widgets of a layout, also while one of them is telling something.
void clear_rows(QBoxLayout& rows);

}  // namespace hepatica
