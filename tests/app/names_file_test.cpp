// SPDX-License-Identifier: GPL-3.0-or-later
// The file that says which pseudonym is whose: nobody in it is forgotten, mixed up or half read.
#include "app/batch/names_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/base/error.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class NamesFile : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(out_); }
    void TearDown() override { fs::remove_all(out_); }

    static BatchInput patient(const std::string& pseudonym, const std::string& scan) {
        BatchInput input;
        input.patient = pseudonym;
        input.scan = scan;
        return input;
    }
    std::string text() const {
        std::ifstream in(out_ / "names.csv", std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void replace_by(const std::string& text) const {
        std::ofstream(out_ / "names.csv", std::ios::binary) << text;
    }
    // What is said where they are added; nothing where they are.
    std::string refusal(const std::vector<BatchInput>& inputs) const {
        try {
            write_names(out_, inputs);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }

    fs::path out_ = fs::path(testing::TempDir()) / "hepatica names";
};

TEST_F(NamesFile, KeepsWhoStandsThereAlready) {
    write_names(out_, {patient("P-2", "berta")});
    write_names(out_, {patient("P-1", "anton")});
    EXPECT_EQ(text(), "patient,scan\n\"P-1\",\"anton\"\n\"P-2\",\"berta\"\n");
}

TEST_F(NamesFile, ReadsEveryNameThatItWrote) {
    const std::vector<BatchInput> inputs{patient("P-1", "a \"quoted\", name"),
                                         patient("P-2", "two\nlines"), patient("P-3", "")};
    write_names(out_, inputs);
    const std::string written = text();
    EXPECT_EQ(refusal(inputs), "");
    EXPECT_EQ(text(), written);
    EXPECT_THAT(refusal({patient("P-2", "two")}), HasSubstr("P-2"));
}

TEST_F(NamesFile, RefusesTwoScansOfOneNameAndKeepsTheFirst) {
    write_names(out_, {patient("P-1", "anton")});
    const std::string said = refusal({patient("P-2", "berta"), patient("P-1", "carla")});
    EXPECT_THAT(said, HasSubstr("calls two scans P-1"));
    EXPECT_THAT(said, HasSubstr("names.csv"));
    EXPECT_EQ(text(), "patient,scan\n\"P-1\",\"anton\"\n");
}

TEST_F(NamesFile, IsNotWrittenAnewWhereItIsDamaged) {
    for (const char* damaged :
         {"something else", "patient,scan", "\"P-1\",\"anton\"\n", "patient,scan\nP-1,anton\n",
          "patient,scan\n\"P-1\",\"anton\"", "patient,scan\n\"P-1\",\"anton\n",
          "patient,scan\n\"P-1\"\n", "patient,scan\n\"P-1\";\"anton\"\n",
          "patient,scan\n\"P-1\",\"anton\",\"x\"\n"}) {
        replace_by(damaged);
        EXPECT_THAT(refusal({patient("P-2", "berta")}), HasSubstr("is not as it was written"))
            << damaged;
        EXPECT_EQ(text(), damaged);
    }
}

// A file that cannot be read was not empty: what stands in it must not be lost.
TEST_F(NamesFile, IsNotWrittenAnewWhereItCannotBeRead) {
    fs::create_directories(out_ / "names.csv");
    EXPECT_THAT(refusal({patient("P-2", "berta")}), HasSubstr("is a folder"));
    fs::remove(out_ / "names.csv");
    if (!fs::exists("/proc/self/mem")) GTEST_SKIP() << "no file whose reading fails";
    fs::create_symlink("/proc/self/mem", out_ / "names.csv");
    EXPECT_THAT(refusal({patient("P-2", "berta")}), HasSubstr("cannot be read"));
    EXPECT_TRUE(fs::is_symlink(out_ / "names.csv"));
}

}  // namespace
}  // namespace hepatica
