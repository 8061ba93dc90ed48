// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM series written by the program, then bent in every way that real folders are bent.
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <functional>

#include "core/base/parallel.h"
#include "core/image/dicom_reader.h"
#include "core/image/dicom_slices.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/dicom_folder.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

TEST(Dicom, ComesBackAsItWasWritten) {
    for (const Grid& grid : {small_grid(), turned_grid()}) {
        const DicomFolder folder(patterned_volume(grid));
        ReadRemarks remarks;
        const Volume read = folder.read(&remarks);
        EXPECT_TRUE(same_grid(read.grid, grid));
        EXPECT_EQ(read.voxels, folder.volume().voxels);
        EXPECT_TRUE(remarks.empty());
    }
}

// As PS3.3 C.8.2.1 wants the pixels of a CT: 16 bits, signed (1; there is no 2), one sample.
TEST(Dicom, DescribesItsPixelsAsTheStandardAsks) {
    const DicomFolder folder;
    gdcm::Reader reader;
    reader.SetFileName(folder.slice(1).c_str());
    ASSERT_TRUE(reader.Read());
    const gdcm::DataSet& data = reader.GetFile().GetDataSet();
    const auto number = [&](std::uint16_t element) {
        const gdcm::ByteValue* value =
            data.GetDataElement(gdcm::Tag(0x0028, element)).GetByteValue();
        std::uint16_t read = 0;
        if (value != nullptr && value->GetLength() == sizeof(read))
            std::memcpy(&read, value->GetPointer(), sizeof(read));
        return read;
    };
    EXPECT_EQ(number(0x0002), 1) << "samples per pixel";
    EXPECT_EQ(number(0x0100), 16) << "bits allocated";
    EXPECT_EQ(number(0x0101), 16) << "bits stored";
    EXPECT_EQ(number(0x0102), 15) << "high bit";
    EXPECT_EQ(number(0x0103), 1) << "pixel representation";
}

TEST(Dicom, IsWrittenWithTheSameBytesEveryTime) {
    const DicomFolder a;
    const DicomFolder b;
    EXPECT_EQ(bytes_of_file(a.slice(4)), bytes_of_file(b.slice(4)));
    Volume other = a.volume();
    other.voxels[0] += 1;
    const DicomFolder c(other);
    EXPECT_NE(bytes_of_file(a.slice(4)), bytes_of_file(c.slice(4)));  // other content, other UIDs
}

TEST(Dicom, SortsByPositionWhateverTheNames) {
    const DicomFolder folder;
    const char* names[] = {"x.9", "10", "IM", "a.b.c", "zz", "1", "image_2", "image_10", "0.dcm"};
    for (int i = 1; i <= 9; ++i) fs::rename(folder.slice(i), folder.path() / names[i * 5 % 9]);
    EXPECT_EQ(folder.read().voxels, folder.volume().voxels);
}

TEST(Dicom, IsFoundFromOneOfItsFilesAndFromADicomdir) {
    const DicomFolder folder;
    write_bytes(folder.path() / "DICOMDIR", "not read, only its place matters");
    Job job;
    EXPECT_EQ(read_volume(folder.slice(3), job).voxels, folder.volume().voxels);
    EXPECT_EQ(read_volume(folder.path() / "DICOMDIR", job).voxels, folder.volume().voxels);
}

TEST(Dicom, PassesOverFilesThatAreNoImages) {
    const DicomFolder folder;
    write_bytes(folder.path() / "report.pdf", std::string(5000, 'p'));
    write_bytes(folder.path() / "empty", "");
    write_bytes(folder.path() / ".DS_Store", std::string(300, '\0'));
    write_bytes(folder.path() / "preamble only", std::string(128, '\0') + "DICM");
    fs::create_symlink("nowhere", folder.path() / "broken link");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    ASSERT_EQ(remarks.size(), 2u);  // the preamble without data, and the link
    EXPECT_NE((remarks[0] + remarks[1]).find("broken link” was passed over (a link to nothing)"),
              std::string::npos);
}

// Another user's rights, where the test runs as root, whom nothing is forbidden.
class AsNobody {
  public:
    AsNobody() : user_(geteuid()) {
        if (user_ == 0) {
            EXPECT_EQ(seteuid(65534), 0);
        }
    }
    ~AsNobody() { EXPECT_EQ(seteuid(user_), 0); }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

  private:
    uid_t user_;
};

// Whether it exists is not known then, and no error of the file system may come through.
TEST(Dicom, BelowAFolderThatMayNotBeEnteredIsRefusedWithTheReason) {
    const DicomFolder folder;
    fs::permissions(folder.path(), fs::perms::none);
    std::vector<std::string> refusals;
    {
        const AsNobody nobody;
        Job job;
        for (const fs::path& path : {folder.slice(1), folder.path() / "series"}) {
            refusals.push_back(refusal([&] { read_volume(path, job); }));
            refusals.push_back(refusal([&] { find_series(path, 0, job); }));
        }
    }
    fs::permissions(folder.path(), fs::perms::owner_all);
    for (const std::string& refused : refusals)
        EXPECT_NE(refused.find("cannot be opened (Permission denied)"), std::string::npos)
            << refused;
}

// The same without permissions: no file system has such a name.
TEST(Dicom, OfANameThatNoFileCanHaveIsRefusedWithTheReason) {
    const fs::path path(std::string(300, 'x'));
    Job job;
    for (const std::string& refused :
         {refusal([&] { read_volume(path, job); }), refusal([&] { read_mask(path, job); }),
          refusal([&] { list_series(path, job); }), refusal([&] { find_series(path, 0, job); })})
        EXPECT_NE(refused.find("cannot be opened (File name too long)"), std::string::npos)
            << refused;
    EXPECT_NE(refusal([&] { find_series({}, 0, job); }).find("is no DICOM image"),
              std::string::npos);
}

// What a scan of the folder could not see is said; the rest is read.
TEST(Dicom, NamesFoldersAndFilesThatMayNotBeRead) {
    const DicomFolder folder;
    fs::create_directory(folder.path() / "a locked");
    write_bytes(folder.path() / "b locked.dcm", "not for you");
    for (const char* name : {"a locked", "b locked.dcm"})
        fs::permissions(folder.path() / name, fs::perms::none);
    for (const fs::path& open : {fs::temp_directory_path(), folder.path()})
        fs::permissions(open, fs::perms::all & ~fs::perms::group_write & ~fs::perms::others_write);
    ReadRemarks remarks;
    Volume read;
    {
        const AsNobody nobody;
        read = folder.read(&remarks);
    }
    fs::permissions(folder.path() / "a locked", fs::perms::owner_all);
    EXPECT_EQ(read.voxels, folder.volume().voxels);
    ASSERT_EQ(remarks.size(), 2u);
    EXPECT_NE(remarks[0].find("a locked” could not be listed (Permission denied)"),
              std::string::npos)
        << remarks[0];
    EXPECT_NE(remarks[1].find("b locked.dcm” was passed over (Permission denied)"),
              std::string::npos)
        << remarks[1];
}

TEST(Dicom, ReadsEverySupportedCompression) {
    for (const auto syntax :
         {gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::JPEGLosslessProcess14_1,
          gdcm::TransferSyntax::RLELossless, gdcm::TransferSyntax::JPEGLSLossless,
          gdcm::TransferSyntax::ImplicitVRLittleEndian,
          gdcm::TransferSyntax::ExplicitVRBigEndian}) {
        const DicomFolder folder;
        for (int i = 1; i <= 9; ++i) {
            gdcm::ImageReader reader;
            reader.SetFileName(folder.slice(i).c_str());
            ASSERT_TRUE(reader.Read());
            gdcm::ImageChangeTransferSyntax change;
            change.SetTransferSyntax(syntax);
            change.SetInput(reader.GetImage());
            ASSERT_TRUE(change.Change());
            gdcm::ImageWriter writer;
            writer.SetFileName(folder.slice(i).c_str());
            writer.SetFile(reader.GetFile());
            writer.SetImage(change.GetOutput());
            ASSERT_TRUE(writer.Write());
        }
        EXPECT_EQ(folder.read().voxels, folder.volume().voxels)
            << gdcm::TransferSyntax::GetTSString(syntax);
    }
}

TEST(Dicom, ReadsSeriesThatLostTheirIdentifiers) {
    const DicomFolder folder;
    for (const gdcm::Tag& tag : {series_uid, study_uid, series_number}) folder.edit_all(tag, "");
    folder.edit_all(modality, "");
    EXPECT_EQ(folder.read().voxels, folder.volume().voxels);
}

TEST(Dicom, AppliesEachSlicesOwnRescale) {
    const DicomFolder folder;
    folder.edit(2, slope, "2");
    folder.edit(2, intercept, "-100");
    const Volume read = folder.read();
    EXPECT_EQ(read.at(5, 6, 1), 2 * folder.volume().at(5, 6, 1) - 100);
    EXPECT_EQ(read.at(5, 6, 2), folder.volume().at(5, 6, 2));
}

TEST(Dicom, TakesTheLargestCtSeriesAndNamesTheOthers) {
    const DicomFolder folder;
    Job job;
    Grid grid = small_grid();
    grid.dims[2] = 4;
    DicomSeriesInfo late;
    late.series_description = "late phase";
    write_dicom_series(folder.path() / "deeper" / "late", patterned_volume(grid), late, job);
    grid.dims[2] = 20;
    DicomSeriesInfo mr;
    mr.series_description = "not a CT";
    write_dicom_series(folder.path() / "mr", patterned_volume(grid), mr, job);
    for (const auto& entry : fs::directory_iterator(folder.path() / "mr"))
        DicomFolder::edit_file(entry.path(), modality, "MR");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).grid.dims[2], 9);
    ASSERT_EQ(remarks.size(), 2u);
    const std::string both = remarks[0] + remarks[1];
    EXPECT_NE(both.find("late phase"), std::string::npos);
    EXPECT_NE(both.find("it covers more of the body"), std::string::npos);
    EXPECT_NE(both.find("not a CT"), std::string::npos);
    // Asked by one of its files, the smaller series is read.
    EXPECT_EQ(read_volume(folder.path() / "deeper" / "late" / "slice_0002.dcm", job).grid.dims[2],
              4);
}

TEST(Dicom, LeavesOutScouts) {
    const DicomFolder folder;
    fs::copy_file(folder.slice(1), folder.path() / "scout");
    DicomFolder::edit_file(folder.path() / "scout", image_type, "ORIGINAL\\PRIMARY\\LOCALIZER");
    DicomFolder::edit_file(folder.path() / "scout", orientation, "1\\0\\0\\0\\0\\-1");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("scout"), std::string::npos);
}

TEST(Dicom, ReadsASliceThatStandsThereTwiceOnce) {
    const DicomFolder folder;
    fs::copy_file(folder.slice(5), folder.path() / "again.dcm");
    ReadRemarks remarks;
    EXPECT_EQ(folder.read(&remarks).voxels, folder.volume().voxels);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("twice"), std::string::npos);
}

// A series may stand there twice, and decoding takes long: a look for each file, and one for each
// comparison.
TEST(Dicom, AsksBeforeEachSliceThatIsCompared) {
    const DicomFolder folder;
    const auto checks = [&] {
        std::atomic<int> count = 0;
        Job job;
        job.observe([&](JobEvent event) { count += event == JobEvent::check ? 1 : 0; });
        read_volume(folder.path(), job);
        return count.load();
    };
    const int once = checks();
    const int slices = folder.volume().grid.dims[2];
    for (int i = 1; i <= slices; ++i)
        fs::copy_file(folder.slice(i), folder.path() / ("again " + std::to_string(i) + ".dcm"));
    EXPECT_GE(checks(), once + 2 * slices);
}

// As 3D-IRCADb hands out its experts' masks.
TEST(Dicom, ServesAsAMask) {
    Volume drawn(small_grid());
    for (std::size_t i = 0; i < drawn.voxels.size(); i += 5) drawn.voxels[i] = 255;
    const DicomFolder folder(drawn);
    Job job;
    const Mask mask = read_mask(folder.path(), job);
    EXPECT_TRUE(same_grid(mask.grid, drawn.grid));
    for (std::size_t i = 0; i < mask.voxels.size(); ++i)
        ASSERT_EQ(mask.voxels[i], i % 5 == 0 ? 1 : 0);
    const std::vector<int> other{7};
    EXPECT_NE(refusal([&] { read_mask(folder.path(), job, other); }), "");
}

TEST(BadDicom, WithTwoPhasesInOnePlaceIsRefused) {
    const DicomFolder folder;
    fs::copy_file(folder.slice(5), folder.path() / "again.dcm");
    DicomFolder::edit_file(folder.path() / "again.dcm", intercept, "60");
    EXPECT_NE(folder.refusal_of_folder().find("same place"), std::string::npos);
}

TEST(BadDicom, WithASliceMissingIsRefusedByItsNeighbours) {
    const DicomFolder one;
    fs::remove(one.slice(4));
    const std::string message = one.refusal_of_folder();
    EXPECT_NE(message.find("1 slice is missing between “slice_0003.dcm” and “slice_0005.dcm”"),
              std::string::npos)
        << message;
    const DicomFolder two;
    fs::remove(two.slice(6));
    fs::remove(two.slice(7));
    EXPECT_NE(two.refusal_of_folder().find("2 slices are missing"), std::string::npos);
}

TEST(BadDicom, WithUnevenGapsIsRefused) {
    const DicomFolder folder;
    folder.edit(6, position, "-31.25\\17.5\\-394.1");  // 0.4 mm off the even spacing of 1.5
    const std::string message = folder.refusal_of_folder();
    EXPECT_NE(message.find("gap between"), std::string::npos) << message;
    EXPECT_NE(message.find("slice_0006.dcm"), std::string::npos) << message;
}

TEST(BadDicom, WithASliceShiftedSidewaysIsRefused) {
    const DicomFolder folder;
    folder.edit(6, position, "-30.25\\17.5\\-394.5");
    EXPECT_NE(folder.refusal_of_folder().find("sideways"), std::string::npos);
}

TEST(BadDicom, WithMixedOrientationsSizesOrSpacingsIsRefused) {
    const DicomFolder turned;
    turned.edit(3, orientation, "1\\0\\0\\0\\0\\-1");
    EXPECT_NE(turned.refusal_of_folder().find("slice_0003.dcm: is oriented otherwise"),
              std::string::npos);
    const DicomFolder coarser;
    coarser.edit(3, pixel_spacing, "0.9\\0.9");
    EXPECT_NE(coarser.refusal_of_folder().find("slice_0003.dcm: has pixels of 0.9 mm"),
              std::string::npos);

    const DicomFolder smaller;
    Grid grid = small_grid();
    grid.dims[0] = 10;
    Job job;
    const TemporaryFolder other;
    write_dicom_series(other / "ct", patterned_volume(grid), {}, job);
    fs::copy_file(other / "ct" / "slice_0003.dcm", smaller.slice(3),
                  fs::copy_options::overwrite_existing);
    smaller.edit_all(series_uid, "1.2.3");
    EXPECT_NE(smaller.refusal_of_folder().find("has 10 x 11 pixels"), std::string::npos);
}

TEST(BadDicom, WithoutASoundGeometryIsRefused) {
    for (const std::string spacing : {"0\\0", "-1\\1", "abc\\1", "nan\\nan", ""}) {
        const DicomFolder folder;
        folder.edit_all(pixel_spacing, spacing);
        EXPECT_NE(folder.refusal_of_folder().find("spacing"), std::string::npos) << spacing;
    }
    const DicomFolder nowhere;
    nowhere.edit(2, position, "");
    EXPECT_NE(nowhere.refusal_of_folder().find("slice_0002.dcm: has no position"),
              std::string::npos);
    const DicomFolder skewed;
    skewed.edit_all(orientation, "1\\0\\0\\1\\0\\0");
    EXPECT_NE(skewed.refusal_of_folder().find("perpendicular"), std::string::npos);
    const DicomFolder flat;
    flat.edit_all(slope, "0");
    EXPECT_NE(flat.refusal_of_folder(), "");
}

TEST(BadDicom, BeyondTenMetresIsRefusedByValue) {
    const DicomFolder folder;
    for (int i = 1; i <= 9; ++i)
        folder.edit(i, position, "1e21\\17.5\\" + std::to_string(-402.0 + 1.5 * (i - 1)));
    const std::string message = folder.refusal_of_folder();
    EXPECT_NE(message.find("1e+21"), std::string::npos) << message;
}

TEST(BadDicom, CutShortIsRefusedByName) {
    const DicomFolder folder;
    const std::string whole = bytes_of_file(folder.slice(7));
    write_bytes(folder.slice(7), whole.substr(0, whole.size() - 60));
    EXPECT_NE(folder.refusal_of_folder().find("slice_0007.dcm"), std::string::npos);
}

TEST(BadDicom, OfOtherKindsIsRefusedWithTheReason) {
    const DicomFolder mr;
    mr.edit_all(modality, "MR");
    EXPECT_NE(mr.refusal_of_folder().find("no CT series"), std::string::npos);
    EXPECT_NE(mr.refusal_of_folder().find("(“MR”, 9 images, 1.5 mm apart)"), std::string::npos);

    const DicomFolder multi;
    for (int i = 2; i <= 9; ++i) fs::remove(multi.slice(i));
    EXPECT_NE(multi.refusal_of_folder().find("only one slice"), std::string::npos);
    multi.edit(1, frames, "100000");
    EXPECT_NE(multi.refusal_of_folder().find("100000 frames"), std::string::npos);

    const TemporaryFolder empty;
    Job job;
    EXPECT_NE(refusal([&] { read_volume(empty.path(), job); }).find("is empty"), std::string::npos);
    write_bytes(empty / "readme.txt", "no images here");
    EXPECT_NE(refusal([&] { read_volume(empty.path(), job); }).find("no DICOM images"),
              std::string::npos);
}

TEST(Dicom, ReadsTheSameForAnyNumberOfThreadsAndStopsWhenCancelled) {
    const DicomFolder folder;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        EXPECT_EQ(folder.read().voxels, folder.volume().voxels);
    }
    Job job;
    job.cancel();
    EXPECT_THROW(read_volume(folder.path(), job), Cancelled);
    const TemporaryFolder out;
    EXPECT_THROW(write_dicom_series(out / "ct", folder.volume(), {}, job), Cancelled);
    EXPECT_TRUE(fs::is_empty(out.path()));
}

// DICOM counts rows and columns in 16 bits.
TEST(DicomWriter, RefusesMoreRowsOrColumnsThanCanBeCounted) {
    const TemporaryFolder out;
    Job job;
    for (const std::size_t axis : {0u, 1u}) {
        Grid grid = small_grid();
        grid.dims = {1, 1, 1};
        grid.dims[axis] = 65535;
        write_dicom_series(out / "most", Volume(grid), {}, job);
        const auto slice = read_dicom_slice(out / "most" / "slice_0001.dcm");
        ASSERT_TRUE(slice);
        EXPECT_EQ(slice->columns, grid.dims[0]);
        EXPECT_EQ(slice->rows, grid.dims[1]);
        grid.dims[axis] = 65536;
        const std::string message =
            refusal([&] { write_dicom_series(out / "more", Volume(grid), {}, job); });
        EXPECT_NE(message.find("65536 pixels"), std::string::npos) << message;
        EXPECT_FALSE(fs::exists(out / "more"));
    }
}

}  // namespace
}  // namespace hepatica
