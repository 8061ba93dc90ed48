// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quality_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QTest>
#include <algorithm>
#include <string>
#include <vector>

#include "core/scene/measured_dial.h"
#include "core/scene/scene_spec.h"

namespace hepatica {
namespace {

struct Panel {
    std::vector<Command> posted;
    QualityPanel panel{[this](Command command) { posted.push_back(std::move(command)); }};
    QSlider& dial = *panel.findChild<QSlider*>();
    QCheckBox& automatic = *panel.findChild<QCheckBox*>("automatic");

    bool shows(const QString& words) const {
        for (const QLabel* label : panel.findChildren<QLabel*>())
            if (label->text().contains(words)) return true;
        return false;
    }
    bool explains(const QString& words) const {
        return std::ranges::any_of(panel.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->toolTip().contains(words);
        });
    }
};

TEST(QualityPanel, FollowsTheSettingThatTheSessionPicked) {
    Panel p;
    FrameStatistics statistics;
    statistics.automatic = true;
    statistics.quality = 0.8;
    statistics.setting = "corotated, 4 substeps";
    statistics.expected_error = 0.12;
    statistics.error_reference = "the built-in patient";
    p.panel.show_statistics(statistics);
    EXPECT_TRUE(p.automatic.isChecked());
    EXPECT_EQ(p.dial.value(), 80);
    EXPECT_TRUE(p.posted.empty());
    EXPECT_TRUE(p.shows("Expected error 12 % of the motion"));
    EXPECT_FALSE(p.shows("corotated")) << "that is for who looks closer";
    EXPECT_TRUE(p.explains("corotated, 4 substeps"));
    EXPECT_TRUE(p.explains("It is: the built-in patient"));
}

TEST(QualityPanel, SaysWhatWasSimplified) {
    Panel p;
    FrameStatistics statistics;
    statistics.setting = "corotated";
    p.panel.show_statistics(statistics);
    EXPECT_FALSE(p.shows("simplified"));
    statistics.degraded = true;
    p.panel.show_statistics(statistics);
    EXPECT_TRUE(p.shows("Each step is solved directly; the last step was simplified"));
}

// Now and then one is, while a vessel is torn; all below the sentence jumped and was squashed.
TEST(QualityPanel, StaysInItsPlaceWhileStepsAreSimplified) {
    Panel p;
    QScrollArea scroll;
    scroll.setWidgetResizable(true);
    scroll.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll.setWidget(&p.panel);
    scroll.resize(320, 350);
    scroll.show();
    FrameStatistics statistics;
    statistics.setting = "corotated, 4 substeps";
    p.panel.show_statistics(statistics);
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&scroll));
    constexpr int more_than_layouts_within_each_other = 10;
    for (int i = 0; i < more_than_layouts_within_each_other; ++i) QCoreApplication::processEvents();
    auto* computed_by = p.panel.findChild<QComboBox*>("back_end");
    const auto place = [&] {
        return QRect(computed_by->mapTo(&p.panel, QPoint()), computed_by->size());
    };
    const QRect before = place();
    EXPECT_GE(before.height(), computed_by->minimumSizeHint().height());
    statistics.degraded = true;
    p.panel.show_statistics(statistics);
    const auto* solver = p.panel.findChild<QLabel*>("quiet");
    EXPECT_GT(solver->fontMetrics().horizontalAdvance(solver->text()), solver->width());
    for (int i = 0; i < more_than_layouts_within_each_other; ++i) {
        QCoreApplication::processEvents();
        EXPECT_EQ(place(), before) << i;
    }
    scroll.takeWidget();
}

// Errors of two bodies are no one scale: the figure of a synthetic patient says nothing of this
// one.
TEST(QualityPanel, ShowsNoErrorThatWasMeasuredOnAnotherBody) {
    Panel p;
    FrameStatistics statistics;
    statistics.setting = "corotated";
    const QualityDial dial = built_in_dial(4616);
    statistics.expected_error = dial.front()[0].error_relative;
    statistics.error_reference = dial.front()[0].reference;
    p.panel.show_statistics(statistics);
    EXPECT_FALSE(p.shows("2.1 %"));
    EXPECT_TRUE(p.shows("not measured on these vessels yet"));
}

TEST(QualityPanel, AHandAtTheDialEndsAutomaticAndAClickBringsItBack) {
    Panel p;
    FrameStatistics statistics;
    statistics.automatic = true;
    statistics.setting = "corotated";
    p.panel.show_statistics(statistics);
    p.dial.setValue(30);
    ASSERT_EQ(p.posted.size(), 1u);
    EXPECT_EQ(std::get<SetQuality>(p.posted[0]).quality, 0.3);
    EXPECT_FALSE(p.automatic.isChecked());
    p.automatic.click();
    ASSERT_EQ(p.posted.size(), 2u);
    EXPECT_TRUE(std::get<SetAutomaticQuality>(p.posted[1]).automatic);
    p.automatic.click();
    ASSERT_EQ(p.posted.size(), 3u);
    EXPECT_EQ(std::get<SetQuality>(p.posted[2]).quality, 0.3);
}

// Frames reach the panel late: what they say of the choice may be from before it.
TEST(QualityPanel, AFrameFromBeforeTheChoiceDoesNotUndoIt) {
    Panel p;
    FrameStatistics statistics;
    statistics.setting = "corotated";
    statistics.quality = 0.5;
    p.panel.show_statistics(statistics);  // the session's first frame, before its first step
    EXPECT_TRUE(p.automatic.isChecked());
    statistics.automatic = true;
    p.panel.show_statistics(statistics);
    p.dial.setValue(30);
    statistics.quality = 0.9;
    p.panel.show_statistics(statistics);
    EXPECT_FALSE(p.automatic.isChecked());
    EXPECT_EQ(p.dial.value(), 30);
    p.automatic.click();
    statistics.automatic = false;
    statistics.quality = 0.3;
    p.panel.show_statistics(statistics);
    EXPECT_TRUE(p.automatic.isChecked());
    EXPECT_EQ(p.posted.size(), 2u);
}

TEST(QualityPanel, TheWallIsSolidUntilAThicknessIsGiven) {
    Panel p;
    auto& wall = *p.panel.findChild<QDoubleSpinBox*>("wall");
    EXPECT_EQ(wall.text(), "solid");
    wall.setValue(0.6);
    ASSERT_EQ(p.posted.size(), 1u);
    EXPECT_EQ(std::get<SetWall>(p.posted[0]).wall_mm, 0.6);
    wall.setValue(1e6);
    EXPECT_EQ(std::get<SetWall>(p.posted[1]).wall_mm, thickest_wall_mm);
    wall.setValue(0.0);
    EXPECT_EQ(std::get<SetWall>(p.posted[2]).wall_mm, 0.0);
}

TEST(QualityPanel, TellsANewSimulationWhatTheUserHadChosen) {
    Panel p;
    p.panel.show_statistics({});  // nothing is played yet: that is no choice
    p.panel.post_choices();
    EXPECT_TRUE(p.posted.empty()) << "automatic, tissue and no gravity are how a session begins";
    p.dial.setValue(30);
    for (QCheckBox* box : p.panel.findChildren<QCheckBox*>())
        if (box != &p.automatic) box->click();
    p.posted.clear();
    p.panel.post_choices();
    ASSERT_EQ(p.posted.size(), 3u);
    EXPECT_EQ(std::get<SetQuality>(p.posted[0]).quality, 0.3);
    EXPECT_GT(std::get<SetGravity>(p.posted[1]).gravity_mm_per_s2.norm(), 9000.0);
    EXPECT_EQ(std::get<SetTether>(p.posted[2]).pa_per_mm2, 0.0);
}

TEST(QualityPanel, SaysWhatMakesTheStepsAndLetsTheUserChoose) {
    Panel p;
    std::vector<std::string> chosen;
    p.panel.on_back_end = [&](const std::string& name) { chosen.push_back(name); };
    auto& box = *p.panel.findChild<QComboBox*>("back_end");
    const QLabel& device = *p.panel.findChild<QLabel*>("device");
    EXPECT_EQ(box.currentData().toString(), "cpu");
    EXPECT_EQ(box.count(), 3) << "nobody asked for the emulated device";
    p.panel.show_back_end("cuda-emulated");
    EXPECT_EQ(box.count(), 4);
    EXPECT_EQ(box.currentText(), "CUDA device, emulated");
    p.panel.show_back_end("auto");
    EXPECT_EQ(box.currentText(), "CUDA, else processor");
    EXPECT_TRUE(chosen.empty());

    FrameStatistics statistics;
    p.panel.show_statistics(statistics);
    EXPECT_EQ(device.text(), "") << "nothing moves in this scene";
    const QWidget& heading = *p.panel.findChild<QWidget*>("deviceHeading");
    EXPECT_TRUE(heading.isHidden()) << "of nothing";
    statistics.setting = "corotated";
    p.panel.show_statistics(statistics);
    EXPECT_EQ(device.text(), "the processor");
    EXPECT_FALSE(heading.isHidden());
    EXPECT_FALSE(device.isHidden());
    statistics.device = "NVIDIA H200";
    p.panel.show_statistics(statistics);
    EXPECT_EQ(device.text(), "NVIDIA H200");
    EXPECT_EQ(box.currentData().toString(), "auto") << "a frame changes figures, never a choice";

    QTest::keyClick(&box, Qt::Key_Up);
    EXPECT_EQ(chosen, std::vector<std::string>{"cuda"});
}

}  // namespace
}  // namespace hepatica
