// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report_writing.h"

#include <unistd.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <string>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/lesson/attempts.h"
#include "ui/file_name.h"
#include "ui/language.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 50;  // between two checks of the job, ms
// Nice value of the process. Beside a thread of the play it gets a quarter of a core that both
// want; at 15 it would get a thirtieth, and nearly nothing where others work on the machine, too.
constexpr int after_the_play = 5;

// `patient`: the case of who was played; empty: it is searched for.
QStringList arguments_of(const ReportOrder& order, const fs::path& patient, const fs::path& out) {
    QStringList arguments{"--report",   to_text(order.recording),
                          "--out",      to_text(out),
                          "--lesson",   order.lesson,
                          "--units",    name_of(order.units),
                          "--language", spoken_language(),
                          "--progress"};
    if (const std::string name = name_beside(order.recording); !name.empty())
        arguments << "--name" << QString::fromStdString(name);
    if (!patient.empty()) arguments << "--patient" << to_text(patient);
    if (!order.patient_name.isEmpty()) arguments << "--patient-name" << order.patient_name;
    return arguments;
}

// Without the voxels that no play needs: organs may be obstacles. The others are not even copied,
// since they may be hundreds of megabytes.
PatientCase light_copy(const PatientCase& patient) {
    PatientCase light;
    light.source = patient.source;
    light.organs = organs_of(patient);
    light.tree = patient.tree;
    light.surface = patient.surface;
    light.mesh = patient.mesh;
    light.corrections.bridges = patient.corrections.bridges;
    light.corrections.edits = patient.corrections.edits;
    light.corrections.extracted = patient.corrections.extracted;
    light.corrections.rebuilt = patient.corrections.rebuilt;
    light.doubts = patient.doubts;
    light.warnings = patient.warnings;
    light.warnings_of_image = patient.warnings_of_image;
    light.dial_json = patient.dial_json;
    light.measured = patient.measured;
    return light;
}

// Owns the process: kills it if it still runs at destruction.
class Running {
  public:
    Running(const QString& program, const QStringList& arguments) {
        // Qt's warnings about the system must not appear as the report's errors.
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_LOGGING_RULES", "*.warning=false");
        process_.setProcessEnvironment(environment);
        // A lesson played meanwhile has priority.
        process_.setChildProcessModifier([] { (void)!::nice(after_the_play); });
        process_.start(program, arguments);
        if (!process_.waitForStarted())
            throw InputError(Words::id("the program could not be started again"),
                             program.toStdString(), "");
    }
    ~Running() {
        if (process_.state() == QProcess::NotRunning) return;
        process_.kill();
        process_.waitForFinished();
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void wait(Job& job) {
        int stage = -1;  // none yet
        do {
            job.throw_if_cancelled();
            process_.waitForReadyRead(patience_ms);
            while (process_.canReadLine()) pass_on(process_.readLine(), stage, job);
        } while (process_.state() != QProcess::NotRunning);
    }
    bool succeeded() const {
        return process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0;
    }
    std::string errors() {
        QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
        if (const QString self = "hepatica: "; said.startsWith(self)) said.remove(0, self.size());
        return said.toStdString();
    }

  private:
    // The stages are those of the process, and so is their count: there is one bar of the whole.
    static void pass_on(const QByteArray& line, int& stage, Job& job) {
        const QJsonObject now = QJsonDocument::fromJson(line).object();
        if (!now.contains("stage")) return;  // the last line names the files
        const int number = now["number"].toInt();
        if (number != stage) {
            job.expect_stages(now["count"].toInt() - number + 1);
            job.begin_stage(now["stage"].toString().toStdString());
        }
        stage = number;
        job.advance(now["fraction"].toDouble());
    }

    QProcess process_;
};

}  // namespace

fs::path report_folder(const fs::path& chosen, const QString& lesson, const QDateTime& played) {
    return numbered_folder(chosen / to_path(report_name(lesson, played)));
}

QString report_name(const QString& lesson, const QDateTime& played) {
    return (as_file_name(lesson, {}) + " " + played.toString("yyyy-MM-dd hh-mm")).trimmed();
}

fs::path numbered_folder(const fs::path& folder) {
    fs::path free = folder;
    std::error_code ignored;
    for (int number = 2; fs::exists(free, ignored); ++number)
        free = folder.string() + " (" + std::to_string(number) + ")";
    return free;
}

void order_report(const QString& program, const ReportOrder& order, const fs::path& folder,
                  Job& job) {
    const TemporaryFolder beside;
    const fs::path patient = order.patient ? beside.path() / "patient.hep" : fs::path();
    if (order.patient) write_case(patient, light_copy(*order.patient));
    write_folder_atomically(folder, [&](const fs::path& unfinished) {
        Running report(program, arguments_of(order, patient, unfinished));
        report.wait(job);
        if (report.succeeded()) return;
        const std::string errors = report.errors();
        if (!errors.empty()) throw InputError(errors, to_text(folder).toStdString(), "");
        throw InputError(Words::id("the program that writes the report ended without a word"),
                         to_text(folder).toStdString(),
                         Words::id("close other programs and write it again"));
    });
}

}  // namespace hepatica
