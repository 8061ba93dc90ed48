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
#include "ui/message_bar.h"
#include "ui/message_log.h"

namespace hepatica {
namespace {

class GivenBranch : public testing::WindowTest {
  protected:
    GivenBranch()
        : WindowTest({[](const OpenRequest&, Job& job) {
                          return play(
                              std::make_shared<const PatientCase>(test::patient_with_bridges()),
                              job);
                      },
                      [](const std::filesystem::path&, const PatientCase&) {},
                      [](std::shared_ptr<const PatientCase> patient, Job& job) {
                          return play(std::move(patient), job);
                      }}) {
        open_built_in();
        window_.actions()[ActionId::edit_mode].trigger();
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        tools->setCurrentIndex(tools->findText("Give to a system"));
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

}  // namespace
}  // namespace hepatica
