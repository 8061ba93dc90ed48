// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the review for another recording that is shown beside it.
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/lesson/attempts.h"
#include "core/lesson/review.h"
#include "core/lesson/score.h"
#include "core/session/recording_file.h"
#include "ui/core_words.h"
#include "ui/lesson_marks.h"
#include "ui/recording_dialog.h"
#include "ui/review_dock.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

void ReviewDock::compare(const fs::path& other) {
    other_job_.reset();
    other_tape_.reset();
    other_frame_.reset();
    ways_.beside(nullptr, {}, {}, {});
    compare_->setText(Words::tr("&Compare with…"));
    if (other.empty() || !reviewing()) return show_progress({});
    const RecordingFacts first = facts_of(file_), facts = facts_of(other);
    side_by_side_ = headings_of(first, facts);
    other_marked_ = std::make_shared<std::unique_ptr<const MarkedLesson>>();
    other_tape_ = std::make_shared<ReviewTape>();
    compare_->setText(Words::tr("E&nd the comparison"));
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [this](const JobProgress& now) { show_progress(now); };
    callbacks.failed = [this](const Failure& failure) {
        ways_.failed(failure);
        QTimer::singleShot(0, this, [this] { compare({}); });
    };
    callbacks.ended = [this] {
        other_job_.reset();
        show_progress({});
    };
    other_job_ = std::make_unique<BackgroundJob>(
        [file = other, lesson = lesson_, patient = ways_.patient(), tape = other_tape_,
         marked = other_marked_, first = first.lesson, named = facts.lesson,
         back_end = ways_.back_end](Job& job) -> std::function<void()> {
            const Recording recording = read_recording(file);
            if (hash_of(*patient) != recording.patient_hash)
                throw InputError(Words::id("was played on another patient"), file.string(),
                                 Words::id("Choose a recording of the patient who is shown"));
            const bool same = lesson && is_same_scene(recording.scene, lesson->scene);
            const auto own = with_course_pass(same ? lesson : built_in_lesson_of(recording), file);
            // Lessons that were made of others may have their scene, but other places.
            const bool is_own = own && named == (same ? first : translated(own->name));
            if (is_own) *marked = std::make_unique<const MarkedLesson>(*own, patient);
            review(recording, own, patient, *tape, job, back_end(recording.back_end),
                   interrupted_beside(file));
            return [] {};
        },
        std::move(callbacks));
}

double ReviewDock::end_s() const {
    return std::max(tape_->end_s(), comparing() ? other_tape_->end_s() : 0.0);
}

double ReviewDock::read_s() const {
    double read_s = end_s();
    if (job_ != nullptr) read_s = std::min(read_s, tape_->end_s());
    if (other_job_ != nullptr) read_s = std::min(read_s, other_tape_->end_s());
    return read_s;
}

double ReviewDock::length_s() const {
    return all_computed() ? end_s() : std::max(end_s(), played_s_);
}

void ReviewDock::show_other() {
    if (!comparing()) return;
    const std::shared_ptr<const Frame> frame = other_tape_->at(at_s_);
    if (frame == nullptr || frame == other_frame_) return;
    other_frame_ = frame;
    ways_.beside(frame, marks_in(*frame, *other_tape_, other_marked_->get()), side_by_side_[0],
                 side_by_side_[1]);
}

}  // namespace hepatica
