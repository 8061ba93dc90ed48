// SPDX-License-Identifier: GPL-3.0-or-later
// Asks which series of a DICOM folder is to be read. The first is the best for the liver's vessels
// and is chosen already, so that Enter takes it.
#pragma once

#include <QDialog>
#include <vector>

#include "core/image/volume_reader.h"

class QTreeWidget;

namespace hepatica {

class SeriesDialog : public QDialog {
  public:
    // Two series or more, the best first.
    SeriesDialog(const std::vector<SeriesDescription>& series, QWidget* parent = nullptr);

    int chosen() const;  // its number in the list, from 1

  private:
    QTreeWidget* list_;
};

}  // namespace hepatica
