// SPDX-License-Identifier: GPL-3.0-or-later
// All attempts at one lesson that lie in this user's folder: a table, the learning curve of one
// quantity over them, and the band of those attempts that others are measured by.
#pragma once

#include <QDialog>
#include <exception>
#include <filesystem>
#include <functional>

#include "core/lesson/attempts.h"
#include "render/chart.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace hepatica {

class PlotView;

// The quantity over the attempts, from 1; with a band, its bounds; those that were not passed are
// marked.
Chart learning_curve(const std::vector<Attempt>& attempts, Quantity quantity);

class AttemptsDialog : public QDialog {
  public:
    struct Ways {
        std::function<void(const std::filesystem::path& recording)> look_back;
        std::function<void(const std::string& csv)> save;
        std::function<void(const std::exception_ptr& error)> failed;
    };
    AttemptsDialog(Ways ways, QWidget* parent);

    // Reads them anew and shows those of who is called so, where any is, else everybody's; the
    // newest is chosen. Recordings that were interrupted stand behind those that have a result, and
    // count in no curve.
    void show_lesson(const std::string& lesson, const std::filesystem::path& folder,
                     const std::string& name = {},
                     std::vector<std::filesystem::path> interrupted = {});
    const std::vector<Attempt>& attempts() const { return attempts_.list; }
    const Chart& chart() const;

  private:
    void offer_names(const std::string& name);
    void show_attempts();
    void fill_table();
    void fill_row(int row, const Attempt& attempt);
    void fill_interrupted(int row, const std::filesystem::path& recording);
    void choose_quantities();
    void draw_curve();
    void mark(int row, bool reference);

    Ways ways_;
    Attempts attempts_;
    std::vector<std::filesystem::path> interrupted_;
    std::string lesson_;
    std::filesystem::path folder_;
    bool named_ = false;                // any of them
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
