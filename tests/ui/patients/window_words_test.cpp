// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_words.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <system_error>

#include "core/base/error.h"
#include "ui/background_job.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

// Texts of a source: string literals, those that follow each other joined.
std::vector<std::string> texts_of(const fs::path& source) {
    std::ifstream in(source);
    const std::string code{std::istreambuf_iterator<char>(in), {}};
    static const std::regex literals(R"(("([^"\\\n]|\\.)*"\s*)+)");
    static const std::regex joints("\"\\s*\"");
    std::vector<std::string> texts;
    for (std::sregex_iterator it(code.begin(), code.end(), literals), end; it != end; ++it)
        texts.push_back(std::regex_replace(it->str(), joints, ""));
    return texts;
}

// Whatever the window can be told: of reading, reconstructing, correcting, keeping and playing with
// a patient. Who sits before it has no command line.
TEST(WindowWords, no_message_that_reaches_the_window_asks_for_an_option) {
    int worded = 0;
    const fs::path core = fs::path(HEPATICA_SOURCE_DIR) / "core";
    for (const char* room : {"image", "segmentation", "tree", "mesh", "patient", "reconstruction",
                             "opening", "scene", "session", "lesson"}) {
        for (const auto& entry : fs::recursive_directory_iterator(core / room)) {
            if (entry.path().extension() != ".cpp") continue;
            for (const std::string& text : texts_of(entry.path())) {
                static const std::regex option("(^|[ (\"])--[a-z]");
                if (!std::regex_search(text, option) &&
                    text.find("hepatica-cli") == std::string::npos)
                    continue;
                if (text.find("On the command line") != std::string::npos) continue;  // says so
                ++worded;
                const std::string said = in_window_words(text);
                EXPECT_FALSE(std::regex_search(said, option)) << entry.path() << ": " << said;
                EXPECT_EQ(said.find("hepatica-cli"), std::string::npos) << said;
            }
        }
    }
    EXPECT_GT(worded, 4) << "the texts were not found";
}

// A folder that may not be written is no fault of the program that anybody should report.
TEST(WindowWords, say_what_the_system_refused_and_where) {
    const Failure failure = failure_of(std::make_exception_ptr(
        fs::filesystem_error("cannot create directories", "/kept/here",
                             std::make_error_code(std::errc::permission_denied))));
    EXPECT_EQ(failure.problem, "Permission denied");
    EXPECT_EQ(failure.place, "/kept/here");
    EXPECT_EQ(failure.remedy, "Check that the folder exists, may be written and has free space");
}

TEST(WindowWords, name_the_fields_in_failures) {
    const Failure failure = failure_of(std::make_exception_ptr(
        InputError("no vessels were found", "--seed-mm", "Give a window (--window LO,HI)")));
    EXPECT_EQ(failure.problem, "no vessels were found");
    EXPECT_EQ(failure.place, "Portal vein seeds, Hepatic vein seeds");
    EXPECT_EQ(failure.remedy, "Give a window (Window of File > Reconstruct with options)");
    EXPECT_EQ(in_window_words("5 -- 6"), "5 -- 6");
    EXPECT_EQ(in_window_words("On the command line --series 2 reads the one that was left out."),
              "In File > Reconstruct with options, Series 2 reads the one that was left out.");
}

// As the fields take it: in German a comma is the decimal point.
TEST(WindowWords, write_the_place_of_a_seed_as_it_is_typed) {
    EXPECT_EQ(in_window_words("18.4,-1,1 lies 12 mm from the liver of /ct/1,2,3.nii"),
              "18.4 -1 1 lies 12 mm from the liver of /ct/1,2,3.nii");
    EXPECT_EQ(in_window_words(
                  "0,24,44.5 lies outside the image, which reaches from 10,20,40 to 17,30,-52.5"),
              "0 24 44.5 lies outside the image, which reaches from 10 20 40 to 17 30 -52.5");
    EXPECT_EQ(in_window_words("--seed-mm X,Y,Z,portal"), "Portal vein seeds");
    EXPECT_EQ(in_window_words("--seed-mm X,Y,Z,hepatic"), "Hepatic vein seeds");
}

TEST(WindowWords, OfManyWarningsTwoAreShown) {
    EXPECT_EQ(in_short({}), "");
    EXPECT_EQ(in_short({"a"}), "a");
    EXPECT_EQ(in_short({"a", "b"}), "a\nb");
    EXPECT_EQ(in_short({"a", "b", "c", "d"}), "a\nb\n2 more under All messages.");
}

}  // namespace
}  // namespace hepatica
