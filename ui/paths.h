// SPDX-License-Identifier: GPL-3.0-or-later
// Between Qt's paths and the standard library's, whatever letters they are written in.
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

// The same file or folder, whatever way its path takes.
inline bool same_place(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code missing;
    return a.lexically_normal() == b.lexically_normal() ||
           std::filesystem::equivalent(a, b, missing);
}

// For file dialogs.
inline QString volume_filter() {
    return Words::tr("Volumes (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr);;All files (*)");
}

// What "Open CT file" offers: a case in one file is no folder, as cases are else.
inline QString openable_filter() {
    return Words::tr(
        "Volumes and cases in one file (*.nii *.nii.gz *.mha *.mhd *.nrrd *.nhdr *.hepz);;"
        "All files (*)");
}

}  // namespace hepatica
