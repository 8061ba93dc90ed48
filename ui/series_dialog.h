// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that chooses a series of a DICOM folder, with a thumbnail of each. The first one suits the
// liver's vessels best and is preselected, so that Enter takes it.
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "core/image/volume_reader.h"

class QLabel;
class QTreeWidget;

namespace hepatica {

class SeriesThumbnails;

// The name of a series in lists.
QString name_in_list(const SeriesDescription& series);
// Why the series is not the first of the list; empty for the first.
QString why_not_first(const SeriesDescription& series);

// UI thread only.
class SeriesDialog : public QDialog {
  public:
    // At least two series, the best first.
    SeriesDialog(const std::vector<SeriesDescription>& series, QWidget* parent = nullptr);
    ~SeriesDialog() override;

    int chosen() const;  // number in the list, from 1
    // Whether thumbnails are still missing; they end when the dialog is closed.
    bool draws_pictures() const;

  private:
    // Adds the folder to names that occur more than once.
    void name_folders(const std::vector<SeriesDescription>& series);
    void begin_pictures(const std::vector<SeriesDescription>& series);
    void show_warnings_of(const std::vector<SeriesDescription>& series);
    void show_picture(int row, const QImage& picture);

    QTreeWidget* list_;
    QLabel* warnings_;  // of the selected series
    std::unique_ptr<SeriesThumbnails> thumbnails_;
};

}  // namespace hepatica
