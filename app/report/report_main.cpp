// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_main.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <utility>

#include "app/interruption.h"
#include "app/report/lesson_report.h"
#include "app/users_cache.h"
#include "core/base/error.h"
#include "ui/core_words.h"
#include "ui/language.h"
#include "ui/paths.h"
#include "ui/theme.h"

namespace hepatica {

namespace {

void print(const WrittenReport& written, bool json) {
    for (const std::string& warning : written.warnings)
        std::fprintf(stderr, "hepatica: %s\n", qPrintable(translated(warning)));
    if (!json) {
        for (const std::filesystem::path& file : written.files)
            std::printf("%s\n", qPrintable(to_text(file)));
        return;
    }
    QJsonArray files;
    for (const std::filesystem::path& file : written.files) files.append(to_text(file));
    const QJsonValue passed = written.passed ? QJsonValue(*written.passed) : QJsonValue();
    const QJsonObject answer{{"passed", passed}, {"files", files}};
    std::printf("%s\n", QJsonDocument(answer).toJson(QJsonDocument::Compact).constData());
}

// Prints a line for each stage and each percent of it.
void print_progress(const Job& job) {
    static std::pair<int, int> last{0, 0};
    const JobProgress now = job.progress();
    const std::pair shown{now.stage_number, static_cast<int>(100.0 * now.fraction)};
    if (shown == last || now.stage_number == 0) return;
    last = shown;
    const QJsonObject line{{"stage", QString::fromStdString(now.stage)},
                           {"fraction", now.fraction},
                           {"number", now.stage_number},
                           {"count", now.stage_count}};
    std::printf("%s\n", QJsonDocument(line).toJson(QJsonDocument::Compact).constData());
    std::fflush(stdout);
}

int refuse(const std::string& problem, int code) {
    std::fprintf(stderr, "hepatica: %s\n", problem.c_str());
    return code;
}

// In the language of the report, which is that of the window that requested it.
std::string words_of(const Error& error) {
    QStringList lines{translated(error.problem())};
    if (!error.place().empty()) lines << translated(error.place());
    if (!error.remedy().empty()) lines << translated(error.remedy());
    return lines.join("\n").toStdString();
}

// Runs `work` and returns the exit code of the program, that of hepatica-cli (app/command_line.h).
int exit_code_of(const std::function<void()>& work) {
    try {
        work();
        return 0;
    } catch (const Cancelled&) {
        return refuse(translated("interrupted").toStdString(), 130);
    } catch (const UsageError& error) {
        return refuse(words_of(error), 2);
    } catch (const Error& error) {
        return refuse(words_of(error), 1);
    } catch (const std::filesystem::filesystem_error& error) {
        return refuse(error.path1().string() + ": " + error.code().message(), 1);
    } catch (const std::bad_alloc&) {
        return refuse(translated("not enough memory").toStdString(), 3);
    } catch (const std::exception& error) {
        return refuse(translated(std::string("internal error: ") + error.what()).toStdString(), 3);
    }
}

}  // namespace

QList<QCommandLineOption> report_options() {
    return {{"report", "Write the report of a recorded play, without a window.", "RECORDING"},
            {"out", "Folder for the report.", "DIR"},
            {"lesson", "Its lesson: a file or a name; none: as the recording shows.", "LESSON"},
            {"name", "The trainee's name or number in the report.", "NAME"},
            {"patient",
             "Case that was recorded; none: the one that the lesson names, the one beside the "
             "recording, or the built-in patient.",
             "CASE"},
            {"units", "Blood on the pages: computed (g, g/s) or clinic (mL, mL/min).", "UNITS",
             "computed"},
            {"language", "Language of the pages: en or de.", "LANGUAGE", "en"},
            {"patient-name", "What the pages call the patient; none: as the case does.", "NAME"},
            {"progress", "Print how far the report is, a JSON object a line."}};
}

bool asks_for_report(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--report") == 0 || std::strncmp(argv[i], "--report=", 9) == 0)
            return true;
    return false;
}

int report_main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setApplicationName("Hepatica");
    std::setlocale(LC_NUMERIC, "C");
    apply_theme(application, theme_named("light"));  // for paper
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOptions(report_options());
    parser.process(application);
    // An option behind it would be taken for the recording, and what follows for a case to open.
    if (parser.value("report").startsWith("--"))
        return refuse("--report needs a RECORDING, and is followed by " +
                          parser.value("report").toStdString(),
                      2);
    if (const QStringList more = parser.positionalArguments(); !more.isEmpty())
        return refuse("beside --report nothing is opened: leave " + more[0].toStdString() + " out",
                      2);
    if (!parser.isSet("out")) return refuse("--report needs --out DIR", 2);
    const FlowUnits units = flow_units_named(parser.value("units"));
    if (name_of(units) != parser.value("units")) return refuse("--units is computed or clinic", 2);
    const QString language = parser.value("language");
    if (language.isEmpty() || language_of(language) != language)
        return refuse("--language is en or de", 2);
    use_language(language);
    return exit_code_of([&] {
        Job job;
        const Interruption interruption;
        job.observe([&job, tells = parser.isSet("progress")](JobEvent) {
            if (Interruption::came()) job.cancel();
            if (tells) print_progress(job);
        });
        print(write_report({.recording = to_path(parser.value("report")),
                            .out = to_path(parser.value("out")),
                            .lesson = parser.value("lesson").toStdString(),
                            .name = parser.value("name").toStdString(),
                            .patient = to_path(parser.value("patient")),
                            .cache = users_cache(),
                            .units = units,
                            .patient_name = parser.value("patient-name").toStdString(),
                            .language = language.toStdString()},
                           job),
              parser.isSet("json"));
    });
}

}  // namespace hepatica
