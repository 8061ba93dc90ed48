// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds set by clicks in the slices, and the reconstruction that begins with them.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include "tests/ui/slices_test.h"
#include "ui/patient_wizard.h"
#include "ui/slices/seed_doubt.h"

namespace hepatica {
namespace {

constexpr int crosshair = 0, seeds_portal = 10, seeds_hepatic = 11, seeds_artery = 12;

class Seeds : public testing::SlicesTest {
  protected:
    void take(int purpose) { emit list().activated(purpose); }
    QComboBox& list() { return *window_.findChild<QComboBox*>("measure"); }
    QPushButton& button() { return *window_.findChild<QPushButton*>("reconstructWithSeeds"); }
    SliceView& axial() { return view(SliceDirection::axial); }
    void click(int x, int y) {
        QTest::mouseClick(&axial(), Qt::LeftButton, {}, axial().rect().center() + QPoint(x, y));
    }
    const std::vector<VesselSeed>& seeds() { return scene().seeds().seeds(); }
};

TEST_F(Seeds, are_set_by_clicks_and_by_keys_and_taken_back) {
    show_slices();
    EXPECT_FALSE(button().isVisible());
    take(seeds_portal);
    EXPECT_TRUE(button().isVisible());
    EXPECT_FALSE(button().isEnabled()) << "there is none yet";
    const Vec3 crosshair_mm = scene().crosshair_mm();
    const QImage before = axial().grab().toImage();
    click(10, 5);
    ASSERT_EQ(seeds().size(), 1u);
    EXPECT_EQ(seeds()[0].system, VascularSystem::portal);
    EXPECT_LT((axial().place_of(seeds()[0].position_mm) -
               QPointF(axial().rect().center() + QPoint(10, 5)))
                  .manhattanLength(),
              1.0);
    EXPECT_EQ(scene().crosshair_mm(), crosshair_mm) << "a seed leaves the slices where they are";
    const QImage after = axial().grab().toImage();
    EXPECT_NE(after.pixel(axial().rect().center() + QPoint(10, 5)),
              before.pixel(axial().rect().center() + QPoint(10, 5)));
    take(seeds_artery);
    QTest::keyClick(&axial(), Qt::Key_Return);
    ASSERT_EQ(seeds().size(), 2u);
    EXPECT_EQ(seeds()[1].system, VascularSystem::artery);
    EXPECT_EQ(seeds()[1].position_mm, crosshair_mm);
    QTest::keyClick(&axial(), Qt::Key_Delete);
    EXPECT_EQ(seeds().size(), 1u);
    QTest::keyClick(&axial(), Qt::Key_Escape);
    EXPECT_EQ(list().currentIndex(), crosshair);
    EXPECT_EQ(seeds().size(), 1u) << "put away, not taken back";
    EXPECT_TRUE(button().isVisible());
    click(-10, 5);
    EXPECT_EQ(seeds().size(), 1u);
    // Another purpose of a click ends it as well.
    take(seeds_hepatic);
    take(crosshair);
    EXPECT_FALSE(scene().seeds().taken());
}

TEST_F(Seeds, are_put_away_by_a_measurement_that_a_key_takes) {
    show_slices();
    take(seeds_portal);
    QTest::keyClick(&window_, Qt::Key_M);
    EXPECT_FALSE(scene().seeds().taken());
    EXPECT_EQ(list().currentIndex(), 1);
    click(10, 5);
    EXPECT_TRUE(seeds().empty());
    EXPECT_NE(scene().measurements().half_made(), nullptr);
}

TEST_F(Seeds, leave_what_was_typed_for_other_systems) {
    show_slices();
    take(seeds_hepatic);
    click(10, 5);
    PatientWizard wizard("");
    wizard.findChild<QLineEdit*>("portalSeeds")->setText("1 2 3");
    wizard.findChild<QLineEdit*>("hepaticSeeds")->setText("4 5 6");
    wizard.set_seeds(seeds());
    EXPECT_EQ(wizard.findChild<QLineEdit*>("portalSeeds")->text(), "1 2 3");
    EXPECT_NE(wizard.findChild<QLineEdit*>("hepaticSeeds")->text(), "4 5 6");
}

TEST_F(Seeds, begin_the_next_reconstruction) {
    show_slices();
    for (const auto& [purpose, x] : {std::pair(seeds_portal, -20), std::pair(seeds_hepatic, 20),
                                     std::pair(seeds_portal, -30)}) {
        take(purpose);
        click(x, 10);
    }
    ASSERT_EQ(seeds().size(), 3u);
    std::vector<VesselSeed> read;
    QTimer::singleShot(0, &window_, [&] {
        auto& wizard = dynamic_cast<PatientWizard&>(*QApplication::activeModalWidget());
        wizard.findChild<QLineEdit*>("ct")->setText("/some/ct");
        read = wizard.options().seeds;
        wizard.reject();
    });
    button().click();
    ASSERT_EQ(read.size(), 3u);
    for (const auto& [field, set] : {std::pair(0, 0), std::pair(1, 2), std::pair(2, 1)}) {
        EXPECT_EQ(read[field].system, seeds()[set].system);
        EXPECT_LT((read[field].position_mm - seeds()[set].position_mm).cwiseAbs().maxCoeff(),
                  0.051);
    }
    EXPECT_EQ(seeds().size(), 3u) << "a cancelled dialog changes nothing";
}

// A ball of contrast in a liver of 100 HU, beside which lies air.
TEST(SeedDoubt, TellsWhatIsNoVesselOrFarFromTheLiverAndNothingElse) {
    Grid grid;
    grid.dims = {60, 20, 20};
    grid.spacing_mm = Vec3(2, 2, 2);
    Volume ct(grid);
    Mask organs(grid);
    for (int x = 0; x < 60; ++x)
        for (int y = 0; y < 20; ++y)
            for (int z = 0; z < 20; ++z) {
                ct.at(x, y, z) = static_cast<std::int16_t>(x < 5 ? -1000 : x < 55 ? 150 : 700);
                organs.at(x, y, z) = x >= 8 && x < 20 ? organ_label::liver : 0;
            }
    const auto doubt = [&](double x_mm, const Mask& of) {
        return doubt_of_seed(Vec3(x_mm, 20, 20), ct, of);
    };
    EXPECT_EQ(doubt(30, organs), "");
    EXPECT_EQ(doubt(60, organs), "") << "22 mm beside the liver, as the trunk may lie";
    EXPECT_TRUE(doubt(70, organs).startsWith("Seed far outside the liver"));
    EXPECT_EQ(doubt(70, {}), "") << "the case knows no liver";
    EXPECT_TRUE(doubt(4, organs).startsWith("Seed at -1000 HU"));
    EXPECT_TRUE(doubt(116, organs).startsWith("Seed at 700 HU"));
}

TEST_F(Seeds, are_told_with_the_values_of_their_places_and_kept_whatever_speaks_against_them) {
    show_slices();
    const auto text = [this] { return window_.findChild<QLabel*>("slicePlace")->text(); };
    take(seeds_portal);
    EXPECT_TRUE(text().contains("Click into the vessel")) << text().toStdString();
    EXPECT_TRUE(text().contains(" HU")) << text().toStdString();
    click(10, 5);
    const QString there = QString::fromStdString(scene().describe(seeds().back().position_mm));
    EXPECT_TRUE(text().endsWith(there)) << text().toStdString();
    const std::size_t before = seeds().size();
    std::size_t doubted = 0;
    constexpr std::size_t more = 9;  // of values from 20 to 820 HU
    for (std::size_t i = 0; i < more; ++i) {
        const Vec3 place(0, 0, 3.0 * static_cast<double>(i));
        scene().seeds().add(place);
        const bool odd = !doubt_of_seed(place, ct_, {}).isEmpty();
        EXPECT_EQ(text().startsWith("Seed at "), odd) << text().toStdString();
        doubted += odd;
    }
    EXPECT_EQ(seeds().size(), before + more) << "none is refused";
    EXPECT_GT(doubted, 0u);
    EXPECT_LT(doubted, more);
}

TEST_F(Seeds, belong_to_one_patient) {
    show_slices();
    take(seeds_portal);
    click(10, 5);
    views().clear();
    EXPECT_TRUE(seeds().empty());
    EXPECT_FALSE(scene().seeds().taken());
}

}  // namespace
}  // namespace hepatica
