// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/batch_report.h"

#include <cstdio>

#include "app/html_report.h"
#include "core/base/atomic_write.h"
#include "core/base/csv_cell.h"

namespace hepatica {

namespace {

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
    return text;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

// `patient` as his files are called; his record, which is JSON, may have had to replace bytes of
// it.
void add_patient(const std::string& patient, const BatchRecord& record, HtmlReport& page) {
    page.add_heading(record.patient);
    if (!record.done) {
        page.add_paragraph("Failed: " + record.reason);
        return;
    }
    if (record.has_picture)
        page.add_picture("pictures/" + patient + ".png",
                         "The vessels of " + record.patient + " from the front.");
    page.add_paragraph("Length of the vessels " + number(record.vessels_mm) + " mm; made in " +
                       number(record.seconds) + " s.");
    if (record.doubts.empty()) page.add_paragraph("Nothing is in doubt.");
    for (const std::string& doubt : record.doubts) page.add_paragraph(doubt);
}

}  // namespace

std::string batch_table(const std::filesystem::path& out,
                        const std::vector<std::string>& patients) {
    std::string table = "patient,state,seconds,vessels_mm,liver_ml,doubts,reason\n";
    for (const std::string& patient : patients) {
        const auto record = read_record(out, patient);
        table += csv_cell(patient) + ",";
        if (!record) {
            table += "to do,,,,,\n";
        } else if (record->done) {
            table += "done," + number(record->seconds) + "," + number(record->vessels_mm) + "," +
                     number(record->liver_ml) + "," + csv_cell(joined(record->doubts)) + ",\n";
        } else {
            table += "failed," + number(record->seconds) + ",,,," + csv_cell(record->reason) + "\n";
        }
    }
    return table;
}

void write_batch_report(const std::filesystem::path& out,
                        const std::vector<std::string>& patients) {
    write_text_atomically(out / "summary.csv", batch_table(out, patients));
    HtmlReport page("Hepatica: a batch of " + std::to_string(patients.size()) + " patients");
    std::size_t done = 0, failed = 0;
    for (const std::string& patient : patients)
        if (const auto record = read_record(out, patient)) ++(record->done ? done : failed);
    page.add_paragraph(std::to_string(done) + " done, " + std::to_string(failed) + " failed, " +
                       std::to_string(patients.size() - done - failed) +
                       " to do. The same as a table: summary.csv.");
    for (const std::string& patient : patients)
        if (const auto record = read_record(out, patient)) add_patient(patient, *record, page);
    page.write(out / "index.html");
}

}  // namespace hepatica
