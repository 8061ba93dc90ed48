// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the keeper that leaves a patient: asks about what is unsaved and waits for what is
// being written.
#include <utility>

#include "ui/patient_keeper.h"
#include "ui/words.h"

namespace hepatica {

void PatientKeeper::leave(std::function<void()> go, std::function<void()> stay) {
    leave_patient([this, go = std::move(go), stay] { go_when_reported(go, stay); }, stay);
    ends_ = true;
}

void PatientKeeper::leave_patient(std::function<void()> go, std::function<void()> stay) {
    ends_ = false;
    discarded_version_.reset();
    dropped_strokes_.reset();
    leave_if_safe(std::move(go), std::move(stay));
}

void PatientKeeper::leave_if_safe(std::function<void()> go, std::function<void()> stay) {
    go_ = nullptr;
    // What is being taken is asked about once it is there.
    if (jobs_.holds(JobKind::offers)) return wait_to_go(std::move(go), std::move(stay));
    if (!jobs_.holds(JobKind::save)) {
        bool stays = false;
        if (!strokes_let_go([&stays] { stays = true; }))
            return stays ? stay() : wait_to_go(std::move(go), std::move(stay));
        if (!workspace_.dirty() || discarded_version_ == workspace_.version())
            return go_when_archived(std::move(go), std::move(stay));
        const UnsavedAnswer answer = questions_.unsaved(workspace_.title());
        if (answer == UnsavedAnswer::cancel) return stay();
        if (answer == UnsavedAnswer::discard) {
            discarded_version_ = workspace_.version();
            return go_when_archived(std::move(go), std::move(stay));
        }
        if (!save()) return stay();
    }
    wait_to_go(std::move(go), std::move(stay));
}

void PatientKeeper::wait_to_go(std::function<void()> go, std::function<void()> stay) {
    go_ = std::move(go);
    stay_ = std::move(stay);
}

bool PatientKeeper::strokes_let_go(const std::function<void()>& stay) {
    if (workspace_.strokes().empty() || dropped_strokes_ == workspace_.strokes_version())
        return true;
    switch (questions_.strokes(workspace_.title(), workspace_.strokes().size())) {
        case StrokesAnswer::drop:
            dropped_strokes_ = workspace_.strokes_version();
            return true;
        case StrokesAnswer::rebuild:
            if (!jobs_.holds(JobKind::remake)) screen_.remake_painted();
            // When that has ended, go_on() continues.
            if (jobs_.holds(JobKind::remake)) return false;
            break;
        case StrokesAnswer::cancel:
            break;
    }
    stay();
    return false;
}

bool PatientKeeper::play_let_go() {
    const std::optional<int> play = screen_.kept_play();
    if (!play || play == ended_play_) return true;
    if (!questions_.end_play()) return false;
    ended_play_ = play;
    return true;
}

void PatientKeeper::go_when_archived(std::function<void()> go, std::function<void()> stay) {
    if (!jobs_.holds(JobKind::archive)) return go();
    wait_to_go(std::move(go), std::move(stay));
}

void PatientKeeper::go_when_reported(const std::function<void()>& go,
                                     const std::function<void()>& stay) {
    if (!jobs_.holds(JobKind::report)) return go();
    screen_.say(Words::tr("The window closes as soon as the report is written. Cancel closes it "
                          "without the report.")
                    .toStdString());
    wait_to_go([this, go, stay] { go_when_reported(go, stay); }, stay);
}

// The user is to read why there is no report.
void PatientKeeper::add_report(QueuedJob job) {
    job.failed = [this, failed = std::move(job.failed)](const Failure& failure) {
        if (ends_ && std::exchange(go_, nullptr)) stay_();
        failed(failure);
    };
    jobs_.add(std::move(job));
}

// After a save, a rebuild, a report or a search among what is offered: asks again about later
// corrections.
void PatientKeeper::go_on() {
    if (go_ && !jobs_.holds(JobKind::save) && !jobs_.holds(JobKind::archive) &&
        !jobs_.holds(JobKind::remake) && !jobs_.holds(JobKind::offers))
        leave_if_safe(std::exchange(go_, nullptr), stay_);
}

}  // namespace hepatica
