// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the programs that take the pictures of the guide and of the README: they operate
// the window like a user and save what it shows. Needs a display.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <clocale>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <utility>

#include "core/patient/patient_case.h"
#include "core/session/script.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/opengl_probe.h"
#include "ui/pixel_mapping.h"
#include "ui/slices/slice_view.h"
#include "ui/theme.h"
#include "ui/vtk_widget.h"

namespace hepatica {

class Photographer {
  public:
    Photographer(MainWindow& window, QString folder)
        : window_(window), folder_(std::move(folder)) {}

    void open_built_in() {
        window_.actions()[ActionId::built_in].trigger();
        until([this] { return window_.has_patient() && !window_.busy(); });
        settle();
    }
    void until(const std::function<bool()>& condition) {
        constexpr int patience_ms = 300000;
        if (!QTest::qWaitFor(condition, patience_ms)) throw std::runtime_error("it took too long");
    }
    void settle() {
        QTest::qWait(2500);
    }  // until the picture is smoothed and the panels have followed

    QPoint pixel_of(const Vec3& place_mm) {
        return point_at(window_.view().scene().pixel_of(place_mm),
                        window_.view().devicePixelRatioF())
            .toPoint();
    }
    // A pixel on the first branch, or, for a share above one half, on the branch with the most
    // points.
    QPoint on_vessel(double share) {
        const VesselTree& tree = window_.workspace().patient()->tree;
        const VesselSegment* longest = &tree.segments.front();
        if (share > 0.5)
            for (const VesselSegment& segment : tree.segments)
                if (segment.points_mm.size() > longest->points_mm.size()) longest = &segment;
        const auto index =
            static_cast<std::size_t>(share * static_cast<double>(longest->points_mm.size() - 1));
        return pixel_of(longest->points_mm[index]);
    }
    // Moves the mouse from one point of the view to another, with or without a pressed button.
    void lead(const QPoint& from, const QPoint& to, int moves, int wait_ms) {
        for (int i = 1; i <= moves; ++i) {
            QTest::mouseMove(&window_.view(), from + (to - from) * i / moves);
            QTest::qWait(wait_ms);
        }
    }
    QPoint on_longest_path(double share) {
        return pixel_of(point_on_longest_path(window_.workspace().patient()->tree, share));
    }
    // Takes the tool of this key in hand at a point of the view, closes it if it has jaws, and
    // moves it.
    void hold_tool(Qt::Key key, const QPoint& at, const QPoint& by) {
        QTest::keyClick(&window_, key);
        QTest::mouseMove(&window_.view(), at);
        until([this] { return window_.frame().tool.has_value(); });
        settle();
        QTest::keyClick(&window_, Qt::Key_C);
        settle();
        lead(at, at + by, 20, 60);
        settle();
    }
    void put_tool_away() {
        QTest::keyClick(&window_, Qt::Key_Escape);
        window_.actions()[ActionId::reset].trigger();
        settle();
    }
    static void lead(SliceView& slice, const Vec3& place) {
        const QPointF at = slice.place_of(place).toPoint();
        QMouseEvent move(QEvent::MouseMove, at, slice.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&slice, &move);
    }

    void save(const QImage& picture, const QString& name) {
        const QString file = folder_ + "/" + name + ".png";
        if (!picture.save(file)) throw std::runtime_error("cannot write " + file.toStdString());
        std::printf("%s\n", file.toStdString().c_str());
    }
    // With the dialog, if any, in front in the middle of the view.
    void save_window(const QString& name, int width, QWidget* dialog = nullptr) {
        QPixmap shown = window_.grab();
        if (dialog != nullptr)
            QPainter(&shown).drawPixmap(
                window_.view().mapTo(&window_, window_.view().rect().center()) -
                    dialog->rect().center(),
                dialog->grab());
        save(shown.toImage().scaledToWidth(width, Qt::SmoothTransformation), name);
    }

    MainWindow& window() { return window_; }

  private:
    MainWindow& window_;
    QString folder_;
};

// Main function of such a program: calls `take` with a window that has its own settings and this
// language. Returns the exit code.
inline int take_pictures(int& argc, char** argv, const char* language,
                         const std::function<void(MainWindow&)>& take) {
    try {
        prepare_opengl();
        QApplication application(argc, argv);
        std::setlocale(LC_NUMERIC, "C");
        use_language(language);
        apply_theme(application);
        const QTemporaryDir folder;
        Settings settings(folder.filePath("settings.ini"));
        const auto load = [](const OpenRequest& request, Job& job) {
            return load_patient(request, job);
        };
        MainWindow window(settings, {load, write_case});
        window.resize(1280, 800);
        window.show();
        if (!QTest::qWaitForWindowExposed(&window)) return 1;
        QApplication::setActiveWindow(&window);
        take(window);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
}

}  // namespace hepatica
