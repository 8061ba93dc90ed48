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

#include "core/base/child_process.h"
#include "core/base/program_files.h"
#include "core/image/segmentation_writer.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/dicom_folder.h"
#include "tests/image/enhanced_ct.h"
#include "tests/support/small_disk.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

const std::vector<SegmentMeaning> meanings{
    {"Vein that was painted",
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

// The direction cosines are rounded: taken as they stand, the last columns would be those before.
TEST(SegmentationWriter, AxesThatAreNoUnitsMoveNoPixel) {
    Grid wide = small_grid();
    wide.dims = {120, 5, 3};
    const DicomFolder series(patterned_volume(wide));
    series.edit_all(orientation, "0.992\\0\\0\\0\\0.992\\0");
    Job job;
    Mask drawn(read_volume(series.path(), job).grid);
    for (std::size_t i = 0; i < drawn.voxels.size(); ++i)
        drawn.voxels[i] = drawn.grid.index_of(i)[0] % 2 == 0 ? 1 : 0;
    const TemporaryFolder folder;
    const std::vector<SegmentLayer> layers{{&drawn, {{1, 0}}}};
    write_dicom_segmentation(folder / "vessels.dcm", {&meanings[0], 1}, layers, series.path(), 0,
                             "1.2.3", job);
    const Mask back = on_grid_of(drawn.grid, read_mask(folder / "vessels.dcm", job), "vessels.dcm");
    EXPECT_EQ(back.voxels, drawn.voxels);
}

gdcm::DataSet read_data(const fs::path& file) {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    EXPECT_TRUE(reader.Read()) << file;
    return reader.GetFile().GetDataSet();
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
    const gdcm::DataSet data = read_data(scan.file);
    EXPECT_EQ(text(data, 0x0008, 0x0016), "1.2.840.10008.5.1.4.1.1.66.4");
    EXPECT_EQ(text(data, 0x0008, 0x0060), "SEG");
    EXPECT_EQ(text(data, 0x0018, 0x1020), "1.2.3");
    // The segment without a pixel is left out, and the others are numbered without a gap.
    EXPECT_EQ(text(item(data, 0x0062, 0x0002, 1), 0x0062, 0x0005), "Vein that was painted");
    EXPECT_EQ(text(item(data, 0x0062, 0x0002, 2), 0x0062, 0x0005), "Liver");
    EXPECT_EQ(data.GetDataElement(gdcm::Tag(0x0062, 0x0002)).GetValueAsSQ()->GetNumberOfItems(),
              2u);
    const gdcm::DataSet& vein = item(data, 0x0062, 0x0002, 1);
    EXPECT_EQ(text(item(vein, 0x0062, 0x000f), 0x0008, 0x0100), "32764006");
    EXPECT_EQ(text(item(vein, 0x0062, 0x000f), 0x0008, 0x0104), "Portal vein");
    EXPECT_EQ(text(item(vein, 0x0062, 0x0003), 0x0008, 0x0100), "91723000");
    EXPECT_EQ(text(item(vein, 0x0062, 0x0003), 0x0008, 0x0104), "Anatomical Structure");
    const gdcm::DataSet& measures = item(item(data, 0x5200, 0x9229), 0x0028, 0x9110);
    EXPECT_NEAR(std::stod(text(measures, 0x0018, 0x0088)), 1.5, 1e-3);
    // The first two frames are the vessel's slices 2 and 5, whichever way the files count.
    for (const auto& [frame, z] : {std::pair{1, 2}, std::pair{2, 5}}) {
        const gdcm::DataSet& group = item(data, 0x5200, 0x9230, static_cast<std::size_t>(frame));
        const std::string instance =
            text(item(item(group, 0x0008, 0x9124), 0x0008, 0x2112), 0x0008, 0x1155);
        bool found = false;
        for (const auto& entry : fs::directory_iterator(scan.ct)) {
            const gdcm::DataSet header = read_data(entry.path());
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

// The numbers of an unsigned short, binary as DICOM has them.
std::vector<double> numbers(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element,
                            std::size_t bytes) {
    const gdcm::ByteValue& value = *data.GetDataElement(gdcm::Tag(group, element)).GetByteValue();
    std::vector<double> found;
    for (std::size_t at = 0; at + bytes <= value.GetLength(); at += bytes) {
        double number = 0.0;
        for (std::size_t b = bytes; b-- > 0;)
            number = 256.0 * number + static_cast<unsigned char>(value.GetPointer()[at + b]);
        found.push_back(number);
    }
    return found;
}

// L, a and b of a colour (CIE 1976 about D65, sRGB of IEC 61966-2-1).
Vec3 lab_of(const std::array<std::uint8_t, 3>& srgb) {
    Vec3 light;
    for (Eigen::Index c = 0; c < 3; ++c) {
        const double v = srgb[static_cast<std::size_t>(c)] / 255.0;
        light[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    Mat3 to_xyz;
    to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vec3 xyz = (to_xyz * light).cwiseQuotient(Vec3(0.9505, 1.0, 1.089));
    const Vec3 f = xyz.unaryExpr([](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    });
    return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

TEST(SegmentationWriter, RecommendsTheColoursThatItWasGiven) {
    const Scan scan;
    scan.write();
    const gdcm::DataSet data = read_data(scan.file);
    for (const auto& [segment, meaning] : {std::pair{1, 0}, std::pair{2, 2}}) {
        const std::vector<double> written = numbers(
            item(data, 0x0062, 0x0002, static_cast<std::size_t>(segment)), 0x0062, 0x000d, 2);
        ASSERT_EQ(written.size(), 3u);
        const Vec3 lab(written[0] * 100.0 / 65535.0, written[1] * 255.0 / 65535.0 - 128.0,
                       written[2] * 255.0 / 65535.0 - 128.0);  // PS3.3 C.10.7.1.1
        // The white of another lamp moves a colour by a few units.
        EXPECT_LT((lab - lab_of(meanings[static_cast<std::size_t>(meaning)].srgb)).norm(), 8.0)
            << lab.transpose();
    }
}

void remove_element(const fs::path& file, const gdcm::Tag& tag) {
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    ASSERT_TRUE(reader.Read());
    reader.GetFile().GetDataSet().Remove(tag);
    gdcm::Writer writer;
    writer.SetCheckFileMetaInformation(false);
    writer.SetFile(reader.GetFile());
    writer.SetFileName(file.c_str());
    ASSERT_TRUE(writer.Write());
}

// The helper's order by hand: a segment on one slice.
struct HandMadeOrder {
    void write(const fs::path& folder) const {
        for (const auto& [name, bytes] :
             {std::pair{"slices", &slices}, {"segments", &segments}, {"frames", &frames}})
            std::ofstream(folder / name, std::ios::binary) << *bytes;
    }
    static std::string segment(const std::string& label) {
        std::string values;
        for (const std::string& value :
             {label, std::string("91723000"), std::string("Anatomical Structure"),
              std::string("10200004"), label, std::string("171 115 94")})
            values += value + '\0';
        return values;
    }
    static std::size_t pixels() {
        const Index3 dims = turned_grid().dims;
        return static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]);
    }

    std::string slices;
    std::string segments = segment("Liver");
    std::string frames = std::string("\1\0\0\0\0\0", 6) + std::string(pixels(), '\1');
    static std::string second_frame() {
        return std::string("\2\0\0\0\0\0", 6) + std::string(pixels(), '\1');
    }
};

ChildOutcome carried_out(const fs::path& order, const fs::path& file) {
    return run_child(helper("hepatica-dicom-segmentation"), {order.string(), "1", file.string()},
                     {std::uint64_t{2} << 30, 120}, Job());
}

// The program's own readers refuse a series of one slice, so the helper is given its order by hand.
TEST(SegmentationWriter, ASingleSliceIsSpacedByItsThickness) {
    const Scan scan;
    const fs::path slice = scan.ct / "slice_0004.dcm";
    const auto cut = [&] {
        const TemporaryFolder order;
        HandMadeOrder{.slices = slice.string() + '\0'}.write(order.path());
        return carried_out(order.path(), scan.file);
    };
    const ChildOutcome written = cut();
    ASSERT_EQ(written.number, 0) << written.errors;
    const gdcm::DataSet data = read_data(scan.file);
    const gdcm::DataSet& measures = item(item(data, 0x5200, 0x9229), 0x0028, 0x9110);
    EXPECT_NEAR(std::stod(text(measures, 0x0018, 0x0088)), 1.5, 1e-3);
    remove_element(slice, gdcm::Tag(0x0018, 0x0050));
    const ChildOutcome refused = cut();
    EXPECT_EQ(refused.number, 1);
    EXPECT_NE(refused.errors.find("slice thickness"), std::string::npos) << refused.errors;
}

// What is missing would be missing in the file, too, and nobody would know.
TEST(SegmentationWriter, AnOrderThatIsCutOffOrCannotBeReadIsRefused) {
    const Scan scan;
    HandMadeOrder whole{.slices = (scan.ct / "slice_0004.dcm").string() + '\0'};
    whole.segments += HandMadeOrder::segment("Tumour");
    std::vector<HandMadeOrder> damaged(4, whole);
    whole.frames += HandMadeOrder::second_frame();
    damaged[0].slices.pop_back();
    damaged[1].segments.pop_back();
    damaged[2].segments.resize(whole.segments.size() - std::string("171 115 94").size() - 1);
    damaged[3].segments.replace(whole.segments.size() - 4, 3, " up");  // a colour of two numbers
    const auto expect_refused = [&](const TemporaryFolder& order, const std::string& what) {
        const ChildOutcome outcome = carried_out(order.path(), scan.file);
        EXPECT_EQ(outcome.number, 1) << what;
        EXPECT_NE(outcome.errors.find("cut off"), std::string::npos) << what << outcome.errors;
    };
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        const TemporaryFolder order;
        damaged[i].write(order.path());
        expect_refused(order, std::to_string(i));
    }
    const TemporaryFolder order;
    whole.write(order.path());
    EXPECT_EQ(carried_out(order.path(), scan.file).number, 0);
    fs::remove(order / "frames");
    expect_refused(order, "no frames");
    fs::create_directory(order / "frames");
    expect_refused(order, "frames that cannot be read");
}

// By which viewers sort frames: the segment's number, then the slice's, in one order of heights.
TEST(SegmentationWriter, NumbersEachFramesSegmentAndSlice) {
    const Scan scan;
    scan.write();
    const gdcm::DataSet data = read_data(scan.file);
    const std::size_t frames =
        data.GetDataElement(gdcm::Tag(0x5200, 0x9230)).GetValueAsSQ()->GetNumberOfItems();
    EXPECT_GT(frames, 4u);
    const int slices = turned_grid().dims[2];
    int upwards = 0, downwards = 0;
    for (std::size_t frame = 1; frame <= frames; ++frame) {
        const gdcm::DataSet& group = item(data, 0x5200, 0x9230, frame);
        const auto index = numbers(item(group, 0x0020, 0x9111), 0x0020, 0x9157, 4);
        ASSERT_EQ(index.size(), 2u);
        EXPECT_EQ(index[0], numbers(item(group, 0x0062, 0x000a), 0x0062, 0x000b, 2).at(0));
        Vec3 corner;
        ASSERT_EQ(std::sscanf(text(item(group, 0x0020, 0x9113), 0x0020, 0x0032).c_str(),
                              "%lf\\%lf\\%lf", &corner[0], &corner[1], &corner[2]),
                  3);
        const int z = static_cast<int>(std::lround(turned_grid().to_index(corner).z()));
        upwards += index[1] == z + 1;
        downwards += index[1] == slices - z;
    }
    EXPECT_EQ(std::max(upwards, downwards), static_cast<int>(frames));
}

// A frame of reference is what lays a segmentation over its CT: where the CT has lost its own, the
// file has one all the same.
TEST(SegmentationWriter, HasAFrameOfReferenceWhereTheCtLacksOne) {
    const Scan scan;
    for (const auto& entry : fs::directory_iterator(scan.ct))
        remove_element(entry.path(), gdcm::Tag(0x0020, 0x0052));
    scan.write();
    EXPECT_FALSE(text(read_data(scan.file), 0x0020, 0x0052).empty());
    expect_segment(scan, 1, [&](int x, int y, int z) { return scan.vessel.at(x, y, z) != 0; });
}

// A file that was cut off would be shown as if it were whole.
TEST(SegmentationWriter, SaysThatTheDiskIsFullAndLeavesNothing) {
    const Scan scan;
    scan.write();
    const std::uintmax_t whole = fs::file_size(scan.file);
    fs::remove(scan.file);
    // New identifiers are some characters longer or shorter, and what is missing is less than what
    // one write holds back.
    constexpr std::uintmax_t few = 200;
    for (const std::uintmax_t missing : {few, whole / 3}) {
        const std::string said = refusal([&] {
            const test::DiskOf disk(whole - missing);
            scan.write();
        });
        EXPECT_TRUE(said.starts_with(scan.file.string() + ": cannot be written: the disk takes no "
                                                          "more"))
            << said << " (the CT is not what is full)";
        EXPECT_FALSE(fs::exists(scan.file)) << missing << " bytes short";
    }
    scan.write();
    EXPECT_GT(fs::file_size(scan.file), whole - few);
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
    remove_element(victim, gdcm::Tag(0x0008, 0x0018));
    const std::string said = refusal([&] { scan.write(); });
    EXPECT_NE(said.find("slice_0004.dcm: it has no SOP class and instance UID"), std::string::npos)
        << said;
    EXPECT_FALSE(fs::exists(scan.file));
}

}  // namespace
}  // namespace hepatica
