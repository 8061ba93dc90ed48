// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the keeper that corrects the tree: what is wanted, which of it is possible, and the
// body of that.
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "ui/patient_keeper.h"
#include "ui/standing_warnings.h"
#include "ui/words.h"

namespace hepatica {

namespace {

// `undo_goes_on`: what was undone before them is still being made.
QString said_of(const Workspace::GivenUp& given_up, bool undo_goes_on) {
    const int steps = static_cast<int>(given_up.steps), lost = static_cast<int>(given_up.lost);
    if (undo_goes_on)
        return Words::tr(
            "%n correction(s) taken back; Redo makes them again. The Undo before them "
            "goes on: Cancel once more ends it, too",
            nullptr, steps);
    if (steps > 0)
        return Words::tr("%n correction(s) taken back; Redo makes them again", nullptr, steps);
    if (lost > 0)
        return Words::tr(
            "Cancelled: what was undone is there again. %n correction(s) made after "
            "that Undo cannot be made again",
            nullptr, lost);
    return Words::tr("Cancelled: what was undone is there again");
}

}  // namespace

void PatientKeeper::add_all(const std::vector<TreeEdit>& edits) {
    if (!workspace_.has_patient()) return;
    workspace_.add_all(edits);
    std::ranges::any_of(edits, changes_tree, &TreeEdit::kind) ? correct() : screen_.changed();
}

// Looked for once the corrections before it are made, of which it depends what still fits.
void PatientKeeper::accept_offers(double confidence) {
    if (!workspace_.has_patient()) return;
    QueuedJob job;
    job.kind = JobKind::offers;
    job.title = Words::tr("Taking what is offered").toStdString();
    job.begin = [this, confidence] { return accepting(confidence); };
    job.failed = [this, title = job.title](const Failure& failure) {
        screen_.failed(title, failure);
    };
    job.cancelled = [this] { screen_.say(Words::tr("Nothing was taken").toStdString()); };
    jobs_.replace(std::move(job));
}

BackgroundJob::Work PatientKeeper::accepting(double confidence) {
    return [this, confidence, patient = workspace_.patient(),
            edits = workspace_.edits()](Job& job) -> std::function<void()> {
        job.expect_stages(1);
        job.begin_stage(Words::id("Looking for what fits"));
        const Workspace::Edits found = ways_.offers(*patient, edits, confidence, job);
        return [this, edits, patient, found] {
            if (edits != workspace_.edits() || patient != workspace_.patient())
                return screen_.say(
                    Words::tr("Nothing was taken, because something was corrected meanwhile")
                        .toStdString());
            if (found.empty())
                return screen_.say(
                    Words::tr("None of them fits: taken one by one, each says why").toStdString());
            workspace_.add_all(found);
            correct(JobQueue::Turn::next);  // a case that waits to be saved holds it
        };
    };
}

void PatientKeeper::correct(JobQueue::Turn turn) {
    screen_.changed();
    if (!workspace_.awaits_body()) return jobs_.drop(JobKind::correct);
    QueuedJob job;
    job.kind = JobKind::correct;
    job.title = Words::tr("Correcting the tree").toStdString();
    job.begin = [this] { return correction(); };
    job.failed = [this, title = job.title](const Failure& failure) {
        give_up_what_waits();
        screen_.failed(title, failure);
    };
    job.cancelled = [this] {
        const Workspace::GivenUp given_up = give_up_what_waits();
        screen_.say(said_of(given_up, workspace_.awaits_body()).toStdString());
    };
    jobs_.replace(std::move(job), turn);
}

// An impossible correction is refused without affecting those after it.
PatientKeeper::Possible PatientKeeper::possible_edits(const PatientCase& patient,
                                                      const Workspace::Edits& wanted,
                                                      const Job& job) const {
    Possible possible;
    try {
        ways_.check(patient, wanted);
        return {wanted, {}};
    } catch (const InputError&) {
        // The loop below finds out which ones.
    }
    for (const TreeEdit& edit : wanted) {
        job.throw_if_cancelled();
        possible.edits.push_back(edit);
        try {
            ways_.check(patient, possible.edits);
        } catch (const InputError&) {
            possible.edits.pop_back();
            possible.refused.push_back(failure_of(std::current_exception()));
        }
    }
    return possible;
}

BackgroundJob::Work PatientKeeper::correction() {
    return [this, wanted = workspace_.edits(),
            patient = workspace_.patient()](Job& job) -> std::function<void()> {
        const Possible possible = possible_edits(*patient, wanted, job);
        std::shared_ptr<LoadedPatient> loaded;
        if (possible.edits != patient->corrections.edits) {
            auto corrected =
                std::make_shared<const PatientCase>(ways_.correct(*patient, possible.edits, job));
            loaded = std::make_shared<LoadedPatient>(ways_.play_on(std::move(corrected), job));
        }
        const auto said_before = said_of_vessels(*patient);
        const auto said_now = loaded ? said_of_vessels(*loaded->patient) : said_before;
        return [this, loaded, patient, said_before, said_now, refused = possible.refused] {
            workspace_.show_body(loaded ? loaded->patient : patient);
            workspace_.set_warnings(still_standing(workspace_.warnings(), said_before, said_now));
            if (loaded) loaded->warnings = workspace_.warnings();
            if (loaded) screen_.show(std::move(*loaded), true);
            if (!refused.empty()) go_ = nullptr;
            for (const Failure& failure : refused)
                screen_.failed(Words::tr("Correcting the tree").toStdString(), failure);
            screen_.changed();
        };
    };
}

Workspace::GivenUp PatientKeeper::give_up_what_waits() {
    go_ = nullptr;
    const Workspace::GivenUp given_up = workspace_.give_up_edits();
    // A case that waits to be saved holds what is left.
    workspace_.awaits_body() ? correct(JobQueue::Turn::next) : screen_.changed();
    return given_up;
}

}  // namespace hepatica
