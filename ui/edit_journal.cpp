// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit_journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace hepatica {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* journal_format = "hepatica-edits";

std::string line_of(const JournalBase& base) {
    Json json{{"format", journal_format},
              {"version", 1},
              {"title", base.title},
              {"case", base.place.string()},
              {"extracted", to_hex(base.extracted)}};
    if (!base.copy_of.empty()) json["copy_of"] = base.copy_of.string();
    if (!base.digest.empty()) json["digest"] = base.digest;
    return json.dump() + "\n";
}

JournalBase base_from(const Json& json) {
    if (json.at("format") != journal_format || json.at("version") != 1)
        throw InputError("is no journal of edits", "", "");
    JournalBase base{json.at("title").get<std::string>(), json.at("case").get<std::string>(), 0};
    const auto digits = json.at("extracted").get<std::string>();
    std::from_chars(digits.data(), digits.data() + digits.size(), base.extracted, 16);
    base.copy_of = json.value("copy_of", std::string());
    base.digest = json.value("digest", std::string());
    return base;
}

// Keeps the first `keep` items and appends the added ones.
template <class Item>
void go_on_from(std::size_t keep, std::vector<Item> added, std::vector<Item>& items) {
    if (keep > items.size()) throw InputError("keeps more than there is", "", "");
    items.resize(keep);
    std::ranges::move(added, std::back_inserter(items));
}

void read_change(const Json& json, Journalled& read) {
    const auto change = json.at("change").get<std::uint64_t>();
    go_on_from(json.at("keep").get<std::size_t>(),
               edits_from_json(json.at("add").dump(), "journal"), read.edits);
    read.change = change;
    if (!json.contains("add_measured")) return;
    std::vector<KeptMeasurement> measured = read.measured.value_or(std::vector<KeptMeasurement>{});
    go_on_from(json.at("keep_measured").get<std::size_t>(),
               measurements_from_json(json.at("add_measured").dump(), "journal"), measured);
    read.measured = std::move(measured);
}

void read_strokes(const Json& json, Journalled& read) {
    go_on_from(json.at("keep_strokes").get<std::size_t>(),
               strokes_from_json(json.at("add_strokes").dump(), "journal"), read.strokes);
}

template <class Item>
std::size_t kept_of(const std::vector<Item>& before, const std::vector<Item>& now) {
    return static_cast<std::size_t>(std::ranges::mismatch(before, now).in1 - before.begin());
}

// The items of `now` after the first `kept`.
template <class Item>
std::vector<Item> added_to(std::size_t kept, const std::vector<Item>& now) {
    return {now.begin() + static_cast<std::ptrdiff_t>(kept), now.end()};
}

// Says in a change line how the measurements changed, if they did.
void note_measured(const Journalled& before, const Journalled& now, Json& change) {
    if (!now.measured || before.measured == now.measured) return;
    const std::size_t kept =
        kept_of(before.measured.value_or(std::vector<KeptMeasurement>{}), *now.measured);
    change["keep_measured"] = kept;
    change["add_measured"] = Json::parse(measurements_to_json(added_to(kept, *now.measured)));
}

// The lines that lead from one state to the next; from none if nothing is written yet, or the last
// line was cut off.
std::string lines_from(const std::optional<Journalled>& written, const Journalled& now) {
    const Journalled before = written.value_or(Journalled{});
    std::string lines;
    if (!written || before.base != now.base) lines = line_of(now.base);
    if (before.strokes != now.strokes) {
        const std::size_t kept = kept_of(before.strokes, now.strokes);
        const Json json{{"keep_strokes", kept},
                        {"add_strokes", Json::parse(strokes_to_json(added_to(kept, now.strokes)))}};
        lines += json.dump() + "\n";
    }
    const std::size_t kept = kept_of(before.edits, now.edits);
    Json json{{"change", now.change},
              {"keep", kept},
              {"add", Json::parse(edits_to_json(added_to(kept, now.edits)))}};
    note_measured(before, now, json);
    return lines + json.dump() + "\n";
}

bool write_whole(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno != EINTR) return false;
        done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    return ::fdatasync(file) == 0;
}

// `now` is empty as long as nothing can be believed.
void read_line(const Json& json, std::optional<Journalled>& now) {
    if (json.contains("format")) {
        JournalBase base = base_from(json);
        if (!now) now.emplace();
        now->base = std::move(base);
    } else if (now) {
        json.contains("add_strokes") ? read_strokes(json, *now) : read_change(json, *now);
    }
}

}  // namespace

std::optional<Journalled> read_edit_journal(const fs::path& file, JournalLoss* loss) {
    using Kind = JournalLoss::Kind;
    std::ifstream in(file, std::ios::binary);
    std::optional<Journalled> newest, now;
    JournalLoss lost;
    int number = 0;
    const auto damaged = [&](Kind kind) {
        now.reset();
        if (lost.kind == Kind::none) lost = {kind, number};
    };
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (in.eof()) {  // a line without its end is incomplete
            damaged(Kind::end);
            break;
        }
        try {
            read_line(Json::parse(line), now);
            if (!now || now->change == 0) continue;
            newest = now;
            lost = {};
        } catch (const Json::exception&) {
            damaged(Kind::line);
        } catch (const InputError&) {
            damaged(Kind::line);
        }
    }
    if (in.bad()) lost = {Kind::read, number + 1};
    if (loss != nullptr) *loss = lost;
    return newest;
}

EditJournal::EditJournal(fs::path file)
    : file_(std::move(file)), thread_([this] { write_until_closed(); }) {}

EditJournal::~EditJournal() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void EditJournal::append(const Journalled& wanted) {
    if (said_ == wanted && !failed_) return;
    said_ = wanted;
    {
        const std::scoped_lock lock(mutex_);
        waiting_ = wanted;
    }
    changed_.notify_all();
}

void EditJournal::wait_until_written() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !writing_ && !waiting_; });
}

void EditJournal::write_until_closed() {
    int file = -1;
    std::optional<Journalled> written;
    for (;;) {
        std::optional<Journalled> wanted;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return closing_ || waiting_; });
            wanted.swap(waiting_);
            writing_ = wanted.has_value();
        }
        if (!wanted) break;
        if (file < 0) file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        try {
            // The line break ends a line that was cut off.
            const std::string lines = (failed_ ? "\n" : "") + lines_from(written, *wanted);
            failed_ = file < 0 || !write_whole(file, lines);
        } catch (const std::exception&) {  // a text that JSON cannot hold
            failed_ = true;
        }
        written = failed_ ? std::nullopt : std::move(wanted);
        {
            const std::scoped_lock lock(mutex_);
            writing_ = false;
        }
        changed_.notify_all();
    }
    if (file >= 0) ::close(file);
}

}  // namespace hepatica
