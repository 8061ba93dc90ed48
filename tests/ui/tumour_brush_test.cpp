// SPDX-License-Identifier: GPL-3.0-or-later
// Tumours painted and erased in the slices by mouse and keys.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QTabWidget>

#include "tests/patient/parted_patient.h"
#include "tests/ui/slices_test.h"
#include "ui/lesson_editor/lesson_editor.h"

namespace hepatica {
namespace {

using testing::wait_for;

constexpr int crosshair = 0, painting = 8, erasing = 9;

// Pixels that are as green as nothing but a tumour is.
int green_pixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            count += qGreen(pixel) > qRed(pixel) + 25 && qGreen(pixel) > qBlue(pixel) + 25;
        }
    return count;
}

// The brush of 4 mm in hand, over the axial slice through the middle, of a patient without a liver.
class TumourBrushOnSlices : public testing::SlicesTest {
  protected:
    void begin() {
        show_slices();
        wait_for_tumours();
        take(painting);
        window_.findChild<QDoubleSpinBox*>("brushRadius")->setValue(4.0);
        scene().set_crosshair(place(20));
    }
    void wait_for_tumours() {
        ASSERT_TRUE(wait_for(
            [this] { return views().tumours_shown() && !brush().organs().voxels.empty(); }));
    }
    void take(int purpose) { emit choice().activated(purpose); }
    void choose(int number) {
        auto& box = *window_.findChild<QComboBox*>("tumour");
        box.setCurrentIndex(box.findData(number));
        emit box.activated(box.currentIndex());
    }
    // From column to column, with the button held.
    void stroke(int from, int to) {
        QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(from));
        const QPointF end = pixel(to);
        QMouseEvent event(QEvent::MouseMove, end, axial().mapToGlobal(end), Qt::NoButton,
                          Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&axial(), &event);
        QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pixel(to));
    }
    void press(Qt::Key key) { QTest::keyClick(&axial(), key); }
    int tumour_in_column(int i) { return brush().tumour_at(place(i)); }
    std::vector<int> tumours() {
        std::vector<int> found;
        for (const Tumour& tumour : brush().tumours()) found.push_back(tumour.number);
        return found;
    }
    QStringList offered() {
        QStringList texts;
        auto& box = *window_.findChild<QComboBox*>("tumour");
        for (int i = 0; i < box.count(); ++i) texts << box.itemText(i);
        return texts;
    }
    bool said(const QString& words) {
        return window_.findChild<QLabel*>("slicePlace")->text().contains(words);
    }
    Vec3 place(int column) { return ct_.grid.to_mm(column, 25, 30); }
    const Workspace::Edits& edits() { return window_.workspace().edits(); }
    SliceView& axial() { return view(SliceDirection::axial); }
    const TumourBrush& brush() { return scene().tumours(); }
    QComboBox& choice() { return *window_.findChild<QComboBox*>("measure"); }
    QPoint pixel(int column) { return axial().place_of(place(column)).toPoint(); }
};

// What the mouse still leads.
TEST_F(TumourBrushOnSlices, DropsTheStrokeThatIsBeingLedAndNothingElse) {
    begin();
    stroke(8, 10);
    const Mask before = brush().organs();
    QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(20));
    EXPECT_NE(brush().organs().voxels, before.voxels);
    press(Qt::Key_Delete);
    EXPECT_EQ(brush().organs().voxels, before.voxels);
    QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pixel(20));
    EXPECT_EQ(edits().size(), 1u);
}

TEST_F(TumourBrushOnSlices, ShowsTheFirstTumourWhileItIsLed) {
    begin();
    const int plain = green_pixels(axial().grab().toImage());
    QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(20));
    EXPECT_GT(green_pixels(axial().grab().toImage()), plain + 20);
    QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pixel(20));
}

TEST_F(TumourBrushOnSlices, LeavesNoStrokeToTheNextPatient) {
    begin();
    QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(20));
    scene().clear();
    EXPECT_TRUE(edits().empty());
}

// A correction made since keeps the strokes before it; the brush can still be put away.
TEST_F(TumourBrushOnSlices, IsPutAwayWhereItsStrokesCannotBeTakenBack) {
    begin();
    stroke(8, 10);
    TumourBrush& own = scene().tumours();
    own.on_stroke({[](const TreeEdit&) {}, [](std::size_t) {}, [] {}});
    press(Qt::Key_Escape);
    EXPECT_EQ(own.mode(), BrushMode::away);
}

TEST_F(TumourBrushOnSlices, ShowsAtOnceWhatItPaintsAndThePlayGoesOn) {
    begin();
    const auto green_in_view = [this](bool annotated) {
        window_.view().scene().set_annotations_visible(annotated);
        window_.view().draw_again();
        paint();
        return green_pixels(window_.view().drawn());
    };
    const int before = green_in_view(false);
    EXPECT_EQ(green_pixels(axial().picture()), 0);
    const std::size_t commands = simulation_->commands().size();
    const testing::FakeSimulation* simulation = simulation_;
    stroke(10, 15);
    EXPECT_EQ(tumours(), std::vector{1});
    EXPECT_EQ(tumour_in_column(12), 1);
    EXPECT_EQ(tumour_in_column(18), 0);
    EXPECT_EQ(brush().tumour_at(ct_.grid.to_mm(12, 25, 31)), 1) << "a ball, not a disc";
    EXPECT_GT(green_pixels(axial().picture()), 10);
    EXPECT_TRUE(scene().describe(place(12)).find("tumour 1") != std::string::npos);
    ASSERT_TRUE(wait_for([this] { return views().tumours_shown(); }));
    const int surface = green_in_view(false);
    EXPECT_GT(surface, before + 50);
    EXPECT_GT(green_in_view(true), surface + 20) << "and in the legend";
    ASSERT_EQ(edits().size(), 1u);
    EXPECT_EQ(edits()[0].kind, TreeEditKind::paint_tumour);
    EXPECT_TRUE(window_.isWindowModified());
    EXPECT_FALSE(window_.busy()) << "no body is made";
    EXPECT_EQ(simulation_, simulation);
    EXPECT_EQ(simulation_->commands().size(), commands);
    EXPECT_FALSE(window_.findChild<QPushButton*>("rebuildVessels")->isVisible());
    const auto listed = window_.findChildren<QListWidget*>();
    EXPECT_TRUE(std::ranges::any_of(listed, [](const QListWidget* list) {
        return !list->findItems("Tumour 1 painted", Qt::MatchContains).isEmpty();
    })) << "among the corrections";
}

TEST_F(TumourBrushOnSlices, GoesOnWithATumourUntilANewOneIsChosen) {
    begin();
    EXPECT_EQ(offered(), (QStringList{"New tumour"}));
    stroke(5, 7);
    EXPECT_EQ(brush().chosen(), 1);
    stroke(10, 12);
    EXPECT_EQ(tumours(), std::vector{1});
    choose(0);
    stroke(25, 27);
    EXPECT_EQ(tumours(), (std::vector{1, 2}));
    EXPECT_EQ(offered(), (QStringList{"New tumour", "Tumour 1", "Tumour 2"}));
    EXPECT_EQ(tumour_in_column(11), 1);
    EXPECT_EQ(tumour_in_column(26), 2);
}

// The lesson's editor, opened before and after: each is the beginning of a target near it.
TEST_F(TumourBrushOnSlices, OffersWhatItPaintedAsTheTargetOfALesson) {
    begin();
    stroke(5, 7);
    LessonEditor& editor = window_.lesson_editor();
    editor.show_editor();
    editor.findChild<QTabWidget*>("lessonPages")->setCurrentIndex(1);
    const QMenu& offered = *editor.findChild<QPushButton*>("lessonTumour")->menu();
    ASSERT_EQ(offered.actions().size(), 1);
    EXPECT_TRUE(offered.actions()[0]->text().startsWith("Tumour 1 ("));
    choose(0);
    stroke(25, 27);
    ASSERT_TRUE(wait_for([&] { return offered.actions().size() == 2; }));
    EXPECT_TRUE(offered.actions()[1]->text().startsWith("Tumour 2 ("));
    ASSERT_FALSE(editor.document().lesson().target);
    offered.actions()[1]->trigger();
    EXPECT_TRUE(editor.document().lesson().target);
}

TEST_F(TumourBrushOnSlices, ErasesOneOrAnyAndTheOthersKeepTheirNumbers) {
    begin();
    stroke(5, 7);
    choose(0);
    stroke(25, 27);
    take(erasing);
    EXPECT_EQ(offered(), (QStringList{"Any tumour", "Tumour 1", "Tumour 2"}));
    choose(2);
    stroke(3, 9);
    EXPECT_EQ(tumours(), (std::vector{1, 2})) << "that was tumour 1";
    EXPECT_TRUE(said("Nothing erased"));
    EXPECT_EQ(edits().size(), 2u) << "what changes nothing is no correction";
    choose(0);
    stroke(3, 9);
    EXPECT_EQ(tumours(), std::vector{2});
    EXPECT_EQ(offered(), (QStringList{"Any tumour", "Tumour 2"}));
}

TEST_F(TumourBrushOnSlices, IsLedByKeysAndTakesBackWhatItPaintedSinceItWasTaken) {
    begin();
    press(Qt::Key_Return);
    EXPECT_EQ(tumour_in_column(20), 1);
    take(crosshair);
    take(painting);
    scene().set_crosshair(place(30));
    press(Qt::Key_Minus);
    EXPECT_EQ(window_.findChild<QDoubleSpinBox*>("brushRadius")->value(), 3.5);
    press(Qt::Key_Return);
    scene().set_crosshair(place(35));
    press(Qt::Key_Return);
    EXPECT_EQ(edits().size(), 3u);
    press(Qt::Key_Delete);
    EXPECT_EQ(edits().size(), 2u);
    EXPECT_EQ(tumour_in_column(35), 0);
    EXPECT_NE(tumour_in_column(30), 0);
    press(Qt::Key_Return);
    press(Qt::Key_Escape);
    EXPECT_EQ(edits().size(), 1u) << "all since it was taken";
    EXPECT_NE(tumour_in_column(20), 0);
    press(Qt::Key_Delete);
    EXPECT_EQ(edits().size(), 1u);
    press(Qt::Key_Escape);
    EXPECT_EQ(choice().currentText(), "Crosshair");
}

TEST_F(TumourBrushOnSlices, IsUndoneAndDoneAgainLikeEveryCorrection) {
    begin();
    stroke(10, 15);
    const Mask painted = brush().organs();
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_TRUE(tumours().empty());
    EXPECT_EQ(green_pixels(axial().picture()), 0);
    EXPECT_FALSE(window_.isWindowModified());
    window_.actions()[ActionId::redo_edit].trigger();
    EXPECT_EQ(brush().organs().voxels, painted.voxels);
    EXPECT_EQ(brush().chosen(), 1) << "the next stroke goes on with it again";
    stroke(15, 18);
    EXPECT_EQ(tumours(), std::vector{1});
    EXPECT_NE(brush().organs().voxels, painted.voxels);
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_EQ(brush().organs().voxels, painted.voxels);
}

TEST_F(TumourBrushOnSlices, GoesOnWithAnotherThatWasChosenSinceItWasTakenBack) {
    begin();
    stroke(5, 7);
    window_.actions()[ActionId::undo_edit].trigger();
    choose(0);
    window_.actions()[ActionId::redo_edit].trigger();
    EXPECT_EQ(brush().chosen(), 0);
}

// A case on disk with a liver, whose CT is known.
class TumoursOfACase : public testing::WindowTest {
  protected:
    TumoursOfACase()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          return request.built_in ? play(std::make_shared<const PatientCase>(
                                                             test::patient_with_bridges()),
                                                         job)
                                                  : load_patient(request, job);
                      },
                      write_case}) {
        const auto ct_file = to_path(folder_.filePath("ct.nii.gz"));
        Volume ct(Grid{{60, 60, 60}, Vec3::Ones(), Vec3(-20, 0, -30), Mat3::Identity()}, 60);
        write_nifti(ct_file, ct);
        PatientCase patient = test::patient_with_bridges();
        patient.source.image_sha256 = digest_of(ct);
        patient.source.image_grid = ct.grid;
        patient.mask = Mask(ct.grid);
        patient.mask.at(20, 20, 30) = 1;
        patient.organs = Mask(ct.grid, organ_label::liver);
        write_case(case_, patient);
        settings_.remember_image(patient.source.image_sha256, to_text(ct_file));
    }
    void open_case() {
        window_.open(to_text(case_));
        wait();
    }
    TumourBrush& brush() { return window_.view_layout().slices().tumours(); }
    void wait_for_tumours() {
        ASSERT_TRUE(wait_for([this] {
            return window_.view_layout().tumours_shown() && !brush().organs().voxels.empty();
        }));
    }

    const std::filesystem::path case_ = to_path(folder_.filePath("p.hep"));
};

TEST_F(TumoursOfACase, AreThereAgainWhenItIsSavedAndOpened) {
    open_case();
    window_.actions()[ActionId::toggle_slices].trigger();
    wait_for_tumours();
    brush().set_mode(BrushMode::paints);
    brush().begin(Vec3(10, 20, 10), 6.0);
    EXPECT_EQ(brush().lift(), "");
    const Mask painted = brush().organs();
    window_.save_case(to_text(case_));
    wait();
    EXPECT_FALSE(window_.isWindowModified());
    EXPECT_EQ(tumours_in(read_case(case_).organs).size(), 1u);

    open_built_in();
    EXPECT_TRUE(brush().tumours().empty());
    window_.actions()[ActionId::toggle_slices]
        .trigger();  // away: a tumour is shown in the view alone
    open_case();
    wait_for_tumours();
    EXPECT_EQ(brush().organs().voxels, painted.voxels);
    window_.view().scene().set_annotations_visible(false);
    window_.view().draw_again();
    paint();
    EXPECT_GT(green_pixels(window_.view().drawn()), 50);
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_TRUE(brush().tumours().empty()) << "also what an earlier session painted";
}

// The play goes on with its obstacles, here the liver, until a correction begins it anew.
TEST_F(TumoursOfACase, AreObstaclesOnceAVesselIsCorrected) {
    open_case();
    window_.actions()[ActionId::toggle_slices].trigger();
    wait_for_tumours();
    const auto touch_obstacles = [this] {
        auto& box = *window_.findChild<QCheckBox*>("obstaclesTouch");
        if (!box.isChecked()) box.click();
        ASSERT_TRUE(wait_for([this] { return window_.frame().obstacles != nullptr; }));
    };
    const auto paint_at = [this](const Vec3& at) {
        brush().set_mode(BrushMode::paints);
        brush().begin(at, 6.0);
        EXPECT_EQ(brush().lift(), "");
    };
    paint_at(Vec3(10, 20, 10));
    EXPECT_FALSE(window_.statusBar()->currentMessage().contains("become obstacles"))
        << "vessels touch none";
    touch_obstacles();
    EXPECT_EQ(window_.frame().obstacles->all.size(), 1u);
    paint_at(Vec3(10, 40, 10));
    EXPECT_TRUE(window_.statusBar()->currentMessage().contains("become obstacles"));
    const std::size_t edits = window_.workspace().edits().size();
    window_.findChild<QPushButton*>("acceptAll")->click();
    ASSERT_TRUE(wait_for([&] { return window_.workspace().edits().size() > edits; }));
    wait();
    touch_obstacles();
    ASSERT_EQ(brush().tumours().size(), 1u) << "both strokes are of the new tumour";
    EXPECT_EQ(window_.frame().obstacles->all.size(), 2u);
}

// The tree is corrected beside tumours: both are kept, and each undo takes back one of them.
TEST_F(TumoursOfACase, StandAmongCorrectionsOfTheTree) {
    open_case();
    window_.actions()[ActionId::toggle_slices].trigger();
    wait_for_tumours();
    const std::size_t roots_before = roots(window_.workspace().patient()->tree).size();
    brush().set_mode(BrushMode::paints);
    brush().begin(Vec3(10, 20, 10), 6.0);
    brush().lift();
    const std::size_t edits = window_.workspace().edits().size();
    window_.findChild<QPushButton*>("acceptAll")->click();
    ASSERT_TRUE(wait_for([&] { return window_.workspace().edits().size() > edits; }));
    wait();
    ASSERT_EQ(window_.workspace().edits().size(), 2u);
    EXPECT_LT(roots(window_.workspace().patient()->tree).size(), roots_before);
    EXPECT_EQ(brush().tumours().size(), 1u);
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_EQ(roots(window_.workspace().patient()->tree).size(), roots_before);
    EXPECT_EQ(brush().tumours().size(), 1u);
    window_.actions()[ActionId::undo_edit].trigger();
    EXPECT_TRUE(brush().tumours().empty());
    EXPECT_FALSE(window_.isWindowModified());
}

}  // namespace
}  // namespace hepatica
