// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recovery.h"

#include <QLockFile>
#include <QUuid>
#include <algorithm>
#include <system_error>
#include <utility>

#include "core/opening/patient_image.h"
#include "ui/paths.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr int delay_ms = 500;
constexpr const char* lock_name = "lock";

std::unique_ptr<QLockFile> lock_of(const fs::path& folder) {
    auto lock = std::make_unique<QLockFile>(to_text(folder / lock_name));
    lock->setStaleLockTime(
        0);  // a program may run for weeks; one that is gone is seen by its number
    return lock;
}

// A title as the name of a case folder.
std::string case_name(std::string title) {
    for (const char* ending : {".hepz", ".hep"})
        if (title.ends_with(ending)) title.resize(title.size() - std::string_view(ending).size());
    std::ranges::replace(title, '/', '_');
    return (title.empty() || title.front() == '.' ? "case" + title : title) + ".hep";
}

// One of another program, and that program's folder where it was the last one.
void remove_copy(const fs::path& place) {
    if (place.empty()) return;
    const fs::path version = place.parent_path(), program = version.parent_path();
    std::error_code ignored;
    fs::remove_all(version, ignored);
    for (const auto& entry : fs::directory_iterator(program, ignored))
        if (entry.is_directory()) return;
    fs::remove_all(program, ignored);
}

}  // namespace

Recovery::Recovery(fs::path folder, Write write, std::function<void(const Failure&)> failed)
    : folder_(std::move(folder)), write_(std::move(write)), failed_(std::move(failed)) {
    delay_.setSingleShot(true);
    delay_.setInterval(delay_ms);
    QObject::connect(&delay_, &QTimer::timeout, &delay_, [this] { this->write(); });
}

Recovery::~Recovery() = default;

void Recovery::follow(const Workspace& workspace) {
    if (!write_) return;
    if (!workspace.dirty()) {
        delay_.stop();
        wanted_ = {};
        kept_version_ = 0;
        needless_ = job_ != nullptr;
        if (!job_) remove_own_copies();
        remove_copy(workspace.kept_copy());
        return;
    }
    // Called again as soon as the correction has its body.
    if (workspace.awaits_body() || workspace.version() == kept_version_) return;
    wanted_ = {workspace.patient(), workspace.made_edits(), workspace.title(),
               workspace.folder(),  workspace.kept_copy(),  workspace.version()};
    needless_ = false;
    delay_.start();
}

void Recovery::write() {
    if (job_ || !wanted_.patient) return;
    const Copy copy = std::exchange(wanted_, {});
    needless_ = false;
    BackgroundJob::Callbacks callbacks;
    callbacks.progress = [](const JobProgress&) {};
    callbacks.failed = failed_;
    callbacks.cancelled = [] {};
    callbacks.ended = [this] {
        job_.reset();
        if (needless_) remove_own_copies();
        this->write();
    };
    try {
        make_own_folder();
    } catch (...) {
        return failed_(failure_of(std::current_exception()));
    }
    // Beside the copy before, which is removed when this one is whole.
    const fs::path place = own_ / std::to_string(copy.version) / case_name(copy.title);
    job_ = std::make_unique<BackgroundJob>(
        [this, copy, place, write = write_](Job& job) -> std::function<void()> {
            const PatientCase whole = whole_case(*copy.patient, copy.voxels, copy.edits, job);
            fs::create_directories(place.parent_path());
            write(place, whole);
            return [this, copy, place] { written(copy, place); };
        },
        std::move(callbacks));
}

void Recovery::written(const Copy& copy, const fs::path& place) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(own_, ignored))
        if (entry.is_directory() && entry.path() != place.parent_path())
            fs::remove_all(entry.path(), ignored);
    kept_version_ = copy.version;
    remove_copy(copy.opened_from);  // it is not needed beside this one
}

void Recovery::make_own_folder() {
    if (!own_.empty()) return;
    const fs::path own = folder_ / QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    fs::create_directories(own);
    fs::permissions(own, fs::perms::owner_all);  // nobody else's business
    lock_ = lock_of(own);
    lock_->tryLock(0);
    own_ = own;
}

void Recovery::remove_own_copies() {
    if (own_.empty()) return;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(own_, ignored))
        if (entry.is_directory()) fs::remove_all(entry.path(), ignored);
}

void Recovery::end() {
    delay_.stop();
    wanted_ = {};
    job_.reset();
    if (own_.empty()) return;
    lock_.reset();
    std::error_code ignored;
    fs::remove_all(own_, ignored);
    own_.clear();
}

std::vector<fs::path> Recovery::left_behind() const {
    struct Left {
        fs::path place;
        fs::file_time_type time;
    };
    std::vector<Left> left;
    std::error_code ignored;
    for (const auto& program : fs::directory_iterator(folder_, ignored)) {
        if (program.path() == own_ || !program.is_directory()) continue;
        if (!lock_of(program.path())->tryLock(0)) continue;  // it runs
        for (const auto& version : fs::directory_iterator(program.path(), ignored)) {
            if (!version.is_directory()) continue;
            for (const auto& entry : fs::directory_iterator(version.path(), ignored))
                if (is_case(entry.path()))
                    left.push_back({entry.path(), entry.last_write_time(ignored)});
        }
    }
    std::ranges::sort(left, std::greater(), &Left::time);
    std::vector<fs::path> places;
    for (Left& one : left) places.push_back(std::move(one.place));
    return places;
}

}  // namespace hepatica
