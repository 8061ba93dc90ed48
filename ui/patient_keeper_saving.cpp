// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the keeper that writes a case. The folder may have been changed, moved or removed
// since it was opened: nobody's work is replaced without a question, and none is lost.
#include <utility>

#include "core/opening/patient_image.h"
#include "ui/file_name.h"
#include "ui/paths.h"
#include "ui/patient_keeper.h"
#include "ui/words.h"

namespace hepatica {

namespace {

QString words_of_saved(bool anew, bool strokes_wait) {
    if (anew) return Words::tr("%1 was not there any more: it was saved anew");
    return strokes_wait ? Words::tr("Saved %1, without strokes that wait for Rebuild")
                        : Words::tr("Saved %1");
}

}  // namespace

void PatientKeeper::add_saving(const Saving& saving) {
    QueuedJob job;
    job.kind = JobKind::save;
    job.title = Words::tr("Saving %1").arg(to_text(saving.folder.filename())).toStdString();
    job.begin = [this, saving] { return writing(saving); };
    add_writing(std::move(job));
}

BackgroundJob::Work PatientKeeper::writing(const Saving& saving) {
    // Compared at home only: for another place the dialog has asked already.
    const bool compares = saving.replaces || saving.folder == workspace_.home();
    const std::string known = saving.replaces.value_or(workspace_.digest());
    return [this, saving, compares, known, patient = workspace_.patient(),
            edits = workspace_.made_edits(), measured = workspace_.measured(),
            voxels = workspace_.folder()](Job& job) -> std::function<void()> {
        job.begin_stage(Words::id("Writing the case"));
        PatientCase whole = whole_case(*patient, voxels, edits, job);
        whole.measured = measured;
        // As late as possible: what is saved there between this and the end of the writing is lost.
        const std::string found = compares ? ways_.digest(saving.folder) : known;
        if (!found.empty() && found != known)
            return [this, changed = Saving{saving.folder, saving.written, found}] {
                ask_about_changed(changed);
            };
        ways_.save(saving.folder, whole);
        const bool anew = compares && found.empty();
        return [this, saving, anew, edits = whole.corrections.edits, measured,
                digest = ways_.digest(saving.folder)] {
            workspace_.saved(saving.folder, edits, measured);
            workspace_.set_digest(digest);
            written_.insert(saving.folder);
            screen_.remember(saving.folder);
            screen_.case_written(saving.folder);
            screen_.changed();
            screen_.say(words_of_saved(anew, !workspace_.strokes().empty())
                            .arg(to_text(saving.folder))
                            .toStdString());
            if (saving.written) saving.written();
        };
    };
}

void PatientKeeper::ask_about_changed(Saving saving) {
    switch (questions_.changed_on_disk(saving.folder)) {
        case ChangedAnswer::replace:
            return add_saving(saving);
        case ChangedAnswer::save_as: {
            const std::filesystem::path parent = saving.folder.parent_path();
            const QString name = free_name(to_text(parent), to_text(saving.folder.filename()));
            if (ask_and_save(parent / to_path(name), std::move(saving.written))) return;
            break;
        }
        case ChangedAnswer::cancel:
            break;
    }
    if (std::exchange(go_, nullptr)) stay_();
    screen_.say(Words::tr("Not saved").toStdString());
}

}  // namespace hepatica
