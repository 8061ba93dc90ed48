// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/save_file_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QRegularExpression>

#include "core/base/error.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// "csv" from "Tables (*.csv)".
QString suffix_of(const QString& filter) {
    static const QRegularExpression pattern(R"(\*\.([^ )]+))");
    return pattern.match(filter).captured(1);
}

// Adds the suffix before the dialog checks whether the file exists. Qt's default suffix would not
// be added to "a.b", which has one already.
class SaveFileDialog : public QFileDialog {
  public:
    using QFileDialog::QFileDialog;

    void accept() override {
        auto* name = findChild<QLineEdit*>("fileNameEdit");
        const QString suffix = "." + suffix_of(selectedNameFilter());
        if (name && !name->text().isEmpty() &&
            !name->text().endsWith(suffix, Qt::CaseInsensitive) &&
            !QFileInfo(directory(), name->text()).isDir())
            name->setText(name->text() + suffix);
        QFileDialog::accept();
    }
};

// Takes a new name as well as a folder that is there, into which QFileDialog would go instead.
class SaveFolderDialog : public QFileDialog {
  public:
    using QFileDialog::QFileDialog;

    QString chosen() const { return chosen_.isEmpty() ? selectedFiles().value(0) : chosen_; }
    void accept() override {
        const auto* name = findChild<QLineEdit*>("fileNameEdit");
        if (name == nullptr || name->text().isEmpty()) return QFileDialog::accept();
        chosen_ = QFileInfo(directory(), name->text()).absoluteFilePath();
        QDialog::accept();
    }

  private:
    QString chosen_;  // empty for a native dialog
};

}  // namespace

void require_folder_of(const QString& file) {
    const QFileInfo folder(QFileInfo(file).absolutePath());
    if (!folder.isDir())
        throw InputError(Words::id("There is no such folder, and nothing was saved"),
                         folder.filePath().toStdString(),
                         Words::id("Make the folder first, or choose one that is there"));
}

QString ask_where_to_save_file(QWidget& parent, const QString& title, const QString& suggested,
                               const QString& filter) {
    SaveFileDialog dialog(&parent, title, suggested, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(suffix_of(filter));  // for a native dialog
    if (dialog.exec() != QDialog::Accepted) return {};
    return dialog.selectedFiles().value(0);
}

// Into one that is there the dialog would go.
QString free_folder(const QString& suggested) {
    QString folder = suggested;
    for (int number = 2; QFileInfo::exists(folder); ++number)
        folder = suggested + "-" + QString::number(number);
    return folder;
}

QString ask_where_to_save_folder(QWidget& parent, const QString& title, const QString& suggested) {
    SaveFolderDialog dialog(&parent, title, suggested);
    dialog.selectFile(free_folder(suggested));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    return dialog.exec() == QDialog::Accepted ? dialog.chosen() : QString();
}

}  // namespace hepatica
