// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a play from the window: a process of its own writes it, whose progress is a job's.
// Every report gets a folder of its own; none takes the place of another.
#pragma once

#include <QDateTime>
#include <QString>
#include <filesystem>

#include "ui/background_job.h"
#include "ui/flow_units.h"

namespace hepatica {

struct ReportOrder {
    std::filesystem::path recording;
    QString lesson;                 // an id or a file
    std::filesystem::path patient;  // a case; empty: to be found out
    QString patient_name;           // on the pages; empty: as the case says
    FlowUnits units = FlowUnits::computed;
};

// A folder in `chosen` that is not there yet, called by the lesson and when it was played.
std::filesystem::path report_folder(const std::filesystem::path& chosen, const QString& lesson,
                                    const QDateTime& played);

// Writes it into this folder, whole or not at all: a cancel kills the process. `program`: hepatica.
// Throws InputError with what the process said, Cancelled.
void order_report(const QString& program, const ReportOrder& order,
                  const std::filesystem::path& folder, Job& job);

}  // namespace hepatica
