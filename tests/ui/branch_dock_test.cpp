// SPDX-License-Identifier: GPL-3.0-or-later
// The table of branches, on a patient whose liver has a portal vein.
#include "ui/branch_dock.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "tests/ui/window_test.h"

namespace hepatica {
namespace {

// A trunk that divides, in a liver of 12 cm.
std::shared_ptr<PatientCase> forked_patient() {
    auto patient = std::make_shared<PatientCase>();
    VesselSegment trunk;
    trunk.system = VascularSystem::portal;
    trunk.points_mm = {Vec3(0, 0, -50), Vec3(0, 0, -20)};
    trunk.radii_mm = {6.0, 6.0};
    VesselSegment right = trunk, left = trunk;
    right.parent = left.parent = 0;
    right.points_mm = {Vec3(0, 0, -20), Vec3(-50, 5, 10)};
    left.points_mm = {Vec3(0, 0, -20), Vec3(45, -5, 10)};
    right.radii_mm = {4.0, 3.0};
    left.radii_mm = {2.0, 2.0};
    patient->tree.segments = {trunk, right, left};
    Grid grid;
    grid.dims = {60, 60, 60};
    grid.spacing_mm = Vec3::Constant(2.0);
    grid.origin_mm = Vec3::Constant(-59.0);
    patient->organs = Mask(grid, organ_label::liver);
    return patient;
}

class Branches : public ::testing::Test {
  protected:
    Branches()
        : dock_({[this](const BranchRow& row) { chosen_.push_back(row.branch); },
                 [this](const std::vector<std::uint8_t>& segments) { colours_ = segments; },
                 [this](const std::string& csv) { saved_ = csv; },
                 [this](const Failure& failure) { failure_ = failure.problem; }},
                nullptr) {}
    void show(std::shared_ptr<const PatientCase> patient) {
        dock_.show_patient(std::move(patient), {1.0, 0.7, 0.3}, {});
        dock_.show();
        ASSERT_TRUE(testing::wait_for([this] { return !dock_.rows().empty(); }));
    }
    QTableWidget& table() { return *dock_.findChild<QTableWidget*>("branches"); }
    QString note() { return dock_.findChild<QLabel*>("quiet")->text(); }
    double value(int row, int column) {
        return table().item(row, column)->data(Qt::DisplayRole).toDouble();
    }

    std::vector<int> chosen_;
    std::vector<std::uint8_t> colours_{9};
    std::string saved_, failure_;
    BranchDock dock_;
};

TEST_F(Branches, AreReadWhenTheTableIsShown) {
    dock_.show_patient(forked_patient(), {}, {});
    QTest::qWait(0);
    EXPECT_TRUE(dock_.rows().empty());
    show(forked_patient());
    ASSERT_EQ(table().rowCount(), 3);
    EXPECT_EQ(value(0, 3), 30.0);
    EXPECT_EQ(value(1, 2), 2.0);
    EXPECT_EQ(value(1, 6), 70.0);
    EXPECT_EQ(table().item(0, 3)->text(), "30.0") << "as many decimals in each row";
    EXPECT_EQ(table().item(0, 6)->text(), "100.00");
    EXPECT_EQ(table().item(1, 6)->text(), "70.00");
    EXPECT_EQ(table().item(0, 1)->text(), "portal vein");
}

TEST_F(Branches, AreSortedAsNumbersAndChosenByARow) {
    show(forked_patient());
    table().sortByColumn(4, Qt::AscendingOrder);
    EXPECT_EQ(value(0, 0), 3.0) << "the thinnest is the left one";
    EXPECT_EQ(value(2, 0), 1.0);
    table().selectRow(0);
    EXPECT_EQ(chosen_, std::vector<int>{2});
    dock_.select(1);
    EXPECT_EQ(chosen_.size(), 1u) << "what the view has chosen is not told back";
    EXPECT_EQ(value(table().currentRow(), 0), 2.0);
}

TEST_F(Branches, AreColouredByTheSegmentsOfTheLiver) {
    show(forked_patient());
    EXPECT_TRUE(colours_.empty());
    auto* box = dock_.findChild<QCheckBox*>("segmentColours");
    ASSERT_TRUE(box->isEnabled());
    box->click();
    ASSERT_EQ(colours_.size(), 3u);
    EXPECT_EQ(colours_[0], 0) << "the trunk supplies all of them";
    EXPECT_EQ(table().item(0, 5)->text(), "trunk");
    EXPECT_EQ(table().item(0, 5)->toolTip(), "It supplies several segments of the liver");
    EXPECT_EQ(table().item(1, 5)->toolTip(), "");
    EXPECT_GE(colours_[1], 5) << "right of the middle vein lie 5 to 8";
    EXPECT_LE(colours_[2], 4);
    const QString right = table().item(1, 5)->text(), left = table().item(2, 5)->text();
    EXPECT_TRUE(QStringList({"V", "VI", "VII", "VIII"}).contains(right)) << right.toStdString();
    EXPECT_TRUE(QStringList({"I", "II", "III", "IV"}).contains(left)) << left.toStdString();
    table().sortByColumn(5, Qt::DescendingOrder);
    EXPECT_EQ(table().item(0, 5)->text(), right) << "V to VIII stand above I to IV";
    EXPECT_EQ(table().item(2, 5)->text(), "trunk") << "below all that have one";
    box->click();
    EXPECT_TRUE(colours_.empty());
}

// A trunk in two pieces, as where a small branch leaves it; a hepatic vein has no segment.
TEST_F(Branches, OfSeveralSegmentsSaySoAndThoseOfOtherSystemsSayNothing) {
    auto patient = forked_patient();
    VesselTree& tree = patient->tree;
    VesselSegment& trunk = tree.segments[0];
    VesselSegment further = trunk;
    further.parent = 0;
    trunk.points_mm.back() = further.points_mm.front() = Vec3(0, 0, -35);
    for (const std::size_t branch : {1u, 2u}) tree.segments[branch].parent = 1;
    tree.segments.insert(tree.segments.begin() + 1, further);
    VesselSegment vein = tree.segments[0];
    vein.system = VascularSystem::hepatic;
    vein.points_mm = {Vec3(0, 40, 50), Vec3(0, 10, 0)};
    tree.segments.push_back(vein);
    dock_.show_patient(patient, {}, {});
    dock_.show();
    ASSERT_TRUE(testing::wait_for([this] { return !dock_.rows().empty(); }));
    ASSERT_EQ(dock_.rows()[1].couinaud, 0) << "the test's own premise";
    EXPECT_EQ(table().item(0, 5)->text(), "trunk");
    EXPECT_EQ(table().item(1, 5)->text(), "several");
    EXPECT_EQ(table().item(4, 5)->text(), "");
    EXPECT_EQ(table().item(4, 5)->toolTip(), "");
}

TEST_F(Branches, HaveNoSegmentsWithoutALiver) {
    auto patient = forked_patient();
    patient->organs = {};
    show(patient);
    EXPECT_FALSE(dock_.findChild<QCheckBox*>("segmentColours")->isEnabled());
    EXPECT_EQ(table().rowCount(), 3);
    EXPECT_EQ(table().item(0, 5)->text(), "") << "nothing is known of it";
    EXPECT_EQ(failure_, "");
    EXPECT_TRUE(note().contains("need a liver mask")) << note().toStdString();
}

TEST_F(Branches, OfACaseThatCannotBeReadKeepTheirLengths) {
    auto patient = forked_patient();
    patient->organs = {};
    dock_.show_patient(patient, {}, "/nowhere/p.hep");
    dock_.show();
    ASSERT_TRUE(testing::wait_for([this] { return !failure_.empty(); }));
    EXPECT_EQ(table().rowCount(), 3);
    EXPECT_EQ(note(), "The segments cannot be read: " + QString::fromStdString(failure_));
}

TEST_F(Branches, AreSavedAsTheTableOfTheTree) {
    show(forked_patient());
    table().sortByColumn(4, Qt::DescendingOrder);
    dock_.findChild<QPushButton*>("saveBranches")->click();
    EXPECT_EQ(saved_, branch_table_csv(dock_.rows()));
    dock_.clear();
    EXPECT_EQ(table().rowCount(), 0);
}

}  // namespace
}  // namespace hepatica
