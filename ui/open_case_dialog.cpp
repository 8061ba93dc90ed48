// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/open_case_dialog.h"

#include <QFileInfo>
#include <QLineEdit>
#include <utility>

#include "core/patient/patient_case.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

OpenCaseDialog::OpenCaseDialog(const QString& folder, std::function<void(const QString&)> refuse,
                               QWidget* parent)
    : QFileDialog(parent, Words::tr("Open case"), folder, Words::tr("Cases (*.hep *.hepz)")),
      refuse_(std::move(refuse)) {
    // The desktop's own dialog accepts either folders or files, not both.
    setOption(QFileDialog::DontUseNativeDialog);
    setAcceptMode(QFileDialog::AcceptOpen);
    setFileMode(QFileDialog::AnyFile);
    setLabelText(QFileDialog::FileName, Words::tr("Folder NAME.hep or file NAME.hepz:"));
    // By default a folder that is clicked once is not named.
    connect(this, &QFileDialog::currentChanged, this, [this](const QString& path) {
        if (is_case(to_path(path)))
            findChild<QLineEdit*>("fileNameEdit")->setText(QFileInfo(path).fileName());
    });
    // A double click enters a folder; a case is opened instead.
    connect(this, &QFileDialog::directoryEntered, this, [this](const QString& entered) {
        if (!is_case(to_path(entered))) return;
        chosen_ = to_path(entered);
        done(QDialog::Accepted);
    });
}

void OpenCaseDialog::accept() {
    const QStringList files = selectedFiles();
    if (files.isEmpty()) return;
    const QFileInfo info(files.front());
    const std::filesystem::path place = to_path(info.absoluteFilePath());
    if (is_case(place)) {
        chosen_ = place;
        return done(QDialog::Accepted);
    }
    const bool called_a_case = info.fileName().endsWith(".hep", Qt::CaseInsensitive);
    if (info.isDir() && !called_a_case) return setDirectory(info.absoluteFilePath());
    if (!info.exists()) return refuse_(Words::tr("There is no %1.").arg(info.fileName()));
    refuse_(Words::tr("%1 is no case. A case is a folder NAME.hep or a file NAME.hepz; a CT is "
                      "opened by Open CT folder or Open CT file.")
                .arg(info.fileName()));
}

}  // namespace hepatica
