// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit_journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
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
    const Json json{{"format", journal_format},
                    {"version", 1},
                    {"title", base.title},
                    {"case", base.place.string()},
                    {"extracted", to_hex(base.extracted)}};
    return json.dump() + "\n";
}

JournalBase base_from(const Json& json) {
    if (json.at("format") != journal_format || json.at("version") != 1)
        throw InputError("is no journal of edits", "", "");
    JournalBase base{json.at("title").get<std::string>(), json.at("case").get<std::string>(), 0};
    const auto digits = json.at("extracted").get<std::string>();
    std::from_chars(digits.data(), digits.data() + digits.size(), base.extracted, 16);
    return base;
}

void read_change(const Json& json, Journalled& read) {
    std::vector<TreeEdit> added = edits_from_json(json.at("add").dump(), "journal");
    const auto keep = json.at("keep").get<std::size_t>();
    const auto change = json.at("change").get<std::uint64_t>();
    if (keep > read.edits.size()) throw InputError("keeps more edits than there are", "", "");
    read.edits.resize(keep);
    std::ranges::move(added, std::back_inserter(read.edits));
    read.change = change;
}

bool write_whole(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno != EINTR) return false;
        done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    return ::fdatasync(file) == 0;
}

}  // namespace

std::optional<Journalled> read_edit_journal(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    Journalled read;
    bool has_base = false;
    try {
        for (std::string line; std::getline(in, line) && !in.eof();) {  // a whole line has an end
            const Json json = Json::parse(line);
            if (json.contains("format")) {
                read.base = base_from(json);
                has_base = true;
            } else {
                read_change(json, read);
            }
        }
    } catch (const Json::exception&) {
        // What stands before the damage counts.
    } catch (const InputError&) {
        // Likewise.
    }
    if (!has_base || read.change == 0) return std::nullopt;
    return read;
}

EditJournal::EditJournal(fs::path file)
    : file_(std::move(file)), thread_([this] { write_until_closed(); }) {}

EditJournal::~EditJournal() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void EditJournal::append(const JournalBase& base, const std::vector<TreeEdit>& edits,
                         std::uint64_t change) {
    std::string lines;
    if (base_ != base) lines = line_of(base);
    const auto same = std::ranges::mismatch(edits_, edits);
    const std::vector<TreeEdit> added(same.in2, edits.end());
    const Json json{{"change", change},
                    {"keep", same.in1 - edits_.begin()},
                    {"add", Json::parse(edits_to_json(added))}};
    lines += json.dump() + "\n";
    base_ = base;
    edits_ = edits;
    {
        const std::scoped_lock lock(mutex_);
        waiting_ += lines;
    }
    changed_.notify_one();
}

void EditJournal::write_until_closed() {
    int file = -1;
    for (;;) {
        std::string lines;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
            lines.swap(waiting_);
        }
        if (lines.empty()) break;
        if (file < 0) file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        if (file < 0 || !write_whole(file, lines)) failed_ = true;
    }
    if (file >= 0) ::close(file);
}

}  // namespace hepatica
