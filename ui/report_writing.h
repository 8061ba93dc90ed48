// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the report of a play by a separate process, whose progress is passed to a Job. Each report
// gets a new folder.
#pragma once

#include <QDateTime>
#include <QString>
#include <filesystem>
#include <memory>

#include "core/patient/patient_case.h"
#include "ui/background_job.h"
#include "ui/flow_units.h"

namespace hepatica {

struct ReportOrder {
    std::filesystem::path recording;
    QString lesson;  // an id or a file
    // Who was played; null: his case is searched for. The process gets a copy: the case on disk may
    // have been saved with other vessels since, or there is none.
    std::shared_ptr<const PatientCase> patient{};
    QString patient_name{};  // on the pages; empty: as in the case
    FlowUnits units = FlowUnits::computed;
};

// Named after the lesson and the time of the play: a folder's name.
QString report_name(const QString& lesson, const QDateTime& played);
// The folder itself if it does not exist yet, else "FOLDER (2)", "FOLDER (3)", ...
std::filesystem::path numbered_folder(const std::filesystem::path& folder);
// A folder in `chosen` of that name, numbered likewise.
std::filesystem::path report_folder(const std::filesystem::path& chosen, const QString& lesson,
                                    const QDateTime& played);

// Writes the report into this folder atomically; cancelling kills the process. `program` is
// hepatica. Throws InputError with the process's message, and Cancelled.
void order_report(const QString& program, const ReportOrder& order,
                  const std::filesystem::path& folder, Job& job);

}  // namespace hepatica
