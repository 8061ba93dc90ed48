// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_play.h"

#include <QDateTime>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/session/session.h"
#include "ui/simulation_thread.h"
#include "ui/words.h"

namespace hepatica {

namespace {

// A command of the setup was refused, which the session says in its frame: nobody could play that.
[[noreturn]] void refuse_setup(const LessonWatch& watch, Session& session) {
    std::error_code ignored;
    std::filesystem::remove(watch.recording(), ignored);
    session.update_frame();
    const FrameStatistics& said = session.frame().statistics;
    const bool is_refusal = !said.message.empty() && !said.message_of_solver;
    const std::string why = is_refusal ? said.message : watch.standing().reasons.front();
    throw InputError("cannot be set up: " + why, watch.lesson().name,
                     Words::id("Change what the lesson sets up, or the parts of its scene"));
}

}  // namespace

LessonWatch::LessonWatch(Lesson lesson, std::shared_ptr<const PatientCase> patient,
                         std::filesystem::path recording)
    : run_(std::move(lesson), std::move(patient)),
      recording_(std::move(recording)),
      standing_(run_.standing()) {}

LessonStanding LessonWatch::standing() const {
    const std::scoped_lock lock(mutex_);
    return standing_;
}

bool LessonWatch::see(const std::vector<Command>& commands, const Frame& frame,
                      const std::stop_token& stop) {
    run_.see(commands, frame, stop);
    const bool running = run_.standing().outcome == LessonOutcome::running;
    {
        const std::scoped_lock lock(mutex_);
        standing_ = run_.standing();
    }
    if (running) return true;
    // The step that ended the attempt was recorded before; what follows does not belong to it.
    writer_->close();
    writer_.reset();
    recorded_ = true;
    return false;
}

void LessonWatch::keep(RecordedStep step) {
    if (writer_ != nullptr) writer_->append(std::move(step));
}

LessonPlay LessonPlay::begin(const Lesson& lesson, std::shared_ptr<const PatientCase> patient,
                             const std::filesystem::path& recording, Job& job,
                             const DeformBackEnd& back_end) {
    LessonPlay play;
    play.watch = std::make_shared<LessonWatch>(lesson, patient, recording);
    auto session = std::make_unique<Session>(std::move(patient), lesson.scene, job, back_end);
    Recording start = session->recording_start();
    start.played_at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    play.watch->writer_ = std::make_unique<RecordingWriter>(recording, start);
    session->record([watch = play.watch](RecordedStep step) { watch->keep(std::move(step)); });
    session->watch(
        [watch = play.watch, played = session.get()](
            const std::vector<Command>& commands, const Frame& frame, const std::stop_token& stop) {
            const bool running = watch->see(commands, frame, stop);
            // At once, so that the play shown beside the verdict is the one that was judged: the
            // window learns of the verdict some steps later.
            if (!running) played->post(SetPaused{true});
            return running;
        });
    for (const Command& command : play.watch->run_.setup()) session->post(command);
    if (lesson.scene.deform) session->post(SetAutomaticQuality{true});
    session->step(job);
    if (play.watch->standing().outcome != LessonOutcome::running)
        refuse_setup(*play.watch, *session);
    // The trainee reads the task first: time stands until he does something.
    session->post(SetPaused{true});
    play.simulation = std::make_unique<SimulationThread>(std::move(session));
    return play;
}

}  // namespace hepatica
