// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are no image, or a broken one, are refused with the reason.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstring>
#include <limits>
#include <random>

#include "core/image/memory_limit.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "tests/image/image_fixtures.h"
#include "tests/image/nifti_bytes.h"

namespace hepatica {
namespace {

using namespace testing_support;

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

}  // namespace
}  // namespace hepatica
