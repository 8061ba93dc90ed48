// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured stays: it is kept with the case, counts as unsaved work, and outlasts
// corrections.
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QStatusBar>
#include <fstream>

#include "core/patient/case_digest.h"
#include "core/patient/patient_case.h"
#include "tests/patient/parted_patient.h"
#include "tests/ui/window_test.h"
#include "ui/lesson_dock.h"
#include "ui/library_dialog.h"
#include "ui/message_bar.h"
#include "ui/paths.h"
#include "ui/slices/view_layout.h"

namespace hepatica::testing {
namespace {

// Along the straight vessel of parted_tree(), as a share of its length.
Vec3 along_vessel(double share) {
    return Vec3(29, 49, 3) + share * Vec3(16, 11, 2);
}

class KeptMeasurements : public WindowTest {
  protected:
    KeptMeasurements()
        : WindowTest({[](const OpenRequest& request, Job& job) {
                          if (!request.built_in) return load_patient(request, job);
                          return play(
                              std::make_shared<const PatientCase>(test::patient_with_bridges()),
                              job);
                      },
                      [](const std::filesystem::path& path, const PatientCase& patient) {
                          write_case(path, patient);
                      },
                      [](std::shared_ptr<const PatientCase> patient, Job& job) {
                          return play(std::move(patient), job);
                      }}) {
        open_built_in();
    }
    const std::vector<Measurement>& made() {
        return window_.view_layout().slices().measurements().made();
    }
    void measure_distance() {
        QTest::keyClick(&window_, Qt::Key_M);
        for (const double share : {0.3, 0.7})
            QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(along_vessel(share)));
    }
    void measure_diameter(const Vec3& at_mm) {
        QTest::keyClick(&window_, Qt::Key_M, Qt::ControlModifier);
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(at_mm));
    }
    void delete_vessel() {
        window_.actions()[ActionId::edit_mode].trigger();
        auto* tools = window_.findChild<QComboBox*>("EditTool");
        tools->setCurrentIndex(tools->findText("Delete a whole tree"));
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, on_widget(along_vessel(0.5)));
        wait();
    }
    void save() {
        window_.save_case(folder_.filePath("p.hep"));
        wait();
    }
    void open(const QString& path) {
        window_.open(path);
        wait();
    }
    std::filesystem::path file() { return to_path(folder_.filePath("p.hep/measurements.json")); }
};

TEST_F(KeptMeasurements, CountAsUnsavedAndAreThereWhenTheCaseIsOpenedAgain) {
    EXPECT_FALSE(window_.isWindowModified());
    measure_distance();
    measure_diameter(along_vessel(0.5));
    ASSERT_EQ(made().size(), 2u);
    EXPECT_TRUE(window_.isWindowModified());
    const std::vector<std::string> texts{made()[0].text, made()[1].text};
    save();
    EXPECT_FALSE(window_.isWindowModified());
    QTest::keyClick(&window_, Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_TRUE(window_.isWindowModified()) << "one of them is gone";
    open_built_in();
    EXPECT_EQ(questions_asked_, 1) << "it would have been lost";
    EXPECT_TRUE(made().empty());
    open(folder_.filePath("p.hep"));
    ASSERT_EQ(made().size(), 2u);
    EXPECT_EQ((std::vector<std::string>{made()[0].text, made()[1].text}), texts);
    EXPECT_EQ(window_.view().scene().measures().size(), 2u);
    EXPECT_FALSE(window_.isWindowModified());
}

TEST_F(KeptMeasurements, ACopyOfTheCaseLacksThemUntilTheyAreSavedAndThatIsSaid) {
    settings_.set_library_folder(folder_.path());
    save();
    LibraryDialog& library = window_.library();
    const auto said_of_copy = [&](const char* name) {
        window_.actions()[ActionId::open_library].trigger();
        EXPECT_TRUE(wait_for([&] { return !library.busy() && !library.cases().empty(); }));
        library.give_away(to_path(folder_.filePath(name)));
        EXPECT_TRUE(wait_for([&] { return !library.busy(); }));
        return library.messages().text();
    };
    EXPECT_FALSE(said_of_copy("whole.hepz").contains("not saved yet"));
    measure_distance();
    ASSERT_TRUE(window_.isWindowModified());
    copy_answer_ = CopyAnswer::as_saved;
    EXPECT_TRUE(said_of_copy("without.hepz").contains("not saved yet"));
    EXPECT_TRUE(read_case(to_path(folder_.filePath("without.hepz"))).measured.empty());
    EXPECT_TRUE(window_.isWindowModified());

    copy_answer_ = CopyAnswer::cancel;
    said_of_copy("none.hepz");
    EXPECT_FALSE(QFile::exists(folder_.filePath("none.hepz")));

    copy_answer_ = CopyAnswer::save;
    library.give_away(to_path(folder_.filePath("with.hepz")));
    ASSERT_TRUE(
        wait_for([&] { return QFile::exists(folder_.filePath("with.hepz")) && !library.busy(); }));
    EXPECT_FALSE(library.messages().text().contains("not saved yet"));
    EXPECT_EQ(read_case(to_path(folder_.filePath("with.hepz"))).measured.size(), 1u);
    EXPECT_FALSE(window_.isWindowModified()) << "the case itself is saved, too";
}

TEST_F(KeptMeasurements, OfAPatientWhoWasNeverSavedAreAskedAboutBeforeTheyAreLost) {
    measure_distance();
    unsaved_answer_ = UnsavedAnswer::cancel;
    EXPECT_FALSE(window_.close());
    EXPECT_EQ(questions_asked_, 1);
    EXPECT_EQ(made().size(), 1u);
}

// A diameter belongs to the vessels: it goes with its vessel, and comes back with it.
TEST_F(KeptMeasurements, OutlastCorrectionsAndFollowUndo) {
    measure_distance();
    measure_diameter(along_vessel(0.5));
    ASSERT_EQ(made().size(), 2u);
    save();
    const auto points = made()[1].points_mm;
    delete_vessel();
    ASSERT_EQ(made().size(), 1u) << "its vessel is gone";
    EXPECT_EQ(made()[0].kind, MeasurementKind::distance);
    EXPECT_TRUE(window_.messages().text().contains("1 diameter"))
        << window_.messages().text().toStdString();
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    ASSERT_EQ(made().size(), 2u);
    EXPECT_EQ(made()[1].points_mm, points);
    EXPECT_FALSE(window_.isWindowModified()) << "all is as it was saved";
    window_.actions()[ActionId::redo_edit].trigger();
    wait();
    EXPECT_EQ(made().size(), 1u);
    EXPECT_TRUE(window_.isWindowModified());
}

// A case keeps the correction, too, which may be taken back after it is opened again.
TEST_F(KeptMeasurements, OfAVesselThatIsGoneAreSavedAndComeBackWithIt) {
    measure_diameter(along_vessel(0.5));
    delete_vessel();
    ASSERT_TRUE(made().empty());
    save();
    open(folder_.filePath("p.hep"));
    EXPECT_TRUE(made().empty());
    EXPECT_FALSE(window_.isWindowModified());
    window_.actions()[ActionId::undo_edit].trigger();
    wait();
    EXPECT_EQ(made().size(), 1u);
}

TEST_F(KeptMeasurements, StayWhereEscapeIsPressedOnceMore) {
    measure_distance();
    for (int i = 0; i < 3; ++i) QTest::keyClick(&window_, Qt::Key_Escape);
    EXPECT_EQ(made().size(), 1u);
}

TEST_F(KeptMeasurements, AreBroughtBackAfterTheyWereAllRemoved) {
    measure_distance();
    window_.actions()[ActionId::clear_measurements].trigger();
    EXPECT_TRUE(made().empty());
    EXPECT_TRUE(window_.messages().text().contains("1 measurement"));
    auto* back = window_.messages().findChild<QPushButton*>("offer");
    ASSERT_TRUE(back->isVisible());
    QTest::mouseClick(back, Qt::LeftButton);
    EXPECT_EQ(made().size(), 1u);
    EXPECT_FALSE(window_.messages().isVisible());
}

// Also one whose vessel is gone, and on the vessels as they are by then.
TEST(MeasurementsBroughtBack, StandWithThoseThatWereMadeSince) {
    const VesselTree tree = test::parted_tree();
    Measurements measurements;
    const auto measure = [&](MeasurementKind kind, std::vector<double> shares) {
        measurements.choose(kind);
        for (const double share : shares) measurements.add_point(along_vessel(share), {}, tree);
    };
    measure(MeasurementKind::diameter, {0.5});
    measure(MeasurementKind::distance, {0.3, 0.7});
    EXPECT_EQ(measurements.follow_tree({}), 1u);
    ASSERT_EQ(measurements.made().size(), 1u);
    EXPECT_EQ(measurements.kept().size(), 2u);
    const std::vector<KeptMeasurement> removed = measurements.remove_all();
    EXPECT_EQ(removed.size(), 2u);
    EXPECT_TRUE(measurements.kept().empty());
    measure(MeasurementKind::angle, {0.2, 0.5, 0.8});
    measurements.bring_back(removed, {});
    ASSERT_EQ(measurements.made().size(), 2u) << "there is no vessel yet";
    EXPECT_EQ(measurements.made()[0].kind, MeasurementKind::distance);
    EXPECT_EQ(measurements.made()[1].kind, MeasurementKind::angle);
    EXPECT_EQ(measurements.follow_tree(tree), 0u);
    ASSERT_EQ(measurements.made().size(), 3u);
    EXPECT_EQ(measurements.kept()[0], removed[0]);
    measurements.remove_last();
    EXPECT_EQ(measurements.kept(), removed) << "the angle was the last";
}

// By a program that was killed before it had a copy of the case.
TEST_F(KeptMeasurements, ThatAnEarlierRunLeftInItsJournalAreShown) {
    measure_distance();
    const std::vector<KeptMeasurement> left = window_.workspace().measured();
    ASSERT_EQ(left.size(), 1u);
    window_.actions()[ActionId::clear_measurements].trigger();
    save();
    OpenRequest request;
    request.reconstruct.ct = to_path(folder_.filePath("p.hep"));
    request.left_edits.emplace();
    request.left_edits->extracted = hash_of_extracted(*window_.workspace().patient());
    request.left_edits->file = to_path(folder_.filePath("left/edits.jsonl"));
    request.left_edits->measured = left;
    request.left_edits->digest = digest_of_case(request.reconstruct.ct);
    window_.open(request);
    wait();
    ASSERT_EQ(made().size(), 1u);
    EXPECT_EQ(window_.view().scene().measures().size(), 1u);
    EXPECT_TRUE(window_.isWindowModified()) << "no case holds it yet";
    save();
    open(folder_.filePath("p.hep"));
    EXPECT_EQ(made().size(), 1u);
}

TEST_F(KeptMeasurements, InAFileThatIsDamagedAreRefusedWithFileValueAndRemedy) {
    measure_distance();
    save();
    std::ofstream(file()) << R"({"format": "hepatica-measurements", "version": 1, "measurements":
        [{"kind": "distance", "points_mm": [[1, 2, 3], [1e9, 2, 3]]}]})";
    window_.open(folder_.filePath("p.hep"));
    ASSERT_TRUE(wait_for([this] { return !window_.busy(); }));
    const QString said = window_.messages().text();
    EXPECT_TRUE(said.contains("measurements.json")) << said.toStdString();
    EXPECT_TRUE(said.contains("1000000000")) << said.toStdString();
    EXPECT_TRUE(said.contains("remove the file")) << said.toStdString();
}

// They would be thrown away for nothing.
TEST_F(KeptMeasurements, are_not_asked_about_for_a_lesson_that_cannot_be_recorded) {
    measure_distance();
    ASSERT_TRUE(window_.isWindowModified());
    const std::filesystem::path recordings = to_path(folder_.filePath("recordings"));
    std::filesystem::remove_all(recordings);
    std::ofstream(recordings) << "a file in the folder's place";
    EXPECT_TRUE(window_.lessons().start("gentle_pull"));
    EXPECT_FALSE(window_.busy());
    EXPECT_EQ(questions_asked_, 0);
    EXPECT_TRUE(window_.isWindowModified());
    EXPECT_EQ(made().size(), 1u);
    EXPECT_TRUE(window_.messages().text().startsWith("Cannot be written"))
        << window_.messages().text().toStdString();
    std::filesystem::remove(recordings);
    EXPECT_TRUE(window_.lessons().start("gentle_pull"));
    wait();
    EXPECT_EQ(questions_asked_, 1) << "the lesson is played on the built-in patient";
}

}  // namespace
}  // namespace hepatica::testing
