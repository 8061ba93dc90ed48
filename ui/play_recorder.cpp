// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/play_recorder.h"

#include <QDateTime>
#include <exception>
#include <mutex>
#include <system_error>
#include <utility>

#include "core/session/recording_file.h"

namespace hepatica {

namespace fs = std::filesystem;

class PlayRecorder::Tape {
  public:
    // On the thread that steps.
    void begin(const fs::path& file, const Recording& start) {
        const std::scoped_lock lock(mutex_);
        if (ended_) return;
        try {
            writer_ = std::make_unique<RecordingWriter>(file, start);
        } catch (...) {
            failed_ = std::current_exception();
        }
    }
    void keep(RecordedStep step) {
        const std::scoped_lock lock(mutex_);
        if (writer_ == nullptr) return;
        writer_->append(std::move(step));
        ++steps_;
    }
    // Closes the file and returns the number of steps.
    std::size_t end() {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        if (failed_) std::rethrow_exception(failed_);
        if (auto writer = std::exchange(writer_, nullptr)) writer->close();
        return steps_;
    }

  private:
    std::mutex mutex_;
    std::unique_ptr<RecordingWriter> writer_;
    std::exception_ptr failed_;
    std::size_t steps_ = 0;
    bool ended_ = false;
};

PlayRecorder::PlayRecorder() = default;

PlayRecorder::~PlayRecorder() {
    try {
        end(nullptr);
    } catch (...) {
        // Nobody is left to be told; the steps written before stay.
    }
}

void PlayRecorder::begin(Simulation& simulation, const fs::path& folder) {
    fs::create_directories(folder);
    const QDateTime now = QDateTime::currentDateTimeUtc();
    file_ = folder / ("play-" + now.toString("yyyyMMdd-HHmmss-zzz").toStdString() + ".hrec");
    guard_ = std::make_unique<RecordingGuard>(file_);
    tape_ = std::make_shared<Tape>();
    const std::string played_at = now.toString(Qt::ISODate).toStdString();
    simulation.record_from_now([tape = tape_, file = file_, played_at](Recording start) {
        start.played_at = played_at;
        tape->begin(file, start);
        return [tape](RecordedStep step) { tape->keep(std::move(step)); };
    });
}

bool PlayRecorder::end(Simulation* simulation) {
    if (tape_ == nullptr) return false;
    const std::shared_ptr<Tape> tape = std::exchange(tape_, nullptr);
    if (simulation != nullptr) simulation->record_from_now({});
    const std::unique_ptr<RecordingGuard> guard = std::move(guard_);
    const bool recorded = tape->end() > 0;
    std::error_code ignored;
    if (!recorded) fs::remove(file_, ignored);
    return recorded;
}

}  // namespace hepatica
