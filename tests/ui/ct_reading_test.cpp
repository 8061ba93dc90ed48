// SPDX-License-Identifier: GPL-3.0-or-later
// The CT of a case is read for the slices: with progress, to be cancelled, or asked for.
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "tests/ui/slices_test.h"

namespace hepatica {
namespace {

class CtReading : public testing::SlicesTest {};

TEST_F(CtReading, SaysWhatIsMissingWhereNobodyKnowsTheCt) {
    views().show_patient(patient_, {}, {});
    QTest::keyClick(&window_, Qt::Key_F7);
    auto* choose = window_.findChild<QPushButton*>("chooseCt");
    ASSERT_TRUE(testing::wait_for([&] { return choose->isVisible(); }));
    EXPECT_TRUE(scene().empty());
    EXPECT_TRUE(window_.view().isVisible()) << "the vessels stay";
}

// Of a large CT it takes several seconds.
TEST_F(CtReading, HasProgressAndCanBeCancelledAndBegunAgain) {
    views().show_patient(patient_, {}, file_);
    QTest::keyClick(&window_, Qt::Key_F7);
    auto* cancel = window_.findChild<QPushButton*>("cancelCt");
    ASSERT_TRUE(cancel->isVisible());
    EXPECT_TRUE(window_.findChild<QProgressBar*>("readingCt")->isVisible());
    cancel->click();
    EXPECT_FALSE(cancel->isVisible());
    EXPECT_TRUE(window_.findChild<QPushButton*>("chooseCt")->isVisible());
    const auto says_so = [this] {
        for (const QLabel* label :
             window_.findChild<QWidget*>("sliceNotice")->findChildren<QLabel*>())
            if (label->isVisible() && label->text().startsWith("The CT was not read")) return true;
        return false;
    };
    EXPECT_TRUE(says_so());
    EXPECT_TRUE(scene().empty());
    QTest::keyClick(&window_, Qt::Key_F7);
    QTest::keyClick(&window_, Qt::Key_F7);
    EXPECT_TRUE(cancel->isVisible());
    EXPECT_TRUE(testing::wait_for([this] { return !scene().empty(); }));
    EXPECT_FALSE(says_so());
}

// A bar that refuses the one before would stand over the reading of the next.
TEST_F(CtReading, TellsThatAnotherOneIsChosenBeforeItIsRead) {
    int told = 0;
    ViewLayout::Callbacks callbacks;
    callbacks.ask_for_ct = [this] { return std::optional(file_); };
    callbacks.crosshair = [](const std::optional<Vec3>&) {};
    callbacks.failed = [](const QString&, const Failure&) {};
    callbacks.other_ct = [&told] { ++told; };
    callbacks.tumours = [](const TriangleMesh&) {};
    callbacks.correction = [] { return QString(); };
    ViewLayout alone(new QWidget, settings_, callbacks);
    alone.show_patient(patient_, {}, {});
    alone.set_slices_visible(true);
    auto* choose = alone.findChild<QPushButton*>("chooseCt");
    ASSERT_TRUE(testing::wait_for([&] { return !choose->isHidden(); }));
    ASSERT_EQ(told, 0);
    choose->click();
    EXPECT_EQ(told, 1);
    EXPECT_TRUE(testing::wait_for([&] { return !alone.slices().empty(); }));
}

// It would be said anew every time, although nothing is read again.
TEST_F(CtReading, ThatFailedSaysWhyWhenTheSlicesAreShownAgain) {
    views().show_patient(patient_, {}, {});
    QTest::keyClick(&window_, Qt::Key_F7);
    auto* choose = window_.findChild<QPushButton*>("chooseCt");
    ASSERT_TRUE(testing::wait_for([&] { return choose->isVisible(); }));
    QTest::keyClick(&window_, Qt::Key_F7);
    QTest::keyClick(&window_, Qt::Key_F7);
    EXPECT_TRUE(choose->isVisible());
    EXPECT_FALSE(window_.findChild<QPushButton*>("cancelCt")->isVisible());
}

TEST_F(CtReading, IsNotBegunWithoutAPatient) {
    views().clear();
    QTest::keyClick(&window_, Qt::Key_F7);
    bool said = false;
    for (const QLabel* label : window_.findChildren<QLabel*>())
        said |= label->isVisible() && label->text().contains("Open a patient");
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace hepatica
