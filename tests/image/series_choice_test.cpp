// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of several series: which one is read, and how the user hears of it.
#include <gtest/gtest.h>

#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

const gdcm::Tag kernel(0x0018, 0x1210);
const gdcm::Tag study_date(0x0008, 0x0020);
const gdcm::Tag description(0x0008, 0x103e);
const gdcm::Tag acquisition(0x0020, 0x0012);

// Several series below one folder, each with voxels of one value.
class Examination {
  public:
    void add(const std::string& name, int slices, std::int16_t value, double spacing_mm = 1.5,
             const std::string& kernel_name = "") {
        Grid grid = small_grid();
        grid.dims[2] = slices;
        grid.spacing_mm[2] = spacing_mm;
        DicomSeriesInfo info;
        info.series_description = name;
        Job job;
        write_dicom_series(folder_ / name, Volume(grid, value), info, job);
        if (!kernel_name.empty()) edit(name, kernel, kernel_name);
    }
    void edit(const std::string& name, const gdcm::Tag& tag, const std::string& value) const {
        for (const auto& entry : fs::directory_iterator(folder_ / name))
            DicomFolder::edit_file(entry.path(), tag, value);
    }
    std::int16_t value_read(ReadRemarks* remarks = nullptr, int series = 0) const {
        Job job;
        return read_volume(path(), job, remarks, series).voxels[0];
    }
    const fs::path& path() const { return folder_.path(); }

  private:
    TemporaryFolder folder_;
};

// The lung kernel has more slices than the soft tissue, as it usually has.
TEST(SeriesChoice, PrefersSoftTissueToALungKernelAndSaysSo) {
    for (const auto& [soft, sharp] :
         {std::pair{"B30f", "B70f"}, std::pair{"STANDARD", "LUNG"}, std::pair{"FC08", "FC52"},
          std::pair{"Br40d", "Bl64d"}, std::pair{"I31f", "BONEPLUS"}}) {
        Examination exam;
        exam.add("abdomen", 12, 60, 1.5, soft);
        exam.add("thorax", 20, 900, 1.5, sharp);
        ReadRemarks remarks;
        EXPECT_EQ(exam.value_read(&remarks), 60) << sharp;
        ASSERT_EQ(remarks.size(), 1u);
        for (const char* part :
             {"abdomen", "thorax", soft, sharp, "its kernel is for soft tissue", "--series 2"})
            EXPECT_NE(remarks[0].find(part), std::string::npos) << part << ": " << remarks[0];
        EXPECT_EQ(exam.value_read(&remarks, 2), 900);  // the other is offered
    }
}

TEST(SeriesChoice, SaysAKernelOfSeveralValuesWithoutABackslash) {
    Examination exam;
    exam.add("abdomen", 12, 60, 1.5, "B30f\\3");
    exam.add("thorax", 20, 900, 1.5, "B70f\\3");
    ReadRemarks remarks;
    exam.value_read(&remarks);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("B30f/3"), std::string::npos) << remarks[0];
    EXPECT_EQ(remarks[0].find('\\'), std::string::npos) << remarks[0];
}

// Their word "series" can be translated then, and a choice of one's own is told once.
TEST(SeriesChoice, QuotesTheNamesOfSeriesAlone) {
    Examination exam;
    exam.add("portal", 16, 30);
    exam.add("late", 16, 20);
    exam.add("native", 16, 10);
    exam.edit("portal", series_number, "7");
    exam.edit("native", series_number, "");
    ReadRemarks remarks, wished;
    exam.value_read(&remarks);
    ASSERT_EQ(remarks.size(), 2u);
    for (const std::string& remark : remarks) {
        EXPECT_TRUE(remark.starts_with("Read series 7 “portal” (CT, 16 images")) << remark;
        EXPECT_EQ(remark.find('"'), std::string::npos) << remark;
    }
    EXPECT_NE(remarks[1].find("left out a series “native” (CT"), std::string::npos) << remarks[1];
    exam.value_read(&wished, 3);
    ASSERT_EQ(wished.size(), 1u);
    EXPECT_TRUE(wished[0].starts_with("Read a series “native” (CT")) << wished[0];
    EXPECT_NE(wished[0].find("the best of them series 7 “portal”"), std::string::npos) << wished[0];
}

// However many there are, each sentence says which of them its number reads.
TEST(SeriesChoice, SaysOfAnyNumberOfSeriesHowTheOthersAreRead) {
    Examination exam;
    exam.add("portal", 16, 30);
    exam.add("late", 16, 20);
    ReadRemarks remarks, wished;
    exam.value_read(&remarks);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(
        remarks[0].ends_with(". On the command line --series 2 reads the one that was left out."))
        << remarks[0];
    exam.value_read(&wished, 2);
    ASSERT_EQ(wished.size(), 1u);
    EXPECT_TRUE(wished[0].ends_with(
        " as asked for. On the command line --series 1 reads the one that was left out."))
        << wished[0];
    exam.add("native", 16, 10);
    exam.value_read(&remarks);
    ASSERT_EQ(remarks.size(), 3u);
    EXPECT_TRUE(remarks[2].ends_with("--series 3 reads the one that was left out.")) << remarks[2];
    exam.value_read(&wished, 3);
    ASSERT_EQ(wished.size(), 2u);
    EXPECT_NE(wished[1].find(" and left out 2 others as asked for, the best of them "),
              std::string::npos)
        << wished[1];
    EXPECT_TRUE(wished[1].ends_with(
        ". On the command line --series 1 reads that one, and other numbers read the others."))
        << wished[1];
}

TEST(SeriesChoice, PrefersThePortalVenousPhaseAndThinSlices) {
    Examination phases;
    phases.add("native", 16, 10);
    phases.add("arterial", 16, 20);
    phases.add("portal venous", 12, 30);
    phases.add("delayed 5 min", 16, 40);
    ReadRemarks remarks;
    EXPECT_EQ(phases.value_read(&remarks), 30);
    ASSERT_EQ(remarks.size(), 3u);
    EXPECT_NE(remarks[0].find("because of its phase of the contrast"), std::string::npos);

    Examination thickness;
    thickness.add("thick", 12, 10, 5.0);
    thickness.add("thin", 40, 20, 1.5);
    EXPECT_EQ(thickness.value_read(), 20);
}

// A liver is scanned in the late arterial phase: its veins have no contrast yet.
TEST(SeriesChoice, TakesALateArterialPhaseForArterial) {
    Examination exam;
    exam.add("late arterial", 20, 20);
    exam.add("delayed", 16, 40);
    EXPECT_EQ(exam.value_read(), 40);
}

// What a scanner writes of the dose is a picture of text, but a CT of low dose is a CT.
TEST(SeriesChoice, TellsASeriesOfLowDoseFromAReportOfTheDose) {
    Examination low;
    low.add("abdomen low dose", 16, 60, 1.5, "B30f");
    low.add("thorax", 20, 900, 1.5, "B70f");
    EXPECT_EQ(low.value_read(), 60);

    Examination report;
    report.add("abdomen", 16, 60);
    report.add("Dose Report", 20, 5);
    EXPECT_EQ(report.value_read(), 60);
}

// Naming one of its files chooses a series; a scout belongs to none.
TEST(SeriesChoice, IsNotAskedForByNamingAScout) {
    Examination exam;
    exam.add("portal", 16, 30);
    exam.add("native", 16, 10);
    exam.add("scout", 2, 5);
    exam.edit("scout", image_type, "ORIGINAL\\PRIMARY\\LOCALIZER");
    const fs::path named = exam.path() / "named.dcm";
    fs::copy_file(exam.path() / "scout" / "slice_0001.dcm", named);
    Job job;
    ReadRemarks remarks;
    EXPECT_EQ(read_volume(named, job, &remarks).voxels[0], 30);
    EXPECT_TRUE(mentions(remarks, "because of its phase of the contrast")) << remarks.size();
    EXPECT_FALSE(mentions(remarks, "as asked for"));
}

TEST(SeriesChoice, TakesSlicesOfATiltedGantryForAxial) {
    Examination exam;
    exam.add("sharp", 20, 900, 1.5, "B70f");
    exam.add("tilted", 20, 60, 1.5, "B30f");
    exam.edit("tilted", orientation, "1\\0\\0\\0\\0.8660254\\0.5");  // by 30 degrees
    EXPECT_EQ(exam.value_read(), 60);
}

// A few slices at one level, taken to see the contrast arrive, are no examination.
TEST(SeriesChoice, IgnoresAShortSeriesWhateverItsName) {
    Examination exam;
    exam.add("abdomen", 20, 60);
    exam.add("portal bolus tracking", 3, 90);
    EXPECT_EQ(exam.value_read(), 60);
}

TEST(SeriesChoice, IsListedBestFirstWithTheReason) {
    Examination exam;
    exam.add("lung", 20, 900, 1.5, "B70f");
    exam.add("portal", 16, 60, 2.0, "B30f");
    Job job;
    const std::vector<SeriesDescription> list = list_series(exam.path(), job);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_NE(list[0].description.find("portal"), std::string::npos);
    EXPECT_EQ(list[0].slices, 16u);
    EXPECT_NEAR(list[0].spacing_mm, 2.0, 1e-9);
    EXPECT_EQ(list[0].kernel, "B30f");
    EXPECT_EQ(list[0].phase, "portal venous phase");
    EXPECT_EQ(list[0].why_not_chosen, "");
    EXPECT_EQ(list[1].why_not_chosen, "its kernel is for soft tissue");
    EXPECT_EQ(exam.value_read(nullptr, 1), 60);
    EXPECT_NE(refusal([&] { exam.value_read(nullptr, 3); }).find("no number 3"), std::string::npos);
}

// What would be refused or show little is said before anybody waits for it.
TEST(SeriesChoice, WarnsOfWhatSpeaksAgainstASeries) {
    Examination exam;
    exam.add("portal", 16, 60, 2.0);
    exam.add("thick", 16, 60, 5.0);
    exam.add("native", 16, 60, 2.0);
    exam.add("holed", 16, 60, 2.0);
    exam.add("magnets", 16, 60, 2.0);
    exam.add("copied by halves", 16, 60, 2.0);
    exam.edit("magnets", modality, "MR");
    const fs::path half = exam.path() / "copied by halves" / "slice_0008.dcm";
    fs::resize_file(half, fs::file_size(half) - 100);
    fs::remove(exam.path() / "holed" / "slice_0008.dcm");
    Job job;
    const std::vector<SeriesDescription> list = list_series(exam.path(), job);
    ASSERT_EQ(list.size(), 6u);
    const auto warnings = [&](const char* name) {
        for (const SeriesDescription& one : list)
            if (one.description.find(name) != std::string::npos) return one.warnings;
        return std::vector<std::string>{"not found"};
    };
    const std::string slab = "it is 32 mm high: not all of the liver is in it";
    EXPECT_EQ(warnings("portal"), std::vector<std::string>{slab});
    EXPECT_EQ(warnings("thick"),
              (std::vector<std::string>{"its slices lie far apart: thin vessels are lost",
                                        "it is 80 mm high: not all of the liver is in it"}));
    EXPECT_EQ(warnings("native"),
              (std::vector<std::string>{slab, "without contrast no vessel is seen"}));
    EXPECT_EQ(warnings("magnets"), std::vector<std::string>{"it is no CT"});
    EXPECT_EQ(
        warnings("copied by halves"),
        (std::vector<std::string>{"it cannot be read: has fewer pixels than its header claims "
                                  "(“slice_0008.dcm”)",
                                  slab}));
    ASSERT_EQ(warnings("holed").size(), 2u);
    EXPECT_TRUE(warnings("holed")[0].starts_with("it cannot be read: 1 slice is missing between"))
        << warnings("holed")[0];
}

TEST(SeriesChoice, HasNothingToSayOfOneThatHoldsTheLiver) {
    Examination exam;
    exam.add("portal", 60, 60, 2.0);
    Job job;
    EXPECT_TRUE(list_series(exam.path(), job).at(0).warnings.empty());
}

// Anonymisers blank the UIDs; examinations of two dates were stacked into one.
TEST(SeriesChoice, TellsExaminationsWithoutIdentifiersApart) {
    for (const auto& [tag, one, other] :
         {std::tuple{study_date, "20200101", "20210203"}, std::tuple{series_number, "2", "3"},
          std::tuple{kernel, "B30f", "B31f"}, std::tuple{acquisition, "1", "2"}}) {
        Examination exam;
        exam.add("a", 12, 60);
        exam.add("b", 14, 70);
        for (const char* name : {"a", "b"}) {
            exam.edit(name, series_uid, "");
            exam.edit(name, study_uid, "");
            exam.edit(name, gdcm::Tag(0x0020, 0x0052), "");  // frame of reference
            exam.edit(name, description, "CT");
        }
        exam.edit("a", tag, one);
        exam.edit("b", tag, other);
        ReadRemarks remarks;
        EXPECT_EQ(exam.value_read(&remarks), 70) << tag;
        EXPECT_EQ(remarks.size(), 1u);
    }
}

}  // namespace
}  // namespace hepatica
