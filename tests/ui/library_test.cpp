// SPDX-License-Identifier: GPL-3.0-or-later
// The library of cases: what it shows of each, and how cases come and go.
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTreeWidget>
#include <fstream>

#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/lesson/attempts.h"
#include "core/lesson/lesson_draft.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_ties.h"
#include "core/lesson/lesson_writer.h"
#include "core/patient/case_archive.h"
#include "core/session/recording_file.h"
#include "tests/patient/parted_patient.h"
#include "tests/session/new_session.h"
#include "tests/session/recorded.h"
#include "tests/ui/library_window.h"
#include "tests/ui/window_test.h"
#include "ui/case_lessons.h"
#include "ui/case_shelf.h"
#include "ui/lesson_dock.h"
#include "ui/library_dialog.h"
#include "ui/message_bar.h"
#include "ui/packed_lessons.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::LibraryTest;
using testing::wait_for;
using testing::write_lesson_for;

TEST(CaseShelf, TellsOfEachCaseAndOfHowLessonsWent) {
    const TemporaryFolder folder, recordings;
    PatientCase doubted = *test::small_patient();
    doubted.warnings = {"What the mesh was doubted for"};
    write_case(folder.path() / "b <one>.hep", doubted);
    write_case(folder.path() / "a.hepz", test::patient_with_bridges());
    fs::create_directory(folder.path() / "c.hep");
    std::ofstream(folder.path() / "c.hep" / "case.json") << "{";
    fs::create_directory(folder.path() / "no case");
    // Two attempts on the small patient, one on nobody.
    const auto session = test::new_session();
    const auto recording = test::keep_recording(*session);
    test::play(*session, 2);
    for (const char* name : {"1", "2", "3"}) {
        Attempt attempt;
        attempt.recording = recordings.path() / (std::string(name) + ".hrec");
        attempt.lesson = "Gentle pull";
        attempt.ended_at = std::string("202") + name;
        attempt.passed = name[0] == '1';
        write_attempt(attempt);
        if (name[0] != '3') write_recording(attempt.recording, *recording);
    }
    Job job;
    const std::vector<ShelvedCase> cases = cases_in(folder.path(), recordings.path(), job);
    ASSERT_EQ(cases.size(), 3u);
    EXPECT_EQ(cases[0].name, "a");
    EXPECT_TRUE(cases[0].readable);
    EXPECT_FALSE(cases[0].facts.contains("attempts"));
    EXPECT_TRUE(cases[1].facts.contains("• What the mesh was doubted for"))
        << cases[1].facts.toStdString();
    EXPECT_EQ(cases[1].name, "b <one>");
    EXPECT_TRUE(cases[1].facts.contains("7 branches")) << cases[1].facts.toStdString();
    EXPECT_TRUE(
        cases[1].facts.contains("2 attempts at lessons, 1 passed; the last: Gentle pull, not"))
        << cases[1].facts.toStdString();
    EXPECT_FALSE(cases[2].readable);
    EXPECT_TRUE(cases[2].facts.contains("cannot be opened"));
    EXPECT_TRUE(cases[2].drawing.isNull());
    EXPECT_THROW(cases_in(folder.path() / "none", recordings.path(), job), InputError);
}

// A vessel up along z with a twig to the patient's left, which is to the right.
TEST(CaseShelf, DrawsVesselsFromTheFront) {
    VesselTree tree;
    const auto add = [&](const Vec3& from, const Vec3& to, VascularSystem system) {
        VesselSegment segment;
        segment.system = system;
        segment.points_mm = {from, to};
        segment.radii_mm = {4.0, 4.0};
        tree.segments.push_back(segment);
    };
    add(Vec3(0, 0, 0), Vec3(0, 0, 100), VascularSystem::portal);
    add(Vec3(0, 0, 100), Vec3(60, 0, 100), VascularSystem::artery);
    const QImage drawing = drawing_of(tree, QSize(100, 120));
    const auto inked = [&](int x, int y) { return qAlpha(drawing.pixel(x, y)) > 128; };
    const double scale = 104.0 / 100.0;
    const int left = static_cast<int>(50 - scale * 30), right = static_cast<int>(50 + scale * 25);
    EXPECT_TRUE(inked(left, 60)) << "the trunk";
    EXPECT_FALSE(inked(right, 60));
    EXPECT_TRUE(inked(right, 8)) << "the twig, at the top";
    const QColor twig = drawing.pixelColor(right, 8);
    EXPECT_GT(twig.red(), twig.blue()) << "an artery";
    EXPECT_TRUE(drawing_of(VesselTree{}, QSize(10, 10)).pixelColor(5, 5).alpha() == 0);
}

QStringList names_of(const std::vector<ShelvedLesson>& lessons, ShelvedLesson::Patient patient) {
    QStringList names;
    for (const ShelvedLesson& lesson : lessons)
        if (lesson.patient == patient) names << lesson.name;
    return names;
}

TEST(CaseShelf, TellsWhichLessonsGoWithEachCase) {
    const TemporaryFolder folder, recordings;
    const fs::path& place = folder.path();
    write_case(place / "one.hep", *test::small_patient());
    write_case(place / "two.hepz", *test::small_patient());
    write_lesson_for(place / "c.json", "Of one", "one.hep");
    write_lesson_for(place / "b.json", "Of one by a way about",
                     "../" + place.filename().string() + "/./one.hep");
    write_lesson_for(place / "a.json", "Of two", (place / "two.hepz").string());
    write_lesson_for(place / "d.json", "Of anybody", "any");
    write_lesson_for(place / "e.json", "Of the built-in patient", "built-in");
    write_lesson_for(place / "f.json", "Of one who left", "gone.hep");
    std::ofstream(place / "g.json") << R"({"format": "hepatica-lesson", "version": 1})";
    std::ofstream(place / "h.json") << R"({"format": "hepatica-course", "version": 1})";
    std::ofstream(place / "i.json") << "no JSON at all";
    write_lesson_for(place / "j.txt", "Of another kind of file", "any");
    Job job;
    const std::vector<ShelvedCase> cases = cases_in(place, recordings.path(), job);
    ASSERT_EQ(cases.size(), 2u);
    using enum ShelvedLesson::Patient;
    EXPECT_EQ(names_of(cases[0].lessons, this_case),
              (QStringList{"Of one by a way about", "Of one"}));
    EXPECT_EQ(names_of(cases[1].lessons, this_case), QStringList{"Of two"});
    for (const ShelvedCase& one : cases) {
        EXPECT_EQ(names_of(one.lessons, any), QStringList{"Of anybody"});
        EXPECT_EQ(names_of(one.lessons, unreadable), QStringList{"g.json"});
        EXPECT_EQ(one.lessons.front().patient, this_case) << "its own come first";
        EXPECT_EQ(one.lessons.back().patient, unreadable);
        EXPECT_TRUE(one.lessons.back().about.contains("name"))
            << one.lessons.back().about.toStdString();
    }
    EXPECT_EQ(cases[0].lessons[1].file, place / "c.json");
    EXPECT_EQ(cases[0].lessons[1].about, "Take <it>.");
}

// Reading a process's memory from address 0 on fails. What cannot be read may be a lesson.
TEST(CaseShelf, TellsOfALessonThatFailsToBeRead) {
    if (!fs::exists("/proc/self/mem")) GTEST_SKIP() << "no file whose reading fails";
    const TemporaryFolder folder;
    write_lesson_for(folder.path() / "a.json", "Of anybody", "any");
    fs::create_symlink("/proc/self/mem", folder.path() / "b.json");
    Job job;
    const std::vector<ShelvedLesson> lessons = lessons_in(folder.path(), job);
    ASSERT_GE(lessons.size(), 2u);
    EXPECT_EQ(lessons[0].name, "Of anybody");
    EXPECT_EQ(names_of(lessons, ShelvedLesson::Patient::unreadable), QStringList{"b.json"});
    EXPECT_TRUE(lessons[1].about.contains("cannot be read")) << lessons[1].about.toStdString();
}

// Whoever chooses a case sees which of its lessons a correction has made unfit.
TEST(CaseShelf, TellsWhichLessonsFitTheirCaseNoMore) {
    const TemporaryFolder folder, recordings;
    const fs::path& place = folder.path();
    write_case(place / "one.hep", *test::small_patient());
    Lesson lesson = new_lesson();
    lesson.patient = "one.hep";
    for (const char* name : {"fits", "moved"}) {
        lesson.name = name;
        tie(lesson, test::small_patient()->tree);
        if (lesson.name == "moved") lesson.marks[0].tie->at_mm += Vec3(0, 30, 0);
        write_lesson(place / (lesson.name + ".json"), lesson);
    }
    Job job;
    const std::vector<ShelvedCase> cases = cases_in(place, recordings.path(), job);
    ASSERT_EQ(cases.size(), 1u);
    ASSERT_GE(cases[0].lessons.size(), 2u);
    EXPECT_TRUE(cases[0].lessons[0].misfits.empty());
    ASSERT_EQ(cases[0].lessons[1].misfits.size(), 1u);
    EXPECT_EQ(cases[0].lessons[1].misfits[0],
              "\"mark 1\" now lies 30 mm from where it was when the lesson was made.");
    CaseLessons list([](const ShelvedLesson&) {});
    list.show_lessons(cases[0].lessons, true);
    const auto* tree = list.findChild<QTreeWidget*>("caseLessons");
    EXPECT_EQ(tree->topLevelItem(0)->child(0)->text(0), "fits");
    EXPECT_TRUE(tree->topLevelItem(0)->child(1)->text(0).contains("moved (no longer fits)"));
    EXPECT_TRUE(tree->topLevelItem(0)->child(1)->toolTip(0).contains("30 mm"));
}

TEST(CaseLessons, SaysWhatALessonIsForAsItsAuthorWroteIt) {
    CaseLessons list([](const ShelvedLesson&) {});
    const QString about = "Pull & hold \"it\" at 5 mm";
    list.show_lessons({{"a.json", "A", about, ShelvedLesson::Patient::any, {}}}, true);
    const auto* tree = list.findChild<QTreeWidget*>("caseLessons");
    EXPECT_EQ(tree->topLevelItem(0)->child(0)->toolTip(0), about) << "no entities of HTML";
}

// A chosen one is not tinted with the colour of choice, which in high contrast is not a vessel's.
TEST_F(LibraryTest, shows_the_same_drawing_of_a_case_that_is_chosen) {
    open_library();
    const QIcon icon = dialog().findChild<QListWidget*>("library")->item(0)->icon();
    const QSize size(180, 150);
    EXPECT_EQ(icon.pixmap(size, QIcon::Selected).toImage(),
              icon.pixmap(size, QIcon::Normal).toImage());
}

TEST_F(LibraryTest, opens_what_is_chosen) {
    open_library();
    EXPECT_TRUE(dialog().findChild<QLabel*>("libraryFacts")->text().contains("7 branches"));
    dialog().findChild<QPushButton*>("libraryOpen")->click();
    wait();
    EXPECT_EQ(opened_, cases_ / "first.hep");
    EXPECT_TRUE(dialog().isHidden());
}

// What is saved while the library stands open comes into it, and the choice stays.
TEST_F(LibraryTest, is_read_again_when_a_case_was_saved) {
    open_built_in();
    write_case(cases_ / "second.hep", *test::small_patient());
    open_library();
    auto& list = *dialog().findChild<QListWidget*>("library");
    ASSERT_EQ(list.count(), 2);
    EXPECT_EQ(list.item(0)->text(), "first");
    list.setCurrentRow(1);
    write_case(cases_ / "first.hepz", *test::small_patient());
    write_case(cases_ / "other.hep", *test::small_patient());
    window_.save_case(to_text(cases_ / "other.hep"));
    wait();
    ASSERT_TRUE(wait_for([&] { return !dialog().busy() && list.count() == 4; }));
    EXPECT_EQ(list.item(0)->text(), "first.hep") << "there is a file of this name, too";
    EXPECT_EQ(list.item(1)->text(), "first.hepz");
    EXPECT_EQ(list.item(2)->text(), "other");
    EXPECT_EQ(list.currentRow(), 3);
}

TEST_F(LibraryTest, lists_the_lessons_of_the_chosen_case) {
    write_case(cases_ / "second.hep", *test::small_patient());
    write_lesson_for(cases_ / "a.json", "Hold it", "second.hep");
    write_lesson_for(cases_ / "b.json", "Whoever", "any");
    std::ofstream(cases_ / "c.json") << R"({"format": "hepatica-lesson", "version": 1})";
    open_library();
    EXPECT_EQ(listed(), (QStringList{"For any patient: Whoever", "Cannot be read: c.json"}));
    EXPECT_FALSE(begin_button().isEnabled()) << "none is chosen";
    QTest::mouseClick(lessons().viewport(), Qt::LeftButton, {}, place_of(1, 0));
    EXPECT_FALSE(begin_button().isEnabled()) << "a damaged one cannot begin";
    QTest::mouseDClick(lessons().viewport(), Qt::LeftButton, {}, place_of(1, 0));
    EXPECT_TRUE(dialog().isVisible());
    dialog().findChild<QListWidget*>("library")->setCurrentRow(1);
    EXPECT_EQ(listed(), (QStringList{"For this patient: Hold it", "For any patient: Whoever",
                                     "Cannot be read: c.json"}));
}

TEST_F(LibraryTest, says_that_no_lesson_goes_with_a_case) {
    open_library();
    ASSERT_EQ(listed().size(), 1);
    EXPECT_TRUE(listed()[0].startsWith("No lesson in this folder"));
    EXPECT_FALSE(begin_button().isEnabled());
}

TEST_F(LibraryTest, begins_a_lesson_of_the_case_by_a_double_click) {
    write_lesson_for(cases_ / "a.json", "Hold it", "first.hep");
    open_library();
    QTest::mouseClick(lessons().viewport(), Qt::LeftButton, {}, place_of(0, 0));
    QTest::mouseDClick(lessons().viewport(), Qt::LeftButton, {}, place_of(0, 0));
    EXPECT_TRUE(dialog().isHidden());
    EXPECT_TRUE(wait_for([this] { return plays("Hold it"); }));
    EXPECT_EQ(opened_, cases_ / "first.hep");
}

TEST_F(LibraryTest, begins_a_lesson_for_anybody_on_the_chosen_case) {
    write_case(cases_ / "second.hep", *test::small_patient());
    write_lesson_for(cases_ / "a.json", "Whoever", "any");
    open_library();
    dialog().findChild<QListWidget*>("library")->setCurrentRow(1);
    QTest::mouseClick(lessons().viewport(), Qt::LeftButton, {}, place_of(0, 0));
    ASSERT_TRUE(begin_button().isEnabled());
    QTest::mouseClick(&begin_button(), Qt::LeftButton);
    EXPECT_TRUE(dialog().isHidden());
    EXPECT_TRUE(wait_for([this] { return plays("Whoever"); }));
    EXPECT_EQ(opened_, cases_ / "second.hep");
}

TEST_F(LibraryTest, is_read_again_when_an_attempt_has_ended) {
    Lesson lesson = new_lesson();
    lesson.name = "Soon over";
    lesson.limits = {{Quantity::time_s, -1, false, 0.2}};
    write_lesson(cases_ / "soon.json", lesson);
    open_built_in();
    open_library();
    const auto* facts = dialog().findChild<QLabel*>("libraryFacts");
    EXPECT_FALSE(facts->text().contains("Soon over"));
    window_.lessons().start((cases_ / "soon.json").string());
    ASSERT_TRUE(wait_for(
        [this] { return window_.lessons().playing() && window_.frame().statistics.paused; }));
    window_.actions()[ActionId::pause_simulation].trigger();
    EXPECT_TRUE(wait_for([&] { return facts->text().contains("the last: Soon over"); }))
        << facts->text().toStdString();
}

TEST_F(LibraryTest, gives_a_case_away_and_takes_one_in) {
    open_library();
    const fs::path file = given_away("gift.hepz");
    dialog().take_in(file);
    ASSERT_TRUE(wait_for([this] { return dialog().cases().size() == 2 && !dialog().busy(); }));
    EXPECT_EQ(hash_of(read_case(cases_ / "gift.hep")), hash_of(*test::small_patient()));
    const auto before = fs::last_write_time(cases_ / "gift.hep");
    dialog().take_in(file);
    EXPECT_EQ(fs::last_write_time(cases_ / "gift.hep"), before);
    EXPECT_FALSE(dialog().busy());
    EXPECT_TRUE(dialog().messages().text().contains("a case “gift” here already"))
        << dialog().messages().text().toStdString();
    for (const char* kept : {"gift 2.hep", "gift 3.hep"}) {
        dialog().take_in(file);
        dialog().messages().findChild<QPushButton*>("offer")->click();
        ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
        EXPECT_EQ(hash_of(read_case(cases_ / kept)), hash_of(*test::small_patient()));
        EXPECT_TRUE(dialog().messages().isHidden());
    }
    EXPECT_EQ(fs::last_write_time(cases_ / "gift.hep"), before);
}

// The file does not hold the CT, which whoever passes the case on must know.
TEST_F(LibraryTest, says_what_a_case_in_one_file_does_not_hold) {
    open_library();
    given_away("alone.hepz");
    const QString alone = dialog().messages().text();
    EXPECT_TRUE(alone.contains("alone.hepz. The CT is not in it")) << alone.toStdString();
    write_lesson_for(cases_ / "mine.json", "Of first", "first.hep");
    write_lesson_for(cases_ / "other.json", "Of anybody", "any");
    dialog().open_library();
    ASSERT_TRUE(wait_for([this] { return !dialog().busy() && !dialog().cases().empty(); }));
    given_away("with lesson.hepz");
    const QString with_lesson = dialog().messages().text();
    EXPECT_TRUE(with_lesson.contains("1 lesson for this patient, not the CT"))
        << with_lesson.toStdString();
}

// A lesson for the case comes along, tied to its vessels as it was, and is for the case that came.
TEST_F(LibraryTest, gives_the_lessons_for_a_case_away_with_it) {
    Lesson lesson = new_lesson();
    lesson.name = "Of first";
    lesson.patient = "first.hep";
    tie(lesson, test::small_patient()->tree);
    write_lesson(cases_ / "mine.json", lesson);
    write_lesson_for(cases_ / "Of first.json", "Of anybody", "any");  // takes the name
    open_library();
    const fs::path file = given_away("gift.hepz");
    const std::vector<Lesson> packed = lessons_in_archive(file);
    ASSERT_EQ(packed.size(), 1u);
    EXPECT_EQ(packed[0].patient, ".") << "right beside the unpacked case, too";
    EXPECT_EQ(hash_of(read_case(file)), hash_of(*test::small_patient()));
    dialog().take_in(file);
    ASSERT_TRUE(wait_for([this] { return dialog().cases().size() == 2 && !dialog().busy(); }));
    EXPECT_TRUE(dialog().messages().text().contains("Of first 2.json"))
        << dialog().messages().text().toStdString();
    Lesson came = read_lesson(cases_ / "Of first 2.json");
    EXPECT_EQ(came.patient, "gift.hep");
    EXPECT_TRUE(is_tied(came));
    came.patient = lesson.patient;
    EXPECT_EQ(text_of(came), text_of(lesson));
    using enum ShelvedLesson::Patient;
    EXPECT_EQ(names_of(dialog().cases()[0].lessons, this_case), QStringList{"Of first"});
    EXPECT_EQ(names_of(dialog().cases()[1].lessons, this_case), QStringList{"Of first"});
    // From one file into another they come along, and a damaged one hinders nobody.
    const TemporaryFolder unpacked;
    unpack_case(file, unpacked.path());
    std::ofstream(unpacked.path() / "lesson-2.json") << "{";
    pack_case(unpacked.path(), file);
    EXPECT_EQ(lessons_in_archive(file).size(), 1u);
    EXPECT_THROW(pack_lessons(std::vector<Lesson>(41, lesson), file), InputError);
    EXPECT_TRUE(lessons_in_archive(cases_ / "first.hep").empty()) << "a folder holds none";
}

TEST_F(LibraryTest, tells_of_the_lessons_in_a_file_that_is_opened) {
    write_lesson_for(cases_ / "mine.json", "Of first", "first.hep");
    open_library();
    const fs::path file = given_away("gift.hepz");
    OpenRequest request;
    request.reconstruct.ct = file;
    Job job;
    packed_ = testing::load_for_processor(request, job).packed_lessons;
    EXPECT_EQ(packed_, std::vector<std::string>{"Of first"});
    window_.open(to_text(file));
    wait();
    EXPECT_TRUE(window_.messages().text().contains("1 lesson for this patient is in his file: Of"))
        << window_.messages().text().toStdString();
    window_.messages().findChild<QPushButton*>("offer")->click();
    ASSERT_TRUE(wait_for([this] { return dialog().cases().size() == 2 && !dialog().busy(); }));
    EXPECT_TRUE(fs::exists(cases_ / "Of first.json"));
}

// Whoever waits for the file would otherwise have lost the one before.
TEST_F(LibraryTest, keeps_the_file_that_cannot_be_replaced_whole) {
    for (int number = 0; number <= 40; ++number)
        write_lesson_for(cases_ / (std::to_string(number) + ".json"), "Of first", "first.hep");
    open_library();
    const fs::path file = to_path(folder_.filePath("gift.hepz"));
    write_case(file, test::patient_with_bridges());
    dialog().give_away(file);
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    EXPECT_TRUE(dialog().messages().text().contains("they are more than 40"))
        << dialog().messages().text().toStdString();
    EXPECT_EQ(hash_of(read_case(file)), hash_of(test::patient_with_bridges()));
}

// Its second part, the lesson, cannot be written.
TEST_F(LibraryTest, lists_a_case_of_which_a_part_was_taken_in) {
    write_lesson_for(cases_ / "mine.json", "Of first", "first.hep");
    open_library();
    const fs::path file = given_away("gift.hepz");
    fs::create_symlink("Of first.json", cases_ / "Of first.json");
    dialog().take_in(file);
    ASSERT_TRUE(wait_for([this] { return dialog().cases().size() == 2 && !dialog().busy(); }));
    EXPECT_FALSE(dialog().messages().isHidden()) << "why a part is missing is still to be read";
}

// The bar of the main window lies behind the library.
TEST_F(LibraryTest, says_itself_why_a_case_cannot_be_taken_in) {
    open_library();
    const fs::path file = to_path(folder_.filePath("torn.hepz"));
    std::ofstream(file) << "no archive";
    dialog().take_in(file);
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    EXPECT_FALSE(dialog().messages().isHidden());
    EXPECT_TRUE(dialog().messages().text().contains("torn.hepz"))
        << dialog().messages().text().toStdString();
}

TEST_F(LibraryTest, says_that_a_folder_holds_no_case_or_cannot_be_read) {
    const fs::path empty = to_path(folder_.filePath("empty"));
    fs::create_directory(empty);
    settings_.set_library_folder(to_text(empty));
    dialog().open_library();
    auto* facts = dialog().findChild<QLabel*>("libraryFacts");
    EXPECT_TRUE(wait_for([&] { return facts->text().contains("no case in this folder"); }));
    EXPECT_FALSE(dialog().findChild<QPushButton*>("libraryOpen")->isEnabled());
    settings_.set_library_folder(to_text(empty / "gone"));
    dialog().open_library();
    EXPECT_TRUE(wait_for([this] { return window_.messages().text().contains("Cannot be read"); }));
}

}  // namespace
}  // namespace hepatica
