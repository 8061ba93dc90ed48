// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording_guard.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <fstream>
#include <functional>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/atomic_write.h"
#include "core/base/file_extension.h"
#include "core/base/text_file.h"
#include "core/lesson/attempts.h"
#include "core/lesson/play_notes.h"
#include "ui/lock_file.h"
#include "ui/paths.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr const char* ending = ".hrec";
constexpr const char* mark_ending = ".unfinished";

fs::path mark_of(const fs::path& recording) {
    return recording.string() + mark_ending;
}

std::unique_ptr<QLockFile> recording_lock(const fs::path& recording) {
    return lock_file(recording.string() + ".lock");
}

// Attempts are called "LESSON-yyyyMMdd-HHmmss-zzz.hrec". Another lesson's name may begin like this
// one's.
bool is_called_after(const fs::path& recording, const std::string& lesson) {
    constexpr std::size_t when = std::string_view("-yyyyMMdd-HHmmss-zzz").size();
    const std::string stem = recording.stem().string();
    return stem.size() == lesson.size() + when && stem.starts_with(lesson + "-");
}

fs::file_time_type time_of(const fs::path& file) {
    std::error_code ignored;
    return fs::last_write_time(file, ignored);
}

}  // namespace

std::vector<fs::path> recordings_in(const fs::path& folder) {
    // Read once: one that is being written gets newer while the others are compared with it.
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
        if (extension_of(at->path()) == ending) found.emplace_back(time_of(at->path()), at->path());
    std::ranges::sort(found, std::greater());
    std::vector<fs::path> recordings;
    for (auto& [time, recording] : found) recordings.push_back(std::move(recording));
    return recordings;
}

RecordingGuard::RecordingGuard(fs::path recording)
    : recording_(std::move(recording)), lock_(recording_lock(recording_)) {
    lock_->tryLock(0);
    std::ofstream(mark_of(recording_)).flush();
}

RecordingGuard::~RecordingGuard() {
    forget_interruption(recording_);
}

void RecordingGuard::note(const Attempt& if_interrupted) {
    write_text_atomically(mark_of(recording_), text_of(if_interrupted));
}

bool is_being_recorded(const fs::path& recording) {
    std::error_code ignored;
    if (!fs::exists(mark_of(recording), ignored)) return false;
    return !recording_lock(recording)->tryLock(0);
}

std::vector<fs::path> interrupted_recordings(const fs::path& folder) {
    std::vector<fs::path> interrupted;
    std::error_code ignored;
    for (const fs::path& recording : recordings_in(folder))
        if (fs::exists(mark_of(recording), ignored) && !is_being_recorded(recording))
            interrupted.push_back(recording);
    return interrupted;
}

void keep_interrupted(const fs::path& recording) {
    const fs::path mark = mark_of(recording);
    const std::string text = read_text_file(mark, "");
    // A free play has no result, nor an attempt in which nothing was done.
    if (text.empty() || fs::exists(result_file_of(recording))) return;
    Attempt attempt = attempt_from(text, recording, mark.string());
    const QDateTime ended = QFileInfo(to_text(recording)).lastModified().toUTC();
    attempt.ended_at = ended.toString(Qt::ISODate).toStdString();
    write_attempt(attempt);
}

void forget_interruption(const fs::path& recording) {
    std::error_code ignored;
    fs::remove(mark_of(recording), ignored);
}

void forget_attempt(const fs::path& recording) {
    forget_interruption(recording);
    if (!interrupted_beside(recording)) return;
    std::error_code ignored;
    for (const fs::path& file : {recording, notes_file_of(recording), result_file_of(recording)})
        fs::remove(file, ignored);
}

std::vector<fs::path> recordings_without_result(const fs::path& folder, const std::string& lesson) {
    std::vector<fs::path> recordings = recordings_in(folder);
    std::erase_if(recordings, [&](const fs::path& recording) {
        std::error_code ignored;
        return !is_called_after(recording, lesson) ||
               fs::exists(result_file_of(recording), ignored) || is_being_recorded(recording);
    });
    std::ranges::reverse(recordings);
    return recordings;
}

}  // namespace hepatica
