// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include "ui/core_words.h"
#include "ui/file_name.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/plain_text.h"
#include "ui/save_case_dialog.h"
#include "ui/series_dialog.h"
#include "ui/words.h"

namespace hepatica {
namespace {

UnsavedAnswer ask_unsaved(QWidget& parent, const std::string& title) {
    QMessageBox box(
        QMessageBox::Question, "Hepatica",
        as_plain(Words::tr("%1 holds changes that are not saved.").arg(translated(title))),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &parent);
    box.setInformativeText(
        Words::tr("Save them as a case? Corrections that are still being made are waited for."));
    box.setDefaultButton(QMessageBox::Save);
    box.setEscapeButton(QMessageBox::Cancel);
    switch (box.exec()) {
        case QMessageBox::Save:
            return UnsavedAnswer::save;
        case QMessageBox::Discard:
            return UnsavedAnswer::discard;
        default:
            return UnsavedAnswer::cancel;
    }
}

StrokesAnswer ask_strokes(QWidget& parent, const std::string& title, std::size_t strokes) {
    QMessageBox box(QMessageBox::Question, "Hepatica",
                    as_plain(Words::tr("%n stroke(s) at the vessels of %1 are not made into "
                                       "vessels yet.",
                                       nullptr, static_cast<int>(strokes))
                                 .arg(translated(title))),
                    QMessageBox::Cancel, &parent);
    box.setInformativeText(
        Words::tr("No case can hold strokes: rebuild the vessels with them first, or drop them."));
    QPushButton* rebuild = box.addButton(Words::tr("&Rebuild first"), QMessageBox::AcceptRole);
    QPushButton* drop = box.addButton(Words::tr("&Drop them"), QMessageBox::DestructiveRole);
    box.setDefaultButton(rebuild);
    box.setEscapeButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == rebuild ? StrokesAnswer::rebuild
           : box.clickedButton() == drop  ? StrokesAnswer::drop
                                          : StrokesAnswer::cancel;
}

CopyAnswer ask_copy_of_unsaved(QWidget& parent, const std::string& title) {
    QMessageBox box(
        QMessageBox::Question, "Hepatica",
        as_plain(Words::tr("%1 holds changes that are not saved.").arg(translated(title))),
        QMessageBox::Save | QMessageBox::Cancel, &parent);
    box.setInformativeText(
        Words::tr("Save the case before it is copied into one file? As last saved, the copy lacks "
                  "the changes."));
    QPushButton* as_saved = box.addButton(Words::tr("&As last saved"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Save);
    box.setEscapeButton(QMessageBox::Cancel);
    const int answer = box.exec();
    if (box.clickedButton() == as_saved) return CopyAnswer::as_saved;
    return answer == QMessageBox::Save ? CopyAnswer::save : CopyAnswer::cancel;
}

ChangedAnswer ask_changed_on_disk(QWidget& parent, const std::filesystem::path& place) {
    QMessageBox box(
        QMessageBox::Question, "Hepatica",
        as_plain(Words::tr("%1 was changed on the disk since it was opened or saved here.")
                     .arg(to_text(place.filename()))),
        QMessageBox::Cancel, &parent);
    box.setInformativeText(
        Words::tr("Another program or person has saved there. Replacing it loses what they have "
                  "done; under another name both are kept."));
    QPushButton* save_as = box.addButton(Words::tr("Save &as…"), QMessageBox::AcceptRole);
    QPushButton* replace = box.addButton(Words::tr("&Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(save_as);
    box.setEscapeButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace   ? ChangedAnswer::replace
           : box.clickedButton() == save_as ? ChangedAnswer::save_as
                                            : ChangedAnswer::cancel;
}

bool ask_end_lesson(QWidget& parent, const std::string& lesson) {
    QMessageBox box(QMessageBox::Question, "Hepatica",
                    as_plain(Words::tr("The lesson %1 is being played.").arg(translated(lesson))),
                    QMessageBox::NoButton, &parent);
    box.setInformativeText(
        Words::tr("Who quits now gives it up: it counts as not passed. Its recording is kept."));
    QPushButton* quit = box.addButton(Words::tr("&Quit"), QMessageBox::DestructiveRole);
    QPushButton* stay = box.addButton(Words::tr("&Go on playing"), QMessageBox::RejectRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == quit;
}

bool ask_end_play(QWidget& parent) {
    QMessageBox box(QMessageBox::Question, "Hepatica",
                    Words::tr("A free play with tears or an injection waits behind what is shown, "
                              "and ends with this."),
                    QMessageBox::Cancel, &parent);
    box.setInformativeText(Words::tr(
        "It lasts no longer than its patient and the back end that computes it. Cancel leaves all "
        "as it is."));
    QPushButton* end = box.addButton(Words::tr("&End the play"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.setEscapeButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == end;
}

bool ask_replace(QWidget& parent, const QString& name) {
    return QMessageBox::question(&parent, "Hepatica",
                                 as_plain(Words::tr("There is a case “%1” already, of this patient "
                                                    "or of another one. Replace it?")
                                              .arg(name)),
                                 QMessageBox::Yes | QMessageBox::No,
                                 QMessageBox::No) == QMessageBox::Yes;
}

}  // namespace

PatientKeeper::Questions questions_in_dialogs(QWidget& parent, const Settings& settings) {
    PatientKeeper::Questions questions;
    questions.unsaved = [&parent](const std::string& title) { return ask_unsaved(parent, title); };
    questions.strokes = [&parent](const std::string& title, std::size_t strokes) {
        return ask_strokes(parent, title, strokes);
    };
    questions.copy_of_unsaved = [&parent](const std::string& title) {
        return ask_copy_of_unsaved(parent, title);
    };
    questions.changed_on_disk = [&parent](const std::filesystem::path& place) {
        return ask_changed_on_disk(parent, place);
    };
    questions.which_series =
        [&parent](const std::vector<SeriesDescription>& series) -> std::optional<int> {
        SeriesDialog dialog(series, &parent);
        if (dialog.exec() != QDialog::Accepted) return std::nullopt;
        return dialog.chosen();
    };
    questions.where_to_save =
        [&parent,
         &settings](const std::filesystem::path& proposed) -> std::optional<std::filesystem::path> {
        const bool has_place = proposed.has_parent_path();
        SaveCaseDialog dialog(
            has_place ? to_text(proposed.parent_path()) : settings.case_folder(),
            has_place ? to_text(proposed.filename())
                      : free_name(settings.case_folder(), to_text(proposed.filename())),
            [&parent](const QString& name) { return ask_replace(parent, name); },
            [&dialog](const QString& why) {
                QMessageBox::warning(&dialog, "Hepatica", as_plain(why));
            },
            &parent);
        if (dialog.exec() != QDialog::Accepted) return std::nullopt;
        return dialog.chosen();
    };
    questions.end_lesson = [&parent](const std::string& lesson) {
        return ask_end_lesson(parent, lesson);
    };
    questions.end_play = [&parent] { return ask_end_play(parent); };
    return questions;
}

std::optional<std::filesystem::path> ask_where_ct_lies(QWidget& parent, Settings& settings) {
    const QString title = Words::tr("The CT of this patient");
    QMessageBox box(QMessageBox::Question, "Hepatica", Words::tr("Where is this patient's CT?"),
                    QMessageBox::Cancel, &parent);
    box.setInformativeText(
        Words::tr("Choose the folder of its DICOM series, or the file of a volume."));
    QPushButton* folder = box.addButton(Words::tr("Folder…"), QMessageBox::AcceptRole);
    QPushButton* file = box.addButton(Words::tr("File…"), QMessageBox::AcceptRole);
    box.setDefaultButton(folder);
    box.exec();
    if (box.clickedButton() != folder && box.clickedButton() != file) return std::nullopt;
    const QString place = settings.choose(Settings::Kind::ct, [&](const QString& start) {
        return box.clickedButton() == folder
                   ? QFileDialog::getExistingDirectory(&parent, title, start)
                   : QFileDialog::getOpenFileName(&parent, title, start,
                                                  Words::tr("All files (*)"));
    });
    if (place.isEmpty()) return std::nullopt;
    return to_path(place);
}

bool ask_export_with_name(QWidget& parent) {
    QMessageBox box(QMessageBox::Warning, "Hepatica",
                    Words::tr("The DICOM segmentation will name the patient."), QMessageBox::Cancel,
                    &parent);
    box.setInformativeText(
        Words::tr("The patient's name, number and other data are written into the file as they "
                  "stand in the CT, so that an archive finds where it belongs. Pass it on only as "
                  "you would pass on the CT."));
    QPushButton* go_on = box.addButton(Words::tr("&Export…"), QMessageBox::AcceptRole);
    box.setDefaultButton(go_on);
    box.setEscapeButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go_on;
}

QWidget& shown_of(QWidget& own, QWidget& window) {
    return own.isVisible() ? own : window;
}

void tell_failure(QWidget& window, const QString& doing, const Failure& failure) {
    const QStringList lines = lines_of(failure);
    auto* box = new QMessageBox(QMessageBox::Warning, doing, as_plain(lines.front()),
                                QMessageBox::Ok, &window);
    box->setInformativeText(as_plain(lines.mid(1).join("\n")));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

UnsavedLesson ask_unsaved_lesson(QWidget& parent, const std::string& name, bool kept) {
    QMessageBox box(
        QMessageBox::Question, "Hepatica",
        as_plain(
            Words::tr("The lesson %1 holds changes that are not saved.").arg(translated(name))),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &parent);
    QPushButton* later =
        kept ? box.addButton(Words::tr("Keep for later"), QMessageBox::AcceptRole) : nullptr;
    box.setDefaultButton(QMessageBox::Save);
    box.setEscapeButton(QMessageBox::Cancel);
    const int answer = box.exec();
    if (later != nullptr && box.clickedButton() == later) return UnsavedLesson::keep;
    switch (answer) {
        case QMessageBox::Save:
            return UnsavedLesson::save;
        case QMessageBox::Discard:
            return UnsavedLesson::discard;
        default:
            return UnsavedLesson::stay;
    }
}

}  // namespace hepatica
