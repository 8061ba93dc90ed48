// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog for the options of a reconstruction: CT, series of a DICOM folder, liver mask, vessel
// mask, tumour masks, window and seeds. Only the CT is required.
#pragma once

#include <QDialog>
#include <QStringList>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/reconstruction/reconstruct.h"
#include "core/reconstruction/reconstruct_parameters.h"
#include "ui/settings.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace hepatica {

class BackgroundJob;
struct SeriesDescription;

// UI thread only.
class PatientWizard : public QDialog {
  public:
    explicit PatientWizard(const QString& folder, QWidget* parent = nullptr);
    ~PatientWizard() override;

    // `series` is chosen at first if the folder holds several, numbered from 1; 0: the best.
    void set_ct(const QString& path, int series = 0);
    // The options in the fields. Throws InputError that names the first invalid field.
    ReconstructOptions options() const;

    // Offers again what the present case was made with: its window, and those masks whose places
    // are known. Names the others, to be chosen again, and says so where no CT is in its field.
    void set_given(const GivenParts& given, const Settings::MaskPlaces& known);
    // In place of those in the fields of their systems. They are of the CT in its field.
    void set_seeds(const std::vector<VesselSeed>& seeds);
    // What all fields hold, as it was typed, to be set in a later dialog.
    QStringList entries() const;
    void set_entries(const QStringList& entries);

  private:
    std::array<QLineEdit*, 8> edits() const;  // the CT first
    int chosen_series() const;                // numbered from 1; 0: none was chosen
    QLineEdit* add_path(QFormLayout& form, const QString& label, bool folders_too);
    // Lists the series of the CT's folder in the background and offers them if there are several.
    void look_for_series();
    void fill(QLineEdit& edit, const QString& text);
    // Takes out what was filled in for another CT and still stands there.
    void forget_filled();
    void offer(const std::vector<SeriesDescription>& series);

    QString folder_;
    QFormLayout* form_;
    QLineEdit* ct_;
    QComboBox* series_;
    QLineEdit* liver_mask_;
    QLineEdit* vessel_mask_;
    QLineEdit* tumour_masks_;
    QLineEdit* window_;
    QLineEdit* portal_seeds_;
    QLineEdit* hepatic_seeds_;
    QLineEdit* artery_seeds_;
    QLabel* problem_;
    std::filesystem::path looked_in_;  // whose series were listed last
    std::filesystem::path chosen_in_;  // whose series set_ct() named
    int chosen_ = 0;                   // its number; 0: none was named
    std::unique_ptr<BackgroundJob> listing_;
    std::vector<std::pair<QLineEdit*, QString>> filled_;  // with the text
    std::optional<QString> filled_for_;                   // the CT, as typed
};

// Numbers in "12,5 -3; 40": separated by blanks or semicolons, with decimal comma or point. Throws
// InputError that names the part that is no number.
std::vector<double> numbers_in(const QString& text, const std::string& field);

}  // namespace hepatica
