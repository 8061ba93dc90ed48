// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the pictures of the guide from the window, with the built-in patient:
//
//     xvfb-run -s "-screen 0 1280x820x24" build/release/bin/guide_pictures assets/guide/pictures
//
// A second argument is the language of the window, such as "de".
#include <QComboBox>
#include <QSlider>

#include "bench/photographer.h"
#include "ui/slices/threshold_dialog.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

constexpr int picture_width = 680;  // width on the guide's page

class GuidePictures : Photographer {
  public:
    using Photographer::Photographer;

    void run() {
        open_built_in();
        save("window");
        const QPoint vessel = on_vessel(0.75);
        QTest::mousePress(&window().view(), Qt::LeftButton, {}, vessel);
        lead(vessel, vessel + QPoint(80, 60), 20, 30);
        settle();
        save("pull");
        window().actions()[ActionId::toggle_stretch].trigger();
        settle();
        save("stretch");
        window().actions()[ActionId::toggle_stretch].trigger();
        QTest::mouseRelease(&window().view(), Qt::LeftButton, {}, vessel + QPoint(80, 60));
        window().actions()[ActionId::reset].trigger();
        settle();
        hold_tool(Qt::Key_6, on_longest_path(0.8), QPoint(6, 40));
        save("forceps");
        put_tool_away();
        window().actions()[ActionId::pull_mode].trigger();
        QTest::mouseDClick(&window().view(), Qt::LeftButton, {}, on_vessel(0.02));
        QTest::qWait(6000);  // lets the drug flow
        window().actions()[ActionId::play_pause].trigger();
        show_curves(true);
        settle();
        save("drug");
        window().actions()[ActionId::remove_drug].trigger();
        show_curves(false);
        volume();
        slices();
    }

  private:
    using Photographer::lead;

    // They may have come by themselves.
    void show_curves(bool shown) {
        QAction& curves = window().actions()[ActionId::toggle_plots];
        if (curves.isChecked() != shown) curves.trigger();
    }

    void volume() {
        QAction& action = window().actions()[ActionId::toggle_volume];
        action.trigger();
        until([this] { return window().findChild<QWidget*>("volumeBar")->isEnabled(); });
        settle();
        save("volume");
        action.trigger();
        settle();
    }

    void slices() {
        window().actions()[ActionId::toggle_slices].trigger();
        ViewLayout& views = window().view_layout();
        until([&] { return !views.slices().empty(); });
        settle();
        save("slices");
        emit window().findChild<QComboBox*>("measure")->activated(4);
        SliceView& axial = views.slice_view(SliceDirection::axial);
        const Vec3 begin = views.slices().crosshair_mm();
        for (const Vec3& off : {Vec3(0, 0, 0), Vec3(-12, -3, 0), Vec3(-24, -10, 0)})
            QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.place_of(begin + off).toPoint());
        settle();
        save("draw");
        QTest::keyClick(&axial, Qt::Key_Escape);
        paint(axial, [&](int step) {
            return Vec3(begin + Vec3(-10.0 - 2.0 * step, 6.0 + 1.5 * step, 0));
        });
        for (int k = 0; k < 2; ++k)
            QTest::keyClick(&axial, Qt::Key_Escape);  // first the stroke, then the brush
        try_threshold();
        tumour(axial, begin + Vec3(-26.0, -16.0, 0));
    }

    // Paints a branch, and takes the picture while the mouse still leads the brush.
    void paint(SliceView& axial, const std::function<Vec3(int step)>& place) {
        emit window().findChild<QComboBox*>("measure")->activated(6);
        QTest::mousePress(&axial, Qt::LeftButton, {}, axial.place_of(place(0)).toPoint());
        for (int step = 1; step <= 12; ++step) lead(axial, place(step));
        settle();
        save("paint");
        QTest::mouseRelease(&axial, Qt::LeftButton, {}, axial.place_of(place(12)).toPoint());
    }

    // Tries another threshold.
    void try_threshold() {
        window().actions()[ActionId::choose_threshold].trigger();
        ThresholdDialog& dialog = window().view_layout().threshold();
        until([&] { return dialog.measured() && !dialog.working(); });
        dialog.findChild<QSlider*>("lineShare")->setValue(75);
        settle();
        until([&] { return !dialog.working(); });
        settle();
        save("threshold", &dialog);
        dialog.hide();
    }

    // Paints a tumour as wide as a small metastasis.
    void tumour(SliceView& axial, const Vec3& middle) {
        emit window().findChild<QComboBox*>("measure")->activated(8);
        window().view_layout().slices().brush().set_radius(7.0);
        QTest::mousePress(&axial, Qt::LeftButton, {}, axial.place_of(middle).toPoint());
        for (const Vec3& off : {Vec3(-4, 1, 0), Vec3(-6, 5, 0), Vec3(-1, 6, 0)})
            lead(axial, middle + off);
        QTest::mouseRelease(&axial, Qt::LeftButton, {}, axial.place_of(middle).toPoint());
        settle();
        save("tumour");
    }

    void save(const QString& name, QWidget* dialog = nullptr) {
        save_window(name, picture_width, dialog);
    }
};

}  // namespace
}  // namespace hepatica

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "Usage: guide_pictures FOLDER [LANGUAGE]\n");
        return 2;
    }
    const char* language = argc == 3 ? argv[2] : "en";
    return hepatica::take_pictures(argc, argv, language, [&](hepatica::MainWindow& window) {
        hepatica::GuidePictures(window, argv[1]).run();
    });
}
