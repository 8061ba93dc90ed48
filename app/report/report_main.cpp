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

#include "app/report/lesson_report.h"
#include "app/users_cache.h"
#include "core/base/error.h"
#include "ui/paths.h"
#include "ui/theme.h"

namespace hepatica {

namespace {

void print(const WrittenReport& written, bool json) {
    if (!json) {
        for (const std::filesystem::path& file : written.files)
            std::printf("%s\n", qPrintable(to_text(file)));
        return;
    }
    QJsonArray files;
    for (const std::filesystem::path& file : written.files) files.append(to_text(file));
    const QJsonObject answer{{"passed", written.passed}, {"files", files}};
    std::printf("%s\n", QJsonDocument(answer).toJson(QJsonDocument::Compact).constData());
}

int refuse(const char* problem, int code) {
    std::fprintf(stderr, "hepatica: %s\n", problem);
    return code;
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
             "computed"}};
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
    apply_theme(application);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOptions(report_options());
    parser.process(application);
    if (!parser.isSet("out")) return refuse("--report needs --out DIR", 2);
    const FlowUnits units = flow_units_named(parser.value("units"));
    if (name_of(units) != parser.value("units")) return refuse("--units is computed or clinic", 2);
    try {
        Job job;
        print(write_report({.recording = to_path(parser.value("report")),
                            .out = to_path(parser.value("out")),
                            .lesson = parser.value("lesson").toStdString(),
                            .name = parser.value("name").toStdString(),
                            .patient = to_path(parser.value("patient")),
                            .cache = users_cache(),
                            .units = units},
                           job),
              parser.isSet("json"));
    } catch (const InputError& error) {
        return refuse(error.what(), 1);
    } catch (const UsageError& error) {
        return refuse(error.what(), 2);
    }
    return 0;
}

}  // namespace hepatica
