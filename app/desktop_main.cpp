// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica: the window. Opens what the command line names, or waits for a file to be dropped.
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/back_end_names.h"
#include "app/diagnosis.h"
#include "app/process_clock.h"
#include "app/readable.h"
#include "app/report/report_main.h"
#include "app/users_cache.h"
#include "app/writing_signals.h"
#include "core/opening/case_segmentation.h"
#include "core/patient/patient_case.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/opengl_probe.h"
#include "ui/theme.h"
#include "ui/vtk_widget.h"

namespace {

// Exceptions that no part of the window has caught are reported, and the event loop continues.
class Application : public QApplication {
  public:
    using QApplication::QApplication;

    std::function<void(const std::exception_ptr&)> on_failure;

    bool notify(QObject* receiver, QEvent* event) override {
        try {
            return QApplication::notify(receiver, event);
        } catch (...) {
            if (!on_failure) throw;
            on_failure(std::current_exception());
            return true;
        }
    }
};

struct Options {
    QString path;  // may be empty
    bool built_in = false;
    bool safe_mode = false;
    bool startup_report = false;
    bool quit_after_start = false;
    bool diagnose = false;
    bool json = false;
    QString back_end;  // empty: the last choice
};

// Ends the program where an option is given that nothing would come of: it would be taken for what
// the window does.
void refuse_without_effect(const QCommandLineParser& parser) {
    const auto refuse = [](const QString& option, const char* needed) {
        std::fprintf(stderr, "hepatica: --%s is of no use without %s\n", qPrintable(option),
                     needed);
        std::exit(2);
    };
    for (const QCommandLineOption& option : hepatica::report_options())
        if (parser.isSet(option)) refuse(option.names().first(), "--report RECORDING");
    if (parser.isSet("json") && !parser.isSet("diagnose") && !parser.isSet("startup-report"))
        refuse("json", "--diagnose, --startup-report or --report");
}

Options parse(const QCoreApplication& application) {
    using hepatica::report_options;
    QCommandLineParser parser;
    parser.setApplicationDescription("Practise on a patient's own liver vessels.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("PATH", "A case, a CT (folder or file) or a tree", "[PATH]");
    const QCommandLineOption built_in("built-in", "Open the built-in patient.");
    const QCommandLineOption safe("safe-mode", "Ignore settings and cache, and keep none.");
    const QCommandLineOption report("startup-report", "Print how long the window took to appear.");
    const QCommandLineOption quit("quit-after-start", "Leave after the first picture.");
    const QCommandLineOption diagnose("diagnose", "Print what this computer offers, and exit.");
    const QCommandLineOption json("json", "Print the report as JSON.");
    const QCommandLineOption back_end(
        "backend",
        "Computed by cpu, cuda, auto (the CUDA device where there is one) or cuda-emulated.",
        "NAME");
    parser.addOptions({built_in, safe, report, quit, diagnose, json, back_end});
    parser.addOptions(report_options());
    parser.process(application);
    refuse_without_effect(parser);
    for (const QString& more : parser.positionalArguments().mid(1))
        std::fprintf(stderr, "hepatica: opens one at a time, not %s as well\n", qPrintable(more));
    if (parser.isSet(built_in) && !parser.positionalArguments().isEmpty())
        std::fprintf(stderr, "hepatica: opens one at a time, not the built-in patient as well\n");
    return {parser.positionalArguments().value(0),
            parser.isSet(built_in),
            parser.isSet(safe),
            parser.isSet(report),
            parser.isSet(quit),
            parser.isSet(diagnose),
            parser.isSet(json),
            parser.value(back_end)};
}

void print_report(double window_ready_s, const std::string& renderer, bool json) {
    if (!json) {
        std::printf("window ready after %.2f s, renderer %s\n", window_ready_s, renderer.c_str());
    } else {
        const QJsonObject report{{"window_ready_s", window_ready_s},
                                 {"renderer", QString::fromStdString(renderer)}};
        std::printf("%s\n", QJsonDocument(report).toJson(QJsonDocument::Compact).constData());
    }
    std::fflush(stdout);
}

// Runs windows one after another, because a change of language creates the window anew.
int run_windows(Application& application, hepatica::Settings& settings,
                const hepatica::MainWindow::Patients& patients, const Options& options) {
    using namespace hepatica;
    std::optional<OpenRequest> wanted;
    if (options.built_in) wanted = OpenRequest{true, {}};
    for (bool is_first = true;; is_first = false) {
        bool another = false;
        MainWindow window(settings, patients);
        window.on_begin_anew([&](const std::optional<OpenRequest>& shown) {
            wanted = shown;
            another = true;
        });
        window.on_first_picture([&] {
            if (options.startup_report && is_first) {
                print_report(seconds_since_process_start(), window.view().renderer_name(),
                             options.json);
            }
            if (options.quit_after_start) return QCoreApplication::quit();
            if (is_first && !options.path.isEmpty()) {
                window.open(options.path);
            } else if (wanted) {
                window.open(*wanted);
            }
        });
        window.show();
        application.on_failure = [&window](const std::exception_ptr& error) {
            window.tell_failure_of_program(error);
        };
        const int ended = QApplication::exec();
        application.on_failure = nullptr;
        if (!another) return ended;
        use_language(settings.language());
    }
}

// Also reports on the display, which this program needs and hepatica-cli does not.
int print_diagnosis(const QString& display_problem, bool json) {
    nlohmann::ordered_json answer = hepatica::diagnosis();
    answer["display"] = display_problem.isEmpty() ? "there" : display_problem.toStdString();
    std::printf("%s\n", json ? answer.dump().c_str() : hepatica::readable(answer).c_str());
    return 0;
}

int refuse(const QString& problem) {
    std::fprintf(stderr, "hepatica: %s\n", qPrintable(problem));
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace hepatica;
    ignore_signals_of_writing();
    if (asks_for_report(argc, argv)) return report_main(argc, argv);
    prepare_opengl();
    if (const QString problem = display_problem(); !problem.isEmpty()) {
        const QCoreApplication without_window(argc, argv);
        QCoreApplication::setApplicationVersion(HEPATICA_VERSION);
        const Options options = parse(without_window);
        if (options.diagnose) return print_diagnosis(problem, options.json);
        return refuse(problem);
    }
    Application application(argc, argv);
    QApplication::setApplicationName("Hepatica");
    QApplication::setApplicationVersion(HEPATICA_VERSION);
    // These tell the desktop which of its entries the window belongs to.
    QGuiApplication::setDesktopFileName("org.hepatica.Hepatica");
    QApplication::setWindowIcon(QIcon::fromTheme("hepatica"));
    // Qt sets the user's locale; with a decimal comma, numbers in files and shaders would break.
    std::setlocale(LC_NUMERIC, "C");
    const Options options = parse(application);
    if (options.diagnose) return print_diagnosis({}, options.json);
    if (const auto& names = back_end_names();
        !options.back_end.isEmpty() &&
        std::ranges::find(names, options.back_end.toStdString()) == names.end())
        return refuse("--backend takes cpu, cuda, cuda-emulated or auto, not " + options.back_end);
    Settings settings(options.safe_mode ? Settings::Mode::safe : Settings::Mode::remember);
    use_language(settings.language());
    apply_theme(application, theme_named(settings.theme()));
    if (const QString problem = opengl_problem(); !problem.isEmpty()) {
        if (!options.quit_after_start) QMessageBox::critical(nullptr, "Hepatica", problem);
        return refuse(problem);
    }
    const BuiltInCache cache = options.safe_mode ? BuiltInCache{} : users_cache();
    const auto back_ends = std::make_shared<BackEnds>(back_end_named);
    back_ends->choose(
        (options.back_end.isEmpty() ? settings.back_end() : options.back_end).toStdString());
    const auto load = [&cache, back_ends](OpenRequest request, Job& job) {
        request.cache = cache;
        return load_patient(request, job, back_ends->for_play());
    };
    MainWindow::Patients patients{load, write_case};
    patients.back_ends = back_ends;
    patients.play_on = [back_ends](std::shared_ptr<const PatientCase> patient, Job& job) {
        return play_with(back_ends->for_play(), std::move(patient), job);
    };
    patients.keep = write_case;
    patients.archive = [](const PatientCase& patient, const std::filesystem::path& ct,
                          const std::filesystem::path& file, Job& job) {
        write_case_segmentation(patient, ct, file, HEPATICA_VERSION, job);
    };
    return run_windows(application, settings, patients, options);
}
