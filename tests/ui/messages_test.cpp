// SPDX-License-Identifier: GPL-3.0-or-later
// What the window tells its user, and what it remembers of files.
#include <QClipboard>
#include <QComboBox>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <filesystem>
#include <memory>

#include "tests/patient/parted_patient.h"
#include "tests/ui/fake_window_test.h"
#include "ui/branch_links.h"
#include "ui/elided_label.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/plain_text.h"
#include "ui/questions.h"
#include "ui/recent_menu.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

class Messages : public testing::FakeWindowTest {
  protected:
    RecentMenu& recent() { return *window_.findChild<RecentMenu*>(); }
};

TEST_F(Messages, a_divergence_offers_the_last_good_state_and_a_click_restores_it) {
    open_built_in();
    EXPECT_FALSE(window_.actions()[ActionId::restore].isEnabled());
    simulation_->diverge();
    auto* offer = window_.messages().findChild<QPushButton*>("offer");
    ASSERT_TRUE(testing::wait_for([&] { return offer->isVisible(); }));
    EXPECT_TRUE(window_.messages().text().contains("diverged"));
    EXPECT_TRUE(window_.actions()[ActionId::restore].isEnabled());
    EXPECT_TRUE(commands_of_type<RestoreSnapshot>().empty());
    QTest::mouseClick(offer, Qt::LeftButton);
    EXPECT_EQ(commands_of_type<RestoreSnapshot>().size(), 1u);
    EXPECT_TRUE(
        testing::wait_for([&] { return !window_.actions()[ActionId::restore].isEnabled(); }));
    EXPECT_EQ(window_.messages().text(), "");
}

// The exact words are for whoever knows the solver; they come again and again.
TEST_F(Messages, what_the_solver_says_is_told_plainly_and_kept_in_the_log_once) {
    open_built_in();
    const QString exact = "the step was shortened: it would have made energy";
    const auto say = [&](const QString& words) {
        simulation_->say_of_step(words.toStdString());
        wait_for_figures();
    };
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    paint();
    for (int time = 0; time < 2; ++time) {
        say(exact);
        const QString told = window_.statusBar()->currentMessage();
        EXPECT_TRUE(told.startsWith("Forces shown may be rough")) << told.toStdString();
        EXPECT_FALSE(told.contains("energy")) << told.toStdString();
        say("");
        EXPECT_EQ(window_.statusBar()->currentMessage(), told) << "it can be read";
    }
    EXPECT_EQ(window_.log().as_text().count(exact), 1);
    EXPECT_TRUE(window_.log().as_text().contains("\tNote\tSimulation\tForces shown were rough"))
        << "and no warning, which the foot of the window would count";
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk());
    // It stops nothing, also where the play is held just then.
    window_.actions()[ActionId::pause_simulation].trigger();
    ASSERT_TRUE(testing::wait_for([&] { return window_.frame().statistics.paused; }));
    say(exact);
    EXPECT_EQ(window_.messages().text(), "");
    open_built_in();
    say("");
    say(exact);
    EXPECT_EQ(window_.log().as_text().count(exact), 2) << "of another patient";
}

TEST_F(Messages, forces_are_called_rough_only_while_one_is_shown) {
    open_built_in();
    const QString words = "the step was shortened: it would have made energy";
    const auto say = [&](const QString& of_step) {
        simulation_->say_of_step(of_step.toStdString());
        wait_for_figures();
    };
    QTest::mousePress(&window_.view(), Qt::LeftButton, {}, on_trunk());
    paint();
    say(words);
    EXPECT_TRUE(window_.statusBar()->currentMessage().startsWith("Forces shown may be rough"));
    QTest::mouseRelease(&window_.view(), Qt::LeftButton, {}, on_trunk());
    wait_for_figures();
    EXPECT_EQ(window_.statusBar()->currentMessage(), "");
    say("");
    say(words);
    EXPECT_EQ(window_.statusBar()->currentMessage(), "") << "the vessel swings back by itself";
    EXPECT_EQ(window_.log().as_text().count(words), 1) << "which the log keeps";
}

TEST_F(Messages, a_text_shows_its_letters_as_they_are) {
    MessageBar& bar = window_.messages();
    const QString text = "File > Open <unsaved> & more";
    bar.show_notice(text);
    EXPECT_EQ(bar.text(), text);
    // A label that guesses would show the escapes of a text in which no tag stands.
    EXPECT_EQ(bar.findChild<QLabel*>()->textFormat(), Qt::RichText);
}

TEST_F(Messages, a_failure_begins_with_a_capital) {
    MessageBar& bar = window_.messages();
    bar.show_failure({"äther is no drug", "the list", "Choose another"});
    EXPECT_TRUE(bar.text().startsWith("Äther is no drug")) << bar.text().toStdString();
    bar.show_failure({"", "", ""});
    EXPECT_EQ(bar.text(), "");
}

// Whatever is said, it hides one line of the pictures until somebody wants to read it all.
TEST_F(Messages, a_long_one_takes_one_line_until_it_is_opened) {
    open_built_in();
    MessageBar& bar = window_.messages();
    bar.show_notice("short");
    QCoreApplication::processEvents();
    const int low = bar.height();
    EXPECT_LE(low, 44);
    auto* more = bar.findChild<QToolButton*>("moreOfMessage");
    EXPECT_FALSE(more->isVisible());
    const QString text = QString("a long sentence about vessels ").repeated(12).trimmed();
    bar.show_notice(text + "\n" + text, "Do it", [] {});
    QCoreApplication::processEvents();
    EXPECT_LE(bar.height(), 44);
    EXPECT_TRUE(more->isVisible());
    EXPECT_EQ(bar.text(), text + "\n" + text);
    QTest::mouseClick(more, Qt::LeftButton);
    QCoreApplication::processEvents();
    EXPECT_TRUE(bar.open());
    EXPECT_GT(bar.height(), 2 * low);
    // Whoever acts on the vessels sees them again.
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {},
                      QPoint(20, window_.view().height() - 20));
    EXPECT_FALSE(bar.open());
    EXPECT_LE(bar.height(), 44);
    QTest::mouseClick(more, Qt::LeftButton);
    EXPECT_TRUE(bar.open());
    QTest::mouseClick(more, Qt::LeftButton);
    QCoreApplication::processEvents();
    EXPECT_LE(bar.height(), 44);
    bar.show_failure({"this is <no> image", "/some/where", "Give a CT"});
    QCoreApplication::processEvents();
    EXPECT_LE(bar.height(), 44);
    EXPECT_EQ(bar.text(), "This is <no> image\nin /some/where\nGive a CT");
    EXPECT_TRUE(bar.findChild<QLabel*>()->text().contains("&lt;no&gt;"));
}

TEST_F(Messages, name_a_file_once_and_whole) {
    MessageBar& bar = window_.messages();
    const QString path = "/a/" + QString("folder/").repeated(30) + "liver.nii";
    bar.show_failure({path.toStdString() + " is no image", path.toStdString(), "Give a CT"});
    EXPECT_EQ(bar.text().count(path), 1) << bar.text().toStdString();
    EXPECT_TRUE(bar.findChild<QLabel*>()->toolTip().contains(path));
    window_.log().add_failure(
        "Opening", {path.toStdString() + " is no image", path.toStdString(), "Give a CT"});
    EXPECT_EQ(window_.log().as_text().count(path), 1);
}

TEST_F(Messages, lead_to_the_branch_that_they_name) {
    open_built_in();
    MessageBar& bar = window_.messages();
    bar.show_notice("Branch 2 is an end and takes 60 % of the flow of its tree");
    auto* label = bar.findChild<QLabel*>();
    EXPECT_TRUE(label->text().contains("<a href=\"branch:2\" ")) << label->text().toStdString();
    emit label->linkActivated("branch:2");
    auto* table = window_.findChild<QTableWidget*>("branches");
    ASSERT_TRUE(testing::wait_for([table] { return table->currentRow() >= 0; }));
    EXPECT_TRUE(table->isVisible());
    EXPECT_EQ(table->item(table->currentRow(), 0)->text(), "2");
    // A short one would hardly be seen by its light alone.
    ASSERT_EQ(window_.view().scene().marks().size(), 1u);
    EXPECT_FALSE(window_.view().scene().marks()[0].of_lesson);
    window_.log().add_warning("A", "Branch 1 is an end");
    auto* list = window_.log().findChild<QTreeWidget*>();
    emit list->itemActivated(list->topLevelItem(0), 0);
    EXPECT_EQ(table->item(table->currentRow(), 0)->text(), "1");
    window_.log().add_warning("A", "Branch 2 is one, too");
    window_.log().add_warning("A", "The slices are thick");
    auto* show = window_.log().findChild<QPushButton*>("logShowBranch");
    list->setCurrentItem(list->topLevelItem(2));
    EXPECT_FALSE(show->isEnabled()) << "it names none";
    list->setCurrentItem(list->topLevelItem(1));
    window_.log().show();
    show->click();
    EXPECT_EQ(table->item(table->currentRow(), 0)->text(), "2");
    EXPECT_FALSE(window_.log().isVisible()) << "it would lie over the branch";
    window_.log().settle_warning("Branch 2 is one, too");
    EXPECT_FALSE(show->isEnabled()) << "another branch may have its number now";
    emit label->linkActivated("branch:999");  // of a patient before
    window_.actions()[ActionId::toggle_branches].trigger();
    EXPECT_FALSE(table->isVisible());
    EXPECT_TRUE(window_.view().scene().marks().empty());
    EXPECT_FALSE(window_.view().scene().legend().branch_line);
}

// Also one that was written before the theme was chosen.
TEST_F(Messages, have_links_in_the_colour_of_the_theme) {
    MessageBar& bar = window_.messages();
    bar.show_notice("Branch 2 is an end and takes 60 % of the flow of its tree");
    const auto pixels_of_link = [&] {
        const QImage picture = bar.grab().toImage();
        const QRgb link = QGuiApplication::palette().color(QPalette::Link).rgb();
        int found = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) found += picture.pixel(x, y) == link;
        return found;
    };
    for (const ActionId theme :
         {ActionId::theme_high_contrast, ActionId::theme_light, ActionId::theme_dark}) {
        window_.actions()[theme].trigger();
        QCoreApplication::processEvents();
        EXPECT_GT(pixels_of_link(), 20) << window_.actions()[theme].text().toStdString();
    }
}

// Of a file or a lesson, say.
TEST_F(Messages, show_names_that_look_like_html_as_they_are) {
    EXPECT_EQ(as_plain("a & b < c"), "a & b < c");
    EXPECT_EQ(as_plain("<b>a</b>\nc"), "<span>&lt;b&gt;a&lt;/b&gt;<br>c</span>");
    MessageLog log;
    log.add_warning("Open", "<img src=x>.hep cannot be read");
    const QTreeWidgetItem& row = *log.findChild<QTreeWidget*>()->topLevelItem(0);
    EXPECT_EQ(row.text(3), "<img src=x>.hep cannot be read");
    EXPECT_EQ(row.toolTip(3), "<span>&lt;img src=x&gt;.hep cannot be read</span>");
    tell_failure(window_, "Open", {"<b>x</b> is no case", "", "Choose <i>y</i>"});
    auto* box = window_.findChild<QMessageBox*>();
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->text(), "<span>&lt;b&gt;x&lt;/b&gt; is no case</span>");
    EXPECT_EQ(box->informativeText(), "<span>Choose &lt;i&gt;y&lt;/i&gt;</span>");
    box->close();
}

TEST(BranchLinks, LeaveACutNumberAlone) {
    EXPECT_EQ(with_branch_links("Branch 16… of", Qt::red), "Branch 16… of");
    EXPECT_EQ(with_branch_links("Ast 3, Wurzel: Ast 1", Qt::red),
              "<a href=\"branch:3\" style=\"color:#ff0000\">Ast 3</a>, Wurzel: "
              "<a href=\"branch:1\" style=\"color:#ff0000\">Ast 1</a>");
    EXPECT_EQ(branch_named_in("root: branch 7"), 6);
    EXPECT_EQ(branch_named_in("7 branches"), std::nullopt);
    EXPECT_EQ(branch_of_link("https://x"), std::nullopt);
}

TEST_F(Messages, long_lines_of_the_log_wrap) {
    MessageLog& log = window_.log();
    log.add_warning("A", "short");
    log.add_warning("A", QString("a long sentence about vessels ").repeated(20));
    log.show();
    auto& list = *log.findChild<QTreeWidget*>();
    const auto high = [&](int row) { return list.visualItemRect(list.topLevelItem(row)).height(); };
    EXPECT_TRUE(testing::wait_for([&] { return high(1) >= 4 * high(0); }));
}

TEST_F(Messages, a_failure_stays_in_the_log_after_the_next_job) {
    window_.open(folder_.filePath("no_image.nii"));
    ASSERT_TRUE(testing::wait_for([&] { return !window_.busy(); }));
    ASSERT_NE(window_.messages().text(), "");
    open_built_in();
    EXPECT_EQ(window_.messages().text(), "");
    const QString log = window_.log().as_text();
    EXPECT_EQ(log.count('\n'), 1) << log.toStdString();
    for (const char* part : {"\tFailure\tOpening no_image.nii\t", "this is no image", "give a CT"})
        EXPECT_TRUE(log.contains(part)) << log.toStdString();
    window_.actions()[ActionId::messages].trigger();
    EXPECT_TRUE(window_.log().isVisible());
    for (QPushButton* button : window_.log().findChildren<QPushButton*>())
        if (button->text() == "Copy all") button->click();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), log);
}

TEST_F(Messages, a_recent_file_that_is_gone_is_marked_and_leaves_the_list_with_a_word) {
    const QString here = folder_.filePath("endless"), gone = folder_.filePath("gone & lost.hep");
    std::filesystem::create_directory(here.toStdString());
    settings_.add_recent_file(here);
    settings_.add_recent_file(gone);
    recent().fill();
    EXPECT_FALSE(recent().actions()[1]->text().contains("missing"));
    QAction* missing = recent().actions()[0];
    EXPECT_TRUE(missing->text().contains("missing"));
    missing->trigger();
    EXPECT_EQ(settings_.recent_files(), QStringList{here});
    EXPECT_TRUE(window_.messages().text().contains(gone))
        << window_.messages().text().toStdString();
    EXPECT_FALSE(window_.busy());
    recent().fill();
    recent().actions()[0]->trigger();
    EXPECT_TRUE(window_.busy());
}

TEST_F(Messages, recent_files_are_absolute_whatever_was_given) {
    settings_.add_recent_file("p.hep");
    EXPECT_EQ(settings_.recent_files(), QStringList{QDir::current().absoluteFilePath("p.hep")});
    settings_.add_recent_file("./x/../p.hep");
    EXPECT_EQ(settings_.recent_files().size(), 1);
}

// As at the start, where unsaved work is offered before the window is seen.
TEST(ElidedLabel, LeavesOutTheMiddleAndNeverWidensItsWindow) {
    ElidedLabel label(Qt::ElideMiddle, nullptr);
    const QString text = "Opening a_name_of_a_patient_that_is_far_too_long_for_the_strip.nii.gz";
    label.setText(text);
    label.resize(label.sizeHint());
    EXPECT_EQ(label.shown(), text);
    label.resize(220, label.height());
    EXPECT_LT(label.shown().size(), text.size());
    EXPECT_TRUE(label.shown().startsWith("Opening ")) << label.shown().toStdString();
    EXPECT_TRUE(label.shown().endsWith(".nii.gz")) << label.shown().toStdString();
    EXPECT_LE(label.fontMetrics().horizontalAdvance(label.shown()), 220);
    EXPECT_LT(label.minimumSizeHint().width(), 10);
}

TEST(MessageBar, WhatWasSaidBeforeItIsSeenCanBeRead) {
    QWidget pictures;
    MessageBar bar(&pictures);
    bar.show_notice(QString("The program ended without saving. ").repeated(8), "Open it", [] {});
    pictures.resize(900, 400);
    pictures.show();
    const auto* label = bar.findChild<QLabel*>();
    EXPECT_TRUE(testing::wait_for([&] { return label->text().contains("The program ended"); }));
}

TEST(MessageBar, OffersANameAsItIs) {
    QWidget pictures;
    MessageBar bar(&pictures);
    bar.show_notice("Before it, it was A & B.hep.", "Open A & B.hep", [] {});
    EXPECT_EQ(bar.findChild<QPushButton*>("offer")->text(), "Open A && B.hep")
        << "else the letter behind it would be a key";
}

// As an action with a modal dialog does, during which anything may be said.
TEST(MessageBar, AnActionStaysWholeWhileTheNextNoticeIsShown) {
    QWidget pictures;
    MessageBar bar(&pictures);
    auto held = std::make_shared<int>();
    const std::weak_ptr<int> watched = held;
    bool acted = false, whole = false;
    bar.show_notice("Lost", "Open it", [&, held = std::move(held)] {
        // Nothing that the action holds may be read after the notice, where it may be gone.
        const std::weak_ptr<int>& still_there = watched;
        bool& to_acted = acted;
        bool& to_whole = whole;
        bar.show_notice("Next", "Do it", [] {});
        to_acted = true;
        to_whole = !still_there.expired();
    });
    bar.findChild<QPushButton*>("offer")->click();
    EXPECT_TRUE(acted);
    EXPECT_TRUE(whole);
    EXPECT_EQ(bar.text(), "Next");
}

// A patient who was opened with a warning of his CT and one of his vessels, cut into two.
class StandingWarnings : public testing::WindowTest {
  protected:
    StandingWarnings()
        : WindowTest(
              {[](const OpenRequest&, Job& job) {
                   LoadedPatient loaded =
                       play(std::make_shared<const PatientCase>(test::patient_with_bridges()), job);
                   loaded.warnings = {of_vessels, of_image};
                   return loaded;
               },
               [](const std::filesystem::path&, const PatientCase&) {},
               [](std::shared_ptr<const PatientCase> patient, Job& job) {
                   return play(std::move(patient), job);
               }}) {
        open_built_in();
    }
    void bridge_the_gap() {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(test::last_gap[1]));
        wait();
        ASSERT_EQ(window_.workspace().edits().size(), 1u);
    }
    static constexpr const char* of_image = "The slices are 5.0 mm thick: thin vessels are missing";
    static constexpr const char* of_vessels = "2 pieces of vessels were left out of the tree";
};

TEST_F(StandingWarnings, StayAboveTheViewThroughACorrection) {
    ASSERT_TRUE(window_.messages().text().contains(of_image));
    bridge_the_gap();
    EXPECT_TRUE(window_.messages().text().contains(of_image))
        << window_.messages().text().toStdString();
    EXPECT_TRUE(window_.messages().text().contains(of_vessels));
    EXPECT_EQ(window_.log().as_text().count(of_image), 1) << "it is told once";
}

// Else what holds cannot be told from what was mended, or was said of another patient.
TEST_F(StandingWarnings, ThatHoldNoLongerAreMarkedInTheLog) {
    const auto marked = [this] { return window_.log().as_text().count("no longer so"); };
    bridge_the_gap();
    EXPECT_EQ(marked(), 0) << "both stand";
    open_built_in();
    EXPECT_EQ(window_.log().as_text().count(of_image), 2);
    EXPECT_EQ(marked(), 2) << window_.log().as_text().toStdString();
}

// A joined message of several lines is one row for each, which ends on its own.
TEST(MessageLog, MarksAWarningAsPastOnceItHoldsNoLonger) {
    MessageLog log;
    bool holds = true;
    log.add_warning("Corrections", "A loop is left", [&holds] { return holds; });
    log.add_warning("Corrections", "A stroke lies outside", [] { return true; });
    log.add_warning("Measure", "A diameter is gone");
    log.settle();
    EXPECT_EQ(log.as_text().count("no longer so"), 0);
    holds = false;
    log.settle();
    log.settle();
    EXPECT_EQ(log.as_text().count("no longer so"), 1);
    EXPECT_TRUE(log.as_text().contains("no longer so\tCorrections\tA loop is left"));
}

// As by Redo after Undo.
TEST(MessageLog, AWarningThatHoldsAgainIsMarkedAsPastNoLonger) {
    MessageLog log;
    bool holds = true;
    log.add_warning("Corrections", "A loop is left", [&holds] { return holds; });
    log.add_warning("Corrections", "Branch 1 is an end", [] { return true; });
    log.settle_warning("Branch 1 is an end");
    for (const bool now : {false, true}) {
        holds = now;
        log.settle();
        EXPECT_EQ(log.as_text().contains("no longer so\tCorrections\tA loop is left"), !now);
    }
    EXPECT_TRUE(log.as_text().contains("no longer so\tCorrections\tBranch 1")) << "for good";
    // Said once more it is one message that stands, not two.
    holds = false;
    log.settle();
    holds = true;
    log.add_warning("Corrections", "A loop is left", [&holds] { return holds; });
    log.settle();
    EXPECT_EQ(log.as_text().count("no longer so\tCorrections\tA loop is left"), 1);
}

TEST_F(StandingWarnings, AreJoinedByWhatACorrectionMakesDoubtful) {
    window_.actions()[ActionId::edit_mode].trigger();
    auto* tools = window_.findChild<QComboBox*>("EditTool");
    tools->setCurrentIndex(tools->findText("Link two vessels"));
    for (const Vec3& place : {Vec3(0.05, 10, 1.5), Vec3(-8.6, 28, 4.4)}) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(place));
        wait();
    }
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    const QString both = window_.messages().text();
    EXPECT_TRUE(both.contains("1 loop is left")) << both.toStdString();
    EXPECT_EQ(both.count("1 loop is left"), 1) << both.toStdString();
    // It joins what was said of the link itself, which took the place of older warnings.
    EXPECT_TRUE(both.contains("The link leads over")) << both.toStdString();
    EXPECT_EQ(window_.log().as_text().count("1 loop is left"), 1) << "it is told once";
}

// Of what both say the window is told once, and can be read at once.
TEST_F(StandingWarnings, StandBesideTheNoticeOfADiameterThatIsLost) {
    QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(Vec3(37, 54.5, 4)));
    Measurements& measurements = window_.view_layout().slices().measurements();
    ASSERT_EQ(measurements.made().size(), 1u);
    ASSERT_TRUE(window_.messages().text().contains(of_image));
    window_.actions()[ActionId::edit_mode].trigger();
    auto* tools = window_.findChild<QComboBox*>("EditTool");
    tools->setCurrentIndex(tools->findText("Delete a whole tree"));
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(Vec3(37, 54.5, 4)));
    wait();
    ASSERT_TRUE(measurements.made().empty()) << "its vessel is gone";
    const QString both = window_.messages().text();
    for (const char* part : {"1 diameter", of_image, of_vessels})
        EXPECT_EQ(both.count(part), 1) << part << " in " << both.toStdString();
    EXPECT_TRUE(window_.messages().findChild<QPushButton*>("offer")->isVisible());
    // The warnings go on standing; that of the diameter is of the correction that took it.
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    ASSERT_EQ(measurements.made().size(), 1u);
    EXPECT_TRUE(window_.messages().text().contains(of_image));
    EXPECT_FALSE(window_.messages().text().contains("diameter"));
}

TEST_F(StandingWarnings, CanBeReadAgainAfterTheyWereClosed) {
    auto* button = window_.findChild<QToolButton*>("warnings");
    ASSERT_NE(button, nullptr);
    EXPECT_EQ(button->text(), "2 warnings");
    window_.messages().dismiss();
    bridge_the_gap();
    EXPECT_EQ(window_.messages().text(), "") << "they were read";
    EXPECT_EQ(button->text(), "2 warnings");
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(window_.messages().text().contains(of_image));
}

}  // namespace
}  // namespace hepatica
