// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI, MetaImage and NRRD: what is written comes back, and what is broken is refused.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include "core/base/parallel.h"
#include "core/image/memory_limit.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"

namespace hepatica {
namespace {

using namespace testing_support;

// A NIfTI-1 file with some bytes of its header replaced.
class NiftiFile {
  public:
    explicit NiftiFile(const TemporaryFolder& folder) : path_(folder / "case.nii") {
        write_nifti(path_, patterned_volume(small_grid()));
        bytes_ = bytes_of_file(path_);
    }
    template <class T>
    NiftiFile& set(std::size_t offset, T value) {
        std::memcpy(bytes_.data() + offset, &value, sizeof(T));
        return *this;
    }
    NiftiFile& cut(std::size_t size) {
        bytes_.resize(size);
        return *this;
    }
    void write() const { write_bytes(path_, bytes_); }
    std::string refusal_of_volume() {
        write();
        return refusal([&] {
            Job job;
            read_volume(path_, job);
        });
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::string bytes_;
};

TEST(Nifti, SaysThatNothingIsSaidOfHowThePatientLies) {
    const TemporaryFolder folder;
    NiftiFile file(folder);
    const auto remarks = [&] {
        file.write();
        ReadRemarks heard;
        Job job;
        read_volume(file.path(), job, &heard);
        return heard;
    };
    EXPECT_TRUE(remarks().empty());
    file.set<std::int16_t>(252, 0).set<std::int16_t>(254, 0);  // qform_code and sform_code
    ASSERT_EQ(remarks().size(), 1u);
    EXPECT_NE(remarks()[0].find("does not say how the patient lies"), std::string::npos);
}

TEST(Nifti, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    Job job;
    for (const Grid& grid : {small_grid(), turned_grid()})
        for (const char* name : {"ct.nii", "ct.nii.gz", "CT.NII.GZ"}) {
            const Volume volume = patterned_volume(grid);
            write_nifti(folder / name, volume);
            const Volume read = read_volume(folder / name, job);
            EXPECT_TRUE(same_grid(read.grid, grid)) << name;
            EXPECT_EQ(read.voxels, volume.voxels) << name;
        }
}

// Programs may read either form of the position: the rotation alone says the same as the map, of
// grids that are turned by any angle, mirrored or not.
TEST(Nifti, ItsRotationSaysWhatItsMapSays) {
    const TemporaryFolder folder;
    Job job;
    for (const double angle : {0.0, 1.0, 2.5, 4.0, 6.0})
        for (const double mirrored : {1.0, -1.0}) {
            Grid grid = small_grid();
            grid.direction =
                Eigen::AngleAxisd(angle, Vec3(3.0, -1.0, 2.0).normalized()).toRotationMatrix();
            grid.direction.col(2) *= mirrored;
            write_nifti(folder / "turned.nii", patterned_volume(grid));
            const Volume by_map = read_volume(folder / "turned.nii", job);
            std::string bytes = bytes_of_file(folder / "turned.nii");
            const std::int16_t no_map = 0;
            std::memcpy(bytes.data() + 254, &no_map, sizeof no_map);
            write_bytes(folder / "turned.nii", bytes);
            const Volume by_rotation = read_volume(folder / "turned.nii", job);
            const Grid &one = by_map.grid, &other = by_rotation.grid;
            EXPECT_NEAR((other.direction - one.direction).norm(), 0.0, 1e-5) << angle;
            EXPECT_NEAR((other.origin_mm - one.origin_mm).norm(), 0.0, 1e-4) << angle;
            EXPECT_EQ(by_rotation.voxels, by_map.voxels) << angle;
        }
}

TEST(Nifti, KeepsMasksLabelsAndFloats) {
    const TemporaryFolder folder;
    Job job;
    const Grid grid = small_grid();
    Mask mask(grid);
    LabelMap labels(grid);
    FloatVolume field(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        mask.voxels[i] = i % 7 == 0 ? 1 : 0;
        labels.voxels[i] = static_cast<std::uint16_t>(i % 5 * 16000);
        field.voxels[i] = static_cast<float>(i) * 0.75f - 100.0f;
    }
    write_nifti(folder / "mask.nii.gz", mask);
    write_nifti(folder / "labels.nii.gz", labels);
    write_nifti(folder / "field.nii.gz", field);
    EXPECT_EQ(read_mask(folder / "mask.nii.gz", job).voxels, mask.voxels);
    EXPECT_EQ(read_label_map(folder / "labels.nii.gz", job).voxels, labels.voxels);
    const std::vector<int> wanted{16000, 64000};
    const Mask some = read_mask(folder / "labels.nii.gz", job, wanted);
    for (std::size_t i = 0; i < some.voxels.size(); ++i)
        EXPECT_EQ(some.voxels[i] != 0, i % 5 == 1 || i % 5 == 4);
    const Volume rounded = read_volume(folder / "field.nii.gz", job);
    EXPECT_EQ(rounded.voxels[8], -94);
}

TEST(Nifti, WritesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    Grid grid = small_grid();
    grid.dims = {200, 150, 60};  // several blocks of the compressor
    const Volume volume = patterned_volume(grid);
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        write_nifti(folder / (std::to_string(threads) + ".nii.gz"), volume);
    }
    const std::string one = bytes_of_file(folder / "1.nii.gz");
    EXPECT_EQ(one, bytes_of_file(folder / "2.nii.gz"));
    EXPECT_EQ(one, bytes_of_file(folder / "4.nii.gz"));
    Job job;
    EXPECT_EQ(read_volume(folder / "2.nii.gz", job).voxels, volume.voxels);
}

// Flipped and swapped on disk, one image inside: the axes run to the left, back and head again.
TEST(Nifti, TurnsAnyWholeAxisOrderBackToPatientAxes) {
    const TemporaryFolder folder;
    Job job;
    const Volume volume = patterned_volume(small_grid());
    Grid shuffled;  // file axes: head to foot, right to left flipped, front to back
    shuffled.dims = {9, 13, 11};
    shuffled.spacing_mm = {1.5, 0.75, 0.8};
    shuffled.direction << 0, -1, 0, 0, 0, 1, -1, 0, 0;
    shuffled.origin_mm = small_grid().to_mm(12, 0, 8);
    Volume on_disk(shuffled);
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 13; ++x) on_disk.at(8 - z, 12 - x, y) = volume.at(x, y, z);
    write_nifti(folder / "shuffled.nii.gz", on_disk);
    const Volume read = read_volume(folder / "shuffled.nii.gz", job);
    EXPECT_TRUE(same_grid(read.grid, volume.grid));
    EXPECT_EQ(read.voxels, volume.voxels);
}

TEST(Nifti, FallsBackFromAffineToQuaternion) {
    const TemporaryFolder folder;
    Job job;
    const Volume volume = patterned_volume(turned_grid());
    write_nifti(folder / "q.nii", volume);
    std::string bytes = bytes_of_file(folder / "q.nii");
    const std::int16_t none = 0;
    std::memcpy(bytes.data() + 254, &none, 2);  // sform_code
    write_bytes(folder / "q.nii", bytes);
    const Volume read = read_volume(folder / "q.nii", job);
    EXPECT_TRUE(same_grid(read.grid, volume.grid));
    EXPECT_EQ(read.voxels, volume.voxels);
}

TEST(Nifti, WithoutOrientationHasItsSpacingAlongTheAxesOfItsTools) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "s.nii", patterned_volume(small_grid()));
    std::string bytes = bytes_of_file(folder / "s.nii");
    std::memset(bytes.data() + 228, 'x', 24);  // a name beside them, as long as may be
    std::memset(bytes.data() + 252, 0, 4);     // qform_code and sform_code
    write_bytes(folder / "s.nii", bytes);
    const Grid read = read_volume(folder / "s.nii", job).grid;
    EXPECT_EQ(read.dims, small_grid().dims);
    EXPECT_NEAR((read.spacing_mm - small_grid().spacing_mm).norm(), 0.0, 1e-6);
    EXPECT_LT(read.origin_mm.norm(), 30.0) << "a corner of the image, and not where it was";
    EXPECT_GT(small_grid().origin_mm.norm(), 400.0);
    EXPECT_NE(read.spacing_mm.x(), read.spacing_mm.y());
    EXPECT_NE(read.spacing_mm.y(), read.spacing_mm.z());
}

TEST(Nifti, AppliesSlopeAndClampsToSixteenBits) {
    const TemporaryFolder folder;
    NiftiFile file(folder);
    file.set(112, 100.0f).set(116, 7.0f);
    EXPECT_EQ(file.refusal_of_volume(), "");
    Job job;
    ReadRemarks remarks;
    const Volume read = read_volume(file.path(), job, &remarks);
    EXPECT_EQ(read.voxels[0], -32768);    // -1024 * 100 + 7
    EXPECT_EQ(read.at(4, 0, 2), -21993);  // (4 + 800 - 1024) * 100 + 7
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("clamped"), std::string::npos);
}

TEST(Nifti, FillsScatteredVoxelsThatAreNoNumbersAndMakesAirOfPadding) {
    const TemporaryFolder folder;
    FloatVolume field(small_grid(), 50.0f);
    field.voxels[3] = std::numeric_limits<float>::quiet_NaN();
    field.voxels[4] = std::numeric_limits<float>::infinity();
    write_nifti(folder / "nan.nii.gz", field);
    Job job;
    ReadRemarks remarks;
    const Volume read = read_volume(folder / "nan.nii.gz", job, &remarks);
    for (const std::int16_t value : read.voxels) EXPECT_EQ(value, 50);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_NE(remarks[0].find("2 of"), std::string::npos) << remarks[0];

    field.voxels.assign(field.voxels.size(), std::numeric_limits<float>::quiet_NaN());
    field.voxels.back() = 50.0f;
    write_nifti(folder / "padding.nii.gz", field);
    const Volume padded = read_volume(folder / "padding.nii.gz", job, &remarks);
    EXPECT_EQ(padded.voxels.front(), -1024);
    EXPECT_EQ(padded.voxels.back(), 50);
}

TEST(BadFile, IsRefusedByNameWithARemedy) {
    const TemporaryFolder folder;
    Job job;
    const auto says = [&](const std::string& name, const std::string& bytes) {
        write_bytes(folder / name, bytes);
        return refusal([&] { read_volume(folder / name, job); });
    };
    EXPECT_NE(says("text.nii", "Dear colleague,").find("too short"), std::string::npos);
    EXPECT_NE(says("text.nii", std::string(2000, 'x')).find("not a NIfTI"), std::string::npos);
    EXPECT_NE(says("text.nii.gz", std::string(2000, 'x')).find("text.nii.gz"), std::string::npos);
    EXPECT_NE(says("empty.nii", "").find("empty.nii"), std::string::npos);
    EXPECT_NE(says("letter.docx", "PK letter").find("not an image"), std::string::npos);
    EXPECT_NE(says("x.mha", "ObjectType = Image\n").find("ElementDataFile"), std::string::npos);
    EXPECT_NE(says("x.nrrd", "NRRD0004\ntype: short\n\n").find("dimensions"), std::string::npos);
    EXPECT_NE(refusal([&] { read_volume(folder / "nowhere.nii", job); }).find("does not exist"),
              std::string::npos);
    std::filesystem::create_directory(folder / "folder.nii.gz");
    EXPECT_NE(refusal([&] { read_mask(folder / "folder.nii.gz", job); }), "");
}

// The mark at byte 344 is n+1 where the voxels follow, ni1 where they lie in a file of their own;
// anything else is older than NIfTI, also where it differs in one letter only.
TEST(BadHeader, OfAnotherFormatIsRefusedByItsName) {
    for (const auto& [second, reason] : {std::pair('i', "two-file NIfTI"),
                                         {'\0', "Analyze"},
                                         {'x', "Analyze"},
                                         {'1', "Analyze"}}) {
        const TemporaryFolder folder;
        EXPECT_NE(NiftiFile(folder).set(345, second).refusal_of_volume().find(reason),
                  std::string::npos)
            << reason;
    }
    const TemporaryFolder folder;
    EXPECT_NE(NiftiFile(folder).set(344, 'x').refusal_of_volume().find("Analyze"),
              std::string::npos);
    EXPECT_EQ(NiftiFile(folder).set(345, '+').refusal_of_volume(), "");
}

TEST(BadHeader, OfAHundredThousandSlicesIsRefusedBeforeAllocating) {
    const TemporaryFolder folder;
    NiftiFile nifti(folder);
    const std::int16_t most = 32767;
    const std::string message = nifti.set(42, most).set(44, most).set(46, most).refusal_of_volume();
    EXPECT_NE(message.find("32767 x 32767 x 32767"), std::string::npos) << message;

    Job job;
    const std::string nrrd =
        "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\n"
        "sizes: 512 512 100000\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nendian: little\n"
        "encoding: raw\nspace origin: (0,0,0)\n\n0123456789";
    write_bytes(folder / "bomb.nrrd", nrrd);
    const std::string refused = refusal([&] { read_volume(folder / "bomb.nrrd", job); });
    EXPECT_NE(refused.find("512 x 512 x 100000"), std::string::npos) << refused;
    EXPECT_NE(refused.find("cannot hold"), std::string::npos) << refused;
}

// The machine may have more memory than the process is allowed (ulimit -v).
TEST(MemoryLimit, IsTheProcessesOwnWhereThatIsLower) {
    const auto refused_under_limit = [] {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t mapped = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
        constexpr rlim_t room = 200'000'000;
        const rlimit limit{mapped + room, mapped + room};
        if (setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(2);
        require_memory(room / 2, "small.nii");
        const std::string message = refusal([] { require_memory(2 * room, "large.nii"); });
        std::_Exit(message.find("large.nii") == std::string::npos ? 1 : 0);
    };
    EXPECT_EXIT(refused_under_limit(), testing::ExitedWithCode(0), "");
}

// Deflate turns one byte into 1032 at most: a small file cannot honour a large claim.
TEST(BadHeader, OfAGzipBombIsRefusedBeforeInflating) {
    const TemporaryFolder folder;
    Job job;
    Grid grid = small_grid();
    write_nifti(folder / "x.nii.gz", Volume(grid));
    const std::string nrrd =
        "NRRD0004\ntype: double\ndimension: 3\nspace: left-posterior-superior\n"
        "sizes: 4000 4000 4000\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nendian: little\n"
        "encoding: gzip\nspace origin: (0,0,0)\n\n" +
        bytes_of_file(folder / "x.nii.gz");
    write_bytes(folder / "bomb.nrrd", nrrd);
    EXPECT_NE(refusal([&] { read_volume(folder / "bomb.nrrd", job); }).find("cannot hold"),
              std::string::npos);
}

// Positions that far away made arithmetic hang: neighbouring doubles are 131 m apart at 1e21 mm.
TEST(BadHeader, BeyondTenMetresIsRefusedByValue) {
    const TemporaryFolder folder;
    const std::size_t origin_x = 292, axis_x = 280;
    for (const auto& [value, text] :
         {std::pair{1e21f, "1e+21"}, std::pair{3e9f, "3e+09"}, std::pair{-10001.0f, "10001"}}) {
        const std::string message = NiftiFile(folder).set(origin_x, value).refusal_of_volume();
        EXPECT_NE(message.find(text), std::string::npos) << message;
        EXPECT_NE(message.find("10 m from the origin"), std::string::npos) << message;
    }
    EXPECT_EQ(NiftiFile(folder).set(origin_x, 9000.0f).refusal_of_volume(), "");
    // 13 voxels of 800 mm are 10.4 m.
    const std::string long_one = NiftiFile(folder).set(axis_x, -800.0f).refusal_of_volume();
    EXPECT_NE(long_one.find("10.4 m long"), std::string::npos) << long_one;

    Job job;
    const auto says = [&](const std::string& name, const std::string& bytes) {
        write_bytes(folder / name, bytes + std::string(16, '\0'));
        return refusal([&] { read_volume(folder / name, job); });
    };
    const std::string mha =
        says("far.mha",
             "ObjectType = Image\nNDims = 3\nOffset = 0 1e21 0\nElementSpacing = 1 1 1\n"
             "DimSize = 2 2 2\nElementType = MET_SHORT\nElementDataFile = LOCAL\n");
    EXPECT_NE(mha.find("1e+21"), std::string::npos) << mha;
    const std::string nrrd =
        says("far.nrrd",
             "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\n"
             "sizes: 2 2 2\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nendian: little\n"
             "encoding: raw\nspace origin: (0,0,-1e21)\n\n");
    EXPECT_NE(nrrd.find("-1e+21"), std::string::npos) << nrrd;
}

TEST(BadHeader, WithoutASoundGeometryIsRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float spacing : {0.0f, -1.0f, nan, infinite}) {
        const TemporaryFolder folder;
        EXPECT_NE(NiftiFile(folder).set(84, spacing).refusal_of_volume().find("spacing"),
                  std::string::npos);
    }
    const TemporaryFolder folder;
    EXPECT_NE(NiftiFile(folder).set(280, nan).refusal_of_volume(), "");  // affine
    EXPECT_NE(NiftiFile(folder).set(292, nan).refusal_of_volume(), "");  // position
    EXPECT_NE(NiftiFile(folder).set(284, 0.5f).refusal_of_volume().find("right angles"),
              std::string::npos);  // shear
    const std::int16_t none = 0;
    const std::int16_t complex_type = 32;
    const std::int16_t two = 2;
    EXPECT_NE(NiftiFile(folder).set(42, none).refusal_of_volume(), "");
    EXPECT_NE(NiftiFile(folder).set(70, complex_type).refusal_of_volume().find("type 32"),
              std::string::npos);
    EXPECT_NE(NiftiFile(folder).set(40, two).refusal_of_volume().find("dimensions"),
              std::string::npos);
    EXPECT_NE(NiftiFile(folder).set(108, nan).refusal_of_volume().find("offset"),
              std::string::npos);
}

TEST(BadData, CutShortOrDamagedAreRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(NiftiFile(folder).cut(1000).refusal_of_volume().find("cannot hold"),
              std::string::npos);
    Job job;
    std::mt19937 engine(4);
    Volume noise(small_grid());
    for (auto& voxel : noise.voxels) voxel = static_cast<std::int16_t>(engine());
    write_nifti(folder / "ct.nii.gz", noise);
    const std::string whole = bytes_of_file(folder / "ct.nii.gz");
    for (const std::size_t size : {whole.size() / 2, whole.size() - 100, std::size_t{40}}) {
        write_bytes(folder / "ct.nii.gz", whole.substr(0, size));
        EXPECT_NE(refusal([&] { read_volume(folder / "ct.nii.gz", job); }).find("ct.nii.gz"),
                  std::string::npos)
            << size;
    }
    std::string damaged = whole;
    damaged[whole.size() / 2] = static_cast<char>(~damaged[whole.size() / 2]);
    write_bytes(folder / "ct.nii.gz", damaged);
    EXPECT_NE(refusal([&] { read_volume(folder / "ct.nii.gz", job); }), "");  // checksum
}

TEST(Segmentation, ComesBackAndCarriesSlicersNames) {
    const TemporaryFolder folder;
    Job job;
    LabelMap labels(turned_grid());
    for (std::size_t i = 0; i < labels.voxels.size(); ++i)
        labels.voxels[i] = static_cast<std::uint16_t>(i % 3);
    const std::vector<SegmentDescription> segments{{1, "portal vein", {0, 0, 1}},
                                                   {2, "hepatic veins"}};
    write_segmentation(folder / "vessels.seg.nrrd", labels, segments);
    const LabelMap read = read_label_map(folder / "vessels.seg.nrrd", job);
    EXPECT_TRUE(same_grid(read.grid, labels.grid));
    EXPECT_EQ(read.voxels, labels.voxels);
    const std::string header = bytes_of_file(folder / "vessels.seg.nrrd").substr(0, 2000);
    EXPECT_NE(header.find("Segment0_Name:=portal vein\n"), std::string::npos);
    EXPECT_NE(header.find("Segment1_LabelValue:=2\n"), std::string::npos);
    EXPECT_NE(header.find("Segment0_Color:=0 0 1\n"), std::string::npos);
}

TEST(Segmentation, WithOverlappingLayersIsRefused) {
    const TemporaryFolder folder;
    Job job;
    write_bytes(folder / "layers.seg.nrrd",
                "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\n"
                "sizes: 2 4 4 4\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
                "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n\n" +
                    std::string(128, '\1'));
    EXPECT_NE(refusal([&] { read_mask(folder / "layers.seg.nrrd", job); }).find("overlap"),
              std::string::npos);
}

TEST(LabelMap, RefusesAnImage) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "ct.nii.gz", patterned_volume(small_grid()));
    EXPECT_NE(refusal([&] { read_label_map(folder / "ct.nii.gz", job); }).find("no label"),
              std::string::npos);
}

TEST(MaskFile, RefusesOneThatMarksNothing) {
    const TemporaryFolder folder;
    Job job;
    write_nifti(folder / "mask.nii.gz", Mask(small_grid()));
    EXPECT_NE(refusal([&] { read_mask(folder / "mask.nii.gz", job); }).find("no voxel"),
              std::string::npos);
}

TEST(RequireSameGrid, NamesSizesOrPlace) {
    const Grid grid = small_grid();
    EXPECT_NO_THROW(require_same_grid(grid, grid, "m.nii"));
    Grid shifted = grid;
    shifted.origin_mm[0] += 0.1;
    EXPECT_NE(
        refusal([&] { require_same_grid(shifted, grid, "m.nii"); }).find("the mask lies elsewhere"),
        std::string::npos);
    Grid larger = grid;
    larger.dims[2] += 1;
    const std::string sizes = refusal([&] { require_same_grid(larger, grid, "m.nii"); });
    EXPECT_NE(sizes.find("the mask has "), std::string::npos) << "the window begins with it";
    EXPECT_NE(sizes.find("13 x 11 x 10"), std::string::npos);
}

TEST(RequirePlausibleCt, RefusesWhatShowsNoPatient) {
    Grid grid = small_grid();
    const auto says = [&](const Volume& volume) {
        return refusal([&] { require_plausible_ct(volume, "ct", Job()); });
    };
    EXPECT_NE(says(Volume(grid)).find("value 0 in every voxel"), std::string::npos);
    EXPECT_NE(says(Volume(grid, -1024)).find("every voxel"), std::string::npos);
    Volume air(grid, -1000);
    air.voxels[5] = 2000;
    EXPECT_NE(says(air).find("soft tissue"), std::string::npos);
    Grid one_slice = grid;
    one_slice.dims[2] = 1;
    const Volume thin(one_slice, 40);
    EXPECT_NE(says(thin).find("only 1"), std::string::npos);
    EXPECT_EQ(says(patterned_volume(grid)), "");
}

TEST(Writer, RefusesWhatItCannotWriteAndLeavesNothing) {
    const TemporaryFolder folder;
    const Volume volume = patterned_volume(small_grid());
    EXPECT_NE(refusal([&] { write_nifti(folder / "ct.png", volume); }).find(".nii"),
              std::string::npos);
    for (const char* name : {"ct.png", "ct.nrrd", "seg.nrrd"})
        EXPECT_NE(refusal([&] { write_segmentation(folder / name, LabelMap(small_grid()), {}); }),
                  "")
            << name;
    write_bytes(folder / "file", "not a folder");
    EXPECT_NE(refusal([&] { write_nifti(folder / "file" / "ct.nii", volume); }), "");
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path()))
        ++count;
    EXPECT_EQ(count, 1u);
}

TEST(Reading, StopsWhenCancelledAndReportsProgress) {
    const TemporaryFolder folder;
    Grid grid = small_grid();
    grid.dims = {256, 256, 40};
    write_nifti(folder / "ct.nii.gz", patterned_volume(grid));
    Job job;
    read_volume(folder / "ct.nii.gz", job);
    EXPECT_GT(job.progress().fraction, 0.8);
    EXPECT_EQ(job.progress().stage_number, 1);
    Job cancelled;
    cancelled.cancel();
    EXPECT_THROW(read_volume(folder / "ct.nii.gz", cancelled), Cancelled);
}

}  // namespace
}  // namespace hepatica
