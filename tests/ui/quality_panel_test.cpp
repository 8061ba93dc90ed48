// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quality_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <vector>

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
    EXPECT_TRUE(p.shows("Expected error 12 % against the built-in patient"));
    EXPECT_TRUE(p.shows("corotated, 4 substeps"));
}

TEST(QualityPanel, AHandAtTheDialEndsAutomaticAndAClickBringsItBack) {
    Panel p;
    FrameStatistics statistics;
    statistics.automatic = true;
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

}  // namespace
}  // namespace hepatica
