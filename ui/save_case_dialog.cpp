// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/save_case_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <system_error>
#include <utility>

#include "core/patient/case_archive.h"
#include "core/patient/patient_case.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

std::filesystem::path case_folder(const QString& typed) {
    QString name = QDir::cleanPath(typed);
    if (!name.endsWith(".hep", Qt::CaseInsensitive) && !name.endsWith(".hepz", Qt::CaseInsensitive))
        name += ".hep";
    return to_path(QFileInfo(name).absoluteFilePath());
}

SaveCaseDialog::SaveCaseDialog(const QString& folder, const QString& name,
                               std::function<bool(const QString&)> may_replace,
                               std::function<void(const QString&)> refuse, QWidget* parent)
    : QFileDialog(parent, Words::tr("Save case as"), folder, Words::tr("Cases (*.hep *.hepz)")),
      may_replace_(std::move(may_replace)),
      refuse_(std::move(refuse)) {
    // The desktop's own dialog would enter the folder, which cannot be prevented.
    setOption(QFileDialog::DontUseNativeDialog);
    setAcceptMode(QFileDialog::AcceptSave);
    setFileMode(QFileDialog::AnyFile);
    // Over an existing case, which is a folder, the button would say "Open".
    connect(
        findChild<QLineEdit*>("fileNameEdit"), &QLineEdit::textChanged, this,
        [this] {
            auto* save = findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
            if (save != nullptr && is_replaceable_case(chosen())) save->setText(Words::tr("&Save"));
        },
        Qt::QueuedConnection);
    selectFile(name);
    // A double click enters a folder; a case is left again, with its name selected.
    connect(this, &QFileDialog::directoryEntered, this, [this](const QString& entered) {
        if (!is_case(to_path(entered))) return;
        const QFileInfo info(entered);
        setDirectory(info.absolutePath());
        selectFile(info.fileName());
    });
}

std::filesystem::path SaveCaseDialog::chosen() const {
    return case_folder(selectedFiles().value(0));
}

void SaveCaseDialog::accept() {
    const QStringList files = selectedFiles();
    if (files.isEmpty()) return;
    const std::filesystem::path folder = chosen();
    if (is_replaceable_case(folder)) {
        if (may_replace_(to_text(folder.filename()))) done(QDialog::Accepted);
    } else if (is_archive_name(folder) && QFileInfo(to_text(folder)).isDir()) {
        refuse_(Words::tr("%1 is a folder, and no case in one file can take its place. Choose "
                          "another name, or rename the folder or move it away.")
                    .arg(to_text(folder.filename())));
    } else if (QFileInfo(files.front()).isDir()) {
        setDirectory(files.front());
    } else if (std::error_code unreadable; !std::filesystem::exists(folder, unreadable)) {
        done(QDialog::Accepted);  // where it cannot be looked at, saving says why
    } else {
        refuse_(Words::tr("There is %1 already, and it is no case. Choose another name.")
                    .arg(to_text(folder.filename())));
    }
}

}  // namespace hepatica
