// SPDX-License-Identifier: GPL-3.0-or-later
// The wizard's fields, and the dialogs that choose a series and list results.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTableWidget>
#include <QTimer>
#include <QTreeWidget>
#include <filesystem>

#include "core/base/error.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/ui/fake_window_test.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/results_dialog.h"
#include "ui/series_dialog.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// The wizard's fields by their labels.
class Wizard : public ::testing::Test {
  protected:
    QLineEdit& field(const char* name) {
        auto* edit = wizard_.findChild<QLineEdit*>(name);
        EXPECT_NE(edit, nullptr) << name;
        return *edit;
    }
    std::string complaint() {
        try {
            wizard_.options();
        } catch (const InputError& error) {
            return error.place() + ": " + error.problem();
        }
        return "";
    }

    PatientWizard wizard_{"/"};
};

TEST_F(Wizard, fills_the_options_from_its_fields) {
    field("ct").setText(" /data/ct ");
    field("liverMask").setText("/data/liver.nii.gz");
    field("vesselMask").setText("/data/vessels.nii.gz");
    field("tumourMasks").setText("/data/one.nii.gz; /data/other tumour.nii.gz;");
    field("window").setText("140 260,5");
    field("portalSeeds").setText("1 2 3; 4,5 -6 7");
    field("hepaticSeeds").setText("-8 9 10");
    const ReconstructOptions options = wizard_.options();
    EXPECT_EQ(options.ct, fs::path("/data/ct"));
    EXPECT_EQ(options.liver_mask, fs::path("/data/liver.nii.gz"));
    EXPECT_EQ(options.vessel_mask, fs::path("/data/vessels.nii.gz"));
    EXPECT_EQ(options.tumour_masks,
              (std::vector<fs::path>{"/data/one.nii.gz", "/data/other tumour.nii.gz"}));
    EXPECT_EQ(options.window_hu, std::pair(140.0, 260.5));
    ASSERT_EQ(options.seeds.size(), 3u);
    EXPECT_EQ(options.seeds[0].position_mm, Vec3(1, 2, 3));
    EXPECT_EQ(options.seeds[1].position_mm, Vec3(4.5, -6, 7));
    EXPECT_EQ(options.seeds[2].position_mm, Vec3(-8, 9, 10));
    EXPECT_EQ(options.seeds[0].system, options.seeds[1].system);
    EXPECT_NE(options.seeds[0].system, options.seeds[2].system);
}

TEST_F(Wizard, leaves_out_what_is_left_empty) {
    wizard_.set_ct("/data/ct");
    const ReconstructOptions options = wizard_.options();
    EXPECT_FALSE(options.liver_mask || options.vessel_mask || options.window_hu);
    EXPECT_TRUE(options.seeds.empty());
    EXPECT_TRUE(options.tumour_masks.empty());
}

// Two series of an examination, the thin one the better.
fs::path two_series(const fs::path& folder) {
    Volume volume;
    volume.grid.dims = {16, 16, 8};
    volume.grid.spacing_mm = Vec3(1, 1, 1);
    volume.voxels.assign(16 * 16 * 8, 40);
    Job job;
    DicomSeriesInfo info;
    info.series_description = "thin";
    write_dicom_series(folder / "one", volume, info, job);
    volume.grid.dims[2] = 4;
    volume.voxels.resize(16 * 16 * 4);
    info.series_description = "thick, 50 %3";
    volume.grid.spacing_mm.z() = 2.0;
    write_dicom_series(folder / "two", volume, info, job);
    return folder;
}

TEST_F(Wizard, offers_the_series_of_a_folder_that_holds_several) {
    const QTemporaryDir temporary;
    const fs::path both = two_series(to_path(temporary.filePath("scan")));
    auto* series = wizard_.findChild<QComboBox*>("series");
    ASSERT_NE(series, nullptr);
    EXPECT_TRUE(series->isHidden());
    wizard_.set_ct(to_text(both));
    EXPECT_FALSE(series->isHidden()) << "who looks for the field finds it at once";
    EXPECT_FALSE(series->isEnabled());
    EXPECT_TRUE(series->placeholderText().startsWith("Looking"));
    ASSERT_TRUE(testing::wait_for([&] { return series->count() == 2; }));
    EXPECT_FALSE(series->isHidden());
    EXPECT_TRUE(series->isEnabled());
    EXPECT_TRUE(series->itemText(0).contains("thin")) << series->itemText(0).toStdString();
    EXPECT_TRUE(series->itemText(1).contains("\"thick, 50 %3\", 4 images"))
        << series->itemText(1).toStdString();
    EXPECT_EQ(wizard_.options().series, 1) << "it was offered: nobody asks again";
    series->setCurrentIndex(1);
    EXPECT_EQ(wizard_.options().series, 2);
    emit field("ct").editingFinished();  // it loses the focus
    EXPECT_FALSE(series->isHidden());
    EXPECT_EQ(wizard_.options().series, 2) << "the choice stays, and nobody asks again";
    Job job;
    EXPECT_EQ(read_volume(both, job, nullptr, 2).grid.dims[2], 4);
    wizard_.set_ct(to_text(both.parent_path() / "nothing"), 2);
    EXPECT_EQ(wizard_.options().series, 0);
    wizard_.set_ct(to_text(both), 2);
    EXPECT_EQ(wizard_.options().series, 2) << "also before the folder was looked through";
    EXPECT_EQ(wizard_.entries().value(0), "2");
    ASSERT_TRUE(testing::wait_for([&] { return series->count() == 2; }));
    EXPECT_EQ(wizard_.options().series, 2) << "the one that was read";
    const QStringList entries = wizard_.entries();
    wizard_.set_ct(to_text(both.parent_path() / "nothing"));
    wizard_.set_entries(entries);
    EXPECT_EQ(wizard_.options().series, 2) << "who asks for the same again reads the same";
    ASSERT_TRUE(testing::wait_for([&] { return series->count() == 2; }));
    // Another folder, of one series, typed by hand.
    field("ct").setText(to_text(both / "one"));
    emit field("ct").editingFinished();
    EXPECT_EQ(wizard_.options().series, 0);
    ASSERT_TRUE(testing::wait_for([&] { return series->count() == 1; }));
    EXPECT_TRUE(series->isHidden());
}

// A name that is too long stands for every place that the system refuses to look at.
TEST_F(Wizard, takes_a_place_that_cannot_be_looked_at) {
    const QString place = "/" + QString("x").repeated(5000);
    EXPECT_NO_THROW(wizard_.set_ct(place));
    EXPECT_TRUE(wizard_.findChild<QComboBox*>("series")->isHidden());
    EXPECT_EQ(wizard_.options().ct, to_path(place)) << "opening it says why it cannot be read";
}

TEST_F(Wizard, takes_blanks_around_the_name_of_a_file_and_quotes_numbers_as_they_were_typed) {
    wizard_.set_ct("/data/ct");
    field("liverMask").setText(" /data/liver.nii.gz ");
    field("vesselMask").setText("  ");
    EXPECT_EQ(wizard_.options().liver_mask, fs::path("/data/liver.nii.gz"));
    EXPECT_FALSE(wizard_.options().vessel_mask);
    field("window").setText("1,2,3");
    EXPECT_EQ(complaint(), "Window: “1,2,3” is no number");
}

TEST_F(Wizard, names_the_field_that_makes_no_sense_and_stays_open) {
    EXPECT_EQ(complaint(), "CT: nothing is chosen");
    wizard_.set_ct("/data/ct");
    for (const char* window : {"140", "260 140", "1 2 3"}) {
        field("window").setText(window);
        EXPECT_TRUE(complaint().starts_with("Window: ")) << complaint();
    }
    field("window").clear();
    field("hepaticSeeds").setText("1 2");
    EXPECT_TRUE(complaint().starts_with("Hepatic vein seeds: ")) << complaint();
    wizard_.show();
    for (QPushButton* button : wizard_.findChildren<QPushButton*>())
        if (button->text() == "Reconstruct") button->click();
    EXPECT_TRUE(wizard_.isVisible());
    auto* problem = wizard_.findChild<QLabel*>("problem");
    ASSERT_NE(problem, nullptr);
    EXPECT_EQ(problem->text().toStdString(),
              "Hepatic vein seeds: “1 2” is no place. Write it as the slices do, as L 12 P 40 H "
              "155 mm, and a semicolon before the next one; or leave it empty");
    field("hepaticSeeds").setText("L 1  A 2,5  H 3 mm; 4 5 6");
    wizard_.set_ct("/data/ct");
    ASSERT_EQ(wizard_.options().seeds.size(), 2u);
    EXPECT_EQ(wizard_.options().seeds[0].position_mm, Vec3(1, -2.5, 3));
    for (QPushButton* button : wizard_.findChildren<QPushButton*>())
        if (button->text() == "Reconstruct") button->click();
    EXPECT_EQ(wizard_.result(), QDialog::Accepted);
}

class Choosing : public ::testing::Test {
  protected:
    Choosing() { dialog_.show(); }
    QTreeWidget& list() { return *dialog_.findChild<QTreeWidget*>("series"); }

    SeriesDialog dialog_{{{"3 \"portal\"", "CT", 240, 1.25, "B30f", "portal venous phase", ""},
                          {"2 \"lung\"",
                           "CT",
                           480,
                           0.0,
                           "B70f",
                           "",
                           "its kernel is for soft tissue",
                           {},
                           {"it is <odd>", "it is long"}}}};
};

TEST_F(Choosing, lists_what_tells_the_series_apart) {
    ASSERT_EQ(list().topLevelItemCount(), 2);
    const auto row = [&](int number) {
        QStringList cells;
        for (int column = 0; column < list().columnCount(); ++column)
            cells << list().topLevelItem(number)->text(column);
        return cells.join(" | ").toStdString();
    };
    EXPECT_EQ(row(0),
              "1 | 3 \"portal\" | 240 | 1.25 mm | B30f | portal venous phase |  | the best for the "
              "liver's vessels");
    EXPECT_EQ(row(1),
              "2 | 2 \"lung\" | 480 | unknown | B70f |  | 2 | the first is better: its kernel is "
              "for soft tissue");
}

// Two that nobody has called anything are told apart by where they lie.
TEST_F(Choosing, names_series_without_a_word_of_the_reader) {
    SeriesDialog dialog(
        {{"series", "CT", 240, 1.25, "Br38f\\3", "", "", "/scan/one/5.dcm"},
         {"series", "CT", 20, 1.25, "", "", "it has more slices", "/scan/two/5.dcm"},
         {"series 5 \"arterial\"", "CT", 20, 1.25, "", "", "it is a CT"}});
    const auto cell = [&](int row, int column) {
        return dialog.findChild<QTreeWidget*>("series")->topLevelItem(row)->text(column);
    };
    EXPECT_EQ(cell(0, 1), "unnamed\none");
    EXPECT_EQ(cell(1, 1), "unnamed\ntwo");
    EXPECT_EQ(cell(2, 1), "5 \"arterial\"");
    EXPECT_EQ(cell(0, 4), "Br38f, 3");
    EXPECT_EQ(cell(1, 7), "the first is better: it has more slices");
}

// Of two patients of one archive even the folders may be called alike.
TEST_F(Choosing, names_the_folders_from_where_they_part) {
    const SeriesDialog dialog(
        {{"series", "CT", 240, 1.25, "", "", "", "/scan/case 1/DICOM/5.dcm"},
         {"series", "CT", 20, 1.25, "", "", "it has more slices", "/scan/case 7/DICOM/5.dcm"},
         {"series", "CT", 10, 1.25, "", "", "it has more slices", "/scan/case 7/DICOM/9.dcm"}});
    const auto name = [&](int row) {
        return dialog.findChild<QTreeWidget*>("series")->topLevelItem(row)->text(1);
    };
    EXPECT_EQ(name(0), "unnamed\ncase 1/DICOM");
    EXPECT_EQ(name(1), "unnamed\ncase 7/DICOM");
    EXPECT_EQ(name(2), "unnamed\ncase 7/DICOM");
}

// In full beneath the list, wherever its columns end.
TEST_F(Choosing, says_what_is_wrong_with_the_series_that_is_chosen) {
    const auto* warnings = dialog_.findChild<QLabel*>("seriesWarnings");
    EXPECT_FALSE(warnings->isVisible());
    QTest::keyClick(&list(), Qt::Key_Down);
    EXPECT_TRUE(warnings->isVisible());
    EXPECT_EQ(warnings->text().toStdString(), "⚠ it is <odd>\n⚠ it is long");
    EXPECT_TRUE(warnings->wordWrap());
    QTest::keyClick(&list(), Qt::Key_Up);
    EXPECT_FALSE(warnings->isVisible());
}

// At the size it opens with, no column hides behind the edge.
TEST_F(Choosing, shows_all_columns) {
    const std::string name = "4 \"Abdomen portal venous thin, multiplanar, iterative 3\"";
    SeriesDialog dialog(
        {{name, "CT", 240, 1.25, "Br38f/3 medium smooth", "portal venous phase", ""},
         {name, "CT", 480, 5.0, "B70f", "arterial phase", "it has more slices"}});
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, testing::patience_ms));
    const auto* columns = dialog.findChild<QTreeWidget*>("series");
    int widths = 0;
    for (int column = 0; column < columns->columnCount(); ++column)
        widths += columns->columnWidth(column);
    EXPECT_LE(widths, columns->viewport()->width());
    EXPECT_GE(columns->columnWidth(columns->columnCount() - 1), 150) << "the reason";
}

TEST_F(Choosing, takes_the_best_by_enter_alone) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog_, testing::patience_ms));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
    EXPECT_EQ(dialog_.chosen(), 1);
}

TEST_F(Choosing, takes_another_by_one_key_more) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog_, testing::patience_ms));
    QTest::keyClick(&list(), Qt::Key_Down);
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(dialog_.result(), QDialog::Accepted);
    EXPECT_EQ(dialog_.chosen(), 2);
}

// Small pictures of the series in a folder, all of 40 HU.
class Pictures : public ::testing::Test {
  protected:
    Pictures() : folder_(two_series(to_path(temporary_.filePath("scan")))) {}
    std::vector<SeriesDescription> series() const {
        Job job;
        return list_series(folder_, job);
    }
    static QImage picture(SeriesDialog& dialog, int row, QIcon::Mode mode = QIcon::Normal) {
        QTreeWidget* list = dialog.findChild<QTreeWidget*>("series");
        return list->topLevelItem(row)->icon(0).pixmap(QSize(96, 96), mode).toImage();
    }
    static QString tip(SeriesDialog& dialog, int row) {
        return dialog.findChild<QTreeWidget*>("series")->topLevelItem(row)->toolTip(0);
    }

    const QTemporaryDir temporary_;
    const fs::path folder_;
};

TEST_F(Pictures, arrive_in_the_dialog_after_it_is_shown) {
    SeriesDialog dialog(series());
    EXPECT_TRUE(dialog.draws_pictures());
    const QColor before = picture(dialog, 0).pixelColor(48, 48);
    EXPECT_NE(before, QColor(128, 128, 128)) << "nothing has been decoded yet";
    dialog.show();
    EXPECT_TRUE(dialog.isVisible());
    ASSERT_TRUE(testing::wait_for([&] { return !dialog.draws_pictures(); }));
    for (const int row : {0, 1}) {
        EXPECT_EQ(picture(dialog, row).size(), QSize(96, 96)) << "16 by 16 pixels of a millimetre";
        EXPECT_EQ(picture(dialog, row).pixelColor(48, 48), QColor(128, 128, 128)) << "40 HU";
        EXPECT_TRUE(tip(dialog, row).contains("soft tissue"));
    }
    EXPECT_EQ(picture(dialog, 0, QIcon::Selected).pixelColor(48, 48), QColor(128, 128, 128))
        << "the chosen row tints no CT";
    EXPECT_EQ(dialog.chosen(), 1);
}

TEST_F(Pictures, are_as_long_and_wide_as_the_slice) {
    Volume volume;
    volume.grid.dims = {20, 10, 8};
    volume.grid.spacing_mm = Vec3(1, 4, 1);  // 20 by 40 mm
    volume.voxels.assign(20 * 10 * 8, 240);
    Job job;
    write_dicom_series(folder_ / "one", volume, {}, job);
    SeriesDialog dialog(series());
    ASSERT_TRUE(testing::wait_for([&] { return !dialog.draws_pictures(); }));
    auto* list = dialog.findChild<QTreeWidget*>("series");
    const int square = list->topLevelItem(0)->text(1).contains("thick") ? 0 : 1;
    EXPECT_EQ(picture(dialog, square).size(), QSize(96, 96));
    EXPECT_EQ(picture(dialog, 1 - square).size(), QSize(48, 96));
}

TEST_F(Pictures, that_cannot_be_decoded_leave_a_plain_place_and_no_error) {
    std::vector<SeriesDescription> both = series();
    fs::resize_file(both[0].middle_slice, fs::file_size(both[0].middle_slice) - 9);
    both.push_back(both[1]);
    both.back().middle_slice = folder_ / "gone";
    SeriesDialog dialog(both);
    dialog.show();
    ASSERT_TRUE(testing::wait_for([&] { return !dialog.draws_pictures(); }));
    for (const int row : {0, 2}) {
        EXPECT_EQ(picture(dialog, row).size(), QSize(96, 96));
        EXPECT_TRUE(tip(dialog, row).contains("cannot be shown"));
    }
    EXPECT_EQ(picture(dialog, 1).pixelColor(48, 48), QColor(128, 128, 128)) << "the others come";
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_EQ(dialog.chosen(), 1);
    QTest::keyClick(dialog.findChild<QTreeWidget*>("series"), Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(Pictures, are_not_waited_for_and_end_with_the_dialog) {
    SeriesDialog dialog(series());
    dialog.show();
    ASSERT_TRUE(dialog.draws_pictures());
    QTest::keyClick(dialog.findChild<QTreeWidget*>("series"), Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_FALSE(dialog.draws_pictures());
}

TEST(Results, SayWhereTheyComeFromWhileThereAreNone) {
    ResultsDialog dialog([](const std::string&) {}, nullptr);
    const auto* nobody = dialog.findChild<QLabel*>("resultsNobody");
    const auto* table = dialog.findChild<QTableWidget*>("results");
    ASSERT_TRUE(nobody != nullptr && table != nullptr);
    CourseResults results{{"Gentle pull"}, {}};
    dialog.show_results("First steps", results);
    EXPECT_TRUE(nobody->isVisible());
    EXPECT_TRUE(nobody->text().startsWith("No attempt at a lesson has ended yet."));
    EXPECT_FALSE(table->isVisible());
    results.trainees = {{"A", {{.attempts = 2, .passed = true, .best_s = 3.0}}}};
    dialog.show_results("First steps", results);
    EXPECT_FALSE(nobody->isVisible());
    EXPECT_TRUE(table->isVisible());
}

// However long that is in another language or font.
TEST_F(Wizard, HasRoomForWhatItsEmptyFieldsSay) {
    wizard_.setMinimumWidth(0);
    wizard_.show();
    wizard_.resize(1, 1);
    for (const auto* edit : wizard_.findChildren<QLineEdit*>()) {
        QStyleOptionFrame frame;
        frame.initFrom(edit);
        frame.lineWidth = 1;
        const QRect inside =
            edit->style()->subElementRect(QStyle::SE_LineEditContents, &frame, edit);
        EXPECT_GE(inside.width(), edit->fontMetrics().horizontalAdvance(edit->placeholderText()))
            << edit->objectName().toStdString();
    }
}

// Whatever is opened is the fake patient, made of the CT that was asked for.
class ReadSeries : public testing::WindowTest {
  protected:
    ReadSeries()
        : WindowTest({[](const OpenRequest& request, Job&) {
                          LoadedPatient loaded = testing::fake_patient();
                          loaded.image = request.reconstruct.ct;
                          return loaded;
                      },
                      [](const fs::path&, const PatientCase&) {}}) {}

    // Which series of two the dialog of a reconstruction offers first; -1: it offered none.
    int offered_first() {
        int offered = -1;
        QTimer looking;
        QObject::connect(&looking, &QTimer::timeout, [&offered] {
            auto* wizard = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            auto* series = wizard ? wizard->findChild<QComboBox*>("series") : nullptr;
            if (series == nullptr || series->count() < 2) return;
            offered = series->currentIndex();
            wizard->reject();
        });
        looking.start(20);
        window_.actions()[ActionId::reconstruct].trigger();
        return offered;
    }
};

// A case that is opened from the disk holds none, but the user's settings know where it lies.
class KnownCt : public testing::WindowTest {
  protected:
    KnownCt()
        : WindowTest({[](const OpenRequest&, Job&) {
                          LoadedPatient loaded = testing::fake_patient();
                          PatientCase patient = *loaded.patient;
                          patient.source.image_sha256 = std::string(64, 'a');
                          loaded.patient = std::make_shared<const PatientCase>(patient);
                          return loaded;
                      },
                      [](const fs::path&, const PatientCase&) {}}) {}
};

TEST_F(KnownCt, is_offered_for_a_reconstruction) {
    const QString ct = folder_.path();
    settings_.remember_image(std::string(64, 'a'), ct);
    window_.open(ct);
    wait();
    QString offered;
    QTimer::singleShot(0, &window_, [&offered] {
        auto* wizard = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        offered = wizard->findChild<QLineEdit*>("ct")->text();
        wizard->reject();
    });
    window_.actions()[ActionId::reconstruct].trigger();
    EXPECT_EQ(offered, ct);
}

TEST_F(ReadSeries, is_the_one_that_a_reconstruction_offers_first) {
    OpenRequest request;
    request.reconstruct.ct = two_series(to_path(folder_.filePath("scan")));
    for (const int series : {2, 1}) {
        request.reconstruct.series = series;
        window_.open(request);
        wait();
        EXPECT_EQ(offered_first(), series - 1);
    }
}

}  // namespace
}  // namespace hepatica
