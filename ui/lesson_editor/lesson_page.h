// SPDX-License-Identifier: GPL-3.0-or-later
// Base class of the lesson editor's pages: a page shows a part of the lesson and reports the user's
// changes.
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "core/lesson/lesson.h"

class QBoxLayout;

namespace hepatica {

// UI thread only.
class LessonPage : public QWidget {
  public:
    struct Changes {
        // A value has changed; `field` names it, see LessonDocument::change().
        std::function<void(const std::string& field, const std::function<void(Lesson&)>&)> value;
        // Something was added or removed: the page is shown again. Other pages are updated when
        // they are turned to.
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
    // Fills the fields. Their signals meanwhile are not taken for changes by the user.
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

// Removes and deletes the widgets of a layout, safely even while one of them emits a signal.
void clear_rows(QBoxLayout& rows);

}  // namespace hepatica
