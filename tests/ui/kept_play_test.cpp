// SPDX-License-Identifier: GPL-3.0-or-later
// A free play in which something happened outlasts a review and a lesson.
#include "ui/kept_play.h"

#include <QStatusBar>
#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

#include "core/lesson/lesson_writer.h"
#include "tests/render/fake_frame.h"
#include "tests/ui/fake_simulation.h"
#include "tests/ui/review_window_test.h"
#include "ui/lesson_dock.h"
#include "ui/message_bar.h"

namespace hepatica {
namespace {

using testing::fake_frame;
using testing::FakeSimulation;
using testing::ReviewWindowTest;
using testing::wait_for;

std::unique_ptr<FakeSimulation> torn_play() {
    auto play = std::make_unique<FakeSimulation>(fake_frame());
    play->show_tear(TearView{});
    play->update_frame();
    return play;
}

TEST(KeptPlayTest, one_in_which_nothing_happened_is_not_kept) {
    KeptPlay kept;
    kept.take(std::make_unique<FakeSimulation>(fake_frame()));
    EXPECT_EQ(kept.give_back(), nullptr);
}

TEST(KeptPlayTest, stands_still_until_it_is_given_back) {
    auto play = torn_play();
    FakeSimulation& same = *play;
    KeptPlay kept;
    kept.take(std::move(play));
    const auto is_pause = [&same](bool paused) {
        const auto* last = std::get_if<SetPaused>(&same.commands().back());
        return last != nullptr && last->paused == paused;
    };
    EXPECT_TRUE(is_pause(true));
    const std::unique_ptr<Simulation> back = kept.give_back();
    EXPECT_EQ(back.get(), &same);
    EXPECT_TRUE(is_pause(false));
    EXPECT_EQ(kept.give_back(), nullptr) << "once";
}

TEST(KeptPlayTest, one_that_stood_stands_on) {
    auto play = torn_play();
    FakeSimulation& same = *play;
    play->post(SetPaused{true});
    play->update_frame();
    ASSERT_TRUE(play->frame().statistics.paused);
    KeptPlay kept;
    kept.take(std::move(play));
    const std::size_t posted = same.commands().size();
    const std::unique_ptr<Simulation> back = kept.give_back();
    ASSERT_EQ(back.get(), &same);
    EXPECT_EQ(same.commands().size(), posted);
}

class KeptPlayWindowTest : public ReviewWindowTest {
  protected:
    void inject() {
        window_.actions()[ActionId::inject_mode].trigger();
        const Vec3 trunk = test::middle_of(test::small_patient()->tree, 0);
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(trunk));
        ASSERT_TRUE(wait_for([this] { return window_.frame().drug.injection != nullptr; }));
    }
};

// What a trainee has cut or injected is there again, at the time when he left it.
TEST_F(KeptPlayWindowTest, is_as_it_was_after_a_review) {
    open_built_in();
    inject();
    ASSERT_TRUE(wait_for([this] { return window_.frame().drug.time_s > 0.0; }));
    const auto injected = window_.frame().drug.injection;
    look_back();
    ASSERT_EQ(window_.frame().drug.injection, nullptr) << "the recording has none";
    click("reviewLeave");
    ASSERT_TRUE(wait_for([this] { return window_.frame().drug.injection != nullptr; }));
    EXPECT_EQ(window_.frame().drug.injection, injected);
    EXPECT_TRUE(wait_for([this] { return !window_.frame().statistics.paused; })) << "it goes on";
}

TEST_F(KeptPlayWindowTest, is_as_it_was_after_a_lesson) {
    Lesson lesson;
    lesson.name = "Pull";
    lesson.scene = played().recording.scene;
    lesson.tools = {LessonTool::pull};
    lesson.steps = {{"Pull", "", {{Quantity::time_s, -1, true, 1000.0}}, 0.0, {}}};
    const auto place = to_path(folder_.filePath("lesson.json"));
    write_lesson(place, lesson);
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    window_.lessons().start(place.string());
    ASSERT_TRUE(wait_for([this] { return window_.lessons().playing(); }));
    ASSERT_EQ(window_.frame().drug.injection, nullptr);
    window_.lessons().findChild<QAbstractButton*>("lessonLeave")->click();
    ASSERT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
}

// Another patient has another play.
TEST_F(KeptPlayWindowTest, ends_with_its_patient) {
    open_built_in();
    inject();
    look_back();
    window_.open(OpenRequest{true, {}});
    ASSERT_TRUE(wait_for([this] { return opened_ == 2 && !window_.busy(); }));
    paint();
    look_back();
    click("reviewLeave");
    paint();
    EXPECT_EQ(window_.frame().drug.injection, nullptr);
}

// The review had the view for itself: what is left of it must not hide the vessels.
TEST_F(KeptPlayWindowTest, is_seen_whole_after_a_review_that_was_looked_at_closely) {
    open_built_in();
    look_back();
    window_.view().scene().zoom_by(8.0);
    window_.view().draw_again();
    const auto outside = [this] {
        window_.view().drawn();
        const std::vector<float>& at = window_.frame().positions_mm;
        int out = 0;
        for (std::size_t i = 0; i + 2 < at.size(); i += 3)
            out += !window_.view().rect().contains(on_widget(Vec3(at[i], at[i + 1], at[i + 2])));
        return out;
    };
    ASSERT_GT(outside(), 0);
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return outside() == 0; }));
}

// A recording that cannot be read is not being read any more.
TEST_F(KeptPlayWindowTest, nothing_is_said_to_be_read_after_a_failure) {
    open_built_in();
    window_.open(folder_.filePath("none.hrec"));
    ASSERT_TRUE(wait_for([this] { return window_.messages().text().contains("none.hrec"); }));
    EXPECT_TRUE(wait_for([this] { return !dock().busy(); }));
    EXPECT_EQ(window_.statusBar()->currentMessage().indexOf("Reading"), -1);
}

}  // namespace
}  // namespace hepatica
