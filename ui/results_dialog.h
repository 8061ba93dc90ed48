// SPDX-License-Identifier: GPL-3.0-or-later
// One table of who passed what: trainees by the lessons of a course, for an instructor.
#pragma once

#include <QDialog>
#include <functional>
#include <string>

#include "core/lesson/course_results.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

class ResultsDialog : public QDialog {
  public:
    // `save` asks where to.
    ResultsDialog(std::function<void(const std::string& csv)> save, QWidget* parent);

    void show_results(const std::string& course, CourseResults results);

  private:
    void fill();

    CourseResults results_;
    QLabel* title_;
    QTableWidget* table_;
    QPushButton* save_;
};

}  // namespace hepatica
