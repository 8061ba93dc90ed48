// SPDX-License-Identifier: GPL-3.0-or-later
// A free play in which something happened outlasts a review and a lesson.
#include "ui/kept_play.h"

#include <QCheckBox>
#include <QComboBox>
#include <QStatusBar>
#include <algorithm>
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
    TearView torn;
    torn.joints_broken = 1;
    play->show_tear(torn);
    play->update_frame();
    return play;
}

const KeptPlay::Shown as_shown{"cpu", {}, {}};

TEST(KeptPlayTest, one_in_which_nothing_happened_is_not_kept) {
    KeptPlay kept;
    kept.take(std::make_unique<FakeSimulation>(fake_frame()), as_shown);
    EXPECT_EQ(kept.give_back("cpu"), nullptr);
    auto may_tear = std::make_unique<FakeSimulation>(fake_frame());
    may_tear->show_tear(TearView{});
    kept.take(std::move(may_tear), as_shown);
    EXPECT_EQ(kept.give_back("cpu"), nullptr) << "nothing is torn";
}

// The window's frame may be older than the last deed.
TEST(KeptPlayTest, what_is_not_in_the_frame_yet_counts) {
    auto play = std::make_unique<FakeSimulation>(fake_frame());
    TearView torn;
    torn.joints_broken = 1;
    play->show_tear(torn);
    KeptPlay kept;
    FakeSimulation& same = *play;
    kept.take(std::move(play), as_shown);
    const auto has = [&same](auto command) {
        return std::ranges::any_of(same.commands(), [](const Command& posted) {
            return std::holds_alternative<decltype(command)>(posted);
        });
    };
    EXPECT_TRUE(has(ReleaseGrab{}));
    EXPECT_TRUE(has(RemoveTool{}));
    EXPECT_TRUE(has(UseTools{})) << "the vessels are made ready for tools no longer";
    EXPECT_EQ(kept.give_back("cpu").get(), &same);
}

// As one whose thread is in the midst of a long step.
class LateSimulation : public FakeSimulation {
  public:
    using FakeSimulation::FakeSimulation;
    bool update_frame() override { return !late && FakeSimulation::update_frame(); }
    bool late = false;
};

// Two reviews in turn give it back and take it again before it has made a step.
TEST(KeptPlayTest, goes_on_though_it_was_given_back_for_a_moment) {
    Frame torn = fake_frame();
    torn.tear.emplace().joints_broken = 1;
    auto play = std::make_unique<LateSimulation>(torn);
    LateSimulation& same = *play;
    same.show_tear(torn.tear);
    same.update_frame();
    KeptPlay kept;
    kept.take(std::move(play), as_shown);
    same.update_frame();
    ASSERT_TRUE(same.frame().statistics.paused);
    same.late = true;
    kept.take(kept.give_back("cpu"), as_shown);
    EXPECT_EQ(kept.give_back("cpu").get(), &same);
    const auto* last = std::get_if<SetPaused>(&same.commands().back());
    ASSERT_NE(last, nullptr);
    EXPECT_FALSE(last->paused);
}

// The window says that the next play is computed by the back end that was chosen.
TEST(KeptPlayTest, ends_where_another_back_end_was_chosen) {
    KeptPlay kept;
    kept.take(torn_play(), as_shown);
    EXPECT_EQ(kept.give_back("cuda"), nullptr);
    EXPECT_EQ(kept.give_back("cpu"), nullptr);
}

TEST(KeptPlayTest, stands_still_until_it_is_given_back) {
    auto play = torn_play();
    FakeSimulation& same = *play;
    KeptPlay kept;
    kept.take(std::move(play), as_shown);
    const auto is_pause = [&same](bool paused) {
        const auto* last = std::get_if<SetPaused>(&same.commands().back());
        return last != nullptr && last->paused == paused;
    };
    EXPECT_TRUE(is_pause(true));
    const std::unique_ptr<Simulation> back = kept.give_back("cpu");
    EXPECT_EQ(back.get(), &same);
    EXPECT_TRUE(is_pause(false));
    EXPECT_EQ(kept.give_back("cpu"), nullptr) << "once";
}

TEST(KeptPlayTest, one_that_stood_stands_on) {
    auto play = torn_play();
    FakeSimulation& same = *play;
    play->post(SetPaused{true});
    play->update_frame();
    ASSERT_TRUE(play->frame().statistics.paused);
    KeptPlay kept;
    kept.take(std::move(play), as_shown);
    const std::size_t posted = same.commands().size();
    const std::unique_ptr<Simulation> back = kept.give_back("cpu");
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

// What a trainee has injected is there again, with the settings it had.
TEST_F(KeptPlayWindowTest, is_as_it_was_after_a_review) {
    open_built_in();
    inject();
    ASSERT_TRUE(wait_for([this] { return window_.frame().drug.time_s > 0.0; }));
    const auto injected = window_.frame().drug.injection;
    look_back();
    ASSERT_EQ(window_.frame().drug.injection, nullptr) << "the recording has none";
    auto* gravity = window_.findChild<QCheckBox*>("gravity");
    ASSERT_FALSE(gravity->isChecked());
    gravity->setChecked(true);
    click("reviewLeave");
    EXPECT_FALSE(gravity->isChecked()) << "it was chosen for what was shown then";
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
    EXPECT_EQ(play_ends_asked_, 1);
    paint();
    look_back();
    click("reviewLeave");
    paint();
    EXPECT_EQ(window_.frame().drug.injection, nullptr);
}

TEST_F(KeptPlayWindowTest, does_not_end_where_the_user_stays) {
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    look_back();
    play_may_end_ = false;
    window_.open(OpenRequest{true, {}});
    ASSERT_TRUE(wait_for([this] { return play_ends_asked_ == 1 && !window_.busy(); }));
    EXPECT_EQ(opened_, 1);
    EXPECT_TRUE(dock().complete()) << "the review goes on";
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
}

// Begun to be reviewed while the other one was on his way.
TEST_F(KeptPlayWindowTest, does_not_end_where_the_user_stays_when_the_other_patient_arrives) {
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    endless_ = true;
    window_.open(OpenRequest{true, {}});
    look_back();
    EXPECT_EQ(play_ends_asked_, 0);
    play_may_end_ = false;
    endless_ = false;
    ASSERT_TRUE(wait_for([this] { return play_ends_asked_ == 1 && !window_.busy(); }));
    EXPECT_TRUE(dock().complete());
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
}

// A lesson on a case opens it, also where its patient is shown already.
TEST_F(KeptPlayWindowTest, does_not_end_with_a_lesson_that_opens_a_case_where_the_user_stays) {
    Lesson lesson;
    lesson.name = "Pull";
    lesson.patient = "built-in";  // whoever the test opens is not called so
    lesson.scene = played().recording.scene;
    lesson.tools = {LessonTool::pull};
    lesson.steps = {{"Pull", "", {{Quantity::time_s, -1, true, 1000.0}}, 0.0, {}}};
    const auto place = to_path(folder_.filePath("lesson.json"));
    write_lesson(place, lesson);
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    look_back();
    play_may_end_ = false;
    window_.lessons().start(place.string());
    ASSERT_TRUE(wait_for([this] { return play_ends_asked_ == 1 && !window_.busy(); }));
    EXPECT_EQ(opened_, 1);
    EXPECT_FALSE(window_.lessons().playing());
    EXPECT_TRUE(dock().complete());
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
    EXPECT_FALSE(window_.lessons().playing()) << "the lesson is not waited for";
}

// In the panel of settings the back end that computes it stays chosen.
TEST_F(KeptPlayWindowTest, does_not_end_with_another_back_end_where_the_user_stays) {
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    look_back();
    play_may_end_ = false;
    auto* box = window_.findChild<QComboBox*>("back_end");
    const QVariant before = box->currentData();
    const int other = box->findData(QString("cuda"));
    ASSERT_GE(other, 0);
    box->setCurrentIndex(other);
    emit box->activated(other);
    EXPECT_EQ(play_ends_asked_, 1);
    EXPECT_EQ(box->currentData(), before);
    EXPECT_EQ(settings_.back_end(), before.toString());
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
}

TEST_F(KeptPlayWindowTest, nobody_is_asked_about_a_play_in_which_nothing_happened) {
    open_built_in();
    look_back();
    play_may_end_ = false;
    window_.open(OpenRequest{true, {}});
    ASSERT_TRUE(wait_for([this] { return opened_ == 2 && !window_.busy(); }));
    EXPECT_EQ(play_ends_asked_, 0);
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

// Neither the free play nor an empty dock is seen between two reviews.
TEST_F(KeptPlayWindowTest, stays_behind_while_a_review_follows_another) {
    open_built_in();
    inject();
    const auto injected = window_.frame().drug.injection;
    look_back();
    const auto other = to_path(folder_.filePath("other.hrec"));
    std::filesystem::copy(file_, other);
    window_.open(to_text(other));
    EXPECT_TRUE(dock().reviewing());
    EXPECT_TRUE(dock().isVisible());
    EXPECT_EQ(dock().file(), file_) << "until the other one is there";
    EXPECT_EQ(window_.frame().drug.injection, nullptr) << "the free play goes on";
    ASSERT_TRUE(wait_for([&] { return dock().file() == other && dock().complete(); }));
    EXPECT_EQ(window_.frame().drug.injection, nullptr);
    click("reviewLeave");
    EXPECT_TRUE(wait_for([&] { return window_.frame().drug.injection == injected; }));
}

TEST_F(KeptPlayWindowTest, a_review_outlasts_a_recording_that_cannot_be_read) {
    open_built_in();
    look_back();
    window_.open(folder_.filePath("none.hrec"));
    ASSERT_TRUE(wait_for([this] { return window_.messages().text().contains("none.hrec"); }));
    ASSERT_TRUE(wait_for([this] { return !dock().busy(); }));
    EXPECT_TRUE(dock().complete());
    EXPECT_EQ(dock().file(), file_);
    line().set_at(30.2 / 60);
    EXPECT_TRUE(shows_step(29));
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
