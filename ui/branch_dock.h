// SPDX-License-Identifier: GPL-3.0-or-later
// Dock with the table of the patient's branches: sortable, a row highlights its branch in the view,
// CSV export, and the vessels coloured by the liver segments that they supply. The labels are
// computed in the background when the table is shown.
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

// UI thread only.
class BranchDock : public QDockWidget {
  public:
    struct Callbacks {
        // A row was chosen: highlights this branch and moves the crosshair to it.
        std::function<void(const BranchRow&)> choose;
        // Couinaud segment of each branch; empty: the colours of the vascular systems.
        std::function<void(const std::vector<std::uint8_t>&)> colour;
        std::function<void(const std::string& csv)> save;
        std::function<void(const Failure&)> failed;
    };
    BranchDock(Callbacks callbacks, QWidget* parent);
    ~BranchDock() override;

    // Replaces the former patient; `flow_shares` per branch, `folder` is his case, may be empty.
    void show_patient(std::shared_ptr<const PatientCase> patient, std::vector<double> flow_shares,
                      const std::filesystem::path& folder);
    void clear();
    // Selects the row of this branch without calling `choose`.
    void select(int branch);
    // Shows the table and selects the branch as a click on its row does, once the rows are there.
    void show_branch(int branch);

    const std::vector<BranchRow>& rows() const { return rows_; }

    // Sends the colours again, for example after the vertices have changed.
    void colour_vessels();

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void read_labels();
    // `why_none` is shown if there are no labels.
    void show_rows(const std::vector<BranchLabel>& labels, const QString& why_none);
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
    int asked_for_ = -1;  // branch to choose once there are rows; -1: none
    bool asked_ = false;  // the labels of this patient were requested
    std::unique_ptr<BackgroundJob> job_;
};

}  // namespace hepatica
