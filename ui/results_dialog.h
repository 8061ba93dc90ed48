// SPDX-License-Identifier: GPL-3.0-or-later
// Table of the results of all trainees in the lessons of a course, for an instructor.
#pragma once

#include <QDialog>
#include <functional>
#include <string>

#include "core/lesson/course_results.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

// UI thread only.
class ResultsDialog : public QDialog {
  public:
    // `save` asks for a place.
    ResultsDialog(std::function<void(const std::string& csv)> save, QWidget* parent);

    void show_results(const std::string& course, CourseResults results);

  private:
    void fill();

    CourseResults results_;
    QLabel* title_;
    QLabel* nobody_;  // in place of the table where it is empty
    QTableWidget* table_;
    QPushButton* save_;
};

}  // namespace hepatica
