// SPDX-License-Identifier: GPL-3.0-or-later
// Files with random bytes changed, cut or doubled: they are read or refused, and nothing else
// happens. (Under the sanitizers this test also shows reads beyond a buffer.)
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gtest/gtest.h>

#include <random>

#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/image/voxel_file.h"
#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

std::string damaged(std::string bytes, std::mt19937_64& engine, std::size_t header_bytes) {
    const std::size_t reach =
        engine() % 2 == 0 ? std::min(header_bytes, bytes.size()) : bytes.size();
    for (std::uint64_t n = 1 + engine() % 6; n > 0; --n)
        bytes[engine() % reach] = static_cast<char>(engine());
    if (engine() % 8 == 0) bytes.resize(engine() % bytes.size());
    if (engine() % 16 == 0) bytes += bytes;
    return bytes;
}

// How many of `rounds` damaged copies of the file were refused.
int refusals(const fs::path& file, const fs::path& to_read, std::size_t header_bytes, int rounds) {
    const std::string whole = bytes_of_file(file);
    std::mt19937_64 engine(whole.size());
    int refused = 0;
    for (int i = 0; i < rounds; ++i) {
        write_bytes(file, damaged(whole, engine, header_bytes));
        Job job;
        refused += refusal([&] { read_volume(to_read, job); }).empty() ? 0 : 1;
        refusal([&] { read_label_map(to_read, job); });
    }
    write_bytes(file, whole);
    return refused;
}

// Its text is long enough for the voxels that it claims.
TEST(NrrdHeader, ThatIsCutBeforeItsEndIsNotReadAsVoxels) {
    const TemporaryFolder folder;
    write_bytes(folder / "cut.nrrd",
                "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\n"
                "sizes: 4 4 4\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                "space origin: (0,0,0)\nencoding: raw\n");
    Job job;
    EXPECT_NE(refusal([&] { read_label_map(folder / "cut.nrrd", job); }).find("without an end"),
              std::string::npos);
}

// Two voxels a side, marked or not, in a file of their own.
TEST(NrrdHeader, WhoseDataBeginLaterIsRefused) {
    const TemporaryFolder folder;
    Job job;
    write_bytes(folder / "mask.raw", std::string("\0\0\0\n\1\0\0\0\0\0\0\1", 12));
    const auto says = [&](const std::string& skip) {
        write_bytes(folder / "mask.nhdr",
                    "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
                    "sizes: 2 2 2\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\n"
                    "space origin: (0,0,0)\n" +
                        skip + "data file: mask.raw\n\n");
        return refusal([&] { read_label_map(folder / "mask.nhdr", job); });
    };
    for (const char* skip : {"byte skip: 4\n", "byteskip: 4\n", "line skip: 1\n", "lineskip: 1\n"})
        EXPECT_NE(says(skip).find("skips bytes before its data"), std::string::npos) << skip;
    for (const char* none : {"", "byteskip: 0\n", "line skip: 0\n"}) EXPECT_EQ(says(none), "");
}

TEST(MetaHeader, OfVoxelsAsTextIsRefused) {
    const TemporaryFolder folder;
    Job job;
    const auto says = [&](const std::string& binary) {
        write_bytes(folder / "mask.mha",
                    "ObjectType = Image\nNDims = 3\n" + binary +
                        "ElementSpacing = 1 1 1\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
                        "ElementDataFile = LOCAL\n0 0 0 0 0 0 0 1 ");
        return refusal([&] { read_mask(folder / "mask.mha", job); });
    };
    EXPECT_NE(says("BinaryData = False\n").find("holds its voxels as text"), std::string::npos);
    for (const char* binary : {"", "BinaryData = True\n", "BinaryData = 1\n"})
        EXPECT_EQ(says(binary), "") << binary;
}

TEST(DamagedFile, OfAnyVolumeFormatIsReadOrRefused) {
    const TemporaryFolder folder;
    const Volume volume = patterned_volume(turned_grid());
    write_nifti(folder / "a.nii", volume);
    write_nifti(folder / "a.nii.gz", volume);
    write_segmentation(folder / "a.seg.nrrd", LabelMap(small_grid(), 3), {});
    write_bytes(folder / "a.mha",
                "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n"
                "ElementSpacing = 1 1 2\nDimSize = 4 5 6\nElementType = MET_SHORT\n"
                "ElementDataFile = LOCAL\n" +
                    std::string(240, 'v'));
    for (const char* name : {"a.nii", "a.nii.gz", "a.seg.nrrd", "a.mha"})
        EXPECT_GT(refusals(folder / name, folder / name, 400, 150), 10) << name;
}

TEST(DamagedFile, OfADicomSeriesIsReadOrRefused) {
    const TemporaryFolder folder;
    Job job;
    Grid grid = small_grid();
    grid.dims[2] = 3;
    write_dicom_series(folder / "ct", patterned_volume(grid), {}, job);
    const fs::path file = folder / "ct" / "slice_0002.dcm";
    EXPECT_GT(refusals(file, folder / "ct", 1200, 500), 50);
}

TEST(DamagedFile, OfACompressedDicomSeriesIsReadOrRefused) {
    for (const auto syntax :
         {gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::JPEGLosslessProcess14_1,
          gdcm::TransferSyntax::RLELossless, gdcm::TransferSyntax::JPEGLSLossless}) {
        const TemporaryFolder folder;
        Job job;
        Grid grid = small_grid();
        grid.dims = {40, 30, 3};
        write_dicom_series(folder / "ct", patterned_volume(grid), {}, job);
        const fs::path file = folder / "ct" / "slice_0002.dcm";
        gdcm::ImageReader reader;
        reader.SetFileName(file.c_str());
        ASSERT_TRUE(reader.Read());
        gdcm::ImageChangeTransferSyntax change;
        change.SetTransferSyntax(syntax);
        change.SetInput(reader.GetImage());
        ASSERT_TRUE(change.Change());
        gdcm::ImageWriter writer;
        writer.SetFileName(file.c_str());
        writer.SetFile(reader.GetFile());
        writer.SetImage(change.GetOutput());
        ASSERT_TRUE(writer.Write());
        EXPECT_GT(refusals(file, folder / "ct", 1200, 150), 10)
            << gdcm::TransferSyntax::GetTSString(syntax);
    }
}

// Reading a process's memory from address 0 on fails: it is not taken for a header that ended.
TEST(DamagedFile, WhoseReadingFailsIsNotTakenForAShorterOne) {
    const fs::path file = "/proc/self/mem";
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    for (const std::string& said :
         {refusal([&] { read_meta_header(file); }), refusal([&] { read_nrrd_header(file); })}) {
        EXPECT_NE(said.find("cannot be read to its end"), std::string::npos) << said;
        EXPECT_NE(said.find(file.string()), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace hepatica
