// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson that begins with torn vessels: the body then has more vertices than the patient's mesh
// before the first picture of it is drawn.
#include <QDockWidget>
#include <QImage>
#include <fstream>
#include <memory>

#include "tests/session/small_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/paths.h"
#include "ui/plot_panel.h"

namespace hepatica {
namespace {

using testing::wait_for;
using testing::WindowTest;

std::shared_ptr<const PatientCase> portal_patient() {
    static const std::shared_ptr<const PatientCase> patient = [] {
        auto made = std::make_shared<PatientCase>(*test::small_patient());
        for (VesselSegment& segment : made->tree.segments) segment.system = VascularSystem::portal;
        return made;
    }();
    return patient;
}

class TornLesson : public WindowTest {
  protected:
    TornLesson()
        : WindowTest({[](const OpenRequest&, Job& job) { return play(portal_patient(), job); },
                      [](const std::filesystem::path&, const PatientCase&) {}}) {}
};

TEST_F(TornLesson, keeps_the_colours_of_vessels) {
    const auto share_of_grey = [this] {
        paint();
        const QImage picture = window_.view().picture();
        int grey = 0, vessel = 0;
        // Between the places of a legend, which stands above or below the vessels.
        for (int y = picture.height() / 6; y < picture.height() / 2; ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                if (colour.value() < 90) continue;  // background and shade
                ++vessel;
                grey += colour.saturation() < 80 ? 1 : 0;
            }
        return static_cast<double>(grey) / std::max(vessel, 1);
    };
    open_built_in();
    const double before = share_of_grey();
    const VesselTree& tree = portal_patient()->tree;
    const Vec3 at = test::middle_of(tree, 1);
    const std::string file = folder_.filePath("torn.json").toStdString();
    std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Torn",
        "scene": {"name": "torn", "deform": {}, "tear": {}}, "tools": ["pull"],
        "setup": [{"do": "blade", "from_mm": [)"
                        << at.x() - 15 << "," << at.y() << "," << at.z() << R"(], "to_mm": [)"
                        << at.x() + 15 << "," << at.y() << "," << at.z() << R"(]}],
        "steps": [{"text": "Wait", "goal": [{"what": "time_s", "at_least": 1000}]}]})";
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    const std::size_t vertices = portal_patient()->mesh.vertices_mm.size();
    ASSERT_TRUE(wait_for([&] { return window_.frame().positions_mm.size() > 3 * vertices; }));
    EXPECT_LT(share_of_grey(), before + 0.02);
}

// Entropy is no quantity of the lesson, and none that its trainee knows.
TEST_F(TornLesson, shows_no_curve_of_entropy) {
    open_built_in();
    const auto& panel =
        dynamic_cast<PlotPanel&>(*window_.findChild<QDockWidget*>("Curves")->widget());
    const std::string file = folder_.filePath("torn.json").toStdString();
    std::ofstream(file) << R"({"format": "hepatica-lesson", "version": 1, "name": "Torn",
        "scene": {"name": "torn", "deform": {}, "tear": {}}, "tools": ["pull"],
        "steps": [{"text": "Wait", "goal": [{"what": "time_s", "at_least": 1000}]}]})";
    window_.lessons().start(file);
    ASSERT_TRUE(wait_for([&] { return window_.lessons().playing() && !window_.busy(); }));
    ASSERT_TRUE(wait_for([&] { return window_.frame().tear.has_value(); }));
    window_.actions()[ActionId::pause_simulation].trigger();  // lets the clock run
    // The panel and the curves follow a frame together.
    const auto* clock = window_.lessons().findChild<QLabel*>("lessonClock");
    ASSERT_TRUE(wait_for([&] { return clock->text().startsWith("Time:"); }));
    EXPECT_TRUE(window_.frame().tear.has_value());
    EXPECT_TRUE(panel.tear().chart().curves.empty());
}

}  // namespace
}  // namespace hepatica
