// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the README's pictures of the window, with the built-in patient:
//
//     xvfb-run -s "-screen 0 1280x820x24" build/release/bin/readme_pictures docs/images
//
// Take them on an idle machine: beside other work the real-time factor in the status line is low.
#include <QComboBox>
#include <algorithm>

#include "bench/photographer.h"
#include "ui/lesson_dock.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

constexpr int window_width = 1280;
constexpr QSize tour_size(520, 390);

class ReadmePictures : Photographer {
  public:
    using Photographer::Photographer;

    void run() {
        open_built_in();
        tool(Qt::Key_5, "tour_3_probe", QPoint(-10, -36));
        play_drug();
        tool(Qt::Key_6, "tour_3_forceps", QPoint(6, 40), [this] { save("window"); });
        window().actions()[ActionId::remove_drug].trigger();
        if (QAction& plots = window().actions()[ActionId::toggle_plots]; plots.isChecked())
            plots.trigger();
        lesson();
        open_built_in();
        slices();
    }

  private:
    using Photographer::lead;

    void tool(
        Qt::Key key, const QString& name, const QPoint& by,
        const std::function<void()>& then = [] {}) {
        const QPoint vessel = on_longest_path(0.8);
        hold_tool(key, vessel, by);
        then();
        QAction& annotations = window().actions()[ActionId::toggle_annotations];
        annotations.trigger();
        save(around(vessel, window().view().picture()), name);
        annotations.trigger();
        put_tool_away();
    }

    void play_drug() {
        QTest::mouseDClick(&window().view(), Qt::LeftButton, {}, on_vessel(0.02));
        QTest::qWait(6000);  // lets the drug flow
        window().actions()[ActionId::play_pause].trigger();
    }

    void slices() {
        window().actions()[ActionId::toggle_slices].trigger();
        ViewLayout& views = window().view_layout();
        until([&] { return !views.slices().empty(); });
        settle();
        emit window().findChild<QComboBox*>("measure")->activated(1);
        SliceView& coronal = views.slice_view(SliceDirection::coronal);
        const Vec3 begin = views.slices().crosshair_mm();
        for (const Vec3& off : {Vec3(0, 0, 8), Vec3(-40, 0, 20)})
            QTest::mouseClick(&coronal, Qt::LeftButton, {},
                              coronal.place_of(begin + off).toPoint());
        settle();
        save("slices");
        QTest::keyClick(&coronal, Qt::Key_Escape);
        window().actions()[ActionId::toggle_slices].trigger();
        settle();
    }

    // Plays a lesson and takes the picture in the middle of its pull.
    void lesson() {
        begin_lesson("gentle_pull");
        VtkWidget& view = window().view();
        const QPoint mark = on_longest_path(0.5);
        QTest::mousePress(&view, Qt::LeftButton, {}, mark);
        lead(mark, mark + QPoint(14, 48), 60, 60);
        settle();
        save("lesson");
        QTest::mouseRelease(&view, Qt::LeftButton, {}, mark + QPoint(14, 48));
    }

    void begin_lesson(const QString& name) {
        for (QAction* action : window().findChildren<QAction*>())
            if (action->objectName() == name) {
                action->trigger();
                until([this] { return window().lessons().playing() && !window().busy(); });
                return settle();
            }
        throw std::runtime_error("there is no lesson " + name.toStdString());
    }

    void save(const QString& name) { save_window(name, window_width); }
    using Photographer::save;

    static QImage around(const QPoint& middle, const QImage& view) {
        QRect part(QPoint(0, 0), tour_size.boundedTo(view.size()));
        part.moveCenter(middle);
        part.moveLeft(std::clamp(part.left(), 0, view.width() - part.width()));
        part.moveTop(std::clamp(part.top(), 0, view.height() - part.height()));
        return view.copy(part);
    }
};

}  // namespace
}  // namespace hepatica

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "Usage: readme_pictures FOLDER\n");
        return 2;
    }
    return hepatica::take_pictures(argc, argv, "en", [&](hepatica::MainWindow& window) {
        hepatica::ReadmePictures(window, argv[1]).run();
    });
}
