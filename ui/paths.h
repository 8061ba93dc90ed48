// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between paths of Qt and of the standard library, for any characters, and file filters.
#pragma once

#include <QFile>
#include <QString>
#include <filesystem>

#include "ui/words.h"

namespace hepatica {

inline std::filesystem::path to_path(const QString& text) {
    return QFile::encodeName(text).toStdString();
}

inline QString to_text(const std::filesystem::path& path) {
    return QFile::decodeName(path.native().c_str());
}

// Whether both name the same file or folder.
inline bool same_place(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code missing;
    return a.lexically_normal() == b.lexically_normal() ||
           std::filesystem::equivalent(a, b, missing);
}

// For file dialogs.
inline QString volume_filter() {
    return Words::tr("Volumes (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr);;All files (*)");
}

// For "Open CT file", which also opens cases in one file; other cases are folders.
inline QString openable_filter() {
    return Words::tr(
        "Volumes and cases in one file (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr *.hepz);;"
        "All files (*)");
}

}  // namespace hepatica
