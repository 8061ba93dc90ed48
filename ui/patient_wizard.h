// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for what a reconstruction may be helped with: liver mask, vessel mask, window and seeds, and
// which series of a folder that holds several. All of it is optional but the CT.
#pragma once

#include <QDialog>
#include <memory>
#include <optional>
#include <vector>

#include "core/reconstruction/reconstruct.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace hepatica {

class BackgroundJob;
struct SeriesDescription;

class PatientWizard : public QDialog {
  public:
    explicit PatientWizard(const QString& folder, QWidget* parent = nullptr);
    ~PatientWizard() override;

    void set_ct(const QString& path);
    // What the fields say. Throws InputError that names the field that makes no sense.
    ReconstructOptions options() const;

  private:
    QLineEdit* add_path(QFormLayout& form, const QString& label, bool folders_too);
    // Lists those of the CT's folder, beside the dialog; they are offered where there are several.
    void look_for_series();
    void offer(const std::vector<SeriesDescription>& series);

    QString folder_;
    QFormLayout* form_;
    QLineEdit* ct_;
    QComboBox* series_;
    QLineEdit* liver_mask_;
    QLineEdit* vessel_mask_;
    QLineEdit* window_;
    QLineEdit* portal_seeds_;
    QLineEdit* hepatic_seeds_;
    QLabel* problem_;
    std::unique_ptr<BackgroundJob> listing_;
};

// Numbers out of "12,5 -3; 40": separated by blanks or semicolons, decimal comma or point. Throws
// InputError that names the part that is no number.
std::vector<double> numbers_in(const QString& text, const std::string& field);

}  // namespace hepatica
