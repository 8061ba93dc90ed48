// SPDX-License-Identifier: GPL-3.0-or-later
// The library and files that lie in its own folder, cannot be written, or are being written.
#include <gtest/gtest.h>

#include "core/lesson/lesson_file.h"
#include "tests/ui/library_window.h"
#include "ui/message_bar.h"
#include "ui/packed_lessons.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::LibraryTest;
using testing::wait_for;
using testing::write_lesson_for;

TEST_F(LibraryTest, chooses_a_case_that_lies_in_its_folder_and_copies_nothing) {
    write_case(cases_ / "second.hepz", *test::small_patient());
    open_library();
    auto& list = *dialog().findChild<QListWidget*>("library");
    list.setCurrentRow(0);
    dialog().take_in(cases_ / "second.hepz");
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    EXPECT_EQ(list.count(), 2) << "no second one was offered or made";
    EXPECT_EQ(list.currentRow(), 1);
    EXPECT_TRUE(dialog().messages().text().contains("“second.hepz” lies in this folder already"))
        << dialog().messages().text().toStdString();
}

TEST_F(LibraryTest, says_that_a_file_of_its_folder_is_gone) {
    open_library();
    dialog().take_in(cases_ / "gone.hepz");
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    const QString said = dialog().messages().text();
    EXPECT_TRUE(said.contains("gone.hepz")) << said.toStdString();
    EXPECT_FALSE(said.contains("lies in this folder already")) << said.toStdString();
    EXPECT_EQ(dialog().cases().size(), 1u);
}

// Once they lie beside it, opening the file tells of them no more.
TEST_F(LibraryTest, takes_the_lessons_alone_out_of_a_file_in_its_folder) {
    write_lesson_for(cases_ / "mine.json", "Of first", "first.hep");
    open_library();
    const fs::path file = cases_ / "gift.hepz";
    dialog().give_away(file);
    ASSERT_TRUE(wait_for([this] { return dialog().cases().size() == 2 && !dialog().busy(); }));
    OpenRequest request;
    request.reconstruct.ct = file;
    Job job;
    packed_ = testing::load_for_processor(request, job).packed_lessons;
    EXPECT_EQ(packed_, std::vector<std::string>{"Of first"});
    window_.open(to_text(file));
    wait();
    EXPECT_TRUE(window_.messages().text().contains("To play it, take it out"))
        << window_.messages().text().toStdString();
    for (int times = 0; times < 2; ++times) {
        dialog().take_in(file);
        ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    }
    EXPECT_EQ(dialog().cases().size(), 2u);
    EXPECT_EQ(read_lesson(cases_ / "Of first.json").patient, "gift.hepz");
    EXPECT_FALSE(fs::exists(cases_ / "Of first 2.json")) << "it lies beside it already";
    EXPECT_EQ(testing::load_for_processor(request, job).packed_lessons, std::vector<std::string>());
    // Given away again, it holds the lesson once.
    dialog().findChild<QListWidget*>("library")->setCurrentRow(1);
    EXPECT_EQ(lessons_in_archive(given_away("again.hepz")).size(), 1u);
}

// Whether the folder is a case or not: one file cannot take its place.
TEST_F(LibraryTest, refuses_a_file_called_like_a_folder_before_it_reads_the_case) {
    const fs::path plain = to_path(folder_.filePath("plain.hepz"));
    const fs::path of_case = to_path(folder_.filePath("renamed.hepz"));
    fs::create_directory(plain);
    write_case(folder_.filePath("renamed.hep").toStdString(), *test::small_patient());
    fs::rename(folder_.filePath("renamed.hep").toStdString(), of_case);
    open_library();
    for (const fs::path& folder : {plain, of_case}) {
        dialog().give_away(folder);
        EXPECT_FALSE(dialog().busy()) << "nothing is begun";
        const QString said = dialog().messages().text();
        EXPECT_TRUE(said.contains("s a folder, and no case in one file")) << said.toStdString();
        EXPECT_TRUE(said.contains(to_text(folder))) << said.toStdString();
        EXPECT_TRUE(said.contains("another name")) << said.toStdString();
    }
}

TEST_F(LibraryTest, writes_every_file_that_was_asked_for_while_it_was_busy) {
    open_library();
    std::vector<fs::path> files;
    for (const char* name : {"one.hepz", "two.hepz", "three.hepz"}) {
        files.push_back(to_path(folder_.filePath(name)));
        dialog().give_away(files.back());
    }
    ASSERT_TRUE(dialog().busy());
    for (const fs::path& file : files)
        EXPECT_TRUE(wait_for([&] { return fs::exists(file); })) << file;
    EXPECT_TRUE(wait_for([this] { return !dialog().busy(); }));
}

TEST_F(LibraryTest, says_what_it_does_not_copy_because_another_folder_is_shown_by_now) {
    open_library();
    const fs::path one = to_path(folder_.filePath("one.hepz"));
    const fs::path two = to_path(folder_.filePath("two.hepz"));
    dialog().give_away(one);
    dialog().give_away(two);
    const fs::path other = to_path(folder_.filePath("other"));
    fs::create_directory(other);
    settings_.set_library_folder(to_text(other));
    EXPECT_TRUE(wait_for([this] {
        return dialog().messages().text().contains("first.hep” was not copied");
    })) << dialog().messages().text().toStdString();
    EXPECT_TRUE(fs::exists(one));
    EXPECT_FALSE(fs::exists(two));
}

TEST_F(LibraryTest, says_what_its_grey_buttons_wait_for) {
    open_library();
    const auto* said = dialog().findChild<QLabel*>("libraryWaits");
    const auto* open = dialog().findChild<QPushButton*>("libraryOpen");
    EXPECT_EQ(said->text(), "");
    EXPECT_EQ(open->toolTip(), "");
    const fs::path file = to_path(folder_.filePath("gift.hepz"));
    dialog().give_away(file);
    EXPECT_FALSE(open->isEnabled());
    EXPECT_EQ(said->text(), "Writing the case into one file…");
    EXPECT_TRUE(open->toolTip().contains(said->text()));
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    EXPECT_EQ(said->text(), "");
    EXPECT_EQ(open->toolTip(), "");
    dialog().take_in(file);
    EXPECT_EQ(said->text(), "Copying the case into this folder…");
    ASSERT_TRUE(wait_for([this] { return !dialog().busy(); }));
    EXPECT_EQ(said->text(), "");
}

}  // namespace
}  // namespace hepatica
