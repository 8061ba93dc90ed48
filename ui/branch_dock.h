// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the patient's branches in a dock of its own: sorted by a click on a column, lit up
// in the view by a click on a row, saved as CSV; and the vessels coloured by the segments of the
// liver that they supply. What only a case on disk knows is read beside the window when the table
// is shown.
#pragma once

#include <QDockWidget>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/patient/patient_case.h"
#include "core/scene/branch_table.h"
#include "ui/background_job.h"

class QCheckBox;
class QLabel;
class QTableWidget;

namespace hepatica {

class BranchDock : public QDockWidget {
  public:
    struct Callbacks {
        // Lit up and gone to: this branch of the tree.
        std::function<void(const BranchRow&)> choose;
        // Couinaud's segment of each branch of the tree; empty: colours of the systems.
        std::function<void(const std::vector<std::uint8_t>&)> colour;
        std::function<void(const std::string& csv)> save;
        std::function<void(const Failure&)> failed;
    };
    BranchDock(Callbacks callbacks, QWidget* parent);
    ~BranchDock() override;

    // Forgets the patient before.
    void show_patient(std::shared_ptr<const PatientCase> patient, std::vector<double> flow_shares,
                      const std::filesystem::path& folder);
    void clear();
    // The row of this branch is selected, without `choose`.
    void select(int branch);
    // Opens the table with it and tells of it as a click on its row does; once its rows are read.
    void show_branch(int branch);

    const std::vector<BranchRow>& rows() const { return rows_; }

    // The colours again, as where the vertices have changed.
    void colour_vessels();

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void read_labels();
    void show_rows(std::vector<BranchLabel> labels);
    void fill_table();
    void choose_asked_for();

    Callbacks callbacks_;
    QTableWidget* table_;
    QCheckBox* colours_;
    QLabel* note_;
    std::shared_ptr<const PatientCase> patient_;
    std::vector<double> flow_shares_;
    std::filesystem::path folder_;
    std::vector<BranchRow> rows_;
    int asked_for_ = -1;  // a branch to be chosen once there are rows
    bool asked_ = false;  // for this patient's labels
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
