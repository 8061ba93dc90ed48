// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog of a course: its lessons in order with their pass marks and standing, and a button that
// begins one.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "core/lesson/course_standing.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

// The program's own course in the window's language; another one as its author called it.
QString course_title(const std::string& name);

// For whom attempts count: the trainee of this name; empty: whoever played here.
QString whose_attempts(const std::string& trainee);

// UI thread only.
class CourseDialog : public QDialog {
  public:
    using Begin = std::function<void(const CourseLine&)>;
    // `own` is called to show the built-in course.
    CourseDialog(Begin begin, std::function<void()> own, QWidget* parent);

    // Selects the first lesson that is not passed yet. `whose` is the trainee whose attempts count,
    // empty: everybody's. `own`: this is the built-in course.
    void show_course(const std::string& name, std::vector<CourseLine> lines,
                     const std::string& whose, bool own);
    const std::vector<CourseLine>& lines() const { return lines_; }

  private:
    Begin begin_;
    std::vector<CourseLine> lines_;
    QLabel* title_;
    QTableWidget* table_;
    QPushButton* start_;
    QPushButton* own_;
};

}  // namespace hepatica
