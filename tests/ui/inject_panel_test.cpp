// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inject_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/lesson/lesson_file.h"
#include "core/session/script.h"
#include "ui/folded_form.h"

namespace hepatica {
namespace {

// What a script, `play` and `inject` inject where nobody chooses is what the window offers first.
TEST(InjectPanel, BeginsWithTheDefaultInjection) {
    const InjectPanel panel([](const Command&) {});
    const Vec3 at(1.0, 2.0, 3.0);
    const InjectDrug offered = panel.injection_at(at), unchosen{at};
    EXPECT_EQ(offered.point_mm, unchosen.point_mm);
    EXPECT_DOUBLE_EQ(offered.mass_flow_g_s, unchosen.mass_flow_g_s);
    EXPECT_DOUBLE_EQ(offered.void_fraction, unchosen.void_fraction);
    EXPECT_EQ(offered.second_phase, unchosen.second_phase);
    EXPECT_EQ(offered.pressure_model, unchosen.pressure_model);
    EXPECT_FALSE(offered.drug_viscosity_pa_s.has_value());
}

// A lesson's hint names what the panel offers, and its mixture is the one that the play of the
// lesson's tests passes with.
TEST(InjectPanel, OffersTheDrugOfALesson) {
    InjectPanel panel([](const Command&) {});
    auto& drugs = *panel.findChild<QComboBox*>("drug");
    panel.choose_drug("");
    EXPECT_NE(drugs.currentText(), "Lipiodol emulsion, 2 to 1");
    panel.choose_drug(find_lesson("embolization").drug);
    EXPECT_EQ(drugs.currentText(), "Lipiodol emulsion, 2 to 1");
    EXPECT_EQ(panel.injection_at(Vec3::Zero()).second_phase, "lipiodol");
    const Script play =
        read_script(HEPATICA_SOURCE_DIR "/tests/lesson/plays/embolization_passes.json");
    EXPECT_EQ(std::get<InjectDrug>(play.actions.at(0).command.value()).void_fraction,
              panel.injection_at(Vec3::Zero()).void_fraction);
}

// So that the button of the drug's clock stands in sight.
TEST(InjectPanel, FoldsWhatFewNeed) {
    InjectPanel panel([](const Command&) {});
    panel.show();
    auto& more = *dynamic_cast<FoldedForm*>(panel.findChild<QWidget*>("moreOfInjection"));
    auto& law = *more.findChild<QComboBox*>();
    auto& title = *more.findChild<QToolButton*>();
    EXPECT_FALSE(law.isVisible());
    EXPECT_EQ(panel.injection_at(Vec3::Zero()).pressure_model,
              InjectDrug{Vec3::Zero()}.pressure_model);
    const int before = panel.sizeHint().height();
    title.click();
    EXPECT_TRUE(law.isVisible());
    EXPECT_GT(panel.sizeHint().height(), before);
    title.click();
    EXPECT_FALSE(law.isVisible());
}

TEST(InjectPanel, GivesTheDrugFromBeforeALessonBack) {
    InjectPanel panel([](const Command&) {});
    panel.findChild<QComboBox*>("drug")->setCurrentIndex(2);
    const InjectDrug before = panel.injection_at(Vec3::Zero());
    const std::string drug = find_lesson("embolization").drug;
    ASSERT_NE(before.second_phase, drug);
    const auto offered = [&] { return panel.injection_at(Vec3::Zero()); };
    panel.begin_play(false);
    panel.choose_drug(drug);
    panel.choose_drug(drug);  // begun again
    ASSERT_EQ(offered().second_phase, drug);
    panel.begin_play(true);
    EXPECT_EQ(offered().second_phase, before.second_phase);
    EXPECT_DOUBLE_EQ(offered().void_fraction, before.void_fraction);
    panel.choose_drug(drug);
    panel.choose_drug("");  // of a lesson that takes any
    EXPECT_EQ(offered().second_phase, before.second_phase);
}

// In any units; the lesson need not name a drug.
TEST(InjectPanel, GivesTheFlowAndAllElseFromBeforeALessonBack) {
    for (const FlowUnits units : {FlowUnits::computed, FlowUnits::clinic}) {
        InjectPanel panel([](const Command&) {});
        panel.set_units(units);
        QDoubleSpinBox& flow = *panel.findChild<QDoubleSpinBox*>("flow");
        flow.setValue(units == FlowUnits::computed ? 3.5 : 120.0);
        const auto offered = [&] { return panel.injection_at(Vec3::Zero()); };
        const InjectDrug before = offered();
        const auto set_otherwise = [&] {
            panel.findChild<QComboBox*>("drug")->setCurrentIndex(2);
            flow.setValue(2.0 * flow.value());
            for (auto* spin : panel.findChildren<QDoubleSpinBox*>())
                if (spin->suffix().contains("mPa s")) spin->setValue(12.0);
            for (auto* choice : panel.findChildren<QComboBox*>())
                if (choice->findData("published") >= 0)
                    choice->setCurrentIndex(choice->findData("published"));
        };
        const auto expect_as_before = [&](const char* when) {
            EXPECT_EQ(to_json(Command(offered())), to_json(Command(before))) << when;
        };
        for (const char* drug : {"", "lipiodol"}) {
            panel.begin_play(false);
            panel.choose_drug("");
            set_otherwise();
            ASSERT_EQ(offered().pressure_model, "published");
            ASSERT_TRUE(offered().drug_viscosity_pa_s.has_value());
            panel.begin_play(false);  // looked back on
            panel.choose_drug(drug);  // the next one
            EXPECT_FALSE(offered().drug_viscosity_pa_s.has_value());
            if (*drug == 0) expect_as_before("in the next lesson");
            set_otherwise();
            panel.begin_play(true);
            expect_as_before("in free play");
        }
        set_otherwise();
        panel.begin_play(true);
        EXPECT_EQ(offered().pressure_model, "published") << "what was set in free play stays";
    }
}

DrugView injected_drug() {
    DrugView drug;
    drug.arrival_s = std::make_shared<const std::vector<float>>(3, 1.0f);
    drug.version = 1;
    drug.end_s = 10.0;
    return drug;
}

// A frame from before the user's choice must not pull the slider back.
TEST(InjectPanel, AnOlderFrameDoesNotUndoWhatTheSliderAskedFor) {
    std::vector<Command> posted;
    InjectPanel panel([&](Command command) { posted.push_back(std::move(command)); });
    QSlider& time = *panel.findChild<QSlider*>("drugTime");
    DrugView drug = injected_drug();
    drug.playing = true;
    drug.time_s = 2.0;
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 200);
    EXPECT_TRUE(posted.empty()) << "a frame is no choice";

    time.setValue(700);
    ASSERT_EQ(posted.size(), 2u);
    EXPECT_FALSE(std::get<PlayDrug>(posted[0]).playing);
    EXPECT_EQ(std::get<SetDrugTime>(posted[1]).time_s, 7.0);
    drug.time_s = 2.1;  // begun before
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 700);
    drug.playing = false;
    drug.time_s = 7.0;  // has heard of it
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 700);
    drug.time_s = 4.0;  // somebody else's choice
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 400);
    EXPECT_EQ(posted.size(), 2u);
}

// What was asked of a drug that is there no longer binds nobody.
TEST(InjectPanel, ANewInjectionIsFollowedFromItsBeginning) {
    InjectPanel panel([](const Command&) {});
    QSlider& time = *panel.findChild<QSlider*>("drugTime");
    DrugView drug = injected_drug();
    panel.show_drug(drug);
    time.setValue(700);
    ++drug.version;
    drug.time_s = 0.5;
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 50);
    time.setValue(300);
    panel.show_drug({});
    panel.show_drug(drug);
    EXPECT_EQ(time.value(), 50);
}

// A lesson has a speed of its own; what the user chose in free play outlasts it.
TEST(InjectPanel, ShowsTheSpeedOfTheSessionAndKeepsWhatWasChosenInFreePlay) {
    std::vector<Command> posted;
    InjectPanel panel([&](Command command) { posted.push_back(std::move(command)); });
    QDoubleSpinBox& speed = *panel.findChild<QDoubleSpinBox*>("speed");
    const QLabel& said = *panel.findChild<QLabel*>("drugPace");
    const auto show = [&panel](double factor) {
        DrugView drug;
        drug.speed = factor;
        panel.show_drug(drug);
    };
    const auto last_posted = [&posted] { return std::get<SetDrugSpeed>(posted.back()).factor; };
    speed.setValue(2.0);
    EXPECT_EQ(last_posted(), 2.0);
    show(1.0);  // begun before
    EXPECT_EQ(speed.value(), 2.0);
    EXPECT_TRUE(said.text().startsWith("2 s of the drug"));
    show(2.0);  // has heard of it
    panel.begin_play(false);
    show(4.0);
    EXPECT_EQ(speed.value(), 4.0);
    EXPECT_TRUE(said.text().startsWith("4 s of the drug")) << "else two clocks contradict";
    EXPECT_EQ(posted.size(), 1u) << "what is shown is no choice";
    speed.setValue(8.0);
    EXPECT_EQ(last_posted(), 8.0);
    show(4.0);
    EXPECT_EQ(speed.value(), 8.0);
    show(8.0);
    panel.begin_play(true);
    EXPECT_EQ(last_posted(), 2.0);
    show(1.0);
    EXPECT_EQ(speed.value(), 2.0);
    show(2.0);
    EXPECT_EQ(speed.value(), 2.0);
    EXPECT_EQ(posted.size(), 3u);
}

TEST(InjectPanel, TheSliderForgetsADrugThatWasRemoved) {
    std::vector<Command> posted;
    InjectPanel panel([&](Command command) { posted.push_back(std::move(command)); });
    QSlider& time = *panel.findChild<QSlider*>("drugTime");
    DrugView drug = injected_drug();
    drug.time_s = 4.0;
    panel.show_drug(drug);
    ASSERT_EQ(time.value(), 400);
    panel.show_drug(DrugView{});
    EXPECT_EQ(time.value(), 0);
    EXPECT_TRUE(posted.empty());
}

}  // namespace
}  // namespace hepatica
