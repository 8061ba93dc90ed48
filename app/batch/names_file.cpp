// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/names_file.h"

#include <fstream>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/atomic_write.h"
#include "core/base/csv_cell.h"
#include "core/base/error.h"
#include "core/base/text_file.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr const char* heading = "patient,scan";

// Reads a cell written by csv_cell() at `at`, and moves `at` behind it.
std::optional<std::string> cell_from(const std::string& text, std::size_t& at) {
    if (at >= text.size() || text[at] != '"') return std::nullopt;
    std::string cell;
    for (++at; at < text.size(); ++at) {
        if (text[at] != '"') {
            cell += text[at];
        } else if (at + 1 < text.size() && text[at + 1] == '"') {
            cell += text[at++];
        } else {
            ++at;
            return cell;
        }
    }
    return std::nullopt;
}

// The pseudonyms and scans in the file; names may hold line breaks.
std::map<std::string, std::string> read_names(const fs::path& file) {
    std::map<std::string, std::string> names;
    if (std::error_code ignored; !fs::exists(file, ignored)) return names;
    const std::string text =
        read_text_file(file, "Make it readable: it alone says which case is whose");
    if (text.empty()) return names;
    const auto check = [&](bool as_written) {
        if (!as_written)
            throw InputError("is not as it was written", file.string(),
                             "Put it right: it alone says which case is whose");
    };
    const std::string first_line = std::string(heading) + "\n";
    check(text.starts_with(first_line));
    for (std::size_t at = first_line.size(); at < text.size(); ++at) {
        const auto patient = cell_from(text, at);
        const bool comma = patient && at < text.size() && text[at] == ',';
        const auto scan = comma ? cell_from(text, ++at) : std::nullopt;
        check(scan && at < text.size() && text[at] == '\n');
        names[*patient] = *scan;
    }
    return names;
}

}  // namespace

void write_names(const fs::path& out, const std::vector<BatchInput>& inputs) {
    const fs::path file = out / "names.csv";
    std::map<std::string, std::string> names = read_names(file);
    for (const BatchInput& input : inputs) {
        const auto [entry, is_new] = names.try_emplace(input.patient, input.scan);
        if (!is_new && entry->second != input.scan)
            throw InputError("calls two scans " + input.patient, file.string(),
                             "Give another --out, or rename one of the scans");
    }
    std::string table = std::string(heading) + "\n";
    for (const auto& [patient, scan] : names)
        table += csv_cell(patient) + "," + csv_cell(scan) + "\n";
    write_file_atomically(file, [&](const fs::path& temporary) {
        std::ofstream created(temporary, std::ios::binary);
        std::error_code ignored;  // some file systems have no owners
        fs::permissions(temporary, fs::perms::owner_read | fs::perms::owner_write, ignored);
        created << table;
        if (!created.flush())
            throw InputError("cannot be written", file.string(), "Is the disk full?");
    });
}

}  // namespace hepatica
