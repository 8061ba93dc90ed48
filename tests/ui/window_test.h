// SPDX-License-Identifier: GPL-3.0-or-later
// What every test of the whole window shares: a window on the screen with settings of its own, and
// the way from a place in the patient to a place under the mouse. Nothing here waits for a fixed
// time: each wait ends with its condition, or fails after `patience_ms`.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <utility>

#include "ui/main_window.h"
#include "ui/patient_loader.h"
#include "ui/pixel_mapping.h"
#include "ui/vtk_widget.h"

namespace hepatica::testing {

// Far longer than anything takes here, also on a computer that builds at the same time.
inline constexpr int patience_ms = 60000;

// False where the condition has not come true in time.
inline bool wait_for(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, patience_ms);
}

// A patient whose play the processor computes.
inline LoadedPatient load_for_processor(const OpenRequest& request, Job& job) {
    return load_patient(request, job);
}

class WindowTest : public ::testing::Test {
  protected:
    explicit WindowTest(MainWindow::Patients patients)
        : settings_(folder_.filePath("settings.ini")),
          window_(settings_, std::move(patients), answers()) {
        window_.resize(1100, 760);
        window_.show();
        if (!QTest::qWaitForWindowExposed(&window_, patience_ms))
            ADD_FAILURE() << "the window did not appear";
        QApplication::setActiveWindow(&window_);  // there is no window manager that would
    }

    // Until no job runs and there is something to see.
    void wait() {
        EXPECT_TRUE(wait_for([this] {
            return window_.has_patient() && !window_.busy() &&
                   !window_.frame().positions_mm.empty();
        }));
        paint();
    }
    void open_built_in() {
        window_.open(OpenRequest{true, {}});
        wait();
    }
    // Until the window has taken over two more frames or the simulation rests, and draws the last
    // one. The fake simulation, which never rests, has then applied whatever was posted before this
    // call.
    void paint() {
        const std::uint64_t now = window_.frame().step;
        EXPECT_TRUE(wait_for(
            [&] { return window_.frame().step > now + 1 || window_.frame().statistics.resting; }));
        window_.view().drawn();
    }
    // Until the figures at the window's foot and in its panels are those of a frame that was shown
    // after this call.
    void wait_for_figures() {
        auto* step = window_.findChild<QLabel*>("step");
        ASSERT_NE(step, nullptr);
        paint();
        step->clear();
        EXPECT_TRUE(wait_for([&] { return !step->text().isEmpty(); }));
    }
    // Where a point of the patient is on the widget, in Qt's points.
    QPoint on_widget(const Vec3& point_mm) {
        return point_at(window_.view().scene().pixel_of(point_mm),
                        window_.view().devicePixelRatioF())
            .toPoint();
    }

    // Nobody sits before the tests' window: what is asked is answered from here.
    PatientKeeper::Questions answers() {
        PatientKeeper::Questions answers;
        answers.unsaved = [this](const std::string&) {
            ++questions_asked_;
            return unsaved_answer_;
        };
        answers.strokes = [this](const std::string&, std::size_t strokes) {
            strokes_asked_ = strokes;
            return strokes_answer_;
        };
        answers.changed_on_disk = [this](const std::filesystem::path&) {
            ++changed_asked_;
            return changed_answer_;
        };
        answers.copy_of_unsaved = [this](const std::string&) { return copy_answer_; };
        answers.which_series = [](const std::vector<SeriesDescription>&) { return 1; };
        answers.where_to_save = [this](const std::filesystem::path& proposed) {
            proposed_place_ = proposed;
            return save_place_;
        };
        answers.end_lesson = [this](const std::string&) {
            ++lesson_ends_asked_;
            while_asked_();
            return lesson_may_end_;
        };
        answers.end_play = [this] {
            ++play_ends_asked_;
            return play_may_end_;
        };
        return answers;
    }

    int questions_asked_ = 0;
    UnsavedAnswer unsaved_answer_ = UnsavedAnswer::discard;
    std::size_t strokes_asked_ = 0;  // how many waited when it was asked last
    StrokesAnswer strokes_answer_ = StrokesAnswer::drop;
    int changed_asked_ = 0;
    ChangedAnswer changed_answer_ = ChangedAnswer::cancel;
    CopyAnswer copy_answer_ = CopyAnswer::cancel;
    int lesson_ends_asked_ = 0;
    std::function<void()> while_asked_ = [] {};  // whether a lesson may end
    bool lesson_may_end_ = true;
    int play_ends_asked_ = 0;
    bool play_may_end_ = true;
    std::optional<std::filesystem::path> save_place_;
    std::filesystem::path proposed_place_;  // when it was asked last
    QTemporaryDir folder_;
    Settings settings_;
    MainWindow window_;
};

}  // namespace hepatica::testing
