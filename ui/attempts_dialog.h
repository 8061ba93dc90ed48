// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog of all attempts at a lesson in the user's folder: a table, the learning curve of one
// quantity, and the band of the reference attempts.
#pragma once

#include <QDialog>
#include <exception>
#include <filesystem>
#include <functional>

#include "core/lesson/attempts.h"
#include "render/chart.h"
#include "ui/flow_units.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

class PlotView;

// The quantity over the attempts, counted from 1, with the bounds of the reference band if there is
// one; failed attempts are marked.
Chart learning_curve(const std::vector<Attempt>& attempts, Quantity quantity,
                     FlowUnits units = FlowUnits::computed);

// UI thread only.
class AttemptsDialog : public QDialog {
  public:
    struct Ways {
        std::function<void(const std::filesystem::path& recording)> look_back;
        std::function<void(const std::string& csv)> save;
        std::function<void(const std::exception_ptr& error)> failed;
    };
    AttemptsDialog(Ways ways, QWidget* parent);

    // Reads the attempts again and shows those of `name` if there are any, else all; the newest is
    // selected. `interrupted` are recordings without a result: they and interrupted attempts follow
    // the others in the table and are left out of the curve.
    void show_lesson(const LessonKey& lesson, const std::filesystem::path& folder,
                     const std::string& name = {},
                     std::vector<std::filesystem::path> interrupted = {});
    // Of table and curve; a saved table has those of the computation.
    void set_units(FlowUnits units);
    // Those that are listed, but for interrupted ones.
    const std::vector<Attempt>& attempts() const { return attempts_.list; }
    const Chart& chart() const;

  private:
    void offer_names(const std::string& name);
    void show_attempts();
    void fill_table();
    void fill_row(int row, const Attempt& attempt);
    void fill_interrupted(int row, const Attempt& attempt);
    void choose_quantities();
    void draw_curve();
    void mark(int row, bool reference);

    Ways ways_;
    Attempts attempts_;
    std::vector<std::filesystem::path> without_result_;
    std::vector<Attempt> interrupted_;  // with and without a result
    LessonKey lesson_;
    std::filesystem::path folder_;
    FlowUnits units_ = FlowUnits::computed;
    bool named_ = false;                // any attempt has a name
    std::vector<Quantity> quantities_;  // that differ from 0 in any attempt
    QLabel* title_;
    QTableWidget* table_;
    QComboBox* whose_;
    QComboBox* quantity_;
    PlotView* plot_;
    QPushButton* look_back_;
    QPushButton* save_;
};

}  // namespace hepatica
