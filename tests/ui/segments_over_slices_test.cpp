// SPDX-License-Identifier: GPL-3.0-or-later
// Couinaud's segments over the slices of the CT: when they can be chosen, what is painted, and what
// is said of the place under the mouse.
#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <algorithm>
#include <set>

#include "core/image/volume_writer.h"
#include "core/patient/image_digest.h"
#include "render/palette.h"
#include "tests/ui/fake_window_test.h"
#include "ui/paths.h"
#include "ui/slices/segment_overlay.h"
#include "ui/slices/slice_view.h"
#include "ui/slices/view_layout.h"

namespace hepatica {
namespace {

QColor over(int grey, const Colour& tint, double opacity) {
    const auto channel = [&](std::size_t c) {
        return static_cast<int>((1.0 - opacity) * grey + opacity * 255.0 * tint[c]);
    };
    return QColor(channel(0), channel(1), channel(2));
}

// Five by five pixels of segment 4, beside one column of segment 7 at the right.
TEST(SegmentOverlay, TintsTheInsideThinlyAndTheBorderFirmly) {
    QImage picture(8, 7, QImage::Format_RGB32);
    picture.fill(QColor(100, 100, 100));
    std::vector<std::uint8_t> labels(8 * 7, 0);
    for (int row = 1; row <= 5; ++row) {
        for (int column = 1; column <= 5; ++column) labels[row * 8 + column] = 4;
        labels[row * 8 + 6] = 7;
    }
    lay_segments(picture, labels);
    const Colour four = palette::liver_segment(4), seven = palette::liver_segment(7);
    EXPECT_EQ(picture.pixelColor(0, 0), QColor(100, 100, 100)) << "no liver";
    EXPECT_EQ(picture.pixelColor(3, 3), over(100, four, segment_opacity));
    for (const QPoint& edge : {QPoint(1, 3), QPoint(5, 3), QPoint(3, 1), QPoint(3, 5)})
        EXPECT_EQ(picture.pixelColor(edge), over(100, four, segment_border_opacity))
            << edge.x() << " " << edge.y();
    EXPECT_EQ(picture.pixelColor(6, 3), over(100, seven, segment_border_opacity));
}

TEST(SegmentOverlay, WritesNumbersLightEnoughForTheirDarkOutline) {
    for (int segment = 1; segment <= 8; ++segment) {
        const Colour number = colour_of_number(segment);
        EXPECT_GE(*std::ranges::min_element(number), 0.6) << segment;
    }
}

// A ring's middle is not in it.
TEST(SegmentOverlay, WritesNumbersWellInsideAndOnlyWhereThereIsRoom) {
    std::vector<std::uint8_t> labels(20 * 20, 0);
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column)
            if (row < 3 || row > 5 || column < 3 || column > 5) labels[row * 20 + column] = 8;
    for (int row = 10; row < 15; ++row)
        for (int column = 10; column < 17; ++column) labels[row * 20 + column] = 2;
    labels[19 * 20 + 19] = 5;
    const std::vector<SegmentNumber> numbers = segment_numbers(labels, 20, 30);
    ASSERT_EQ(numbers.size(), 2u) << "segment 5 is too small";
    EXPECT_EQ(numbers[0].segment, 2);
    EXPECT_EQ(numbers[0].pixel, QPoint(13, 12));
    EXPECT_EQ(numbers[0].pixels, 35);
    EXPECT_EQ(numbers[1].segment, 8);
    EXPECT_EQ(labels[static_cast<std::size_t>(numbers[1].pixel.y() * 20 + numbers[1].pixel.x())],
              8);
}

class SegmentsOverSlices : public testing::FakeWindowTest {
  protected:
    SegmentsOverSlices() : file_(to_path(folder_.filePath("ct.nii.gz"))) {
        ct_.grid.dims = {40, 50, 60};
        ct_.grid.spacing_mm = Vec3(3, 3, 3);
        ct_.grid.origin_mm = Vec3(-60, -75, -90);
        ct_.voxels.assign(40 * 50 * 60, 100);  // the middle of the first grey window
        ct_.voxels[0] = 0;
        write_nifti(file_, ct_);
        open_built_in();
    }
    // The right half is segment 6, the left half 3; on a grid twice as coarse, and smaller.
    Mask halves(std::uint8_t right, std::uint8_t left) const {
        Grid grid;
        grid.dims = {16, 25, 30};
        grid.spacing_mm = Vec3(6, 6, 6);
        grid.origin_mm = Vec3(-46.5, -73.5, -88.5);
        Mask segments(grid);
        for (int z = 0; z < 30; ++z)
            for (int y = 0; y < 25; ++y)
                for (int x = 0; x < 16; ++x) segments.at(x, y, z) = x < 8 ? right : left;
        return segments;
    }
    std::shared_ptr<PatientCase> patient(Mask segments) const {
        auto made = std::make_shared<PatientCase>();
        made->source.image_sha256 = digest_of(ct_);
        made->source.image_grid = ct_.grid;
        made->mask = Mask(ct_.grid);
        made->mask.voxels[ct_.grid.offset(10, 25, 30)] = 1;
        made->couinaud = std::move(segments);
        return made;
    }
    void show(std::shared_ptr<const PatientCase> shown) {
        window_.view_layout().show_patient(std::move(shown), {}, file_);
        if (!window_.view_layout().slices_visible()) QTest::keyClick(&window_, Qt::Key_F7);
        ASSERT_TRUE(testing::wait_for(
            [this] { return !scene().empty() && !choice().toolTip().contains("being read"); }));
    }
    SliceScene& scene() { return window_.view_layout().slices(); }
    SliceView& axial() { return window_.view_layout().slice_view(SliceDirection::axial); }
    QCheckBox& choice() { return *window_.findChild<QCheckBox*>("segments"); }
    QColor pixel(int column, int row) { return axial().picture().pixelColor(column, row); }

    Volume ct_;
    const std::filesystem::path file_;
};

TEST_F(SegmentsOverSlices, CannotBeChosenWhereTheCaseHasNone) {
    show(patient({}));
    EXPECT_TRUE(choice().toolTip().contains("liver mask and a portal vein"))
        << choice().toolTip().toStdString();
    QTest::mouseClick(&choice(), Qt::LeftButton, {}, QPoint(8, choice().height() / 2));
    EXPECT_FALSE(choice().isChecked());
    EXPECT_TRUE(window_.findChild<QLabel*>("slicePlace")->text().contains("liver mask"))
        << "says why where it is seen";
    EXPECT_FALSE(scene().shows_segments());
    EXPECT_EQ(scene().describe(Vec3(0, 0, 0)).find("segment"), std::string::npos);
}

TEST_F(SegmentsOverSlices, AreDrawnWhereAskedForBelowTheVessels) {
    show(patient(halves(6, 3)));
    scene().set_crosshair(ct_.grid.to_mm(10, 25, 30));
    const int plain = pixel(15, 20).red();
    EXPECT_EQ(pixel(15, 20), QColor(plain, plain, plain)) << "not asked for";
    QTest::mouseClick(&choice(), Qt::LeftButton, {}, QPoint(8, choice().height() / 2));
    ASSERT_TRUE(scene().shows_segments());
    EXPECT_EQ(pixel(15, 20), over(plain, palette::liver_segment(6), segment_opacity));
    EXPECT_EQ(pixel(30, 20), over(plain, palette::liver_segment(3), segment_opacity));
    EXPECT_EQ(pixel(1, 20), QColor(plain, plain, plain)) << "beside the liver";
    window_.findChild<QSlider*>("vesselOpacity")->setValue(100);
    const Colour portal = palette::vessel_system(VascularSystem::portal);
    EXPECT_EQ(pixel(10, 25), over(plain, portal, 1.0)) << "the vessel lies over its segment";
    QTest::mouseClick(&choice(), Qt::LeftButton, {}, QPoint(8, choice().height() / 2));
    EXPECT_EQ(pixel(15, 20), QColor(plain, plain, plain));
}

TEST_F(SegmentsOverSlices, AreNamedUnderTheMouse) {
    show(patient(halves(6, 3)));
    scene().set_crosshair(Vec3(0, 0, 0));
    const auto said_at = [this](const Vec3& place) {
        QTest::mouseMove(&axial(), axial().place_of(place).toPoint());
        const QPointF at = axial().place_of(place).toPoint();
        QMouseEvent move(QEvent::MouseMove, at, axial().mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&axial(), &move);
        return window_.findChild<QLabel*>("slicePlace")->text();
    };
    EXPECT_TRUE(said_at(Vec3(-30, 0, 0)).contains("segment VI"))
        << said_at(Vec3(-30, 0, 0)).toStdString();
    EXPECT_TRUE(said_at(Vec3(30, 0, 0)).contains("segment III"));
    EXPECT_FALSE(said_at(Vec3(-57, 0, 0)).contains("segment")) << "beside the liver";
    EXPECT_TRUE(said_at(Vec3(-57, 0, 0)).contains("HU"));
}

// As in the table of branches, which leaves the trunk's segment empty.
TEST_F(SegmentsOverSlices, AreNotNamedInTheTrunkThatSuppliesSeveral) {
    const auto shown = patient(halves(6, 3));
    const auto add = [&](int parent, const Vec3& from, const Vec3& to) {
        VesselSegment segment;
        segment.parent = parent;
        segment.system = VascularSystem::portal;
        segment.points_mm = {from, 0.5 * (from + to), to};
        segment.radii_mm = {5.0, 5.0, 5.0};
        shown->tree.segments.push_back(segment);
    };
    add(-1, Vec3(-20, 0, 0), Vec3(-10, 20, 0));
    add(0, Vec3(-10, 20, 0), Vec3(-30, 50, 0));
    add(0, Vec3(-10, 20, 0), Vec3(30, 50, 0));
    show(shown);
    const std::string trunk = scene().describe(Vec3(-15, 10, 0));
    EXPECT_NE(trunk.find("portal vein"), std::string::npos) << trunk;
    EXPECT_EQ(trunk.find("segment"), std::string::npos) << trunk;
    const std::string branch = scene().describe(Vec3(-30, 50, 0));
    EXPECT_NE(branch.find("segment VI"), std::string::npos) << branch;
}

// Stripes of 12 mm of which each is a segment, in a slice that is a few points high.
TEST_F(SegmentsOverSlices, HaveNumbersThatLieOnNoOtherAndInTheirOwnSegment) {
    Mask stripes = halves(0, 0);
    for (int z = 0; z < 30; ++z)
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 16; ++x) stripes.at(x, y, z) = static_cast<std::uint8_t>(1 + x / 2);
    show(patient(stripes));
    scene().set_segments_visible(true);
    scene().set_crosshair(ct_.grid.to_mm(10, 25, 30));
    std::set<std::size_t> counts;
    for (const int side : {60, 110, 200, 700}) {
        axial().resize(side, side);
        axial().grab();
        const auto& labels = axial().number_labels();
        ASSERT_FALSE(labels.empty()) << side;
        counts.insert(labels.size());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_EQ(scene().segment_at(axial().to_mm(labels[i].place.center())),
                      labels[i].segment)
                << side;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(labels[i].place.intersects(labels[k].place))
                    << side << ": " << labels[i].segment << " and " << labels[k].segment;
        }
    }
    EXPECT_EQ(*counts.rbegin(), 8u) << "all are there where there is room";
    EXPECT_LT(*counts.begin(), 8u);
    scene().set_segments_visible(false);
    axial().grab();
    EXPECT_TRUE(axial().number_labels().empty());
}

// Words that come and go with the mouse take the slices no room.
TEST_F(SegmentsOverSlices, AreNamedWithoutMovingOrWideningAnything) {
    show(patient(halves(6, 3)));
    auto* place = window_.findChild<QLabel*>("slicePlace");
    const auto least_width = [place] {
        QApplication::processEvents();  // a text that changes is laid out later
        return place->parentWidget()->minimumSizeHint().width();
    };
    place->setText("118 HU");
    const int least = least_width(), high = place->height();
    place->setText(QString("L 154.7  P 205.0  H 154.6 mm   159 HU   segment VIII   ") +
                   "portal vein, radius 13.8 mm");
    EXPECT_EQ(least_width(), least);
    EXPECT_EQ(place->height(), high);
}

TEST_F(SegmentsOverSlices, FollowACorrectedTreeAndGoWithTheirPatient) {
    show(patient(halves(6, 3)));
    scene().set_segments_visible(true);
    EXPECT_TRUE(scene().describe(Vec3(-30, 0, 0)).ends_with("liver segment VI"));
    window_.view_layout().show_corrected(patient(halves(5, 2)));
    EXPECT_FALSE(scene().shows_segments()) << "those of the tree before are not shown";
    EXPECT_TRUE(testing::wait_for(
        [this] { return scene().describe(Vec3(-30, 0, 0)).ends_with("segment V"); }));
    EXPECT_TRUE(scene().shows_segments());
    show(patient({}));
    EXPECT_FALSE(scene().shows_segments()) << "another patient, who has none";
}

}  // namespace
}  // namespace hepatica
