// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody sees changing costs nothing: a window whose patient rests takes no step and draws no
// picture, before an injection and after it has run out.
#include <QDoubleSpinBox>
#include <QPushButton>
#include <ctime>

#include "core/scene/measured_dial.h"
#include "core/study/dial_study.h"
#include "tests/session/small_patient.h"
#include "tests/ui/fake_window_test.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

// One whose dial is known: nothing is left to be measured while nobody plays.
std::shared_ptr<const PatientCase> patient_with_a_dial() {
    auto patient = std::make_shared<PatientCase>(*test::small_patient());
    std::vector<QualityPoint> points;
    double ms = 1.0;
    while (const auto next = next_dial_setting(points)) {
        points.push_back({*next, ms, 0.1 / ms, "made up"});
        ms *= 1.5;
    }
    patient->dial_json = dial_json(points, *patient);
    return patient;
}

// Counts the paintings of a widget and of what lies in it, such as a view's canvas.
class Paintings : public QObject {
  public:
    explicit Paintings(QWidget& widget) {
        widget.installEventFilter(this);
        for (QWidget* inner : widget.findChildren<QWidget*>()) inner->installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) ++count;
        return QObject::eventFilter(watched, event);
    }
    int count = 0;
};

void turn_the_event_loop(int turns) {
    for (int i = 0; i < turns; ++i) {
        QApplication::processEvents();
        QTest::qSleep(1);
    }
}

double seconds_on(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Processor time of the program so far but for this thread, which turns the event loop.
double seconds_of_other_threads() {
    return seconds_on(CLOCK_PROCESS_CPUTIME_ID) - seconds_on(CLOCK_THREAD_CPUTIME_ID);
}

// The picture is drawn once more, smoothed, when it has come to rest.
bool comes_to_rest(const Paintings& paintings) {
    return testing::wait_for([&] {
        const int before = paintings.count;
        turn_the_event_loop(400);
        return paintings.count == before;
    });
}

class Idle : public testing::WindowTest {
  protected:
    Idle()
        : WindowTest({[this](const OpenRequest&, Job& job) {
                          LoadedPatient loaded = play(patient_with_a_dial(), job);
                          loaded.cached_case = cached_;
                          return loaded;
                      },
                      write_case}),
          cached_(to_path(folder_.filePath("cached.hep"))) {
        write_case(cached_, *test::small_patient());
        open_built_in();
    }

    const std::filesystem::path cached_;

    void expect_rest() {
        ASSERT_TRUE(testing::wait_for([this] { return window_.frame().statistics.resting; }));
        // A busy machine may write the last step's figures late, and a message of the status line
        // goes after some seconds: each is painted once. What is painted again every two seconds
        // never lets such a spell pass, nor does a thread that works for nothing.
        constexpr double idle_share = 0.02;  // of a core
        Paintings view(window_.view()), whole_window(window_);
        EXPECT_TRUE(testing::wait_for([&] {
            const std::uint64_t step = window_.frame().step;
            view.count = whole_window.count = 0;
            const double worked_s = seconds_of_other_threads();
            const double began_s = seconds_on(CLOCK_MONOTONIC);
            turn_the_event_loop(2400);
            const double spell_s = seconds_on(CLOCK_MONOTONIC) - began_s;
            return view.count == 0 && whole_window.count == 0 && window_.frame().step == step &&
                   seconds_of_other_threads() - worked_s < idle_share * spell_s;
        }));
    }
};

// At every start it would be measured again, half a minute on all cores.
TEST_F(Idle, the_dial_of_the_built_in_patient_is_kept_with_him) {
    EXPECT_EQ(measured_points(read_case_without_voxels(cached_)).size(),
              measured_points(*patient_with_a_dial()).size());
}

TEST_F(Idle, before_an_injection_and_after_it_has_run_out) {
    expect_rest();
    window_.findChild<QDoubleSpinBox*>("speed")->setValue(100.0);
    const Vec3 root = test::small_patient()->tree.nodes[0].position_mm;
    QTest::mouseDClick(&window_.view(), Qt::LeftButton, {}, on_widget(root + Vec3(0, 0, 3)));
    auto& play = *window_.findChild<QPushButton*>("play");
    ASSERT_TRUE(testing::wait_for([&] { return window_.frame().drug.arrival_s != nullptr; }));
    ASSERT_TRUE(testing::wait_for([&] { return !window_.frame().drug.playing; }));
    expect_rest();
    EXPECT_EQ(play.text(), "Play");
    // Played once more, it begins anew. Slowly: at 100 times the speed a machine that is busy would
    // show its first picture after the injection has run out again.
    window_.findChild<QDoubleSpinBox*>("speed")->setValue(1.0);
    window_.actions()[ActionId::play_pause].trigger();
    EXPECT_TRUE(testing::wait_for([&] {
        const DrugView& drug = window_.frame().drug;
        return drug.playing && drug.time_s < 0.9 * drug.end_s;
    }));
}

// Pressed against a vessel, held there, and put away again.
TEST_F(Idle, with_a_tool_that_rests) {
    const Vec3 root = test::small_patient()->tree.nodes[0].position_mm;
    const QPoint place = on_widget(root + Vec3(0, 0, 3));
    QTest::keyClick(&window_, Qt::Key_4);
    QMouseEvent move(QEvent::MouseMove, place, window_.view().mapToGlobal(place), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&window_.view(), &move);
    ASSERT_TRUE(testing::wait_for([&] { return window_.frame().tool.has_value(); }));
    expect_rest();
    window_.view().mouse().wheel(0.4);
    ASSERT_TRUE(testing::wait_for([&] { return !window_.frame().tool->touched.empty(); }));
    expect_rest();
    EXPECT_FALSE(window_.frame().tool->touched.empty());
    QTest::keyClick(&window_, Qt::Key_Escape);
    ASSERT_TRUE(testing::wait_for([&] { return !window_.frame().tool; }));
    expect_rest();
}

class FakeIdle : public testing::FakeWindowTest {};

// Frames that show what is shown already are not drawn.
TEST_F(FakeIdle, a_frame_like_the_last_is_not_drawn) {
    open_built_in();
    Paintings paintings(window_.view());
    ASSERT_TRUE(comes_to_rest(paintings));
    const std::uint64_t step = window_.frame().step;
    paintings.count = 0;
    ASSERT_TRUE(testing::wait_for([&] { return window_.frame().step > step + 30; }));
    EXPECT_EQ(paintings.count, 0);
    // Nor those of a hand that holds still; one that moves is drawn.
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    ASSERT_TRUE(testing::wait_for([&] { return window_.frame().grab.has_value(); }));
    ASSERT_TRUE(comes_to_rest(paintings));
    paintings.count = 0;
    paint();
    paint();
    EXPECT_EQ(paintings.count, 0);
    QTest::mouseMove(&window_.view(), on_trunk() + QPoint(30, 0));
    EXPECT_TRUE(testing::wait_for([&] { return paintings.count > 0; }));
}

// What is posted is handled, timers do not fire: a picture of draw_again() is drawn then, one of
// draw_soon() waits until the slices rest.
TEST_F(FakeIdle, what_the_slices_change_waits_for_them) {
    open_built_in();
    Paintings paintings(window_.view());
    ASSERT_TRUE(comes_to_rest(paintings));
    paintings.count = 0;
    window_.view().draw_soon();
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(paintings.count, 0);
    window_.view().draw_again();
    QCoreApplication::sendPostedEvents();
    EXPECT_GT(paintings.count, 0) << "else this test would see none of either";
}

// Each change puts the picture off, but not for ever.
TEST_F(FakeIdle, what_the_slices_change_is_drawn_though_they_never_rest) {
    open_built_in();
    Paintings paintings(window_.view());
    ASSERT_TRUE(comes_to_rest(paintings));
    paintings.count = 0;
    EXPECT_TRUE(testing::wait_for([&] {
        window_.view().draw_soon();
        return paintings.count > 0;
    }));
}

}  // namespace
}  // namespace hepatica
