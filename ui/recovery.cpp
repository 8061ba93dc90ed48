// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recovery.h"

#include <QUuid>
#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "core/opening/patient_image.h"
#include "ui/lock_file.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr int delay_ms = 500;
constexpr const char* lock_name = "lock";
constexpr const char* journal_name = "edits.jsonl";
constexpr const char* copy_beside = ".";

std::unique_ptr<QLockFile> lock_of(const fs::path& folder) {
    return lock_file(folder / lock_name);
}

// Shortened to so many bytes, between two letters.
void shorten(std::string& text, std::size_t most) {
    if (text.size() <= most) return;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
    text.resize(most);
}

// A title as the name of a case folder. File systems take 255 bytes, and a CT may have all of them.
std::string case_name(std::string title) {
    constexpr std::size_t longest = 200;
    for (const char* ending : {".hepz", ".hep"})
        if (title.ends_with(ending)) title.resize(title.size() - std::string_view(ending).size());
    std::ranges::replace(title, '/', '_');
    shorten(title, longest);
    return (title.empty() || title.front() == '.' ? "case" + title : title) + ".hep";
}

// A complete copy and the number of the change that it includes.
struct KeptCopy {
    fs::path place;
    std::uint64_t version = 0;
};

// The newest copy in a program's folder; its place is empty if there is none.
KeptCopy newest_copy(const fs::path& program) {
    KeptCopy newest;
    std::error_code ignored;
    for (const auto& version : fs::directory_iterator(program, ignored)) {
        if (!version.is_directory()) continue;
        const std::string digits = version.path().filename().string();
        std::uint64_t number = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
        for (const auto& entry : fs::directory_iterator(version.path(), ignored))
            if (is_case(entry.path()) && (newest.place.empty() || number > newest.version))
                newest = {entry.path(), number};
    }
    return newest;
}

// The case that the edits of this journal apply to; empty: the built-in patient.
fs::path base_of(const Journalled& left, const fs::path& journal) {
    return left.base.place == copy_beside ? newest_copy(journal.parent_path()).place
                                          : left.base.place;
}

// A program's journal if it is newer than the copy or holds strokes, which no copy does; else the
// copy; else empty.
fs::path newest_of(const fs::path& program) {
    const KeptCopy copy = newest_copy(program);
    const fs::path journal = program / journal_name;
    const std::optional<Journalled> left = read_edit_journal(journal);
    const bool needs_copy = left && left->base.place == copy_beside;
    const bool can_be_made = left && !(needs_copy && copy.place.empty());
    if (!can_be_made) return copy.place;
    const bool says_more =
        left->change > copy.version || (left->change == copy.version && !left->strokes.empty());
    return copy.place.empty() || says_more ? journal : copy.place;
}

// The journal that is left, or that of the copy that is.
fs::path journal_of(const fs::path& left) {
    return left.filename() == journal_name ? left : left.parent_path().parent_path() / journal_name;
}

// What this journal holds; nullopt where it is none or is damaged.
std::optional<Journalled> noted_in(const fs::path& place) {
    return place.filename() == journal_name ? read_edit_journal(place) : std::nullopt;
}

template <class T>
bool begins_with(const std::vector<T>& whole, const std::vector<T>& part) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

// What a journal that is damaged has lost, as a warning; empty: nothing.
std::string words_of_loss(const JournalLoss& loss, const fs::path& journal) {
    const QString file = to_text(journal);
    switch (loss.kind) {
        case JournalLoss::Kind::none:
            return {};
        case JournalLoss::Kind::end:
            return Words::tr(
                       "The last change was being written when the program ended, and is lost: "
                       "all before it is here")
                .toStdString();
        case JournalLoss::Kind::line:
            return Words::tr(
                       "The unsaved work is that of before line %1 of %2, which is damaged: "
                       "what was done later is lost")
                .arg(QString::number(loss.line), file)
                .toStdString();
        case JournalLoss::Kind::read:
            return Words::tr(
                       "The unsaved work may lack its end: %1 cannot be read from line %2 on. "
                       "Check its disk and open it again")
                .arg(file, QString::number(loss.line))
                .toStdString();
    }
    return {};
}

// Whether the newer journal holds all of the older one's work: a program was killed after it had
// taken over what another one had left, before it had a copy of its own.
bool holds_all(const Journalled& newer, const Journalled& older) {
    return newer.base.place != copy_beside && newer.base.place == older.base.place &&
           newer.base.extracted == older.base.extracted && begins_with(newer.edits, older.edits) &&
           begins_with(newer.strokes, older.strokes) && newer.measured == older.measured;
}

// Removes what ended programs left of the same work.
void remove_older(const Journalled& newer, const fs::path& folder, const fs::path& own) {
    std::error_code ignored;
    std::vector<fs::path> older;
    for (const auto& program : fs::directory_iterator(folder, ignored)) {
        if (program.path() == own || !program.is_directory()) continue;
        if (!lock_of(program.path())->tryLock(0)) continue;  // still running
        const auto noted = noted_in(newest_of(program.path()));
        if (noted && holds_all(newer, *noted)) older.push_back(program.path());
    }
    for (const fs::path& program : older) fs::remove_all(program, ignored);
}

// Removes what another program left: a copy, and the whole folder if `place` is its journal or its
// last copy. `own`: the folder of this program.
void remove_left(const fs::path& place, const fs::path& own) {
    if (place.empty()) return;
    const fs::path version = place.parent_path(), program = version.parent_path();
    std::error_code ignored;
    if (place.filename() == journal_name) {
        const std::optional<Journalled> noted = noted_in(place);
        fs::remove_all(version, ignored);
        if (noted) remove_older(*noted, program, own);
        return;
    }
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
    noted_.setSingleShot(true);
    noted_.setInterval(delay_ms);
    QObject::connect(&noted_, &QTimer::timeout, &noted_, [this] {
        if (journal_ && newest_ && journal_->failed()) tell_of_journal(own_, newest_->noted);
    });
}

Recovery::~Recovery() = default;

void Recovery::follow(const Workspace& workspace) {
    if (!write_) return;
    if (!workspace.dirty()) forget_copies();
    if (!workspace.unsaved()) {
        forget_journal();
        return remove_left(workspace.kept_copy(), own_);
    }
    note(wanted_of(workspace));
    if (!workspace.dirty()) {  // strokes alone, on a saved case
        if (journal_ && !workspace.kept_copy().empty()) {
            journal_->wait_until_written();
            if (!journal_->failed()) remove_left(workspace.kept_copy(), own_);
        }
        return;
    }
    // Called again when the correction has its body.
    if (workspace.awaits_body() || workspace.version() == kept_version_) return;
    wanted_ = {workspace.patient(), workspace.made_edits(), workspace.measured(),
               workspace.title(),   workspace.folder(),     workspace.kept_copy(),
               workspace.version(), workspace.origin()};
    needless_ = false;
    delay_.start();
}

Recovery::Wanted Recovery::wanted_of(const Workspace& workspace) {
    const bool built_in =
        workspace.title() == built_in_title && workspace.folder().empty() && !workspace.remade();
    return {{{workspace.title(), workspace.base(), hash_of_extracted(*workspace.patient()),
              workspace.home(), workspace.digest()},
             workspace.edits(),
             workspace.strokes(),
             workspace.version(),
             workspace.measured()},
            workspace.base().empty() && !built_in,
            workspace.origin()};
}

// An own copy is preferred to a case that may be changed or removed.
void Recovery::note(const Wanted& wanted) {
    const bool has_copy = copy_origin_ == wanted.origin;
    newest_ = wanted;
    if (wanted.needs_copy && !has_copy) return;  // written() notes it
    Journalled noted = wanted.noted;
    if (has_copy) noted.base.place = copy_beside;
    if (noted.base.place == noted.base.copy_of) noted.base.copy_of.clear();
    try {
        make_own_folder();
    } catch (...) {
        return tell_of_journal(folder_, noted);
    }
    if (!journal_) journal_ = std::make_unique<EditJournal>(own_ / journal_name);
    journal_->append(noted);
    if (journal_->failed()) tell_of_journal(own_, noted);
    noted_.start();  // another thread writes this one
}

// Once: every change is noted.
void Recovery::tell_of_journal(const fs::path& folder, const Journalled& lost) {
    if (std::exchange(told_of_journal_, true)) return;
    const char* remedy =  // no case holds strokes
        lost.strokes.empty()
            ? Words::id("make room on the disk; save the case")
            : Words::id("make room on the disk; rebuild the vessels and save the case");
    failed_({Words::id("corrections cannot be noted at once"), folder.string(), remedy});
}

// Their content is in a case on disk.
void Recovery::forget_copies() {
    delay_.stop();
    wanted_ = {};
    kept_version_ = 0;
    needless_ = job_ != nullptr;
    if (job_)
        copy_origin_ = 0;
    else
        remove_own_copies();
}

void Recovery::forget_journal() {
    noted_.stop();
    newest_.reset();
    if (!std::exchange(journal_, nullptr)) return;
    std::error_code ignored;
    fs::remove(own_ / journal_name, ignored);
}

void Recovery::write() {
    if (job_ || !wanted_.patient) return;
    const Copy copy = std::exchange(wanted_, {});
    needless_ = false;
    BackgroundJob::Callbacks callbacks;
    callbacks.failed = failed_;
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
    // Beside the former copy, which is removed when this one is complete.
    const fs::path place = own_ / std::to_string(copy.version) / case_name(copy.title);
    job_ = std::make_unique<BackgroundJob>(
        [this, copy, place, write = write_](Job& job) -> std::function<void()> {
            PatientCase whole = whole_case(*copy.patient, copy.voxels, copy.edits, job);
            whole.measured = copy.measured;
            fs::create_directories(place.parent_path());
            write(place, whole);
            return [this, copy, place] {
                if (!needless_) written(copy, place);
            };
        },
        std::move(callbacks));
}

void Recovery::written(const Copy& copy, const fs::path& place) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(own_, ignored))
        if (entry.is_directory() && entry.path() != place.parent_path())
            fs::remove_all(entry.path(), ignored);
    kept_version_ = copy.version;
    copy_origin_ = copy.origin;
    if (newest_ && newest_->origin == copy.origin) note(Wanted(*newest_));
    remove_left(copy.opened_from, own_);  // superseded by this copy
}

void Recovery::make_own_folder() {
    if (!own_.empty()) return;
    const fs::path own = folder_ / QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    fs::create_directories(own);
    fs::permissions(own, fs::perms::owner_all);  // private to the user
    lock_ = lock_of(own);
    lock_->tryLock(0);
    own_ = own;
}

void Recovery::remove_own_copies() {
    copy_origin_ = 0;
    if (own_.empty()) return;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(own_, ignored))
        if (entry.is_directory()) fs::remove_all(entry.path(), ignored);
}

void Recovery::end() {
    delay_.stop();
    wanted_ = {};
    job_.reset();
    forget_journal();
    copy_origin_ = 0;
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
        if (!lock_of(program.path())->tryLock(0)) continue;  // still running
        const fs::path place = newest_of(program.path());
        if (!place.empty()) left.push_back({place, fs::last_write_time(place, ignored)});
    }
    std::ranges::sort(left, std::greater(), &Left::time);
    std::vector<fs::path> places;
    std::vector<Journalled> told;
    for (Left& one : left) {
        if (std::optional<Journalled> noted = noted_in(one.place)) {
            if (std::ranges::any_of(
                    told, [&](const Journalled& newer) { return holds_all(newer, *noted); }))
                continue;
            told.push_back(std::move(*noted));
        }
        places.push_back(std::move(one.place));
    }
    return places;
}

fs::path Recovery::case_of(const fs::path& left) {
    if (left.empty()) return {};
    const std::optional<Journalled> noted = read_edit_journal(journal_of(left));
    return noted && is_case(noted->base.copy_of) ? noted->base.copy_of : fs::path();
}

std::string Recovery::digest_of(const fs::path& left) {
    if (left.empty()) return {};
    const std::optional<Journalled> noted = read_edit_journal(journal_of(left));
    return noted ? noted->base.digest : std::string();
}

UnsavedWork Recovery::unsaved_work(const fs::path& left) {
    UnsavedWork work;
    const bool is_journal = left.filename() == journal_name;
    // A copy may be offered because the journal beside it is damaged.
    const fs::path journal = journal_of(left);
    JournalLoss loss;
    std::optional<Journalled> noted = read_edit_journal(journal, &loss);
    work.request.lost = words_of_loss(loss, journal);
    if (!is_journal) noted.reset();
    if (!noted) {
        work.title = left.stem().string();
        work.request.reconstruct.ct = left;
        work.request.unsaved_copy = true;
        return work;
    }
    work.title = noted->base.title;
    work.request.reconstruct.ct = base_of(*noted, left);
    work.request.built_in = work.request.reconstruct.ct.empty();
    work.request.unsaved_copy = noted->base.place == copy_beside;
    work.request.left_edits = LeftEdits{noted->edits, noted->strokes,  noted->base.extracted,
                                        left,         noted->measured, noted->base.digest};
    return work;
}

}  // namespace hepatica
