// SPDX-License-Identifier: GPL-3.0-or-later
// Asks which series of a DICOM folder is to be read, with a small picture of each. The first is the
// best for the liver's vessels and is chosen already, so that Enter takes it.
#pragma once

#include <QDialog>
#include <memory>
#include <vector>

#include "core/image/volume_reader.h"

class QLabel;
class QTreeWidget;

namespace hepatica {

class SeriesThumbnails;

// Its number and name, as lists show it.
QString name_in_list(const SeriesDescription& series);
// Why it is not the first of the list; empty of the first.
QString why_not_first(const SeriesDescription& series);

class SeriesDialog : public QDialog {
  public:
    // Two series or more, the best first.
    SeriesDialog(const std::vector<SeriesDescription>& series, QWidget* parent = nullptr);
    ~SeriesDialog() override;

    int chosen() const;  // its number in the list, from 1
    // Pictures are still to come; none once the dialog is closed.
    bool draws_pictures() const;

  private:
    // Of those that would be called the same.
    void name_folders(const std::vector<SeriesDescription>& series);
    void begin_pictures(const std::vector<SeriesDescription>& series);
    void show_warnings_of(const std::vector<SeriesDescription>& series);
    void show_picture(int row, const QImage& picture);

    QTreeWidget* list_;
    QLabel* warnings_;  // of the series that is chosen
    std::unique_ptr<SeriesThumbnails> thumbnails_;
};

}  // namespace hepatica
