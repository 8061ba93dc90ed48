// SPDX-License-Identifier: GPL-3.0-or-later
// Asks where a file of one kind is to be saved: a name without the kind's suffix gets it, before it
// is asked whether a file of that name may be replaced.
#pragma once

#include <QString>

class QWidget;

namespace hepatica {

// Throws InputError where the folder of a file that is to be saved is not there: none is made
// unasked.
void require_folder_of(const QString& file);

// `filter` as "Tables (*.csv)", `suggested` a whole path. Empty: not after all.
QString ask_where_to_save_file(QWidget& parent, const QString& title, const QString& suggested,
                               const QString& filter);

}  // namespace hepatica
