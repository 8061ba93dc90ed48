// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a play: what was asked and reached, metrics, limits, the instructor's notes,
// pictures, plots over time, and the recording itself, as HTML, PDF and tables in one folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/opening/built_in_cache.h"
#include "ui/flow_units.h"

namespace hepatica {

struct ReportRequest {
    std::filesystem::path recording;
    std::filesystem::path out;  // a folder; other files in it are kept
    std::string lesson;         // file or name; empty: the built-in one that was played, or none
    std::string name;           // of the trainee; empty: not stated
    std::filesystem::path patient;          // a case; empty: see recorded_patient()
    BuiltInCache cache;                     // of the built-in patient
    FlowUnits units = FlowUnits::computed;  // on the pages; tables keep computed units
    std::string patient_name;               // on the pages; empty: the case's name, or none
    std::string language = "en";            // of the pages; must be the one given to use_language()
};

struct WrittenReport {
    std::optional<bool> passed;                // nullopt: nothing was played
    std::vector<std::filesystem::path> files;  // all files in the folder
    std::vector<std::string> warnings;         // from reading the recording
};

// Writes report.html, report.pdf, metrics.csv, plots.csv, pictures and recording.hrec, with the
// notes beside it where there are some, all of them or none. Where nothing was played the page says
// so, without a verdict, and tables and pictures are left out. Needs a QApplication, but no
// display. Throws InputError, also where a recording.hrec is there that is of no report; Cancelled.
WrittenReport write_report(const ReportRequest& request, Job& job);

}  // namespace hepatica
