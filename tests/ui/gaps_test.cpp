// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between vessels in the panel of corrections: those that are offered and those that the
// reconstruction bridged, refused one by one.
#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "core/patient/corrections.h"
#include "tests/ui/editing_window.h"
#include "ui/paths.h"

namespace hepatica::testing {
namespace {

class Gaps : public EditingWindow {
  protected:
    // The reconstruction built the first gap, of 22 %.
    void open_with_a_bridge() {
        PatientCase patient = test::patient_with_bridges();
        patient.corrections.bridges[0].built = true;
        Bridge as_offered = patient.corrections.bridges[0];
        patient.tree = edited(patient.tree, acceptance_of(as_offered));
        Job job;
        patient.mesh = tetrahedralize(patient.tree, {.target_tetrahedra = 2000}, job);
        patient.surface = surface_of(patient.mesh).mesh;
        write_case(to_path(folder_.filePath("built.hep")), patient);
        window_.open(folder_.filePath("built.hep"));
        wait();
    }
    void open_with_a_branch() {
        PatientCase patient = test::patient_with_bridges();
        Bridge branch;
        // Out of the trunk, seen from the front downwards, away from all vessels.
        branch.path_mm = {Vec3(0.05, 10, 1.5), Vec3(1.5, 9.8, -4), Vec3(3, 9, -9), Vec3(5, 8, -16)};
        branch.radii_mm.assign(branch.path_mm.size(), 0.8);
        branch.confidence = 0.7;
        branch.gap_mm = 20.0;
        patient.corrections.bridges.push_back(branch);
        write_case(to_path(folder_.filePath("offered.hep")), patient);
        window_.open(folder_.filePath("offered.hep"));
        wait();
    }
    QStringList listed() {
        QStringList lines;
        auto& list = child<QListWidget>("gaps");
        for (int row = 0; row < list.count() && list.isEnabled(); ++row)
            lines << list.item(row)->text();
        return lines;
    }
    void refuse(int row) {
        child<QListWidget>("gaps").setCurrentRow(row);
        auto& button = child<QPushButton>("refuseGap");
        ASSERT_TRUE(button.isEnabled());
        button.click();
        wait();
    }
    std::size_t trees() { return roots(window_.workspace().patient()->tree).size(); }
};

TEST_F(Gaps, that_are_refused_are_offered_no_more_until_that_is_undone) {
    ASSERT_EQ(listed(), (QStringList{"22 %, gap of 8.0 mm", "10 %, gap of 8.0 mm"}));
    EXPECT_FALSE(child<QPushButton>("refuseGap").isEnabled()) << "no row is chosen";
    const auto body = window_.workspace().patient();
    refuse(0);
    EXPECT_EQ(listed(), QStringList{"10 %, gap of 8.0 mm"});
    EXPECT_EQ(window_.workspace().patient(), body) << "nothing is meshed for it";
    QAction& undo = window_.actions()[ActionId::undo_edit];
    EXPECT_TRUE(undo.text().startsWith("&Undo: Gap refused at")) << undo.text().toStdString();
    EXPECT_TRUE(window_.isWindowModified());
    ASSERT_EQ(saved().corrections.edits.size(), 1u);
    EXPECT_EQ(saved_.corrections.edits[0].kind, TreeEditKind::refuse_gap);
    EXPECT_EQ(state_of_bridge(saved_, 0), BridgeState::refused);
    undo.trigger();
    wait();
    EXPECT_EQ(listed().size(), 2);
    EXPECT_TRUE(saved().corrections.edits.empty());
}

// So that one goes down the list by one key.
TEST_F(Gaps, are_decided_one_after_the_other) {
    auto& list = child<QListWidget>("gaps");
    refuse(0);
    ASSERT_EQ(list.selectedItems().size(), 1) << "the next one is chosen";
    EXPECT_EQ(list.selectedItems()[0]->text(), "10 %, gap of 8.0 mm");
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    list.setCurrentRow(-1);
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    list.setFocus();
    EXPECT_TRUE(list.selectedItems().empty()) << "nobody chose one";
    EXPECT_FALSE(child<QPushButton>("refuseGap").isEnabled());
    EXPECT_FALSE(child<QPushButton>("acceptGap").isEnabled());
}

TEST_F(Gaps, that_were_refused_are_not_listed_when_the_case_is_opened_again) {
    write_case(to_path(folder_.filePath("p.hep")),
               with_edited_tree(test::patient_with_bridges(),
                                {refusal_of(test::patient_with_bridges().corrections.bridges[0])}));
    window_.open(folder_.filePath("p.hep"));
    wait();
    EXPECT_EQ(listed(), QStringList{"10 %, gap of 8.0 mm"});
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_EQ(listed().size(), 2) << "of an earlier run, too";
}

TEST_F(Gaps, that_the_reconstruction_bridged_are_listed_and_parted_again) {
    open_with_a_bridge();
    ASSERT_EQ(trees(), 1u);
    ASSERT_EQ(listed(), QStringList{"bridged: 22 %, gap of 8.0 mm"});
    const auto tells_of_it = [this] {
        for (const auto* label : window_.findChildren<QLabel*>())
            if (label->text().contains("1 gap was bridged by the reconstruction, 8.0 mm"))
                return true;
        return false;
    };
    EXPECT_TRUE(tells_of_it());
    refuse(0);
    EXPECT_FALSE(tells_of_it()) << "it is no bridge any more";
    EXPECT_EQ(trees(), 2u);
    ASSERT_EQ(listed(), QStringList{"10 %, gap of 8.0 mm"}) << "the other is not needless any more";
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_EQ(trees(), 1u);
    EXPECT_EQ(listed(), QStringList{"bridged: 22 %, gap of 8.0 mm"});
}

// In a play they would cover the vessels.
TEST_F(Gaps, are_listed_with_branches_that_are_drawn_in_edit_mode) {
    open_with_a_branch();
    EXPECT_EQ(listed().front(), "70 %, branch of 20 mm");
    const Vec3 on_it(4, 8.5, -12.5);
    const auto is_drawn = [&] {
        const SceneView& scene = window_.view().scene();
        return scene.bridge_at(scene.pixel_of(on_it), 3.0) >= 0;
    };
    EXPECT_FALSE(is_drawn());
    child<QListWidget>("gaps").setCurrentRow(0);
    EXPECT_TRUE(is_drawn()) << "who chooses it sees it";
    child<QListWidget>("gaps").setCurrentRow(1);
    EXPECT_FALSE(is_drawn());
    window_.actions()[ActionId::edit_mode].trigger();
    ASSERT_TRUE(is_drawn());
    const std::size_t before = window_.workspace().patient()->tree.segments.size();
    child<QListWidget>("gaps").setCurrentRow(-1);
    choose_tool("Delete a branch");
    for (int i = 0; i < 2; ++i) {
        click(on_it);
        EXPECT_TRUE(window_.workspace().edits().empty()) << "a click that deletes takes none";
        EXPECT_EQ(child<QListWidget>("gaps").selectedItems().size(), 1) << "it is chosen";
    }
    child<QPushButton>("acceptGap").click();
    wait();
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    EXPECT_TRUE(window_.actions()[ActionId::undo_edit].text().startsWith("&Undo: Branch taken at"));
    EXPECT_EQ(window_.workspace().edits()[0].kind, TreeEditKind::draw_vessel);
    EXPECT_EQ(window_.workspace().patient()->tree.segments.size(), before + 2);
    EXPECT_FALSE(is_drawn());
}

// The one that is chosen is drawn there, too.
TEST_F(Gaps, are_taken_by_a_click_where_a_click_corrects_nothing) {
    open_with_a_branch();
    child<QListWidget>("gaps").setCurrentRow(0);
    click(Vec3(4, 8.5, -12.5));
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    EXPECT_EQ(window_.workspace().edits()[0].kind, TreeEditKind::draw_vessel);
}

TEST_F(Gaps, whose_lines_lie_over_a_vessel_leave_a_click_in_edit_mode_to_it) {
    open_with_a_branch();
    window_.actions()[ActionId::edit_mode].trigger();
    choose_tool("Delete a branch");
    const Vec3 on_trunk_and_line(0.05, 10, 1.5);
    const SceneView& scene = window_.view().scene();
    ASSERT_GE(scene.bridge_at(scene.pixel_of(on_trunk_and_line), 3.0), 0);
    click(on_trunk_and_line);
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    EXPECT_EQ(window_.workspace().edits()[0].kind, TreeEditKind::delete_branch);
}

// The body is made once, as well, but for a step back: of a real patient it takes half a minute.
TEST_F(Gaps, that_are_taken_with_branches_all_at_once_are_one_step_of_undo) {
    open_with_a_branch();
    take_all();
    ASSERT_EQ(window_.workspace().edits().size(), 2u);
    EXPECT_FALSE(window_.workspace().awaits_body());
    const QString all = "2 gaps and doubtful branches taken";
    for (const auto* list : window_.findChildren<QListWidget*>()) {
        if (list->accessibleName() != "Edits") continue;
        ASSERT_EQ(list->count(), 1);
        EXPECT_EQ(list->item(0)->text(), all);
    }
    QAction& undo = window_.actions()[ActionId::undo_edit];
    EXPECT_EQ(undo.text(), "&Undo: " + all);
    undo.trigger();
    wait();
    EXPECT_TRUE(window_.workspace().edits().empty());
    EXPECT_EQ(trees(), 2u);
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    EXPECT_EQ(window_.workspace().patient()->corrections.edits.size(), 2u);
    EXPECT_FALSE(undo.text().isEmpty());
}

TEST_F(Gaps, that_are_built_cannot_be_built_again) {
    open_with_a_bridge();
    auto& list = child<QListWidget>("gaps");
    list.setCurrentRow(0);
    emit list.itemDoubleClicked(list.item(0));
    wait();
    EXPECT_TRUE(window_.workspace().edits().empty());
}

}  // namespace
}  // namespace hepatica::testing
