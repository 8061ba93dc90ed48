// SPDX-License-Identifier: GPL-3.0-or-later
// Correcting a patient's tree in the window, as a person does.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <algorithm>
#include <fstream>

#include "tests/patient/parted_patient.h"
#include "tests/support/tube_ct.h"
#include "tests/ui/editing_window.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"
#include "ui/paths.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

class Editing : public testing::EditingWindow {};

TEST_F(Editing, a_click_on_a_dashed_line_bridges_the_gap_and_can_be_undone) {
    ASSERT_EQ(roots(saved().tree).size(), 2u);
    const Vec3 middle = test::last_gap[1];
    ASSERT_GE(window_.view().scene().bridge_at(
                  pixel_at(on_widget(middle), window_.view().devicePixelRatioF()), 6.0),
              0);
    click(middle);
    EXPECT_EQ(window_.messages().text(), "");
    EXPECT_EQ(roots(saved().tree).size(), 1u);
    EXPECT_GT(bridged_length_mm(saved_.tree), 5.0);
    EXPECT_EQ(saved_.corrections.edits.size(), 1u);
    EXPECT_FALSE(window_.isWindowModified());  // it has just been saved
    QAction& undo = window_.actions()[ActionId::undo_edit];
    QAction& redo = window_.actions()[ActionId::redo_edit];
    EXPECT_TRUE(undo.text().startsWith("&Undo: Gap bridged at")) << undo.text().toStdString();
    EXPECT_EQ(redo.text(), "Red&o");
    EXPECT_TRUE(redo.shortcuts().contains(QKeySequence("Ctrl+Y")));
    EXPECT_TRUE(redo.shortcuts().contains(QKeySequence("Ctrl+Shift+Z")));
    EXPECT_FALSE(redo.isEnabled());
    undo.trigger();
    wait();
    EXPECT_EQ(undo.text(), "&Undo");
    EXPECT_FALSE(undo.isEnabled());
    EXPECT_TRUE(redo.text().startsWith("Red&o: Gap bridged at")) << redo.text().toStdString();
    EXPECT_TRUE(window_.isWindowModified());
    EXPECT_EQ(roots(saved().tree).size(), 2u);
    EXPECT_TRUE(saved_.corrections.edits.empty());
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    EXPECT_EQ(roots(saved().tree).size(), 1u);
}

// A link by hand makes the tree's bridges longer; what the reconstruction bridged stays as it was.
TEST_F(Editing, gaps_of_the_reconstruction_are_told_without_links_by_hand) {
    PatientCase patient = test::patient_with_bridges();
    patient.corrections.bridges[1].built = true;
    write_case(to_path(folder_.filePath("built.hep")), patient);
    window_.open(folder_.filePath("built.hep"));
    wait();
    child<QSlider>("bridgeConfidence").setValue(20);
    take_all();
    ASSERT_GT(bridged_length_mm(window_.workspace().patient()->tree), 5.0);
    QString told;
    for (const auto* label : window_.findChildren<QLabel*>())
        if (label->text().contains("by the reconstruction")) told = label->text();
    EXPECT_TRUE(told.contains("1 gap was bridged by the reconstruction, 8.0 mm in all."))
        << told.toStdString();
}

// The slider shows fewer gaps and the button bridges those that are shown.
TEST_F(Editing, gaps_are_shown_and_bridged_by_their_confidence) {
    const auto shown = [this] {
        int lines = 0;
        for (const auto* list : window_.findChildren<QListWidget*>())
            if (list->accessibleName() == "Gaps and doubtful branches" && list->isEnabled())
                lines = list->count();
        return lines;
    };
    const std::vector<Bridge> offered = open_bridges(*window_.workspace().patient());
    ASSERT_GT(offered.size(), 0u);
    EXPECT_EQ(shown(), static_cast<int>(offered.size()));
    auto& slider = child<QSlider>("bridgeConfidence");
    slider.setValue(100);
    EXPECT_EQ(shown(), std::ranges::count_if(
                           offered, [](const Bridge& bridge) { return bridge.confidence >= 1.0; }));
    slider.setValue(static_cast<int>(std::floor(100.0 * offered.back().confidence)));
    EXPECT_EQ(shown(), static_cast<int>(offered.size()));
    take_all();
    EXPECT_TRUE(open_bridges(*window_.workspace().patient()).empty());
    Job job;
    EXPECT_EQ(saved().corrections.edits.size(),
              acceptances(test::patient_with_bridges(), 0.0, job).size());
}

// Else a click on a vessel would only pull it, without a word.
TEST_F(Editing, whoever_chooses_what_a_click_corrects_is_in_edit_mode) {
    QAction& edit = window_.actions()[ActionId::edit_mode];
    ASSERT_FALSE(edit.isChecked());
    choose_tool("Delete a branch");
    EXPECT_FALSE(edit.isChecked()) << "set by the program";
    emit child<QComboBox>("EditTool").activated(1);
    EXPECT_TRUE(edit.isChecked());
}

TEST_F(Editing, a_click_in_edit_mode_does_what_the_panel_says) {
    const std::size_t before = saved().tree.segments.size();
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a branch");
    click(Vec3(-8.6, 28, 4.4));                           // the left branch
    EXPECT_EQ(saved().tree.segments.size(), before - 2);  // the trunk goes on into the right one
    choose_tool("Set a branch's system");
    child<QComboBox>("EditSystem").setCurrentText("hepatic veins");
    click(Vec3(37, 54.5, 4));  // the vessel apart
    ASSERT_EQ(saved().corrections.edits.size(), 2u);
    EXPECT_EQ(saved_.corrections.edits[1].kind, TreeEditKind::reassign_system);
    EXPECT_EQ(saved_.corrections.edits[1].system, VascularSystem::hepatic);
    // A place beside every vessel is no place.
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, QPoint(5, 5));
    EXPECT_TRUE(window_.statusBar()->currentMessage().startsWith("No vessel there: click"));
    wait();
    EXPECT_EQ(saved().corrections.edits.size(), 2u);
}

TEST_F(Editing, a_root_on_a_twig_is_warned_of_as_long_as_it_is_there) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Set the root");
    click(Vec3(-11, 30.1, 4.85));  // the end of a branch of 2.1 mm, on a trunk of 4
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_TRUE(window_.messages().text().contains("set the root there"))
        << window_.messages().text().toStdString();
    const auto says_so = [this] {
        for (const auto* label : window_.findChildren<QLabel*>())
            if (label->text().startsWith("⚠") && label->text().contains("root")) return true;
        return false;
    };
    EXPECT_TRUE(says_so()) << "in the panel";
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_FALSE(says_so());
}

TEST_F(Editing, a_link_that_closes_a_loop_is_warned_of_and_one_loop_less_is_not) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Link two vessels");
    click(Vec3(0.05, 10, 1.5));
    click(Vec3(-8.6, 28, 4.4));
    ASSERT_EQ(saved().corrections.edits.size(), 1u) << window_.messages().text().toStdString();
    EXPECT_TRUE(window_.messages().text().contains("1 loop is left"))
        << window_.messages().text().toStdString();
    click(Vec3(0.02, 4, 0.6));
    click(Vec3(-8.6, 28, 4.4));
    EXPECT_TRUE(window_.messages().text().contains("2 loops are left"));
    window_.messages().dismiss();
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_EQ(window_.messages().text(), "");
}

// Across the whole liver; the body that shows it takes half a minute on a real patient.
TEST_F(Editing, a_link_that_may_be_a_mistake_is_warned_of_at_once_and_can_be_undone_there) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Link two vessels");
    const auto link = [this] {
        click(Vec3(0.02, 4, 0.6));
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(Vec3(37, 54.5, 4)));
    };
    const auto warned = [this] {
        return window_.messages().text().contains("from wall to wall, farther than");
    };
    link();
    ASSERT_TRUE(window_.workspace().awaits_body());
    EXPECT_TRUE(warned()) << window_.messages().text().toStdString();
    QPushButton* undo = nullptr;
    for (auto* button : window_.messages().findChildren<QPushButton*>())
        if (button->text() == "Undo" && button->isVisible()) undo = button;
    ASSERT_NE(undo, nullptr);
    undo->click();
    wait();
    EXPECT_TRUE(window_.workspace().edits().empty());
    EXPECT_EQ(window_.messages().text(), "");
    link();
    wait();
    EXPECT_TRUE(warned()) << "it stays until the link is undone";
    EXPECT_EQ(window_.workspace().patient()->corrections.edits.size(), 1u);
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_FALSE(warned());
    EXPECT_TRUE(window_.log().as_text().contains("no longer so\tCorrections\tThe link leads"))
        << window_.log().as_text().toStdString();
}

TEST_F(Editing, a_doubtful_link_is_a_warning_of_the_case_as_long_as_it_stands) {
    const auto is_warning = [this] {
        return std::ranges::any_of(window_.workspace().warnings(), [](const std::string& warning) {
            return warning.find("from wall to wall, farther than") != std::string::npos;
        });
    };
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Link two vessels");
    click(Vec3(0.02, 4, 0.6));
    click(Vec3(37, 54.5, 4));
    EXPECT_TRUE(is_warning());
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_FALSE(is_warning());
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    EXPECT_TRUE(is_warning());
    EXPECT_TRUE(window_.messages().text().contains("from wall to wall, farther than"))
        << "also above the view: " << window_.messages().text().toStdString();
    saved();
    window_.open(folder_.filePath("p.hep"));
    wait();
    EXPECT_TRUE(is_warning()) << "opened anew";
}

TEST_F(Editing, the_first_vessel_of_a_link_is_marked_until_the_second_is_chosen) {
    const auto marks = [this] { return window_.view().scene().marks(); };
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Link two vessels");
    ASSERT_TRUE(marks().empty());
    click(Vec3(0.05, 10, 1.5));
    ASSERT_EQ(marks().size(), 1u);
    choose_tool("Delete a branch");
    EXPECT_TRUE(marks().empty()) << "another tool gives the link up";
    choose_tool("Link two vessels");
    click(Vec3(0.05, 10, 1.5));
    ASSERT_EQ(marks().size(), 1u);
    const Vec3 first_mm = marks()[0].place_mm;
    click(Vec3(-8.6, 28, 4.4));
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_LT((saved().corrections.edits[0].at_mm - first_mm).norm(), 1e-9);
    EXPECT_TRUE(marks().empty());
}

TEST_F(Editing, what_was_done_is_listed_with_its_place) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a whole tree");
    click(Vec3(37, 54.5, 4));  // the vessel apart
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_EQ(roots(saved_.tree).size(), 1u);
    QString line;
    for (const auto* list : window_.findChildren<QListWidget*>())
        if (list->accessibleName() == "Edits") line = list->item(0)->text();
    EXPECT_TRUE(line.startsWith("Tree deleted at L 3")) << line.toStdString();
    EXPECT_TRUE(line.endsWith(" mm (unknown system)"))
        << "of the tree that was there: " << line.toStdString();
}

// A click in a slice is one in the view; beside every vessel it is nothing.
TEST_F(Editing, a_click_in_a_slice_corrects_what_lies_there) {
    show_slices(test::tube_ct());
    ViewLayout& views = window_.view_layout();
    SliceView& axial = views.slice_view(SliceDirection::axial);
    const Vec3 trunk(0.05, 10, 1.5);
    views.slices().set_crosshair(trunk);
    emit child<QComboBox>("measure").activated(5);
    EXPECT_TRUE(child<QLabel>("slicePlace").text().contains("Cut the vessel"));
    choose_tool("Set a whole vessel's system");
    child<QComboBox>("EditSystem").setCurrentText("portal vein");
    const auto click_beside = [&](double mm) {
        QTest::mouseClick(&axial, Qt::LeftButton, {},
                          axial.place_of(views.slices().crosshair_mm() + Vec3(mm, 0, 0)).toPoint());
    };
    click_beside(-14.0);
    EXPECT_TRUE(window_.statusBar()->currentMessage().startsWith("No vessel there: click"));
    EXPECT_TRUE(saved().corrections.edits.empty());
    views.slices().set_crosshair(trunk);
    EXPECT_TRUE(child<QLabel>("slicePlace").text().contains("Set a whole vessel's system"));
    click_beside(4.5);  // 0.7 mm beside the wall
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_EQ(saved_.corrections.edits[0].kind, TreeEditKind::seed_system);
    EXPECT_EQ(saved_.corrections.edits[0].system, VascularSystem::portal);
    // By the keys, and away.
    choose_tool("Delete a whole tree");
    views.slices().set_crosshair(trunk);
    QTest::keyClick(&axial, Qt::Key_Return);
    EXPECT_EQ(saved().corrections.edits.size(), 2u);
    QTest::keyClick(&axial, Qt::Key_Escape);
    EXPECT_EQ(child<QComboBox>("measure").currentText(), "Crosshair");
}

TEST_F(Editing, an_edit_that_leaves_nothing_is_refused_and_the_patient_stays) {
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a branch");
    click(Vec3(37, 54.5, 4));
    ASSERT_EQ(roots(saved().tree).size(), 1u);
    click(Vec3(0, 10, 1.5));  // the trunk, and all that hangs on it
    EXPECT_TRUE(window_.messages().text().contains("nothing of the tree"));
    EXPECT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_FALSE(saved_.tree.segments.empty());
}

TEST_F(Editing, a_corrected_patient_is_played_on_with_all_that_was_chosen) {
    child<QCheckBox>("gravity").click();
    child<QCheckBox>("tissue").click();
    child<QSlider>("dial").setValue(30);
    child<QDoubleSpinBox>("wall").setValue(0.8);
    child<QDoubleSpinBox>("speed").setValue(2.5);
    click(test::last_gap[1]);
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    ASSERT_TRUE(heard<SetQuality>() && heard<SetGravity>() && heard<SetTether>() &&
                heard<SetWall>() && heard<SetDrugSpeed>());
    EXPECT_EQ(heard<SetQuality>()->quality, 0.3);
    EXPECT_GT(heard<SetGravity>()->gravity_mm_per_s2.y(), 9000.0);
    EXPECT_EQ(heard<SetTether>()->pa_per_mm2, 0.0);
    EXPECT_EQ(heard<SetWall>()->wall_mm, 0.8);
    EXPECT_EQ(heard<SetDrugSpeed>()->factor, 2.5);
    // The simulation itself took them, and the panels still show them.
    paint();
    EXPECT_EQ(window_.frame().statistics.message, "");
    EXPECT_FALSE(window_.frame().statistics.automatic);
    wait_for_figures();
    EXPECT_FALSE(child<QCheckBox>("automatic").isChecked());
    EXPECT_EQ(child<QSlider>("dial").value(), 30);
    EXPECT_EQ(child<QDoubleSpinBox>("wall").value(), 0.8);
}

TEST_F(Editing, what_was_not_chosen_stays_automatic_after_a_correction) {
    click(test::last_gap[1]);
    EXPECT_TRUE(heard_.empty());
    EXPECT_TRUE(testing::wait_for([this] { return window_.frame().statistics.automatic; }));
    wait_for_figures();
    EXPECT_TRUE(child<QCheckBox>("automatic").isChecked());
}

TEST_F(Editing, a_case_from_disk_is_saved_as_another_with_its_voxels) {
    const QString first = folder_.filePath("first.hep"), second = folder_.filePath("second.hep");
    PatientCase patient = test::patient_with_bridges();
    patient.mask = Mask(Grid{{4, 4, 4}}, 1);
    write_case(to_path(first), patient);
    window_.open(first);
    wait();
    EXPECT_FALSE(window_.isWindowModified());
    click(test::last_gap[1]);
    EXPECT_TRUE(window_.isWindowModified());
    save_place_ = to_path(second);
    window_.actions()[ActionId::save_case_as].trigger();
    wait();
    EXPECT_EQ(window_.messages().text(), "");
    EXPECT_FALSE(window_.isWindowModified());
    const PatientCase written = read_case(to_path(second));
    EXPECT_EQ(written.corrections.edits.size(), 1u);
    EXPECT_EQ(roots(written.tree).size(), 1u);
    EXPECT_EQ(written.mask.voxels, patient.mask.voxels);
    EXPECT_EQ(hash_of(read_case(to_path(first))), hash_of(patient));
}

TEST_F(Editing, saving_at_once_after_a_click_keeps_the_correction) {
    window_.save_case(folder_.filePath("p"));
    wait();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(test::last_gap[1]));
    ASSERT_TRUE(window_.workspace().awaits_body());
    window_.actions()[ActionId::save_case].trigger();
    wait();
    EXPECT_EQ(read_case(to_path(folder_.filePath("p.hep"))).corrections.edits.size(), 1u);
    EXPECT_EQ(roots(window_.workspace().patient()->tree).size(), 1u);
    EXPECT_FALSE(window_.isWindowModified());
    EXPECT_EQ(window_.windowTitle(), "p.hep[*] - Hepatica");
}

TEST_F(Editing, closing_asks_about_what_is_not_saved_and_waits_for_it) {
    unsaved_answer_ = UnsavedAnswer::cancel;
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(test::last_gap[1]));
    EXPECT_FALSE(window_.close());
    EXPECT_EQ(questions_asked_, 1);
    EXPECT_TRUE(window_.isVisible());
    wait();
    unsaved_answer_ = UnsavedAnswer::save;
    save_place_ = to_path(folder_.filePath("p.hep"));
    EXPECT_FALSE(window_.close()) << "the case is being written";
    EXPECT_TRUE(testing::wait_for([this] { return !window_.isVisible(); }));
    EXPECT_EQ(read_case(*save_place_).corrections.edits.size(), 1u);
}

// What cannot be opened is no reason to let anything go.
TEST_F(Editing, a_file_that_cannot_be_read_is_found_out_before_anything_is_asked) {
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(test::last_gap[1]));
    wait();
    ASSERT_TRUE(window_.isWindowModified());
    const QString empty = folder_.filePath("empty");
    QDir().mkpath(empty);
    const QString broken = folder_.filePath("broken.nii");
    std::ofstream(to_path(broken)) << "this is no image";
    for (const QString& path : {folder_.filePath("gone.nii"), empty, broken}) {
        window_.open(path);
        ASSERT_TRUE(testing::wait_for([this] { return !window_.busy(); }));
        EXPECT_EQ(questions_asked_, 0) << path.toStdString();
        EXPECT_TRUE(window_.messages().text().contains(path)) << path.toStdString();
        EXPECT_TRUE(window_.isWindowModified());
    }
}

}  // namespace
}  // namespace hepatica
