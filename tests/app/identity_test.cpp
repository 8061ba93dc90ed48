// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that the program writes names the patient: a name is planted in every text of the DICOM
// files and in every folder and file name, and everything written is searched for it, packed data
// included.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/base/atomic_write.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/app/hidden_text.h"
#include "tests/app/tour.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using test::answer;
using test::Json;
using test::run_cli;

const std::string planted = "MUELLER^ANNA M\xC3\x9CLLER";

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The name as folders, DICOM, JSON and web pages write it, in lower case.
std::string found_name(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
        return static_cast<char>(c < 128 ? std::tolower(c) : c);
    });
    for (const std::string name :
         {"mueller", "anna", "m\xC3\x9Cller", "m\xDCller", "m\\u00dcller", "m%c3%9cller"})
        if (text.find(name) != std::string::npos) return name;
    return "";
}

std::string found_in_files(const fs::path& folder) {
    std::string found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = found_name(entry.path().filename().string());
        if (!name.empty()) found += entry.path().string() + " is called " + name + "\n";
        if (!entry.is_regular_file()) continue;
        const std::string inside = found_name(test::unpacked(bytes_of(entry.path())));
        if (!inside.empty()) found += entry.path().string() + " holds " + inside + "\n";
    }
    return found;
}

// The elements of a file in explicit little endian, by tag.
using Elements = std::map<std::pair<unsigned, unsigned>, std::string>;
constexpr std::size_t preamble = 132;

unsigned number_at(const std::string& bytes, std::size_t at, int size) {
    unsigned number = 0;
    for (int i = size - 1; i >= 0; --i)
        number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    return number;
}

Elements elements_of(const std::string& bytes) {
    Elements elements;
    for (std::size_t at = preamble; at + 8 <= bytes.size();) {
        const std::string type = bytes.substr(at + 4, 2);
        const bool is_long = type == "OB" || type == "OW" || type == "UN" || type == "SQ";
        const std::size_t size =
            is_long ? 12 + number_at(bytes, at + 8, 4) : 8 + number_at(bytes, at + 6, 2);
        elements[{number_at(bytes, at, 2), number_at(bytes, at + 2, 2)}] = bytes.substr(at, size);
        at += size;
    }
    return elements;
}

std::string element(unsigned group, unsigned number, const std::string& type, std::string text) {
    if (text.size() % 2 == 1) text += ' ';
    std::string bytes;
    for (const unsigned part : {group, number}) {
        bytes += static_cast<char>(part & 255);
        bytes += static_cast<char>(part >> 8);
    }
    bytes += type;
    bytes += static_cast<char>(text.size() & 255);
    bytes += static_cast<char>(text.size() >> 8);
    return bytes + text;
}

void plant(const fs::path& file) {
    const std::string bytes = bytes_of(file);
    Elements elements = elements_of(bytes);
    struct Text {
        unsigned group, number;
        const char* type;
    };
    for (const Text& tag : {Text{0x0008, 0x0080, "LO"},
                            {0x0008, 0x0081, "ST"},
                            {0x0008, 0x0090, "PN"},
                            {0x0008, 0x1010, "SH"},
                            {0x0008, 0x1030, "LO"},
                            {0x0008, 0x1040, "LO"},
                            {0x0008, 0x1048, "PN"},
                            {0x0008, 0x1070, "PN"},
                            {0x0008, 0x4000, "LT"},
                            {0x0010, 0x0010, "PN"},
                            {0x0010, 0x0020, "LO"},
                            {0x0010, 0x1000, "LO"},
                            {0x0010, 0x1001, "PN"},
                            {0x0010, 0x1040, "LO"},
                            {0x0010, 0x4000, "LT"},
                            {0x0018, 0x1030, "LO"},
                            {0x0020, 0x0010, "SH"},
                            {0x0020, 0x4000, "LT"},
                            {0x0040, 0x0254, "LO"}})
        elements[{tag.group, tag.number}] =
            element(tag.group, tag.number, tag.type, "MUELLER^ANNA");
    std::ofstream out(file, std::ios::binary);
    out << bytes.substr(0, preamble);
    for (const auto& [tag, text] : elements) out << text;
}

class Identity : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        fs::remove_all(root());
        fs::create_directories(root());
        answer({"phantom", (root() / "phantom").string(), "--seed", "2", "--dims", "96,96,72",
                "--spacing", "2,2,2.2", "--generations", "3", "--format", "nifti"});
        fs::create_directories(patient());
        Job job;
        DicomSeriesInfo info;
        info.series_description = "MUELLER^ANNA";
        write_dicom_series(patient() / planted, read_volume(root() / "phantom" / "ct.nii.gz", job),
                           info, job);
        for (const auto& entry : fs::directory_iterator(patient() / planted)) {
            plant(entry.path());
            ASSERT_NE(found_name(bytes_of(entry.path())), "");
        }
        // A second series, of which the reader speaks when it takes the first, and a slice that it
        // cannot read.
        write_dicom_series(patient() / (planted + " second"), Volume(Grid{{96, 96, 4}}, 40), info,
                           job);
        const fs::path whole = fs::directory_iterator(patient() / planted)->path();
        write_text_atomically(patient() / planted / (planted + " damaged.dcm"),
                              bytes_of(whole).substr(0, 400));
        for (const char* mask : {"truth_mask.nii.gz", "liver.nii.gz"})
            fs::rename(root() / "phantom" / mask, patient() / (planted + mask));
        fs::rename(root() / "phantom" / "truth_tree.vtp", patient() / (planted + ".vtp"));
    }
    static void TearDownTestSuite() { fs::remove_all(root()); }

    // What is read lies in patient(), what is written in written(), but for the case itself: its
    // folder is called after the patient, what is in it must not be.
    static fs::path root() { return fs::path(testing::TempDir()) / "hepatica identity"; }
    static fs::path patient() { return root() / planted; }
    static std::string given(const std::string& name) { return (patient() / name).string(); }
    static std::string written(const std::string& name) {
        fs::create_directories(root() / "written");
        return (root() / "written" / name).string();
    }
    static std::string case_folder() { return given(planted + ".hep"); }
};

// The search itself finds what is packed.
TEST_F(Identity, IsFoundInPackedFiles) {
    const fs::path folder = written("packed");
    fs::create_directories(folder);
    Grid grid;
    grid.dims = {16, 1, 1};
    Mask mask(grid);
    std::copy_n("....MUELLER.....", 16, mask.voxels.begin());
    write_nifti(folder / "a.nii.gz", mask);
    EXPECT_NE(found_in_files(folder), "");
    fs::remove_all(folder);
    EXPECT_EQ(found_name("report of somebody"), "");
    EXPECT_NE(found_name("at M%C3%9CLLER/ct"), "");
}

TEST_F(Identity, IsInNothingThatTheProgramWrites) {
    answer({"reconstruct", given(planted), "--vessel-mask", given(planted + "truth_mask.nii.gz"),
            "--liver-mask", given(planted + "liver.nii.gz"), "--tetrahedra", "1500", "--out",
            case_folder()});
    EXPECT_EQ(found_in_files(case_folder()), "");
    answer({"tradeoff", case_folder(), "--out", written("tradeoff"), "--budget", "2"});
    answer({"dial", case_folder(), "--budget", "1"});
    answer({"bench", "drag", case_folder(), "--motion", "jerk", "--steps-csv", written("steps.csv"),
            "--references", written("references")});
    answer({"edit", case_folder(), "--accept-bridges", "0.1", "--out", written("edited.hep")});
    answer({"inject", case_folder(), "--csv", written("inject.csv"), "--plot",
            written("inject.png"), "--lengths-csv", written("lengths.csv"), "--svzerod",
            written("network.json")});
    answer({"simulate", case_folder(), "--script", HEPATICA_ASSETS "/scripts/drag.json", "--steps",
            "20", "--record", written("drag.hrec")});
    answer({"play", case_folder(), "--out", written("played")});
    answer({"play", given(""), "--out", written("played from CT")});
    answer({"render", case_folder(), "--size", "320,240", "--out", written("picture.png")});
    answer({"compare", case_folder(), "--truth-tree", given(planted + ".vtp"), "--truth-mask",
            given(planted + "truth_mask.nii.gz")});
    EXPECT_EQ(found_in_files(case_folder()), "");
    EXPECT_EQ(found_in_files(root() / "written"), "");
}

TEST_F(Identity, IsOnlyTheNameThatTheUserGave) {
    answer({"play", given(planted), "--name", "Case 7", "--out", written("from_ct")});
    EXPECT_EQ(found_in_files(written("from_ct")), "");
    EXPECT_NE(bytes_of(written("from_ct/report.html")).find("Case 7"), std::string::npos);
    EXPECT_EQ(Json::parse(bytes_of(written("from_ct/patient.hep/case.json"))).at("name"), "Case 7");
}

}  // namespace
}  // namespace hepatica
