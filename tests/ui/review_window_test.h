// SPDX-License-Identifier: GPL-3.0-or-later
// A test of reviews in the window: a recorded pull on the small patient, who is whatever is opened.
#pragma once

#include <QAbstractButton>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/session/recording_file.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/ui/window_test.h"
#include "ui/paths.h"
#include "ui/review_dock.h"
#include "ui/time_line.h"

namespace hepatica::testing {

class ReviewWindowTest : public WindowTest {
  protected:
    // A pull that begins at the tenth of a hundred steps.
    static constexpr int steps = 100, pull_begins = 10, pull_ends = 40;

    struct Played {
        Recording recording;
        std::vector<Frame> frames;
    };

    static const Played& played() {
        static const Played play = [] {
            const auto session = test::new_session();
            const auto recording = test::keep_recording(*session);
            const Vec3 hand = test::middle_of(test::small_patient()->tree, 2);
            Played made;
            for (int k = 0; k < steps; ++k) {
                if (k == pull_begins) session->post(GrabPoint{hand});
                if (k > pull_begins && k < pull_ends)
                    session->post(MoveGrab{hand + 0.3 * (k - pull_begins) * Vec3(1, 0, 0)});
                if (k == pull_ends) session->post(ReleaseGrab{});
                session->step();
                session->update_frame();
                made.frames.push_back(session->frame());
            }
            made.recording = *recording;
            return made;
        }();
        return play;
    }

    ReviewWindowTest()
        : WindowTest({[this](const OpenRequest&, Job& job) {
                          while (endless_) job.throw_if_cancelled();
                          ++opened_;
                          return play(opens_other_ ? other_patient() : test::small_patient(), job);
                      },
                      [](const std::filesystem::path&, const PatientCase&) {}}),
          file_(to_path(folder_.filePath("play.hrec"))) {
        write_recording(file_, played().recording);
    }

    ReviewDock& dock() { return window_.review(); }
    TimeLine& line() { return *dock().findChild<TimeLine*>("reviewLine"); }
    QListWidget& events() { return *dock().findChild<QListWidget*>("reviewEvents"); }
    void click(const char* name) { dock().findChild<QAbstractButton*>(name)->click(); }
    void look_back() {
        window_.open(to_text(file_));
        ASSERT_TRUE(wait_for([this] { return dock().complete(); }));
        if (dock().playing()) click("reviewPlay");
    }
    // The step whose frame the window shows, from 0; -1 where it is not that frame.
    int shown_step() {
        const Frame& shown = window_.frame();
        const Frame& was = played().frames.at(static_cast<std::size_t>(shown.step - 1));
        return shown.positions_mm == was.positions_mm ? static_cast<int>(was.step) - 1 : -1;
    }
    bool shows_step(int wanted) {
        return wait_for([&] { return shown_step() == wanted; });
    }

    std::filesystem::path file_;
    // Whose vessels lie elsewhere.
    static std::shared_ptr<const PatientCase> other_patient() {
        auto other = std::make_shared<PatientCase>(*test::small_patient());
        for (Vec3& vertex : other->mesh.vertices_mm) vertex.x() += 1.0;
        return other;
    }
    // Types it into the next dialog of files.
    void choose_file(const QString& name) {
        auto* timer = new QTimer(&window_);
        QObject::connect(timer, &QTimer::timeout, timer, [timer, name] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return;
            timer->deleteLater();
            QApplication::setActiveWindow(dialog);
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name);
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
        timer->start(20);
    }

    std::atomic<bool> opens_other_ = false;
    std::atomic<int> opened_ = 0;
    std::atomic<bool> endless_ = false;  // nobody can be opened until he is given up
};

}  // namespace hepatica::testing
