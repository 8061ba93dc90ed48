// SPDX-License-Identifier: GPL-3.0-or-later
// Giving a branch to another system in the window: what is said of it then.
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTableWidget>
#include <algorithm>

#include "core/tree/station.h"
#include "tests/patient/parted_patient.h"
#include "tests/ui/window_test.h"
#include "ui/case_editing.h"
#include "ui/message_bar.h"
#include "ui/message_log.h"

namespace hepatica {
namespace {

class GivenBranch : public testing::WindowTest {
  protected:
    explicit GivenBranch(const PatientCase& opened = test::patient_with_bridges())
        : WindowTest({[shared = std::make_shared<const PatientCase>(opened)](
                          const OpenRequest&, Job& job) { return play(shared, job); },
                      [](const std::filesystem::path&, const PatientCase&) {},
                      [](std::shared_ptr<const PatientCase> patient, Job& job) {
                          return play(std::move(patient), job);
                      }}) {
        open_built_in();
        window_.actions()[ActionId::edit_mode].trigger();
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        tools->setCurrentIndex(tools->findText("Set a branch's system"));
        window_.findChild<QComboBox*>("EditSystem")->setCurrentText("hepatic veins");
    }
    void give(const Vec3& place_mm) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(place_mm));
        wait();
    }
    std::ptrdiff_t hepatic_trees() {
        const VesselTree& tree = window_.workspace().patient()->tree;
        return std::ranges::count_if(roots(tree), [&](int root) {
            return tree.segments[static_cast<std::size_t>(root)].system == VascularSystem::hepatic;
        });
    }
    bool says_so() { return window_.messages().text().contains("tree of its own"); }

    const Vec3 vessel_apart_{37, 54.5, 4}, left_branch_{-8.6, 28, 4.4};
};

// Neither the tree nor the case changes by it; nor while the body of the correction before is made.
TEST_F(GivenBranch, of_the_system_already_is_not_given_again) {
    give(vessel_apart_);
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    give(vessel_apart_);
    EXPECT_EQ(window_.workspace().edits().size(), 1u);
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains("already (hepatic veins)"))
        << window_.statusBar()->currentMessage().toStdString();
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(left_branch_));
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(left_branch_));
    wait();
    EXPECT_EQ(window_.workspace().edits().size(), 2u);
}

PatientCase doubtful_portal_vein() {
    PatientCase patient = test::patient_with_bridges();
    for (VesselSegment& segment : patient.tree.segments) {
        segment.system = VascularSystem::portal;
        segment.system_confidence = 0.7;
    }
    return patient;
}

class DoubtfulBranch : public GivenBranch {
  protected:
    DoubtfulBranch() : GivenBranch(doubtful_portal_vein()) {}
};

TEST_F(DoubtfulBranch, is_confirmed_once_by_giving_it_the_system_that_it_has) {
    window_.findChild<QComboBox*>("EditSystem")->setCurrentText("portal vein");
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(left_branch_));
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains("Confirmed"))
        << window_.statusBar()->currentMessage().toStdString();
    wait();
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    const VesselTree& now = window_.workspace().patient()->tree;
    const auto there = static_cast<std::size_t>(nearest_point(now, left_branch_).segment);
    EXPECT_EQ(now.segments[there].system_confidence, 1.0);
    give(left_branch_);
    EXPECT_EQ(window_.workspace().edits().size(), 1u);
}

// Where it hung before it touches nothing of its new system: blood and drugs end there.
TEST_F(GivenBranch, that_became_a_tree_of_its_own_is_warned_of) {
    ASSERT_EQ(hepatic_trees(), 0);
    give(vessel_apart_);
    ASSERT_EQ(hepatic_trees(), 1);
    EXPECT_FALSE(says_so()) << "it is the only one of its system";
    give(left_branch_);
    ASSERT_EQ(hepatic_trees(), 2);
    EXPECT_TRUE(says_so()) << window_.messages().text().toStdString();
    window_.messages().dismiss();
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_FALSE(says_so());
    static const QRegularExpression past("no longer so\tCorrections\t[^\n]*tree of its own");
    EXPECT_TRUE(window_.log().as_text().contains(past)) << window_.log().as_text().toStdString();
}

// One that is shorter than it is wide cannot be clicked on.
TEST_F(GivenBranch, may_be_the_one_that_is_chosen_in_the_table) {
    auto* button = window_.findChild<QPushButton*>("editChosenBranch");
    ASSERT_NE(button, nullptr);
    button->click();
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains("Choose a row"));
    EXPECT_TRUE(window_.workspace().edits().empty());
    window_.actions()[ActionId::toggle_branches].trigger();
    auto* table = window_.findChild<QTableWidget*>("branches");
    ASSERT_TRUE(testing::wait_for([&] { return table->rowCount() > 0; }));
    const int branch = table->rowCount() - 1;
    const VesselSegment& chosen =
        window_.workspace().patient()->tree.segments[static_cast<std::size_t>(branch)];
    const Vec3 middle_mm = station_at(chosen, 0.5 * length_mm(chosen)).position_mm;
    table->selectRow(branch);
    button->click();
    wait();
    ASSERT_EQ(window_.workspace().edits().size(), 1u);
    const TreeEdit& edit = window_.workspace().edits().front();
    EXPECT_EQ(edit.kind, TreeEditKind::reassign_system);
    EXPECT_EQ(edit.system, VascularSystem::hepatic);
    EXPECT_LT((edit.at_mm - middle_mm).norm(), 1e-9);
}

// What system the place has now would read as what it had before.
TEST_F(GivenBranch, is_listed_with_its_new_system_alone) {
    give(vessel_apart_);
    QString line;
    for (const auto* list : window_.findChildren<QListWidget*>())
        if (list->accessibleName() == "Edits" && list->count() > 0) line = list->item(0)->text();
    EXPECT_TRUE(line.startsWith("Given to: hepatic veins at L 3")) << line.toStdString();
    EXPECT_TRUE(line.endsWith(" mm")) << line.toStdString();
}

// What the panel of corrections says and asks for, without a window.
class CorrectedCase : public ::testing::Test {
  protected:
    CorrectedCase() {
        CaseEditing::Callbacks callbacks;
        callbacks.add = [this](const TreeEdit& edit) {
            workspace_.add(edit);
            editing_->update_panel();
        };
        callbacks.show_history = [](const QString&, const QString&) {};
        callbacks.show_bridges = [this](const std::vector<BridgeView>& bridges) {
            bridges_shown_ = bridges.size();
        };
        callbacks.look_at = [this](const std::vector<Vec3>& path_mm) { looked_at_mm_ = path_mm; };
        callbacks.points_wait = [] { return false; };
        callbacks.say = [](const QString&) {};
        callbacks.warn = [this](const QString& text) {
            for (const QString& line : text.split('\n'))
                if (line.contains("tree of its own")) warned_ << line;
        };
        editing_ = std::make_unique<CaseEditing>(panel_, workspace_, std::move(callbacks));
        OpenedPatient opened;
        opened.patient = std::make_shared<const PatientCase>(test::patient_with_bridges());
        workspace_.open(opened);
        editing_->show_body();
    }
    void make_body() {
        workspace_.show_body(std::make_shared<const PatientCase>(
            with_edited_tree(*workspace_.patient(), workspace_.edits())));
        editing_->show_body();
    }
    // Without its body yet.
    void want(TreeEditKind kind, const Vec3& at_mm,
              VascularSystem system = VascularSystem::unknown) {
        TreeEdit edit;
        edit.kind = kind;
        edit.at_mm = at_mm;
        edit.system = system;
        workspace_.add(edit);
    }
    void make(TreeEditKind kind, const Vec3& at_mm, const Vec3& to_mm = Vec3::Zero()) {
        TreeEdit edit;
        edit.kind = kind;
        edit.at_mm = at_mm;
        edit.to_mm = to_mm;
        if (kind == TreeEditKind::reassign_system) edit.system = VascularSystem::hepatic;
        workspace_.add(edit);
        make_body();
    }

    EditPanel panel_;
    Workspace workspace_;
    std::unique_ptr<CaseEditing> editing_;
    std::size_t bridges_shown_ = 0;
    std::vector<Vec3> looked_at_mm_;
    QStringList warned_;  // of vessels that were given
    const Vec3 vessel_apart_{37, 54.5, 4}, left_branch_{-8.6, 28, 4.4};
    const Vec3 trunk_{0.05, 10, 1.5}, last_branch_{15.5, 39, 1.5};
    static constexpr auto portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;
    static constexpr auto give = TreeEditKind::reassign_system;
};

TEST_F(CorrectedCase, AGivenVesselIsStillApartWhenTheVesselsAreRebuilt) {
    make(TreeEditKind::reassign_system, vessel_apart_);
    make(TreeEditKind::reassign_system, left_branch_);
    ASSERT_EQ(warned_.size(), 1);
    const QString doubt = warned_.front();
    EXPECT_TRUE(editing_->stands(doubt));
    const auto before = workspace_.patient();
    PatientCase rebuilt = test::patient_with_bridges();
    const Vec3 by_mm(0.4, 0.0, 0.0);  // other voxels, other centrelines
    for (VesselNode& node : rebuilt.tree.nodes) node.position_mm += by_mm;
    for (VesselSegment& segment : rebuilt.tree.segments)
        for (Vec3& point : segment.points_mm) point += by_mm;
    workspace_.show_remade(before, std::make_shared<const PatientCase>(
                                       with_edited_tree(rebuilt, before->corrections.edits)));
    editing_->show_body();
    EXPECT_TRUE(editing_->stands(doubt));
    EXPECT_EQ(warned_.size(), 1) << "it was said already";
    make(TreeEditKind::add_link, left_branch_, vessel_apart_);
    EXPECT_FALSE(editing_->stands(doubt));
    workspace_.undo();
    make_body();
    EXPECT_TRUE(editing_->stands(doubt));
    workspace_.take_back_remaking();
    editing_->show_body();
    EXPECT_TRUE(editing_->stands(doubt));
    OpenedPatient another;
    another.patient = std::make_shared<const PatientCase>(test::patient_with_bridges());
    workspace_.open(another);
    editing_->show_body();
    EXPECT_FALSE(editing_->stands(doubt));
}

// What is undone and redone before its body is there comes in one go.
TEST_F(CorrectedCase, AVesselThatWasGivenTwiceIsJudgedByTheLast) {
    make(give, trunk_);
    want(give, vessel_apart_, hepatic);
    want(give, vessel_apart_, portal);
    want(TreeEditKind::cut_link, last_branch_);  // a tree more of the hepatic veins
    make_body();
    EXPECT_TRUE(warned_.isEmpty()) << warned_.join('\n').toStdString();
    want(give, left_branch_, hepatic);
    want(give, left_branch_, portal);
    make_body();
    ASSERT_EQ(warned_.size(), 1);
    EXPECT_TRUE(warned_.front().contains("portal vein")) << warned_.front().toStdString();
}

TEST_F(CorrectedCase, AVesselIsNotApartBecauseAnotherWasCutOff) {
    make(give, trunk_);
    want(TreeEditKind::cut_link, last_branch_);
    want(give, left_branch_, hepatic);  // as it is already
    make_body();
    EXPECT_TRUE(warned_.isEmpty()) << warned_.join('\n').toStdString();
}

// Who decides on it wants to see the CT there.
TEST_F(CorrectedCase, ABridgeThatIsChosenIsLookedAt) {
    panel_.findChild<QListWidget*>("gaps")->setCurrentRow(1);
    EXPECT_EQ(looked_at_mm_, workspace_.patient()->corrections.bridges[1].path_mm);
    panel_.findChild<QListWidget*>("gaps")->setCurrentRow(-1);
    EXPECT_TRUE(looked_at_mm_.empty());
}

// Both gaps lead to the same vessel, and the body takes a while.
TEST_F(CorrectedCase, AGapThatIsBeingBridgedIsBridgedOnce) {
    ASSERT_EQ(bridges_shown_, 2u);
    editing_->click_drawn(0);
    ASSERT_TRUE(workspace_.awaits_body());
    EXPECT_EQ(bridges_shown_, 1u);
    workspace_.undo();
    editing_->update_panel();
    EXPECT_EQ(bridges_shown_, 2u);
}

}  // namespace
}  // namespace hepatica
