// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM segmentations that the program writes: read back by its own reader, by GDCM, and judged by
// dciodvfy (Debian's dicom3tools) where that is installed.
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmStringFilter.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "core/image/segmentation_writer.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/enhanced_ct.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

const std::vector<SegmentMeaning> meanings{
    {"Portal vein",
     {"91723000", "Anatomical Structure"},
     {"32764006", "Portal vein"},
     {120, 110, 204}},
    {"Nowhere", {"91723000", "Anatomical Structure"}, {"8993003", "Hepatic vein"}, {0, 0, 255}},
    {"Liver", {"91723000", "Anatomical Structure"}, {"10200004", "Liver"}, {171, 115, 94}}};

// A series on disk, a vessel on its grid and an organ on a finer one that lies aslant to it.
struct Scan {
    Scan() {
        Job job;
        write_dicom_series(ct, patterned_volume(turned_grid()), {}, job);
        for (std::size_t i = 0; i < vessel.voxels.size(); ++i) {
            const auto [x, y, z] = vessel.grid.index_of(i);
            vessel.voxels[i] = (z == 2 || z == 5) && x > 3 && y < 6 && (x + y) % 3 != 0 ? 255 : 0;
        }
        Grid fine = small_grid();
        fine.dims = {18, 16, 14};
        fine.spacing_mm = Vec3(0.4, 0.45, 0.5);
        fine.origin_mm = turned_grid().to_mm(2, 2, 1);
        organ = Mask(fine, 7);
    }
    bool in_organ(int x, int y, int z) const {
        return holds(organ.grid, turned_grid().to_mm(x, y, z));
    }
    std::vector<SegmentLayer> layers() const {
        return {{&vessel, {{255, 0}, {9, 1}}}, {&organ, {{7, 2}}}};
    }
    void write() const {
        Job job;
        write_dicom_segmentation(file, meanings, layers(), ct, 0, "1.2.3", job);
    }

    TemporaryFolder folder;
    fs::path ct = folder / "ct", file = folder / "vessels.dcm";
    Mask vessel{turned_grid()};
    Mask organ;
};

void expect_segment(const Scan& scan, int segment,
                    const std::function<bool(int, int, int)>& truth) {
    Job job;
    const std::vector<int> wanted{segment};
    const Mask mask = on_grid_of(turned_grid(), read_mask(scan.file, job, wanted), "file");
    std::size_t there = 0;
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = mask.grid.index_of(i);
        ASSERT_EQ(mask.voxels[i] != 0, truth(x, y, z)) << x << ", " << y << ", " << z;
        there += mask.voxels[i];
    }
    EXPECT_GT(there, 10u);
    EXPECT_LT(there, mask.voxels.size() / 2);
}

// A slice has 143 pixels, so that frames begin within bytes.
TEST(SegmentationWriter, EverySegmentLiesOnTheCtWhereItsVoxelsAre) {
    const Scan scan;
    scan.write();
    expect_segment(scan, 1, [&](int x, int y, int z) { return scan.vessel.at(x, y, z) != 0; });
    expect_segment(scan, 2, [&](int x, int y, int z) { return scan.in_organ(x, y, z); });
    EXPECT_FALSE(fs::exists(scan.folder / "vessels.dcm.tmp"));
}

std::string text(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element) {
    const gdcm::Tag tag(group, element);
    if (!data.FindDataElement(tag) || data.GetDataElement(tag).GetByteValue() == nullptr) return {};
    const gdcm::ByteValue& value = *data.GetDataElement(tag).GetByteValue();
    std::string text(value.GetPointer(), value.GetLength());
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    return text;
}

const gdcm::DataSet& item(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element,
                          std::size_t number = 1) {
    const auto sequence = data.GetDataElement(gdcm::Tag(group, element)).GetValueAsSQ();
    return sequence->GetItem(number).GetNestedDataSet();
}

TEST(SegmentationWriter, NamesItsSegmentsAndTheSlicesOfEachFrame) {
    const Scan scan;
    scan.write();
    gdcm::Reader file;
    file.SetFileName(scan.file.c_str());
    ASSERT_TRUE(file.Read());
    const gdcm::DataSet& data = file.GetFile().GetDataSet();
    EXPECT_EQ(text(data, 0x0008, 0x0016), "1.2.840.10008.5.1.4.1.1.66.4");
    EXPECT_EQ(text(data, 0x0008, 0x0060), "SEG");
    EXPECT_EQ(text(data, 0x0018, 0x1020), "1.2.3");
    // The segment without a pixel is left out, and the others are numbered without a gap.
    EXPECT_EQ(text(item(data, 0x0062, 0x0002, 1), 0x0062, 0x0005), "Portal vein");
    EXPECT_EQ(text(item(data, 0x0062, 0x0002, 2), 0x0062, 0x0005), "Liver");
    EXPECT_EQ(data.GetDataElement(gdcm::Tag(0x0062, 0x0002)).GetValueAsSQ()->GetNumberOfItems(),
              2u);
    EXPECT_EQ(text(item(item(data, 0x0062, 0x0002, 1), 0x0062, 0x000f), 0x0008, 0x0100),
              "32764006");
    // The first two frames are the vessel's slices 2 and 5, whichever way the files count.
    for (const auto& [frame, z] : {std::pair{1, 2}, std::pair{2, 5}}) {
        const gdcm::DataSet& group = item(data, 0x5200, 0x9230, static_cast<std::size_t>(frame));
        const std::string instance =
            text(item(item(group, 0x0008, 0x9124), 0x0008, 0x2112), 0x0008, 0x1155);
        bool found = false;
        for (const auto& entry : fs::directory_iterator(scan.ct)) {
            gdcm::Reader slice;
            slice.SetFileName(entry.path().c_str());
            ASSERT_TRUE(slice.Read());
            const gdcm::DataSet& header = slice.GetFile().GetDataSet();
            EXPECT_EQ(text(data, 0x0020, 0x000d), text(header, 0x0020, 0x000d));
            EXPECT_EQ(text(data, 0x0020, 0x0052), text(header, 0x0020, 0x0052));
            EXPECT_NE(text(data, 0x0020, 0x000e), text(header, 0x0020, 0x000e));
            EXPECT_EQ(text(data, 0x0010, 0x0010), text(header, 0x0010, 0x0010));
            if (text(header, 0x0008, 0x0018) != instance) continue;
            found = true;
            EXPECT_EQ(text(header, 0x0020, 0x0032),
                      text(item(group, 0x0020, 0x9113), 0x0020, 0x0032));
            const Vec3 corner = turned_grid().to_mm(0, 0, z);
            double height = 0.0;
            ASSERT_EQ(std::sscanf(text(header, 0x0020, 0x0032).c_str(), "%*f\\%*f\\%lf", &height),
                      1);
            EXPECT_NEAR(height, corner.z(), 1e-3);
        }
        EXPECT_TRUE(found) << instance;
    }
}

TEST(SegmentationWriter, IsValidForAnotherProgram) {
    if (std::system("command -v dciodvfy >/dev/null") != 0)
        GTEST_SKIP() << "dciodvfy (package dicom3tools) is not installed";
    const Scan scan;
    scan.write();
    const fs::path report = scan.folder / "report.txt";
    const std::string command = "dciodvfy '" + scan.file.string() + "' 2>'" + report.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string said = bytes_of_file(report);
    EXPECT_NE(said.find("Segmentation"), std::string::npos) << said;
    EXPECT_EQ(said.find("Error"), std::string::npos) << said;
}

TEST(SegmentationWriter, RefusesInWordsAndThenWritesNothing) {
    const Scan scan;
    Job job;
    const auto refused = [&](const fs::path& ct, const std::vector<SegmentLayer>& layers) {
        return refusal(
            [&] { write_dicom_segmentation(scan.file, meanings, layers, ct, 0, "1", job); });
    };
    const fs::path nifti = scan.folder / "ct.nii";
    write_nifti(nifti, patterned_volume(turned_grid()));
    EXPECT_NE(refused(nifti, scan.layers()).find("is no DICOM image"), std::string::npos);
    const Mask empty(turned_grid());
    EXPECT_NE(
        refused(scan.ct, {{&empty, {{1, 0}}}}).find("nothing of the segmentation lies in this"),
        std::string::npos);
    const TemporaryFolder multi;
    EnhancedCt(patterned_volume(turned_grid())).write(multi / "ct.dcm");
    EXPECT_NE(refused(multi.path(), scan.layers()).find("is an enhanced CT"), std::string::npos);
    EXPECT_FALSE(fs::exists(scan.file));
    job.cancel();
    EXPECT_THROW(write_dicom_segmentation(scan.file, meanings, scan.layers(), scan.ct, 0, "1", job),
                 Cancelled);
    EXPECT_FALSE(fs::exists(scan.file));
}

// Anonymisers take identifiers away, without which nothing can refer to a slice.
TEST(SegmentationWriter, NamesTheSliceThatLacksAnIdentifier) {
    const Scan scan;
    const fs::path victim = scan.ct / "slice_0004.dcm";
    gdcm::Reader reader;
    reader.SetFileName(victim.c_str());
    ASSERT_TRUE(reader.Read());
    reader.GetFile().GetDataSet().Remove(gdcm::Tag(0x0008, 0x0018));
    gdcm::Writer writer;
    writer.SetFile(reader.GetFile());
    writer.SetCheckFileMetaInformation(false);
    writer.SetFileName(victim.c_str());
    ASSERT_TRUE(writer.Write());
    const std::string said = refusal([&] { scan.write(); });
    EXPECT_NE(said.find("slice_0004.dcm: it has no SOP class and instance UID"), std::string::npos)
        << said;
    EXPECT_FALSE(fs::exists(scan.file));
}

}  // namespace
}  // namespace hepatica
