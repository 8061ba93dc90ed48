// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the window on a screen: processor time while nothing moves (before and after an injection
// that has run out, and while a cut vessel bleeds), and pictures per second, counted when they are
// swapped onto the screen, while the patient is turned and while a hand pulls a vessel. It runs the
// whole window with mouse events on any display:
//
//     xvfb-run -s "-screen 0 1280x800x24" build/release/bin/window_bench CASE
#include <malloc.h>
#include <unistd.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/frame_time.h"
#include "core/patient/patient_case.h"
#include "core/session/script.h"
#include "core/study/timing.h"
#include "ui/main_window.h"
#include "ui/opengl_probe.h"
#include "ui/paths.h"
#include "ui/pixel_mapping.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"
#include "ui/theme.h"
#include "ui/volume_keeper.h"
#include "ui/vtk_widget.h"

namespace hepatica {
namespace {

constexpr double idle_s = 20.0;
constexpr double patience_s = 300.0;
constexpr int mouse_period_ms = 8;
// Duration of one leg of the hand's path, which leads through these places in a cycle.
constexpr double leg_s = 0.5;
const std::array<Vec3, 3> hand_mm{Vec3(0, 0, 0), Vec3(30, 20, 0), Vec3(0, -20, 10)};
constexpr int rounds = 8;
constexpr double turning_s = 5.0;

double process_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Resident memory after the allocator has returned unused memory.
double memory_in_use_mb() {
    malloc_trim(0);
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return 1e-6 * static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void run_for(double seconds) {
    QEventLoop loop;
    QTimer::singleShot(static_cast<int>(1e3 * seconds), Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

bool run_until(const std::function<bool()>& condition) {
    QElapsedTimer waited;
    waited.start();
    while (!condition()) {
        if (1e-3 * static_cast<double>(waited.elapsed()) > patience_s) return false;
        run_for(0.05);
    }
    return true;
}

// The quantile of study/timing.h; 0 of nothing.
double quantile_of(const std::vector<double>& values, double share) {
    return values.empty() ? 0.0 : quantile(values, share);
}

// Time of each picture of the view, from the start of drawing until it is on the screen.
struct Pictures {
    explicit Pictures(VtkWidget& view) {
        view.on_picture([this](const PictureTime& time) { times_ms.push_back(time.on_screen_ms); });
    }
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;

    std::vector<double> times_ms;
};

class WindowBench {
  public:
    explicit WindowBench(MainWindow& window) : window_(window), pictures_(window.view()) {}

    // A new patient's dial is measured while nobody plays; it is stored in his case, so that a
    // second run finds it there. Waits for its end, and says how long it took.
    void settle() {
        QElapsedTimer waited;
        waited.start();
        double used_s = process_s();
        const bool settled = run_until([&] {
            const double before = used_s;
            run_for(1.0);
            used_s = process_s();
            return used_s - before < 0.05;
        });
        std::printf("%s %.0f s after the patient is shown\n", settled ? "at rest" : "not at rest",
                    1e-3 * static_cast<double>(waited.elapsed()));
        std::fflush(stdout);
    }

    void idle(const char* when) {
        run_for(3.0);
        pictures_.times_ms.clear();
        const std::uint64_t step = window_.frame().step;
        const double before = process_s();
        run_for(idle_s);
        std::printf("idle %s: %.2f %% of a core, %zu pictures, %llu steps in %.0f s\n", when,
                    100.0 * (process_s() - before) / idle_s, pictures_.times_ms.size(),
                    static_cast<unsigned long long>(window_.frame().step - step), idle_s);
        std::fflush(stdout);
    }

    // Double-clicks on the root with a clock that runs ten times as fast. False where the drug does
    // not arrive.
    bool inject() {
        window_.findChild<QDoubleSpinBox*>("speed")->setValue(10.0);
        mouse(QEvent::MouseButtonDblClick, on_vessel(0.1));
        return run_until([this] {
            const DrugView& drug = window_.frame().drug;
            return drug.arrival_s && drug.time_s >= drug.end_s;
        });
    }

    // Cuts across the longest branch with a blade. False where nothing bleeds afterwards.
    bool cut() {
        window_.actions()[ActionId::cut_mode].trigger();
        VtkWidget& view = window_.view();
        const auto place = [&](double share) {
            return point_at(view.scene().pixel_of(on_vessel(share)), view.devicePixelRatioF());
        };
        const QPointF at = place(0.7), along = place(0.72) - place(0.68);
        const double length = std::hypot(along.x(), along.y());
        const QPointF across = 40.0 / std::max(length, 1.0) * QPointF(-along.y(), along.x());
        send(QEvent::MouseButtonPress, at - across);
        send(QEvent::MouseMove, at + across);
        send(QEvent::MouseButtonRelease, at + across);
        window_.actions()[ActionId::pull_mode].trigger();
        return run_until([this] {
            const std::optional<TearView>& tear = window_.frame().tear;
            return tear && tear->leak_g_s > 0.0;
        });
    }

    // Drags beside the vessels, so that only the picture is at work.
    void turn() {
        VtkWidget& view = window_.view();
        const QPointF corner(0.9 * view.width(), 0.9 * view.height());
        send(QEvent::MouseButtonPress, corner);
        pictures_.times_ms.clear();
        const double before = process_s();
        QElapsedTimer clock;
        clock.start();
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer, &QTimer::timeout, [&] {
            send(QEvent::MouseMove,
                 corner - QPointF(0.01 * static_cast<double>(clock.elapsed()), 0.0));
        });
        timer.start(mouse_period_ms);
        run_for(turning_s);
        timer.stop();
        send(QEvent::MouseButtonRelease, corner);
        std::printf("turned for %.0f s:\n", turning_s);
        print_pictures(turning_s);
        std::printf("  %.1f ms of processor time a picture\n",
                    1e3 * (process_s() - before) /
                        std::max<double>(1.0, double(pictures_.times_ms.size())));
        std::fflush(stdout);
        view.scene().look_from(ViewDirection::anterior);
        view.draw_again();
    }

    // Turns without and with a probe beside the vessels, whose ghost and distance line cost time.
    bool turn_with_a_probe() {
        turn_and_rest("without a tool");
        window_.actions()[ActionId::sphere_tool].trigger();
        const QPointF beside(0.1 * window_.view().width(), 0.5 * window_.view().height());
        QMouseEvent over(QEvent::MouseMove, beside, window_.view().mapToGlobal(beside),
                         Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window_.view(), &over);
        if (!run_until([this] { return window_.frame().tool.has_value(); })) return false;
        turn_and_rest("with a probe");
        window_.actions()[ActionId::put_tool_away].trigger();
        return run_until([this] { return !window_.frame().tool.has_value(); });
    }

    // Turns the wheel notch by notch over the axial slice, painting each before the next, through
    // all slices and back. False where the CT does not belong to the patient.
    bool scroll(const std::filesystem::path& ct) {
        ViewLayout& views = window_.view_layout();
        views.show_patient(window_.workspace().patient(), window_.workspace().folder(), ct);
        views.set_slices_visible(true);
        const auto is_read = [&] { return views.ct_readings().present.expired(); };
        if (!run_until([&] { return !views.slices().empty() || is_read(); })) return false;
        if (views.slices().empty()) return false;
        run_for(idle_s);  // the dial is measured once beside the window
        SliceView& axial = views.slice_view(SliceDirection::axial);
        const Index3& dims = views.slices().ct().grid.dims;
        const int slices = dims[2];
        int painted = -1;
        std::vector<double> times_ms;
        for (int notch = 0; notch < 2 * slices; ++notch) {
            QElapsedTimer clock;
            clock.start();
            const QPointF middle(axial.rect().center());
            QWheelEvent turn(middle, axial.mapToGlobal(middle), {},
                             QPoint(0, notch < slices ? -120 : 120), Qt::NoButton, {},
                             Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&axial, &turn);
            if (axial.slice() == painted) continue;  // end of the stack
            painted = axial.slice();
            QCoreApplication::processEvents();
            times_ms.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
        }
        std::printf("scrolled through %d x %d x %d with three slices and the view beside:\n",
                    dims[0], dims[1], dims[2]);
        std::printf("  %zu slices; each with all that follows it: median %.1f ms, p95 %.1f ms\n",
                    times_ms.size(), quantile_of(times_ms, 0.5), quantile_of(times_ms, 0.95));
        paint(views);
        std::printf("memory in use with patient, CT and slices: %.0f MB\n", memory_in_use_mb());
        views.set_slices_visible(false);
        return true;
    }

    // Turns and rests without the CT, with it as a volume in both presets, and without it again.
    // False where the CT does not belong to the patient.
    bool volume(const std::filesystem::path& ct) {
        window_.volume().show_patient(window_.workspace().patient(), window_.workspace().folder(),
                                      ct);
        run_for(idle_s);  // the dial is measured once beside the window
        turn_and_rest("without the CT");
        window_.actions()[ActionId::toggle_volume].trigger();
        const auto* bar = window_.findChild<QWidget*>("volumeBar");
        if (!run_until([&] { return bar->isEnabled() || !window_.volume().making(); }) ||
            !bar->isEnabled())
            return false;
        turn_and_rest("vessels and bones");
        auto* preset = window_.findChild<QComboBox*>("volumePreset");
        preset->setCurrentIndex(1);
        emit preset->activated(1);
        turn_and_rest("maximum intensity");
        window_.actions()[ActionId::toggle_volume].trigger();
        turn_and_rest("without it again");
        return true;
    }

    // Leads a brush in circles through the axial slice, painting each move before the next.
    void paint(ViewLayout& views) const {
        views.slices().set_crosshair(on_vessel(0.5));
        SliceView& axial = views.slice_view(SliceDirection::axial);
        MaskBrush& brush = views.slices().brush();
        const QPointF middle = axial.place_of(views.slices().crosshair_mm());
        const auto send_to_slice = [&](QEvent::Type type, const QPointF& place) {
            const bool moves = type == QEvent::MouseMove;
            QMouseEvent event(
                type, place, axial.mapToGlobal(place), moves ? Qt::NoButton : Qt::LeftButton,
                type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&axial, &event);
        };
        brush.set_mode(BrushMode::paints);
        std::vector<double> times_ms;
        constexpr int strokes = 5, moves = 60;
        for (int i = 0; i < strokes * moves; ++i) {
            const double angle = 0.1 * i;
            const QPointF place =
                middle + (10.0 + 0.1 * i) * QPointF(std::cos(angle), std::sin(angle));
            QElapsedTimer clock;
            clock.start();
            send_to_slice(i % moves == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, place);
            QCoreApplication::processEvents();
            times_ms.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
            if (i % moves == moves - 1) send_to_slice(QEvent::MouseButtonRelease, place);
        }
        std::printf(
            "painted %zu strokes: %d moves, each with all that follows it: median %.1f ms, "
            "p95 %.1f ms, longest %.1f ms\n",
            brush.strokes().size(), strokes * moves, quantile_of(times_ms, 0.5),
            quantile_of(times_ms, 0.95), quantile_of(times_ms, 1.0));
        brush.remove_all();
        brush.set_mode(BrushMode::away);
    }

    void pull() {
        const Vec3 held = on_vessel(0.5);
        mouse(QEvent::MouseButtonPress, held);
        pictures_.times_ms.clear();
        std::vector<double> steps_ms;
        std::uint64_t seen = window_.frame().step;
        const std::uint64_t first = seen;
        const double before = process_s();
        const double all_s = rounds * leg_s * hand_mm.size();
        QElapsedTimer clock;
        clock.start();
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer, &QTimer::timeout, [&] {
            mouse(QEvent::MouseMove,
                  held + hand_at(1e-9 * static_cast<double>(clock.nsecsElapsed())));
            if (window_.frame().step == seen) return;
            seen = window_.frame().step;
            steps_ms.push_back(window_.frame().statistics.step_ms);
        });
        timer.start(mouse_period_ms);
        run_for(all_s);
        timer.stop();
        const double took_s = 1e-9 * static_cast<double>(clock.nsecsElapsed());
        const double processor_s = process_s() - before;
        const double pulled_mm =
            window_.frame().grab ? (window_.frame().grab->point_mm - held).norm() : 0.0;
        mouse(QEvent::MouseButtonRelease, held);
        const auto in_time = std::count_if(steps_ms.begin(), steps_ms.end(),
                                           [](double ms) { return ms <= frame_length_ms; });
        std::printf("pull for %.1f s (the vessel is %.1f mm from where it was):\n", took_s,
                    pulled_mm);
        print_pictures(took_s);
        std::printf(
            "  %.1f steps a second; of %zu that were shown %.3f in time, median %.1f ms, "
            "p95 %.1f ms\n",
            static_cast<double>(seen - first) / took_s, steps_ms.size(),
            static_cast<double>(in_time) / std::max<double>(1.0, double(steps_ms.size())),
            quantile_of(steps_ms, 0.5), quantile_of(steps_ms, 0.95));
        std::printf("  %.2f cores\n", processor_s / took_s);
        std::fflush(stdout);
    }

  private:
    // Turns, then measures the picture at rest: the last one after a change.
    void turn_and_rest(const char* what) {
        std::printf("%s: ", what);
        turn();
        std::vector<double> times_ms;
        for (int i = 0; i < 5; ++i) {
            window_.view().draw_again();
            run_for(3.0);
            times_ms.push_back(pictures_.times_ms.back());
        }
        std::printf("  at rest, each: median %.1f ms; %.0f MB of memory\n",
                    quantile_of(times_ms, 0.5), memory_in_use_mb());
        std::fflush(stdout);
    }

    void print_pictures(double seconds) const {
        std::printf("  %.1f pictures a second; each, to the swap: median %.1f ms, p95 %.1f ms\n",
                    static_cast<double>(pictures_.times_ms.size()) / seconds,
                    quantile_of(pictures_.times_ms, 0.5), quantile_of(pictures_.times_ms, 0.95));
    }

    static Vec3 hand_at(double time_s) {
        const double legs = time_s / leg_s;
        const auto leg = static_cast<std::size_t>(legs);
        const Vec3& from = hand_mm[leg % hand_mm.size()];
        const Vec3& to = hand_mm[(leg + 1) % hand_mm.size()];
        return from + (legs - static_cast<double>(leg)) * (to - from);
    }

    Vec3 on_vessel(double share_of_longest_path) const {
        return point_on_longest_path(window_.workspace().patient()->tree, share_of_longest_path);
    }

    void mouse(QEvent::Type type, const Vec3& at_mm) {
        VtkWidget& view = window_.view();
        send(type, point_at(view.scene().pixel_of(at_mm), view.devicePixelRatioF()));
    }

    void send(QEvent::Type type, const QPointF& place) {
        VtkWidget& view = window_.view();
        const bool moves = type == QEvent::MouseMove;
        const Qt::MouseButtons held =
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, place, view.mapToGlobal(place),
                          moves ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }

    MainWindow& window_;
    Pictures pictures_;
};

struct Wishes {
    QString path;
    bool only_pull = false;
    std::optional<QString> slices, volume;  // a CT
};

// Nothing where the words are none that the program knows.
std::optional<Wishes> wishes_in(const QStringList& words) {
    if (words.size() < 2 || words[1].startsWith("--")) return std::nullopt;
    Wishes wishes;
    wishes.path = words[1];
    const QString option = words.value(2);
    if (words.size() == 3 && option == "--only-pull")
        wishes.only_pull = true;
    else if (words.size() == 4 && option == "--slices")
        wishes.slices = words[3];
    else if (words.size() == 4 && option == "--volume")
        wishes.volume = words[3];
    else if (words.size() != 2)
        return std::nullopt;
    return wishes;
}

// Says so where it is not; the program then ends.
bool is_there(const QString& path) {
    if (QFileInfo::exists(path)) return true;
    std::fprintf(stderr, "window_bench: %s does not exist\n", qPrintable(path));
    return false;
}

// The exit code of what was done with a CT.
int ended(bool done, const QString& ct) {
    if (done) return 0;
    std::fprintf(stderr, "window_bench: %s holds no CT of this patient that can be read\n",
                 qPrintable(ct));
    return 1;
}

}  // namespace
}  // namespace hepatica

int main(int argc, char** argv) {
    using namespace hepatica;
    prepare_opengl();
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const std::optional<Wishes> wishes = wishes_in(application.arguments());
    if (!wishes) {
        std::fprintf(
            stderr,
            "usage: window_bench CASE|built-in [--only-pull | --slices CT | --volume CT]\n");
        return 2;
    }
    if (wishes->path != "built-in" && !is_there(wishes->path)) return 1;
    for (const std::optional<QString>& ct : {wishes->slices, wishes->volume})
        if (ct && !is_there(*ct)) return 1;
    apply_theme(application);
    const QTemporaryDir folder;
    Settings settings(folder.filePath("settings.ini"));
    const auto load = [](const OpenRequest& request, Job& job) {
        return load_patient(request, job);
    };
    MainWindow window(settings, {load, write_case});
    window.resize(1280, 800);
    window.show();
    if (wishes->path == "built-in")
        window.open(OpenRequest{true, {}});
    else
        window.open(wishes->path);
    if (!run_until([&] { return window.has_patient() && !window.busy(); })) return 1;
    run_for(2.0);
    std::printf("%s, %s, view of %d x %d\n", qPrintable(wishes->path),
                window.view().renderer_name().c_str(), window.view().width(),
                window.view().height());
    WindowBench bench(window);
    if (wishes->slices) return ended(bench.scroll(to_path(*wishes->slices)), *wishes->slices);
    if (wishes->volume) return ended(bench.volume(to_path(*wishes->volume)), *wishes->volume);
    if (!wishes->only_pull) {
        bench.settle();
        bench.idle("before an injection");
        if (!bench.inject()) return 1;
        bench.idle("after it has run out");
    }
    bench.turn();
    if (!wishes->only_pull && !bench.turn_with_a_probe()) return 1;
    bench.pull();
    if (wishes->only_pull) return 0;
    if (!bench.cut()) return 1;
    run_for(idle_s);  // while the stump swings back
    bench.idle("while a cut vessel bleeds");
    return 0;
}
