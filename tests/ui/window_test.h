// SPDX-License-Identifier: GPL-3.0-or-later
// What every test of the whole window shares: a window on the screen with settings of its own, and
// the way from a place in the patient to a place under the mouse.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <utility>

#include "ui/main_window.h"
#include "ui/pixel_mapping.h"
#include "ui/vtk_widget.h"

namespace hepatica::testing {

class WindowTest : public ::testing::Test {
  protected:
    explicit WindowTest(MainWindow::Patients patients)
        : settings_(folder_.filePath("settings.ini")), window_(settings_, std::move(patients)) {
        window_.resize(1100, 760);
        window_.show();
        if (!QTest::qWaitForWindowExposed(&window_)) ADD_FAILURE() << "the window did not appear";
        QApplication::setActiveWindow(&window_);  // there is no window manager that would
    }

    // Until no job runs and there is something to see.
    void wait() {
        const bool done = QTest::qWaitFor(
            [this] {
                return window_.has_patient() && !window_.busy() &&
                       !window_.frame().positions_mm.empty();
            },
            60000);
        EXPECT_TRUE(done);
        paint();
    }
    void open_built_in() {
        window_.open(OpenRequest{true, {}});
        wait();
    }
    void paint() {
        QTest::qWait(80);
        window_.view().grabFramebuffer();
    }
    // Where a point of the patient is on the widget, in Qt's points.
    QPoint on_widget(const Vec3& point_mm) {
        return point_at(window_.view().scene().pixel_of(point_mm),
                        window_.view().devicePixelRatioF())
            .toPoint();
    }

    QTemporaryDir folder_;
    Settings settings_;
    MainWindow window_;
};

}  // namespace hepatica::testing
