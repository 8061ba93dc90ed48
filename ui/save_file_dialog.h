// SPDX-License-Identifier: GPL-3.0-or-later
// File dialogs for saving one kind of file, or a folder of files. The kind's suffix is added to the
// name before the user is asked whether an existing file may be replaced.
#pragma once

#include <QString>

class QWidget;

namespace hepatica {

// Throws InputError if the folder of `file` does not exist; it is not created.
void require_folder_of(const QString& file);

// `filter` as "Tables (*.csv)", `suggested` a full path. Returns an empty string if cancelled.
QString ask_where_to_save_file(QWidget& parent, const QString& title, const QString& suggested,
                               const QString& filter);
// A folder that need not exist yet; nothing is made. `suggested` and the answer likewise.
QString ask_where_to_save_folder(QWidget& parent, const QString& title, const QString& suggested);

}  // namespace hepatica
