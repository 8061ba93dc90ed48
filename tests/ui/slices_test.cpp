// SPDX-License-Identifier: GPL-3.0-or-later
// Slices of the CT beside the vessels, in a window with a fake simulation and a CT of a few voxels.
#include "tests/ui/slices_test.h"
#include "ui/lesson_dock.h"
#include "ui/message_bar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QToolButton>

namespace hepatica {
namespace {

constexpr std::array directions{SliceDirection::axial, SliceDirection::coronal,
                                SliceDirection::sagittal};

class Slices : public testing::SlicesTest {};

TEST_F(Slices, AreReadWhenSomebodyWantsToSeeThem) {
    views().show_patient(patient_, {}, file_);
    QTest::qWait(0);
    EXPECT_TRUE(scene().empty());
    for (const SliceDirection direction : directions) EXPECT_FALSE(view(direction).isVisible());
    QTest::keyClick(&window_, Qt::Key_F7);
    ASSERT_TRUE(testing::wait_for([this] { return !scene().empty(); }));
    EXPECT_EQ(scene().ct().voxels, ct_.voxels);
    for (const SliceDirection direction : directions) EXPECT_TRUE(view(direction).isVisible());
    EXPECT_TRUE(window_.view().isVisible());
    QTest::keyClick(&window_, Qt::Key_F7);
    for (const SliceDirection direction : directions) EXPECT_FALSE(view(direction).isVisible());
}

TEST_F(Slices, BeginWhereTheWidestVesselIs) {
    show_slices();
    EXPECT_EQ(scene().crosshair_mm(), Vec3(0, 0, 30));
    EXPECT_TRUE(scene().describe(Vec3(-12.5, 0, 30)).starts_with("R 12.5  P 0.0  H 30.0 mm   "));
    EXPECT_NE(scene().describe(Vec3(0, 0, 30)).find("portal vein, radius 5.0 mm"),
              std::string::npos);
    EXPECT_EQ(scene().describe(Vec3(500, 0, 0)), "") << "outside of the CT";
}

TEST_F(Slices, AClickTakesTheCrosshairThereInAllOfThem) {
    show_slices();
    for (const SliceDirection direction : directions) {
        SliceView& slice = view(direction);
        const Vec3 wanted = slice.to_mm(QPointF(slice.rect().center()) + QPointF(9, -7));
        QTest::mouseClick(&slice, Qt::LeftButton, {}, slice.rect().center() + QPoint(9, -7));
        EXPECT_LT((scene().crosshair_mm() - wanted).norm(), 0.5 * std::sqrt(2.0) * 3.0);
        for (const SliceDirection other : directions) {
            const QPointF there = view(other).place_of(scene().crosshair_mm());
            EXPECT_TRUE(QRectF(view(other).rect()).contains(there));
        }
    }
}

// The value of a voxel tells which one is painted.
TEST_F(Slices, PaintTheVoxelsThroughTheCrosshair) {
    show_slices();
    scene().set_opacity(0.0);
    scene().set_window({450.0, 900.0});
    const Vec3 place = ct_.grid.to_mm(12, 33, 41);
    scene().set_crosshair(place);
    const double value = ct_.at(12, 33, 41);
    for (const SliceDirection direction : directions) {
        const SliceStack stack(ct_.grid, direction);
        const Vec3 at = stack.place_of(place);
        const QRgb pixel = view(direction).picture().pixel(static_cast<int>(std::lround(at.x())),
                                                           static_cast<int>(std::lround(at.y())));
        EXPECT_NEAR(qRed(pixel), 255.0 * value / 900.0, 1.0);
        EXPECT_EQ(view(direction).slice(), std::lround(at.z()));
    }
}

TEST_F(Slices, ShowTheVesselsVoxelsAsOpaqueAsAskedFor) {
    show_slices();
    scene().set_crosshair(ct_.grid.to_mm(20, 25, 30));
    const auto pixel = [&] { return view(SliceDirection::axial).picture().pixel(20, 25); };
    auto* opacity = window_.findChild<QSlider*>("vesselOpacity");
    opacity->setValue(0);
    EXPECT_EQ(qRed(pixel()), qBlue(pixel()));
    opacity->setValue(100);
    EXPECT_GT(qBlue(pixel()), qRed(pixel())) << "the portal vein is violet-blue";
}

TEST_F(Slices, WheelAndKeysGoFromSliceToSlice) {
    show_slices();
    scene().set_crosshair(ct_.grid.to_mm(20, 25, 30));
    SliceView& axial = view(SliceDirection::axial);
    turn_wheel(axial, 2);
    EXPECT_EQ(axial.slice(), 32);
    turn_wheel(axial, -1, Qt::ShiftModifier);
    EXPECT_EQ(axial.slice(), 22);
    QTest::keyClick(&axial, Qt::Key_PageUp);
    EXPECT_EQ(axial.slice(), 23);
    turn_wheel(axial, 1000);
    EXPECT_EQ(axial.slice(), 59) << "the last one";
    QTest::keyClick(&axial, Qt::Key_Right);
    EXPECT_EQ(view(SliceDirection::sagittal).slice(), 21);
    QTest::keyClick(&axial, Qt::Key_Up);
    EXPECT_EQ(view(SliceDirection::coronal).slice(), 24);
}

TEST_F(Slices, ARightDragSetsTheGreyWindowAndPresetsFollow) {
    show_slices();
    auto* presets = window_.findChild<QComboBox*>("greyWindow");
    EXPECT_EQ(presets->currentIndex(), 0);
    const GreyWindow before = scene().window();
    SliceView& axial = view(SliceDirection::axial);
    const QPoint from = axial.rect().center();
    QTest::mousePress(&axial, Qt::RightButton, {}, from);
    const QPointF to(from + QPoint(10, -5));
    QMouseEvent move(QEvent::MouseMove, to, axial.mapToGlobal(to), Qt::NoButton, Qt::RightButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&axial, &move);
    EXPECT_EQ(scene().window().width_hu, before.width_hu + 20.0);
    EXPECT_EQ(scene().window().level_hu, before.level_hu - 10.0);
    EXPECT_EQ(presets->currentText(), "Own");
    // Qt would hold it as pressed in all tests after this one.
    QTest::mouseRelease(&axial, Qt::RightButton, {}, from + QPoint(10, -5));
    emit presets->activated(4);
    EXPECT_EQ(scene().window().width_hu, 1800.0);
}

// Its first click leads the crosshair away for a moment, which was not meant.
TEST_F(Slices, ADoubleClickEnlargesOneAndComesBack) {
    show_slices();
    SliceView& sagittal = view(SliceDirection::sagittal);
    const int before = sagittal.width();
    const Vec3 crosshair = scene().crosshair_mm();
    const auto off_centre = [&] { return sagittal.rect().center() + QPoint(20, 30); };
    QTest::mouseClick(&sagittal, Qt::LeftButton, {}, off_centre());
    EXPECT_GT((scene().crosshair_mm() - crosshair).norm(), 1.0) << "the first click";
    QTest::mouseDClick(&sagittal, Qt::LeftButton, {}, off_centre());
    EXPECT_LT((scene().crosshair_mm() - crosshair).norm(), 1e-9);
    EXPECT_FALSE(view(SliceDirection::axial).isVisible());
    EXPECT_FALSE(window_.view().isVisible());
    ASSERT_TRUE(testing::wait_for([&] { return sagittal.width() > 1.5 * before; }));
    QTest::mouseClick(&sagittal, Qt::LeftButton, {}, off_centre());
    EXPECT_GT((scene().crosshair_mm() - crosshair).norm(), 1.0) << "the first click";
    QTest::mouseDClick(&sagittal, Qt::LeftButton, {}, off_centre());
    EXPECT_LT((scene().crosshair_mm() - crosshair).norm(), 1e-9);
    EXPECT_TRUE(view(SliceDirection::axial).isVisible());
    EXPECT_TRUE(window_.view().isVisible());
}

TEST_F(Slices, ZoomAndPanKeepThePlaceUnderTheMouse) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    const QPointF middle(axial.rect().center());
    const Vec3 there = axial.to_mm(middle);
    turn_wheel(axial, 4, Qt::ControlModifier);
    EXPECT_LT((axial.to_mm(middle) - there).norm(), 1e-9);
    EXPECT_EQ(axial.slice(), view(SliceDirection::axial).slice());
    const Vec3 near = axial.to_mm(middle + QPointF(10, 0));
    turn_wheel(axial, 4, Qt::ControlModifier);
    EXPECT_LT((axial.to_mm(middle + QPointF(10, 0)) - there).norm(), (near - there).norm());
}

TEST_F(Slices, LeaveRoomForALessonOnASmallScreen) {
    show_slices();
    window_.lessons().show();
    for (const int purpose : {0, 1, 4, 5, 6}) {
        emit window_.findChild<QComboBox*>("measure")->activated(purpose);
        QApplication::processEvents();
        EXPECT_LE(window_.minimumSizeHint().width(), 1280) << purpose;
    }
}

TEST_F(Slices, SayWhatTheNextClickDoesWhileTheMouseMoves) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    auto* said = window_.findChild<QLabel*>("slicePlace");
    emit window_.findChild<QComboBox*>("measure")->activated(4);
    EXPECT_TRUE(said->text().startsWith("Click where the missing vessel begins"));
    const QPointF middle = axial.rect().center();
    QMouseEvent move(QEvent::MouseMove, middle, axial.mapToGlobal(middle), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&axial, &move);
    EXPECT_TRUE(said->text().startsWith("Click where the missing vessel begins"));
    EXPECT_TRUE(said->text().contains("HU")) << "what lies there stands below";
    QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center());
    EXPECT_TRUE(said->text().startsWith("Click on along the vessel"));
    QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() + QPoint(9, 4));
    EXPECT_TRUE(said->text().contains("draw it (Enter). Delete or Ctrl+Z: one back. Esc: all"));
    emit window_.findChild<QComboBox*>("measure")->activated(0);
    QApplication::sendEvent(&axial, &move);
    EXPECT_FALSE(said->text().contains("Click"));
}

TEST_F(Slices, StandInThePictureThatIsSaved) {
    const QString alone = folder_.filePath("alone.png"), all = folder_.filePath("all.png");
    window_.save_picture(alone);
    show_slices();
    window_.save_picture(all);
    const QImage with_slices(all);
    const double ratio = window_.devicePixelRatioF();
    EXPECT_EQ(with_slices.size(), (QSizeF(views().pictures().size()) * ratio).toSize());
    for (const SliceDirection direction :
         {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal}) {
        SliceView& slice = view(direction);
        const QImage there = slice.grab().toImage().convertToFormat(QImage::Format_RGB32);
        const QRect place((QPointF(slice.pos()) * ratio).toPoint(), there.size());
        EXPECT_EQ(with_slices.copy(place).convertToFormat(QImage::Format_RGB32), there);
    }
    // The vessels, too, in their quarter.
    const QRect place((QPointF(window_.view().pos()) * ratio).toPoint(),
                      window_.view().picture().size());
    const QImage vessels = with_slices.copy(place);
    const QColor empty = vessels.pixelColor(2, vessels.height() / 2);
    EXPECT_NE(vessels.pixelColor(vessels.rect().center()), empty);
    QTest::keyClick(&window_, Qt::Key_F7);
    const QString again = folder_.filePath("again.png");
    EXPECT_TRUE(testing::wait_for([&] {
        window_.save_picture(again);
        return QImage(again).size() == QImage(alone).size();
    })) << "the view alone";
}

TEST_F(Slices, MeasureDistancesAndAnglesWhereOneClicks) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    auto* choice = window_.findChild<QComboBox*>("measure");
    const Vec3 crosshair = scene().crosshair_mm();
    const QPoint middle = axial.rect().center();
    const auto click = [&](int x, int y) {
        QTest::mouseClick(&axial, Qt::LeftButton, {}, middle + QPoint(x, y));
    };
    emit choice->activated(1);
    EXPECT_EQ(choice->currentText(), "Distance");
    click(-30, 10);
    ASSERT_NE(scene().measurements().half_made(), nullptr);
    click(30, 10);
    EXPECT_EQ(scene().measurements().half_made(), nullptr);
    ASSERT_EQ(scene().measurements().made().size(), 1u);
    const double wide =
        (axial.to_mm(middle + QPoint(30, 10)) - axial.to_mm(middle + QPoint(-30, 10))).norm();
    EXPECT_EQ(scene().measurements().made()[0].text,
              QString("%1 mm").arg(wide, 0, 'f', 1).toStdString());
    EXPECT_EQ(scene().crosshair_mm(), crosshair) << "a click measured, and did nothing else";
    emit choice->activated(2);
    click(-20, 0);
    click(-20, 20);
    click(0, 20);
    ASSERT_EQ(scene().measurements().made().size(), 2u);
    EXPECT_EQ(scene().measurements().made()[1].text, "90\u00b0");
    click(0, 0);
    QTest::mouseDClick(&axial, Qt::LeftButton, {}, middle);
    ASSERT_NE(scene().measurements().half_made(), nullptr);
    EXPECT_EQ(scene().measurements().half_made()->points_mm.size(), 1u);
    QTest::keyClick(&axial, Qt::Key_Delete);  // what was half made
    QTest::keyClick(&axial, Qt::Key_Delete);
    EXPECT_EQ(scene().measurements().made().size(), 1u);
    QTest::keyClick(&axial, Qt::Key_Delete, Qt::ControlModifier);  // not ours
    EXPECT_EQ(scene().measurements().made().size(), 1u);
    QTest::keyClick(&axial, Qt::Key_Escape);
    EXPECT_EQ(choice->currentText(), "Crosshair");
    click(-20, 0);
    EXPECT_NE(scene().crosshair_mm(), crosshair);
}

TEST_F(Slices, TakePlacesOfAVesselThatIsDrawn) {
    show_slices();
    SliceView& axial = view(SliceDirection::axial);
    SliceView& coronal = view(SliceDirection::coronal);
    auto* choice = window_.findChild<QComboBox*>("measure");
    auto* button = window_.findChild<QPushButton*>("drawVessel");
    auto* said = window_.findChild<QLabel*>("slicePlace");
    VesselPen& pen = scene().pen();
    EXPECT_FALSE(button->isVisible());
    emit choice->activated(4);
    EXPECT_EQ(choice->currentText(), "Draw a vessel");
    EXPECT_TRUE(button->isVisible());
    EXPECT_FALSE(button->isEnabled());
    QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() + QPoint(8, 5));
    ASSERT_EQ(pen.places_mm().size(), 1u);
    EXPECT_EQ(scene().crosshair_mm(), pen.places_mm()[0]) << "the other slices follow";
    QTest::keyClick(&axial, Qt::Key_Return);
    EXPECT_TRUE(said->text().contains("two places"));
    const QPoint far = coronal.place_of(pen.places_mm()[0] - Vec3(0, 0, 60)).toPoint();
    QTest::mouseClick(&coronal, Qt::LeftButton, {}, far);
    QTest::mouseDClick(&coronal, Qt::LeftButton, {}, far);
    ASSERT_EQ(pen.places_mm().size(), 2u);
    EXPECT_TRUE(button->isEnabled());
    // What cannot be drawn stays to be changed.
    QTest::keyClick(&coronal, Qt::Key_Return);
    EXPECT_TRUE(said->text().startsWith("Not drawn: why stands above"))
        << said->text().toStdString();
    EXPECT_TRUE(window_.messages().text().contains("more than 50 mm apart")) << "in full";
    EXPECT_EQ(pen.places_mm().size(), 2u);
    // By keys alone: the arrows lead, Enter sets a place.
    QTest::keyClick(&coronal, Qt::Key_Right);
    QTest::keyClick(&coronal, Qt::Key_Return);
    EXPECT_EQ(pen.places_mm().size(), 3u);
    QTest::keyClick(&coronal, Qt::Key_Delete);
    EXPECT_EQ(pen.places_mm().size(), 2u);
    QTest::keyClick(&coronal, Qt::Key_Escape);
    EXPECT_TRUE(pen.places_mm().empty());
    EXPECT_EQ(choice->currentText(), "Draw a vessel");
    QTest::keyClick(&coronal, Qt::Key_Escape);
    EXPECT_EQ(choice->currentText(), "Crosshair");
    EXPECT_FALSE(button->isVisible());
    // Measuring puts it away, and another patient does.
    emit choice->activated(4);
    emit choice->activated(1);
    EXPECT_FALSE(pen.taken());
    emit choice->activated(4);
    views().clear();
    EXPECT_FALSE(pen.taken());
}

TEST_F(Slices, MeasureTheDiameterAtTheCentreline) {
    show_slices();
    SliceView& coronal = view(SliceDirection::coronal);
    emit window_.findChild<QComboBox*>("measure")->activated(3);
    scene().set_crosshair(Vec3(1, 0, 0));  // beside the middle of a vessel of 8 to 10 mm along z
    QTest::keyClick(&coronal, Qt::Key_Return);
    ASSERT_EQ(scene().measurements().made().size(), 1u);
    const Measurement& diameter = scene().measurements().made()[0];
    EXPECT_EQ(diameter.text, "\u2300 9.0 mm, stenosis 0 %") << "it tapers evenly";
    EXPECT_LT((diameter.points_mm[0] + diameter.points_mm[1]).norm(), 1e-9)
        << "about the centreline";
    EXPECT_NEAR(std::abs((diameter.points_mm[1] - diameter.points_mm[0]).x()), 9.0, 1e-9);
    EXPECT_TRUE(window_.findChild<QLabel*>("slicePlace")->text().contains("9.0 mm"));
    // The vessel runs through the axial slices: there it is measured to the right.
    QTest::keyClick(&view(SliceDirection::axial), Qt::Key_Return);
    ASSERT_EQ(scene().measurements().made().size(), 2u);
    const auto& across = scene().measurements().made()[1].points_mm;
    EXPECT_NEAR(std::abs((across[1] - across[0]).x()), 9.0, 1e-9);
    QTest::keyClick(&coronal, Qt::Key_Delete);
    scene().set_crosshair(Vec3(40, 0, 0));
    QTest::keyClick(&coronal, Qt::Key_Return);
    EXPECT_EQ(scene().measurements().made().size(), 1u);
    EXPECT_TRUE(window_.findChild<QLabel*>("slicePlace")->text().contains("no vessel"));
    const auto with_radii = [this](double first_mm, double last_mm) {
        auto corrected = std::make_shared<PatientCase>(*patient_);
        corrected->tree.segments[0].radii_mm = {first_mm, last_mm};
        return views().show_corrected(corrected);
    };
    EXPECT_EQ(with_radii(4.0, 4.0), 0u);
    ASSERT_EQ(scene().measurements().made().size(), 1u);
    EXPECT_EQ(scene().measurements().made()[0].text, "\u2300 8.0 mm, stenosis 0 %")
        << "it is that of the vessels as they are now";
    auto gone = std::make_shared<PatientCase>(*patient_);
    for (Vec3& point : gone->tree.segments[0].points_mm) point.x() += 40.0;
    EXPECT_EQ(views().show_corrected(gone), 1u);
    EXPECT_TRUE(scene().measurements().made().empty()) << "there is no vessel any more";
    EXPECT_EQ(with_radii(4.0, 5.0), 0u);
    ASSERT_EQ(scene().measurements().made().size(), 1u);
    EXPECT_EQ(scene().measurements().made()[0].text, "\u2300 9.0 mm, stenosis 0 %");
    views().clear();
    EXPECT_TRUE(scene().measurements().made().empty()) << "they were another patient's";
}

// A case keeps no path; the window's own settings know it, and nobody else.
TEST_F(Slices, OfACaseThatIsOpenedAgainAreFound) {
    show_slices();
    views().clear();
    EXPECT_TRUE(scene().empty());
    views().show_patient(patient_, {}, {});
    EXPECT_TRUE(testing::wait_for([this] { return !scene().empty(); }));
}

// Somebody may be painting: what comes and goes by itself lies over the pictures.
TEST_F(Slices, StayWhereTheyAreWhileMessagesComeAndGo) {
    show_slices();
    auto* progress = window_.findChild<QWidget*>("progressStrip");
    const auto places = [this] {
        QApplication::processEvents();
        std::vector<QRect> rectangles;
        for (const QWidget* shown : {static_cast<QWidget*>(&view(SliceDirection::axial)),
                                     static_cast<QWidget*>(&window_.view())})
            rectangles.emplace_back(shown->mapToGlobal(QPoint()), shown->size());
        return rectangles;
    };
    const auto before = places();
    MessageBar& messages = window_.messages();
    messages.show_notice("A word");
    progress->show();
    EXPECT_EQ(places(), before);
    const QWidget& pictures = views().pictures();
    EXPECT_EQ(messages.geometry().topLeft(), QPoint(0, 0));
    EXPECT_EQ(messages.width(), pictures.width());
    EXPECT_EQ(progress->mapToGlobal(progress->rect().bottomRight()),
              pictures.mapToGlobal(pictures.rect().bottomRight()));
    const int one_line = messages.height();
    messages.show_notice(QString("many words ").repeated(60));
    EXPECT_EQ(places(), before);
    EXPECT_EQ(messages.height(), one_line);
    messages.findChild<QToolButton*>("moreOfMessage")->click();
    EXPECT_EQ(places(), before);
    EXPECT_GT(messages.height(), one_line) << "they wrap";
    window_.resize(window_.width() - 100, window_.height());
    QApplication::processEvents();
    EXPECT_EQ(messages.width(), pictures.width());
    window_.resize(window_.width() + 100, window_.height());
    messages.dismiss();
    progress->hide();
    EXPECT_EQ(places(), before);
}

// Every letter has something dark on all sides of it.
TEST_F(Slices, WriteWordsThatCanBeReadOnWhiteBone) {
    show_slices();
    scene().set_window({-5000.0, 10.0});  // everything is white
    SliceView& axial = view(SliceDirection::axial);
    ASSERT_TRUE(testing::wait_for([&] { return axial.width() > 200; }));  // its final place
    turn_wheel(axial, 8, Qt::ControlModifier);                            // up to the view's edges
    const QImage shown = axial.grab(QRect(2, 2, 70, 30)).toImage();
    int letters = 0;
    const auto expect_dark_around = [&](int count, const auto& pixel_at) {
        int begin = -1, end = -1, dark_begin = -1, dark_end = -1;
        for (int i = 0; i < count; ++i) {
            const QRgb pixel = pixel_at(i);
            if (qBlue(pixel) - qRed(pixel) > 6 && qRed(pixel) > 200) {  // as letters are
                begin = begin < 0 ? i : begin;
                end = i;
            } else if (qGray(pixel) < 60) {
                dark_begin = dark_begin < 0 ? i : dark_begin;
                dark_end = i;
            }
        }
        if (begin < 0) return;
        ++letters;
        EXPECT_GE(dark_begin, 0);
        EXPECT_LT(dark_begin, begin);
        EXPECT_GT(dark_end, end);
    };
    EXPECT_EQ(shown.pixel(shown.width() - 1, shown.height() - 1), qRgb(255, 255, 255));
    for (int y = 0; y < shown.height(); ++y)
        expect_dark_around(shown.width(), [&](int x) { return shown.pixel(x, y); });
    for (int x = 0; x < shown.width(); ++x)
        expect_dark_around(shown.height(), [&](int y) { return shown.pixel(x, y); });
    EXPECT_GT(letters, 20);
}

TEST(SliceAlone, CorrectsNothingByKeyWhereNobodyReceivesIt) {
    SliceScene scene;
    scene.show(std::make_shared<const Volume>(testing::numbered_ct()), {}, {});
    SliceView view(scene, SliceDirection::axial);
    const auto press = [&view] {
        QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QApplication::sendEvent(&view, &enter);
    };
    scene.set_corrects(true);
    EXPECT_NO_THROW(press());
    std::optional<Vec3> corrected;
    view.on_correct([&](const Vec3& place) { corrected = place; });
    press();
    EXPECT_EQ(corrected, scene.crosshair_mm());
}

// What a click was for is not said any more once it only moves the crosshair again.
TEST_F(Slices, TheBarSaysWhatAClickDoesNow) {
    show_slices();
    auto* choice = window_.findChild<QComboBox*>("measure");
    const auto* place = window_.findChild<QLabel*>("slicePlace");
    emit choice->activated(3);
    EXPECT_TRUE(place->text().contains("Click on a vessel"));
    emit choice->activated(0);
    EXPECT_FALSE(place->text().contains("Click")) << place->text().toStdString();
    EXPECT_TRUE(place->text().contains("HU"));
    EXPECT_EQ(place->toolTip(), "");
    // Measuring ends with it, and the foot does not say what the mouse does in the view meanwhile.
    emit choice->activated(1);
    EXPECT_FALSE(window_.statusBar()->currentMessage().isEmpty());
    emit choice->activated(4);
    EXPECT_EQ(choice->currentText(), "Draw a vessel");
    EXPECT_EQ(window_.statusBar()->currentMessage(), "");
}

// What is said over the pictures covers none of the words in them.
TEST_F(Slices, KeepTheirWordsClearOfTheBarsOverThem) {
    show_slices();
    auto& axial = view(SliceDirection::axial);
    auto& coronal = view(SliceDirection::coronal);
    QCoreApplication::processEvents();
    const QRectF before = axial.room_for_words();
    const double below = coronal.room_for_words().top();
    window_.messages().show_notice("a word");
    QCoreApplication::processEvents();
    const auto covers = [this](const SliceView& slice) {
        const MessageBar& bar = window_.messages();
        return QRectF(QRect(slice.mapFromGlobal(bar.mapToGlobal(QPoint())), bar.size()))
            .intersects(slice.room_for_words());
    };
    EXPECT_FALSE(covers(axial));
    EXPECT_LT(axial.room_for_words().height(), before.height());
    EXPECT_EQ(coronal.room_for_words().top(), below) << "the bar is above";
    window_.messages().dismiss();
    EXPECT_EQ(axial.room_for_words(), before);
}

}  // namespace
}  // namespace hepatica
