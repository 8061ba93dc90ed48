// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files that are proposed to the user, made of names that people gave to patients, lessons
// and courses, which may hold any characters.
#pragma once

#include <QString>

namespace hepatica {

// The name of one file that every file system takes: without the characters that separate folders
// or that some systems refuse, not hidden, and with room for an ending. `otherwise` if nothing is
// left of it.
QString as_file_name(const QString& name, const QString& otherwise);

// The name itself, or "NAME (2).ENDING" and so on where the folder holds one of that name.
QString free_name(const QString& folder, const QString& name);

}  // namespace hepatica
