// SPDX-License-Identifier: GPL-3.0-or-later
// The window's smaller parts: mapping of pixels, numbers, settings, the table of actions, anatomy.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QLineEdit>
#include <QLocale>
#include <QSet>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/error.h"
#include "core/scene/scene_spec.h"
#include "core/scene/surface_anatomy.h"
#include "tests/ui/fake_simulation.h"
#include "ui/actions.h"
#include "ui/decimal_spin_box.h"
#include "ui/main_window.h"
#include "ui/mouse_scheme.h"
#include "ui/paths.h"
#include "ui/patient_wizard.h"
#include "ui/pixel_mapping.h"
#include "ui/settings.h"

namespace hepatica {
namespace {

TEST(PixelMapping, is_right_on_plain_and_on_dense_screens) {
    for (const double ratio : {1.0, 1.25, 2.0}) {
        const Pixel pixel = pixel_at(QPointF(10.5, 20), ratio);
        EXPECT_DOUBLE_EQ(pixel.x, 10.5 * ratio);
        EXPECT_DOUBLE_EQ(pixel.y, 20 * ratio);
        EXPECT_EQ(point_at(pixel, ratio), QPointF(10.5, 20));
        // The lower right corner of the widget is the lower right corner of the picture.
        const QSize points(801, 603);
        const QSize pixels = pixel_size(points, ratio);
        const Pixel corner = pixel_at(QPointF(points.width(), points.height()), ratio);
        EXPECT_NEAR(corner.x, pixels.width(), 0.5);
        EXPECT_NEAR(corner.y, pixels.height(), 0.5);
    }
}

TEST(DecimalSpinBox, takes_comma_and_point_in_every_locale) {
    for (const auto language : {QLocale::C, QLocale::German, QLocale::English, QLocale::Arabic}) {
        QLocale::setDefault(QLocale(language));
        for (const char* text : {"2.75", "2,75"}) {
            DecimalSpinBox box(0.0, 100.0, 1.0, 3, "g/s");
            box.show();
            box.setFocus();
            box.selectAll();
            QTest::keyClicks(&box, text);
            box.interpretText();
            EXPECT_DOUBLE_EQ(box.value(), 2.75) << text;
        }
    }
    QLocale::setDefault(QLocale::c());
}

TEST(Numbers, are_read_with_comma_or_point_and_nonsense_is_named) {
    EXPECT_EQ(numbers_in("12,5 -3; 40.25", "x"), (std::vector<double>{12.5, -3.0, 40.25}));
    EXPECT_TRUE(numbers_in("  ", "x").empty());
    for (const char* bad : {"1 two", "nan", "inf", "1,2,3"}) {
        EXPECT_THROW(numbers_in(bad, "x"), InputError) << bad;
    }
}

TEST(Paths, keep_letters_of_every_script) {
    const QString text = QString::fromUtf8("/tmp/Größe/肝臓/ct.nii.gz");
    EXPECT_EQ(to_text(to_path(text)), text);
}

TEST(Settings, remember_ten_recent_files_newest_first) {
    QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    {
        Settings settings(file);
        for (int i = 0; i < 12; ++i) settings.add_recent_file(QString("/p%1").arg(i));
        settings.add_recent_file("/p5");
    }
    Settings again(file);
    ASSERT_EQ(again.recent_files().size(), 10);
    EXPECT_EQ(again.recent_files()[0], "/p5");
    EXPECT_EQ(again.recent_files()[1], "/p11");
}

TEST(Settings, remember_the_course_the_folder_of_cases_and_what_vessels_touch) {
    QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    {
        Settings settings(file);
        EXPECT_TRUE(settings.course().isEmpty());
        EXPECT_FALSE(settings.contact());
        EXPECT_TRUE(QFileInfo(settings.case_folder()).isDir());
        settings.set_course("/courses/wards.json");
        settings.set_case_folder(folder.path());
        settings.set_contact({true, false, 0.25});
    }
    {
        Settings again(file);
        EXPECT_EQ(again.course(), "/courses/wards.json");
        EXPECT_EQ(again.case_folder(), folder.path());
        again.set_last_folder("/where/a/ct/lies");
        EXPECT_EQ(again.library_folder(), folder.path()) << "cases lie there, not beside a CT";
        ASSERT_TRUE(again.contact());
        EXPECT_TRUE(again.contact()->self);
        EXPECT_FALSE(again.contact()->obstacles);
        EXPECT_EQ(again.contact()->friction, 0.25);
        again.set_course({});
        again.set_case_folder("/a/folder/that/went");
    }
    Settings last(file);
    EXPECT_TRUE(last.course().isEmpty()) << "the program's own";
    EXPECT_TRUE(QFileInfo(last.case_folder()).isDir()) << "another one is proposed";
    QSettings(file, QSettings::IniFormat).setValue("contact/friction", 1e30);
    EXPECT_LE(Settings(file).contact()->friction, greatest_friction);
}

// Of CTs and of patients, each.
TEST(Settings, keep_the_fifty_places_that_were_used_last) {
    QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    {
        Settings settings(file);
        for (unsigned i = 1; i <= 50; ++i) {
            settings.remember_patient(i, QString("/p%1").arg(i));
            settings.remember_image(std::to_string(i), QString("/ct%1").arg(i));
        }
    }
    {
        Settings again(file);
        EXPECT_EQ(again.place_of_patient(1), "/p1");
        EXPECT_EQ(again.place_of_image("2"), "/ct2");
        again.remember_image("1", "/elsewhere");
        again.remember_patient(51, "/p51");
        again.remember_image("51", "/ct51");
        EXPECT_EQ(again.place_of_patient(99), "") << "asking for it keeps no place";
    }
    Settings last(file);
    EXPECT_EQ(last.place_of_patient(1), "/p1") << "it was asked for";
    EXPECT_EQ(last.place_of_patient(2), "") << "the one that was used longest ago";
    EXPECT_EQ(last.place_of_image("1"), "/elsewhere");
    EXPECT_EQ(last.place_of_image("2"), "/ct2");
    EXPECT_EQ(last.place_of_image("3"), "");
    for (unsigned i = 4; i <= 51; ++i) {
        EXPECT_EQ(last.place_of_patient(i), QString("/p%1").arg(i));
        EXPECT_EQ(last.place_of_image(std::to_string(i)), QString("/ct%1").arg(i));
    }
}

// Paths often hold patients' names, so that a case keeps none.
TEST(Settings, know_the_masks_that_a_case_was_made_with) {
    QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    const std::string ct(64, 'a');
    Settings safe(Settings::Mode::safe);
    {
        Settings settings(file);
        for (Settings* kept : {&settings, &safe})
            kept->remember_masks(ct, {"/liver.nii", "", {"/one; two.nii", "/three.nii"}});
        settings.remember_masks("", {"/nothing", "", {}});
    }
    Settings again(file);
    for (Settings* kept : {&again, &safe}) {
        const Settings::MaskPlaces known = kept->places_of_masks(ct);
        EXPECT_EQ(known.liver, "/liver.nii");
        EXPECT_EQ(known.vessel, "");
        EXPECT_EQ(known.tumours, (QStringList{"/one; two.nii", "/three.nii"}));
        EXPECT_EQ(kept->places_of_masks(std::string(64, 'b')).liver, "");
        EXPECT_EQ(kept->places_of_masks("").liver, "");
    }
}

// Nobody knows when they were used.
TEST(Settings, of_an_older_program_lose_the_places_above_fifty) {
    QTemporaryDir folder;
    const QString file = folder.filePath("s.ini");
    {
        QSettings store(file, QSettings::IniFormat);
        for (int i = 100; i < 170; ++i) store.setValue(QString("images/%1").arg(i), "/ct");
    }
    Settings(file).remember_image("new", "/new");
    QSettings store(file, QSettings::IniFormat);
    EXPECT_EQ(store.value("images/new").toString(), "/new");
    store.beginGroup("images");
    EXPECT_EQ(store.childKeys().size(), 50);
}

TEST(Settings, in_safe_mode_read_and_write_nothing) {
    Settings settings(Settings::Mode::safe);
    settings.set_window("geometry", "layout");
    EXPECT_TRUE(settings.window_geometry().isEmpty());
    EXPECT_TRUE(settings.recent_files().isEmpty());
}

// What was read in this run is found again in it, although nothing is kept.
TEST(SafeMode, knows_until_it_ends_where_a_ct_lies) {
    Settings settings(Settings::Mode::safe);
    EXPECT_TRUE(settings.safe());
    EXPECT_EQ(settings.place_of_image("abc"), "");
    settings.remember_image("abc", "/some/ct");
    settings.set_last_folder("/some");
    EXPECT_EQ(settings.place_of_image("abc"), "/some/ct");
    EXPECT_EQ(settings.place_of_image("other"), "");
    EXPECT_EQ(settings.last_folder(), "/some");
    EXPECT_EQ(Settings(Settings::Mode::safe).place_of_image("abc"), "");
    MainWindow window(settings, {});
    EXPECT_TRUE(window.windowTitle().contains("safe mode")) << window.windowTitle().toStdString();
}

TEST(ActionTable, has_no_key_twice_and_explains_everything) {
    QSet<QString> keys;
    const QString sheet = Actions::cheat_sheet(mouse_scheme_named("usual"));
    for (const ActionSpec& spec : action_table()) {
        EXPECT_FALSE(QString(spec.tip).isEmpty()) << spec.text;
        if (!*spec.keys) continue;
        EXPECT_FALSE(keys.contains(spec.keys)) << spec.keys;
        EXPECT_FALSE(QKeySequence::fromString(spec.keys).isEmpty()) << spec.keys;
        keys.insert(spec.keys);
        EXPECT_TRUE(sheet.contains(QString(spec.tip).toHtmlEscaped()));
    }
    EXPECT_FALSE(sheet.contains("robe: Probe")) << "its tip begins with its name";
    EXPECT_TRUE(sheet.contains("Rod probe: the mouse leads"));
    EXPECT_TRUE(sheet.contains("Right drag orbits"));
    const QString of_slicer = Actions::cheat_sheet(mouse_scheme_named("slicer"));
    EXPECT_TRUE(of_slicer.contains("Right drag zooms"));
    EXPECT_FALSE(of_slicer.contains("Right drag orbits"));
}

TEST(SurfaceAnatomy, knows_what_lies_downstream) {
    const LoadedPatient patient = testing::fake_patient();
    const SurfaceAnatomy& anatomy = patient.anatomy;
    EXPECT_EQ(anatomy.ends_downstream_of(0), 2);
    EXPECT_EQ(anatomy.ends_downstream_of(1), 1);
    EXPECT_EQ(anatomy.ends_in_system_of(1), 2);
    const auto all = anatomy.downstream_of({0, 0.0, 0.0});
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), static_cast<long>(all.size()));
    const auto left = anatomy.downstream_of({1, 0.0, 0.0});
    const auto& vertices = patient.patient->mesh.vertices_mm;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double x = vertices[v].x();
        if (x > 15 || vertices[v].z() < -25) {
            EXPECT_EQ(left[v], 0);
        } else if (x < -15) {
            EXPECT_EQ(left[v], 1);
        }
    }
    EXPECT_TRUE(anatomy.downstream_of(TreePoint{}).empty());
    EXPECT_TRUE(anatomy.describe(TreePoint{}, {}).empty());
    const std::string words = anatomy.describe({1, 0.0, 0.0}, patient.flow_shares);
    EXPECT_NE(words.find("1 of 2"), std::string::npos);
    EXPECT_NE(words.find(title_of(anatomy.system_of(1))), std::string::npos);
}

}  // namespace
}  // namespace hepatica
