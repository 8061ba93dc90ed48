// SPDX-License-Identifier: GPL-3.0-or-later
// A course: its lessons in order with their pass marks, which of them are passed, and the way into
// the next one.
#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

#include "core/lesson/course_standing.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

class CourseDialog : public QDialog {
  public:
    using Begin = std::function<void(const CourseLine&)>;
    CourseDialog(Begin begin, QWidget* parent);

    // The first lesson that is not passed yet is chosen. `whose`: the trainee whose attempts count;
    // empty: everybody's.
    void show_course(const std::string& name, std::vector<CourseLine> lines,
                     const std::string& whose = {});
    const std::vector<CourseLine>& lines() const { return lines_; }

  private:
    Begin begin_;
    std::vector<CourseLine> lines_;
    QLabel* title_;
    QTableWidget* table_;
    QPushButton* start_;
};

}  // namespace hepatica
