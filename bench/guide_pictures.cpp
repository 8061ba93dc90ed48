// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the pictures of the guide from the window itself, with the built-in patient:
//
//     xvfb-run -s "-screen 0 1280x820x24" build/release/bin/guide_pictures assets/guide/pictures
//
// A second argument is the language that the window speaks there, such as "de".
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "core/patient/patient_case.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/opengl_probe.h"
#include "ui/pixel_mapping.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/threshold_dialog.h"
#include "ui/slices/view_layout.h"
#include "ui/theme.h"
#include "ui/vtk_widget.h"

namespace hepatica {
namespace {

constexpr int patience_ms = 300000;
constexpr int picture_width = 680;  // of the guide's page

class Photographer {
  public:
    Photographer(MainWindow& window, QString folder)
        : window_(window), folder_(std::move(folder)) {}

    void run() {
        window_.actions()[ActionId::built_in].trigger();
        until([this] { return window_.has_patient() && !window_.busy(); });
        settle();
        save("window");
        const QPoint vessel = on_vessel(0.75);
        QTest::mousePress(&window_.view(), Qt::LeftButton, {}, vessel);
        for (int i = 1; i <= 20; ++i) {
            QTest::mouseMove(&window_.view(), vessel + QPoint(4 * i, 3 * i));
            QTest::qWait(30);
        }
        settle();
        save("pull");
        QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, vessel + QPoint(80, 60));
        window_.actions()[ActionId::reset].trigger();
        settle();
        QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, on_vessel(0.02));
        QTest::qWait(6000);  // of the drug's way
        window_.actions()[ActionId::play_pause].trigger();
        settle();
        save("drug");
        window_.actions()[ActionId::remove_drug].trigger();
        window_.actions()[ActionId::toggle_plots].trigger();
        volume();
        slices();
    }

  private:
    void volume() {
        QAction& action = window_.actions()[ActionId::toggle_volume];
        action.trigger();
        until([this] { return window_.findChild<QWidget*>("volumeBar")->isVisible(); });
        settle();
        save("volume");
        action.trigger();
        settle();
    }

    void slices() {
        window_.actions()[ActionId::toggle_slices].trigger();
        ViewLayout& views = window_.view_layout();
        until([&] { return !views.slices().empty(); });
        settle();
        save("slices");
        emit window_.findChild<QComboBox*>("measure")->activated(4);
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
        for (int k = 0; k < 2; ++k) QTest::keyClick(&axial, Qt::Key_Escape);  // stroke, then brush
        try_threshold();
        tumour(axial, begin + Vec3(-26.0, -16.0, 0));
    }

    // A branch that is painted, while the mouse still leads the brush.
    void paint(SliceView& axial, const std::function<Vec3(int step)>& place) {
        emit window_.findChild<QComboBox*>("measure")->activated(6);
        QTest::mousePress(&axial, Qt::LeftButton, {}, axial.place_of(place(0)).toPoint());
        for (int step = 1; step <= 12; ++step) lead(axial, place(step));
        settle();
        save("paint");
        QTest::mouseRelease(&axial, Qt::LeftButton, {}, axial.place_of(place(12)).toPoint());
    }

    // Another threshold that is tried.
    void try_threshold() {
        window_.actions()[ActionId::choose_threshold].trigger();
        ThresholdDialog& dialog = window_.view_layout().threshold();
        until([&] { return dialog.measured() && !dialog.working(); });
        dialog.findChild<QSlider*>("lineShare")->setValue(75);
        settle();
        save("threshold", &dialog);
        dialog.hide();
    }

    // As wide as a small metastasis.
    void tumour(SliceView& axial, const Vec3& middle) {
        emit window_.findChild<QComboBox*>("measure")->activated(8);
        window_.view_layout().slices().brush().set_radius(7.0);
        QTest::mousePress(&axial, Qt::LeftButton, {}, axial.place_of(middle).toPoint());
        for (const Vec3& off : {Vec3(-4, 1, 0), Vec3(-6, 5, 0), Vec3(-1, 6, 0)})
            lead(axial, middle + off);
        QTest::mouseRelease(&axial, Qt::LeftButton, {}, axial.place_of(middle).toPoint());
        settle();
        save("tumour");
    }

    static void lead(SliceView& axial, const Vec3& place) {
        const QPointF at = axial.place_of(place).toPoint();
        QMouseEvent move(QEvent::MouseMove, at, axial.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&axial, &move);
    }

    // Along the branch that is longest.
    QPoint on_vessel(double share) {
        const VesselTree& tree = window_.workspace().patient()->tree;
        const VesselSegment* longest = &tree.segments.front();
        if (share > 0.5)
            for (const VesselSegment& segment : tree.segments)
                if (segment.points_mm.size() > longest->points_mm.size()) longest = &segment;
        const auto index =
            static_cast<std::size_t>(share * static_cast<double>(longest->points_mm.size() - 1));
        return point_at(window_.view().scene().pixel_of(longest->points_mm[index]),
                        window_.view().devicePixelRatioF())
            .toPoint();
    }

    void until(const std::function<bool()>& condition) {
        if (!QTest::qWaitFor(condition, patience_ms)) throw std::runtime_error("it took too long");
    }
    void settle() { QTest::qWait(2500); }  // until the picture is smoothed and panels follow

    // With the dialog in front, in the middle of the view.
    void save(const QString& name, QWidget* dialog = nullptr) {
        QPixmap shown = window_.grab();
        if (dialog != nullptr)
            QPainter(&shown).drawPixmap(
                window_.view().mapTo(&window_, window_.view().rect().center()) -
                    dialog->rect().center(),
                dialog->grab());
        const QImage picture =
            shown.toImage().scaledToWidth(picture_width, Qt::SmoothTransformation);
        const QString file = folder_ + "/" + name + ".png";
        if (!picture.save(file)) throw std::runtime_error("cannot write " + file.toStdString());
        std::printf("%s\n", file.toStdString().c_str());
    }

    MainWindow& window_;
    QString folder_;
};

int run(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "Usage: guide_pictures FOLDER [LANGUAGE]\n");
        return 2;
    }
    prepare_opengl();
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    use_language(argc == 3 ? argv[2] : "en");
    apply_theme(application);
    QTemporaryDir folder;
    Settings settings(folder.filePath("settings.ini"));
    MainWindow window(settings, {load_patient, write_case});
    window.resize(1280, 800);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) return 1;
    QApplication::setActiveWindow(&window);
    Photographer(window, argv[1]).run();
    return 0;
}

}  // namespace
}  // namespace hepatica

int main(int argc, char** argv) {
    try {
        return hepatica::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "guide_pictures: %s\n", error.what());
        return 1;
    }
}
