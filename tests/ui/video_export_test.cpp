// SPDX-License-Identifier: GPL-3.0-or-later
// Films are whole or not there; the program that makes files of them is a stand-in here.
#include "ui/video_export.h"

#include <gtest/gtest.h>

#include <QFile>
#include <fstream>
#include <set>

#include "core/base/error.h"
#include "core/base/job.h"
#include "core/base/temporary_folder.h"
#include "ui/paths.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// Each picture has the grey of its time; their sides are odd.
Film film_of(double end_s) {
    Film film;
    film.end_s = end_s;
    film.picture = [](double at_s) {
        QImage image(7, 5, QImage::Format_RGB32);
        const int grey = static_cast<int>(100.0 * at_s);
        image.fill(qRgb(grey, grey, grey));
        return image;
    };
    return film;
}

bool always(double) {
    return true;
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

// A program in the place of ffmpeg: it does what this shell script says.
QString stand_in(const fs::path& folder, const std::string& script) {
    const fs::path file = folder / "ffmpeg";
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
    return to_text(file);
}

TEST(Film, HasAPictureAtEveryMomentUpToItsEnd) {
    EXPECT_EQ(film_of(0.0).count(), 1);
    EXPECT_EQ(film_of(0.04).count(), 2);
    EXPECT_EQ(film_of(0.05).count(), 3) << "the end is in it";
    EXPECT_EQ(film_of(1.0).count(), 26);
}

TEST(Film, AsAFolderIsNumberedPicturesOfEvenSize) {
    const TemporaryFolder folder;
    const fs::path place = folder.path() / "film";
    double last = -1.0;
    write_film(film_of(0.08), place, "", [&](double share) {
        EXPECT_GT(share, last);
        last = share;
        return true;
    });
    EXPECT_EQ(names_in(place), (std::set<std::string>{"00000.png", "00001.png", "00002.png"}));
    const QImage picture(to_text(place / "00002.png"));
    EXPECT_EQ(picture.size(), QSize(6, 4));
    EXPECT_EQ(qRed(picture.pixel(0, 0)), 8);
}

TEST(Film, IsNotMixedWithAnother) {
    const TemporaryFolder folder;
    write_film(film_of(0.2), folder.path() / "film", "", always);
    const auto before = names_in(folder.path() / "film");
    EXPECT_THROW(write_film(film_of(0.1), folder.path() / "film", "", always), InputError);
    EXPECT_EQ(names_in(folder.path() / "film"), before);
}

TEST(Film, GoesIntoNoFolderThatHoldsSomethingElse) {
    const TemporaryFolder folder;
    const fs::path place = folder.path() / "play";
    fs::create_directory(place);
    std::ofstream(place / "notes.txt") << "before";
    EXPECT_THROW(write_film(film_of(0.1), place, "", always), InputError);
    EXPECT_EQ(names_in(place), std::set<std::string>{"notes.txt"});
    EXPECT_THROW(write_film(film_of(0.1), place / "notes.txt", "", always), InputError);
    fs::remove(place / "notes.txt");
    write_film(film_of(0.0), place, "", always);
    EXPECT_EQ(names_in(place), std::set<std::string>{"00000.png"}) << "it is empty now";
}

TEST(Film, ThatIsCancelledLeavesNothing) {
    const TemporaryFolder folder;
    for (const char* name : {"film", "film.mp4"}) {
        int asked = 0;
        EXPECT_THROW(write_film(film_of(1.0), folder.path() / name, "/bin/true",
                                [&](double) { return ++asked < 5; }),
                     Cancelled);
        EXPECT_TRUE(names_in(folder.path()).empty()) << name;
    }
}

// Also while ffmpeg runs, which is ended.
TEST(Film, ThatIsCancelledWhileFfmpegRunsLeavesNothing) {
    const TemporaryFolder folder, programs;
    const fs::path begun = programs.path() / "begun";
    const QString program =
        stand_in(programs.path(), "touch '" + begun.string() + "'; exec sleep 3600");
    EXPECT_THROW(write_film(film_of(0.1), folder.path() / "film.mp4", program,
                            [&](double) { return !fs::exists(begun); }),
                 Cancelled);
    EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(Film, AsAFileIsMadeByFfmpegFromAllPictures) {
    const TemporaryFolder folder, programs;
    // Its last argument is the file; the pictures are counted where it reads them.
    const QString program = stand_in(programs.path(),
                                     "for last; do :; done; ls \"$(dirname \"$7\")\" | wc -l > "
                                     "\"$last\"; echo \"$@\" >> \"$last\"");
    const fs::path place = folder.path() / "a play.mp4";
    write_film(film_of(0.4), place, program, always);
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a play.mp4"});
    std::ifstream in(place);
    int pictures = 0;
    std::string arguments;
    in >> pictures;
    std::getline(in >> std::ws, arguments);
    EXPECT_EQ(pictures, 11);
    EXPECT_NE(arguments.find("-framerate 25 -i"), std::string::npos) << arguments;
}

TEST(Film, ThatFfmpegRefusesLeavesWhatWasThere) {
    const TemporaryFolder folder, programs;
    const fs::path place = folder.path() / "play.mp4";
    std::ofstream(place) << "before";
    const QString program = stand_in(programs.path(), "echo no; echo unknown codec; exit 1");
    try {
        write_film(film_of(0.1), place, program, always);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("unknown codec"), std::string::npos) << error.problem();
    }
    EXPECT_THROW(write_film(film_of(0.1), place, "", always), InputError) << "there is none";
    EXPECT_THROW(write_film(film_of(0.1), place, "/no/such/program", always), InputError);
    std::ifstream in(place);
    std::string text;
    in >> text;
    EXPECT_EQ(text, "before");
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"play.mp4"});
}

}  // namespace
}  // namespace hepatica
