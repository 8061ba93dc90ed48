// SPDX-License-Identifier: GPL-3.0-or-later
// What the window opens and saves: dialogs, drops and files.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QStatusBar>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/plot_panel.h"
#include "ui/vtk_widget.h"

namespace hepatica {

void MainWindow::save_plots(bool picture) {
    const QString file = QFileDialog::getSaveFileName(
        this, "Save curves", settings_.last_folder() + (picture ? "/curves.png" : "/curves.csv"),
        picture ? "PNG (*.png)" : "Tables (*.csv)");
    if (file.isEmpty()) return;
    attempt([&] { picture ? plots_->save_picture(file) : plots_->save_table(file); });
}

void MainWindow::ask_for_ct(bool folder) {
    const QString path = folder
                             ? QFileDialog::getExistingDirectory(this, "Open CT folder (DICOM)",
                                                                 settings_.last_folder())
                             : QFileDialog::getOpenFileName(
                                   this, "Open CT file", settings_.last_folder(), volume_filter());
    if (!path.isEmpty()) open(path);
}

void MainWindow::ask_where_to_save() {
    const QString folder = QFileDialog::getSaveFileName(
        this, "Save case as", settings_.last_folder() + "/patient.hep", "Cases (*.hep)");
    if (!folder.isEmpty()) save_case(folder);
}

void MainWindow::save_case(const QString& folder) {
    if (!patient_) return;
    start_job("Saving " + QFileInfo(folder).fileName(),
              [this, folder, patient = patient_->patient, voxels = patient_->folder,
               save = patients_.save](Job& job) {
                  job.begin_stage("write");
                  PatientCase whole = *patient;
                  if (!voxels.empty()) add_voxels(voxels, whole);
                  save(to_path(folder), whole);
                  return [this, folder] {
                      setWindowModified(false);
                      settings_.add_recent_file(folder);
                      statusBar()->showMessage("Saved " + folder, 6000);
                  };
              });
}

void MainWindow::save_picture(const QString& file) {
    const QImage picture = view_->picture();
    write_file_atomically(to_path(file), [&](const std::filesystem::path& temporary) {
        if (!picture.save(to_text(temporary), "PNG")) {
            throw InputError("the picture cannot be written", file.toStdString(),
                             "choose a folder you may write to, on a disk with room");
        }
    });
    statusBar()->showMessage("Saved " + file, 6000);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        if (!url.isLocalFile()) continue;
        event->acceptProposedAction();
        return open(url.toLocalFile());
    }
    messages_->show_failure({"only files and folders of this computer can be opened", "",
                             "save it to a folder and drop that"});
}

}  // namespace hepatica
