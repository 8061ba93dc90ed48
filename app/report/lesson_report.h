// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a play: what was asked and reached, the metrics, pictures, plots over time, the
// limits, and the recording itself, as HTML, PDF and tables in one folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/opening/built_in_cache.h"
#include "ui/flow_units.h"

namespace hepatica {

struct ReportRequest {
    std::filesystem::path recording;
    std::filesystem::path out;  // a folder; others' files in it stay
    std::string lesson;         // file or name; empty: the built-in one that was played, or none
    std::string name;           // of the trainee; empty: not said
    std::filesystem::path patient;          // a case; empty: see recorded_patient()
    BuiltInCache cache;                     // of the built-in patient
    FlowUnits units = FlowUnits::computed;  // on the pages; tables keep what is computed in
    std::string patient_name;     // as the pages call him; empty: as the case does, or not at all
    std::string language = "en";  // of the pages, which use_language() was told
};

struct WrittenReport {
    bool passed = false;
    std::vector<std::filesystem::path> files;  // that stand in the folder now
};

// Writes report.html, report.pdf, metrics.csv, plots.csv, pictures and recording.hrec, all of them
// or none. Needs a QApplication, and no display. Throws InputError, Cancelled.
WrittenReport write_report(const ReportRequest& request, Job& job);

}  // namespace hepatica
