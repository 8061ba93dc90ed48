// SPDX-License-Identifier: GPL-3.0-or-later
// Enhanced multi-frame CT: one file with all slices, each with a position and a rescale of its own.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/image/dicom_frames.h"
#include "core/image/dicom_slices.h"
#include "core/image/thumbnail.h"
#include "core/image/volume_reader.h"
#include "tests/image/dicom_folder.h"
#include "tests/image/enhanced_ct.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

struct EnhancedFile {
    explicit EnhancedFile(const EnhancedCt& ct, gdcm::TransferSyntax::TSType syntax =
                                                    gdcm::TransferSyntax::ExplicitVRLittleEndian) {
        ct.write(path(), syntax);
    }
    fs::path path() const { return folder / "ct.dcm"; }
    Volume read(ReadRemarks* remarks = nullptr) const {
        Job job;
        return read_volume(folder.path(), job, remarks);
    }
    std::string refusal_of_file() const {
        return refusal([&] { read(); });
    }
    TemporaryFolder folder;
};

EnhancedCt patterned(const Grid& grid = turned_grid()) {
    return EnhancedCt(patterned_volume(grid));
}

TEST(EnhancedCt, EveryVoxelComesOutAtItsPlace) {
    for (const Grid& grid : {small_grid(), turned_grid()}) {
        const EnhancedCt ct = patterned(grid);
        const EnhancedFile file(ct);
        ReadRemarks remarks;
        const Volume read = file.read(&remarks);
        EXPECT_TRUE(same_grid(read.grid, grid));
        EXPECT_EQ(read.voxels, ct.volume.voxels);
        EXPECT_TRUE(remarks.empty());
    }
}

TEST(EnhancedCt, OfEveryPlainEncodingIsRead) {
    const EnhancedCt ct = patterned();
    const EnhancedFile implicit(ct, gdcm::TransferSyntax::ImplicitVRLittleEndian);
    EXPECT_EQ(implicit.read().voxels, ct.volume.voxels);
}

TEST(EnhancedCt, ABallStandsWhereItStoodAlsoBeforeATiltedGantry) {
    const Vec3 centre_mm(-20.0, 31.0, -390.0);
    for (const double degrees : {0.0, 18.0}) {
        Grid grid;
        grid.dims = {40, 38, 21};
        grid.spacing_mm = {1.0, 1.1, 2.0};
        grid.direction =
            Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3::UnitX()).toRotationMatrix();
        EnhancedCt ct{Volume(grid, -1000)};
        for (int z = 0; z < 21; ++z) {
            const Vec3 corner =
                centre_mm - grid.direction * Vec3(18.0, 21.0, 0.0) + Vec3(0.0, 0.0, 2.0 * (z - 9));
            ct.corners_mm[static_cast<std::size_t>(z)] = corner;
            for (int y = 0; y < 38; ++y)
                for (int x = 0; x < 40; ++x)
                    if ((corner + grid.direction * Vec3(x, 1.1 * y, 0.0) - centre_mm).norm() < 12.0)
                        ct.volume.at(x, y, z) = 60;
        }
        const EnhancedFile file(ct);
        const Volume read = file.read();
        Vec3 sum = Vec3::Zero();
        double count = 0.0;
        for (std::size_t i = 0; i < read.voxels.size(); ++i) {
            if (read.voxels[i] < -470) continue;
            const Index3 at = read.grid.index_of(i);
            const Vec3 place = read.grid.to_mm(at[0], at[1], at[2]);
            EXPECT_LT((place - centre_mm).norm(), 13.0);
            sum += place;
            ++count;
        }
        EXPECT_LT((sum / count - centre_mm).norm(), 0.5) << degrees;
        const double ball_ml = 4.0 / 3.0 * M_PI * 12.0 * 12.0 * 12.0;
        EXPECT_NEAR(count * read.grid.spacing_mm.prod(), ball_ml, 0.03 * ball_ml) << degrees;
    }
}

TEST(EnhancedCt, IsListedWithItsFramesAndReadByItsName) {
    const EnhancedCt ct = patterned();
    const EnhancedFile file(ct);
    Job job;
    const auto series = list_series(file.folder.path(), job);
    ASSERT_EQ(series.size(), 1u);
    EXPECT_EQ(series[0].slices, 9u);
    for (const std::string& warning : series[0].warnings)
        EXPECT_EQ(warning.find("cannot be read"), std::string::npos) << warning;
    const Thumbnail middle = thumbnail_of(series[0].middle_slice, 96, job);
    EXPECT_EQ(std::max(middle.width, middle.height), 96);
    Job unwanted;
    unwanted.cancel();
    EXPECT_THROW(thumbnail_of(series[0].middle_slice, 96, unwanted), Cancelled);
    EXPECT_EQ(read_volume(file.path(), job).voxels, ct.volume.voxels);
}

// The description of the series that is called so.
SeriesDescription called(const std::string& name, const std::vector<SeriesDescription>& all) {
    const auto found = std::ranges::find_if(all, [&](const SeriesDescription& one) {
        return one.description.find(name) != std::string::npos;
    });
    if (found == all.end()) throw std::runtime_error(name + " is not listed");
    return *found;
}

// Frames with what tells a series: a kernel in each, a contrast agent for all.
EnhancedCt described(Volume volume, const std::string& kernel) {
    EnhancedCt ct(std::move(volume));
    ct.edit_group = [kernel](gdcm::DataSet& group, int) {
        gdcm::DataSet reconstruction, other;
        put(reconstruction, gdcm::Tag(0x0018, 0x1210), gdcm::VR::SH, kernel);
        put_sequence(group, gdcm::Tag(0x0018, 0x9314), {reconstruction});
        // The same tag within what is not looked into means something else.
        put(other, gdcm::Tag(0x0018, 0x1210), gdcm::VR::SH, "WRONG");
        put_sequence(group, gdcm::Tag(0x0018, 0x9306), {other});
    };
    ct.edit_data = [](gdcm::DataSet& data) {
        gdcm::DataSet agent;
        put(agent, gdcm::Tag(0x0008, 0x0104), gdcm::VR::LO, "Iohexol");
        put_sequence(data, gdcm::Tag(0x0018, 0x0012), {agent});
    };
    return ct;
}

TEST(EnhancedCt, SaysOfItselfWhatAClassicSeriesSays) {
    for (const auto syntax : {gdcm::TransferSyntax::ExplicitVRLittleEndian,
                              gdcm::TransferSyntax::ImplicitVRLittleEndian}) {
        const TemporaryFolder folder;
        const EnhancedCt ct = described(patterned_volume(small_grid()), "B30f");
        ct.write(folder / "enhanced", syntax);
        const auto slice = read_dicom_slice(folder / "enhanced");
        ASSERT_TRUE(slice.has_value());
        EXPECT_EQ(slice->kernel, "B30f");
        EXPECT_TRUE(slice->contrast_agent);
        ASSERT_EQ(slice->frame_positions_mm.size(), 9u);
        for (int frame = 0; frame < 9; ++frame)
            EXPECT_LT((slice->frame_positions_mm[static_cast<std::size_t>(frame)] -
                       small_grid().to_mm(0, 0, ct.slice_of(frame)))
                          .norm(),
                      1e-6);
        EXPECT_NEAR(std::abs(slice->normal().dot(small_grid().direction.col(2))), 1.0, 1e-6);
        Job job;
        EXPECT_NEAR(list_series(folder.path(), job)[0].spacing_mm, small_grid().spacing_mm[2],
                    1e-6);
    }
}

// A sequence may stand there and name nothing.
TEST(EnhancedCt, WithoutAnyAgentHasNoContrast) {
    EnhancedCt ct = described(patterned_volume(small_grid()), "B30f");
    ct.edit_data = [](gdcm::DataSet& data) { put_sequence(data, gdcm::Tag(0x0018, 0x0012), {}); };
    const EnhancedFile file(ct);
    const auto slice = read_dicom_slice(file.path());
    ASSERT_TRUE(slice.has_value());
    EXPECT_FALSE(slice->contrast_agent);
    EXPECT_EQ(slice->kernel, "B30f");
}

// Beside a classic series of nine slices it is judged by the same measures, in both directions.
TEST(EnhancedCt, IsChosenForTheReasonsOfClassicSeries) {
    const auto why_not = [](const EnhancedCt& ct, int classic_slices, const char* kind) {
        const TemporaryFolder folder;
        ct.write(folder / "enhanced");
        Grid grid = small_grid();
        grid.dims[2] = classic_slices;
        DicomSeriesInfo info;
        info.series_description = std::string("portal venous, classic, ") + kind;
        Job job;
        write_dicom_series(folder / "classic", patterned_volume(grid), info, job);
        const auto all = list_series(folder.path(), job);
        return std::pair{called("enhanced", all).why_not_chosen,
                         called("classic", all).why_not_chosen};
    };
    const Volume whole = patterned_volume(small_grid());
    EXPECT_EQ(why_not(described(whole, "B70f"), 9, "soft"),
              std::pair(std::string("its kernel is for soft tissue"), std::string()));
    EXPECT_EQ(why_not(described(whole, "B30f"), 9, "lung"),
              std::pair(std::string(), std::string("its kernel is for soft tissue")));
    EXPECT_EQ(why_not(described(whole, "B30f"), 3, "soft"),
              std::pair(std::string(), std::string("it covers more of the body")));
    Grid few = small_grid();
    few.dims[2] = 3;
    EXPECT_EQ(why_not(described(patterned_volume(few), "B30f"), 9, "soft"),
              std::pair(std::string("it covers more of the body"), std::string()));
}

// Its extent may be unknown: that must not make it lose against any other series.
TEST(EnhancedCt, IsPreferredToAShortClassicSeriesBesideIt) {
    const EnhancedCt ct = patterned();
    const EnhancedFile file(ct);
    Grid grid = small_grid();
    grid.dims[2] = 3;
    Job job;
    write_dicom_series(file.folder / "tracker", patterned_volume(grid), {}, job);
    ReadRemarks remarks;
    EXPECT_EQ(file.read(&remarks).voxels, ct.volume.voxels);
    EXPECT_EQ(remarks.size(), 1u);
    EXPECT_EQ(read_volume(file.folder / "tracker" / "slice_0001.dcm", job).grid.dims[2], 3);
}

TEST(EnhancedCt, MayBeSeveralFilesOfOneSeries) {
    const Volume whole = patterned_volume(small_grid());
    const TemporaryFolder folder;
    for (int part = 0; part < 3; ++part) {
        Grid grid = small_grid();
        grid.dims[2] = 3;
        grid.origin_mm = small_grid().to_mm(0, 0, 3 * part);
        Volume volume(grid);
        std::copy_n(whole.voxels.begin() + static_cast<std::ptrdiff_t>(grid.count()) * part,
                    grid.count(), volume.voxels.begin());
        EnhancedCt(volume).write(folder / ("part " + std::to_string(part)));
    }
    Job job;
    EXPECT_EQ(read_volume(folder.path(), job).voxels, whole.voxels);
}

// The fragments of one frame, compressed by GDCM.
std::vector<std::string> fragments_of(const EnhancedCt& ct, int frame,
                                      gdcm::TransferSyntax::TSType syntax) {
    Volume slice(ct.volume.grid);
    slice.grid.dims[2] = 1;
    slice.voxels = ct.stored(frame);
    const DicomFolder folder(slice);
    gdcm::ImageReader reader;
    reader.SetFileName(folder.slice(1).c_str());
    EXPECT_TRUE(reader.Read());
    gdcm::ImageChangeTransferSyntax change;
    change.SetTransferSyntax(syntax);
    change.SetInput(reader.GetImage());
    EXPECT_TRUE(change.Change());
    const gdcm::SequenceOfFragments* made =
        change.GetOutput().GetDataElement().GetSequenceOfFragments();
    std::vector<std::string> fragments;
    for (unsigned i = 0; i < made->GetNumberOfFragments(); ++i) {
        const gdcm::ByteValue* bytes = made->GetFragment(i).GetByteValue();
        fragments.emplace_back(bytes->GetPointer(), bytes->GetLength());
    }
    return fragments;
}

// Each frame in `pieces` fragments, with a table of offsets or an empty one.
auto compressed_pixels(gdcm::TransferSyntax::TSType syntax, std::size_t pieces, bool with_table) {
    return [=](const EnhancedCt& ct, gdcm::DataSet& data) {
        const gdcm::SmartPointer<gdcm::SequenceOfFragments> all = new gdcm::SequenceOfFragments();
        std::string table;
        std::uint32_t at = 0;
        for (int frame = 0; frame < ct.volume.grid.dims[2]; ++frame) {
            const std::string bytes = fragments_of(ct, frame, syntax).front();
            table += word_of(static_cast<int>(at & 0xffff)) + word_of(static_cast<int>(at >> 16));
            const std::size_t piece = (bytes.size() / pieces + 1) / 2 * 2;
            for (std::size_t i = 0; i < pieces; ++i) {
                const std::string part =
                    bytes.substr(i * piece, i + 1 < pieces ? piece : std::string::npos);
                gdcm::Fragment fragment;
                fragment.SetByteValue(part.data(), static_cast<std::uint32_t>(part.size()));
                all->AddFragment(fragment);
                at += 8 + static_cast<std::uint32_t>(part.size() + part.size() % 2);
            }
        }
        if (with_table)
            all->GetTable().SetByteValue(table.data(), static_cast<std::uint32_t>(table.size()));
        gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
        element.SetVR(gdcm::VR::OB);
        element.SetValue(*all);
        element.SetVL(gdcm::VL(0xffffffff));  // undefined
        data.Replace(element);
    };
}

TEST(EnhancedCt, OfEveryCompressionIsRead) {
    for (const auto syntax :
         {gdcm::TransferSyntax::RLELossless, gdcm::TransferSyntax::JPEG2000Lossless,
          gdcm::TransferSyntax::JPEGLSLossless, gdcm::TransferSyntax::JPEGLosslessProcess14_1}) {
        EnhancedCt ct = patterned();
        ct.pixels = compressed_pixels(syntax, 1, false);
        EXPECT_EQ(EnhancedFile(ct, syntax).read().voxels, ct.volume.voxels)
            << gdcm::TransferSyntax::GetTSString(syntax);
    }
}

TEST(EnhancedCt, OfFramesInSeveralPiecesNeedsATableOfThem) {
    const auto syntax = gdcm::TransferSyntax::JPEG2000Lossless;
    EnhancedCt ct = patterned();
    ct.pixels = compressed_pixels(syntax, 3, true);
    EXPECT_EQ(EnhancedFile(ct, syntax).read().voxels, ct.volume.voxels);
    ct.pixels = compressed_pixels(syntax, 3, false);
    const std::string message = EnhancedFile(ct, syntax).refusal_of_file();
    EXPECT_NE(message.find("9 frames in 27 compressed pieces"), std::string::npos) << message;
}

// What is wrong, in which file, and what to do.
void expect_refusal(const EnhancedCt& ct, const std::vector<std::string>& parts) {
    const std::string message = EnhancedFile(ct).refusal_of_file();
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(BadEnhancedCt, WithoutAPositionIsRefusedByItsFrame) {
    EnhancedCt ct = patterned();
    ct.edit_group = [](gdcm::DataSet& group, int frame) {
        if (frame == 2) group.Remove(plane_position);
    };
    expect_refusal(ct, {"ct.dcm (frame 3): has no position", "Export the series again"});
}

TEST(BadEnhancedCt, WithoutOrientationOrSpacingIsRefused) {
    EnhancedCt ct = patterned();
    ct.edit_data = [](gdcm::DataSet& data) { data.Remove(gdcm::Tag(0x5200, 0x9229)); };
    expect_refusal(ct, {"ct.dcm (frame 1)", "position, orientation or pixel spacing"});
}

TEST(BadEnhancedCt, WithoutGroupsOrWithTooFewIsRefusedByTheirNumber) {
    EnhancedCt none = patterned();
    none.edit_data = [](gdcm::DataSet& data) { data.Remove(per_frame_groups); };
    expect_refusal(none, {"ct.dcm: says nothing of its single frames", "5200,9230", "Export"});
    EnhancedCt few = patterned();
    few.edit_data = [](gdcm::DataSet& data) {
        put(data, gdcm::Tag(0x0028, 0x0008), gdcm::VR::IS, "12");
    };
    expect_refusal(few, {"ct.dcm: states 12 frames", "describes 9", "Export"});
    EnhancedCt uncounted = patterned();
    uncounted.edit_data = [](gdcm::DataSet& data) { data.Remove(gdcm::Tag(0x0028, 0x0008)); };
    expect_refusal(uncounted, {"ct.dcm: states no number of frames"});
}

TEST(BadEnhancedCt, WithFewerPixelsThanItsFramesTakeIsRefusedByBoth) {
    EnhancedCt ct = patterned();
    ct.edit_data = [](gdcm::DataSet& data) {
        put(data, gdcm::Tag(0x0028, 0x0010), gdcm::VR::US, word_of(60));
    };
    expect_refusal(ct, {"ct.dcm: holds 2574 bytes of pixels", "9 frames of 13 x 60 pixels",
                        "14040"});  // 13 x 60 x 9 x 2
    ct.edit_data = [](gdcm::DataSet& data) { data.Remove(gdcm::Tag(0x7fe0, 0x0010)); };
    EXPECT_NE(EnhancedFile(ct).refusal_of_file(), "");
}

TEST(BadEnhancedCt, WithAFrameMissingOrMovedIsRefusedByItsFrames) {
    EnhancedCt ct = patterned(small_grid());
    ct.corners_mm[7].z() += 1.5;
    ct.corners_mm[8].z() += 1.5;
    // Slices 6 and 7, from 0, are shown by frames 7 and 4, from 1.
    expect_refusal(ct, {"1 slice is missing between “ct.dcm (frame 8)” and “ct.dcm (frame 4)”"});
    EnhancedCt uneven = patterned(small_grid());
    uneven.corners_mm[4].z() += 0.4;
    expect_refusal(uneven, {"the gap between", "is 1.9 mm, elsewhere it is 1.5 mm"});
}

TEST(BadEnhancedCt, OfSeveralStacksOrTimesIsRefused) {
    for (const auto& [tag, vr, words] :
         {std::tuple{gdcm::Tag(0x0020, 0x9056), gdcm::VR(gdcm::VR::SH), "several stacks"},
          std::tuple{gdcm::Tag(0x0020, 0x9128), gdcm::VR(gdcm::VR::UL),
                     "several points in time"}}) {
        EnhancedCt ct = patterned();
        ct.edit_group = [&, tag = tag, vr = vr](gdcm::DataSet& group, int frame) {
            gdcm::DataSet content;
            const bool is_number = vr == gdcm::VR::UL;
            const int which = frame < 5 ? 1 : 2;
            put(content, tag, vr, is_number ? word_of(which) + word_of(0) : std::to_string(which));
            put_sequence(group, frame_content, {content});
        };
        expect_refusal(ct, {words, "\"1\" and \"2\"", "series of its own"});
    }
}

TEST(BadEnhancedCt, OfFilesOfSeveralSizesIsRefused) {
    const EnhancedFile file(patterned(small_grid()));
    Grid grid = small_grid();
    grid.dims = {10, 11, 9};
    grid.origin_mm = small_grid().to_mm(0, 0, 9);
    EnhancedCt(patterned_volume(grid)).write(file.folder / "other.dcm");
    const std::string message = file.refusal_of_file();
    EXPECT_NE(message.find("other.dcm (frame 1): has 10 x 11 pixels, but “ct.dcm (frame 1)” has "
                           "13 x 11"),
              std::string::npos)
        << message;
}

TEST(BadEnhancedCt, OfAnotherKindOfManyFramesIsRefused) {
    EnhancedCt ct = patterned();
    ct.edit_data = [](gdcm::DataSet& data) {  // multi-frame grayscale secondary capture
        put(data, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.7.3");
    };
    expect_refusal(ct, {"ct.dcm: holds 9 frames in one file and is no enhanced CT"});
}

TEST(BadEnhancedCt, CutShortAnywhereIsRefused) {
    const EnhancedFile file(patterned());
    const std::string whole = bytes_of_file(file.path());
    for (std::size_t bytes = 140; bytes < whole.size(); bytes += 1 + whole.size() / 40) {
        write_bytes(file.path(), whole.substr(0, bytes));
        EXPECT_NE(file.refusal_of_file(), "") << bytes << " of " << whole.size();
    }
    write_bytes(file.path(), whole.substr(0, whole.size() - 1));
    const std::string message = file.refusal_of_file();
    EXPECT_NE(message.find("ct.dcm: "), std::string::npos) << message;
}

TEST(BadEnhancedCt, DamagedAtRandomIsReadOrRefused) {
    const EnhancedFile file(patterned());
    const std::string whole = bytes_of_file(file.path());
    std::mt19937_64 engine(4);
    int refused = 0;
    for (int round = 0; round < 60; ++round) {
        std::string bytes = whole;
        for (int n = 0; n < 4; ++n) bytes[engine() % bytes.size()] = static_cast<char>(engine());
        write_bytes(file.path(), bytes);
        refused += file.refusal_of_file().empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 10);
}

// The file that stands for a helper: a shell script.
fs::path helper_that(const TemporaryFolder& folder, const std::string& does) {
    const fs::path script = folder / "helper";
    write_bytes(script, "#!/bin/sh\n" + does + "\n");
    fs::permissions(script, fs::perms::owner_all);
    return script;
}

std::string refusal_with_helper_that(const std::string& does) {
    const EnhancedFile file(patterned());
    const TemporaryFolder folder;
    Job job;
    DicomSlice slice = read_dicom_slice(file.path()).value();
    SplitFrames split(helper_that(folder, does));
    return refusal([&] { split.split({slice}, job); });
}

TEST(FrameHelper, ThatIsNotThereIsNamed) {
    const EnhancedFile file(patterned());
    Job job;
    DicomSlice slice = read_dicom_slice(file.path()).value();
    SplitFrames split("/nowhere/helper");
    const std::string message = refusal([&] { split.split({slice}, job); });
    EXPECT_NE(message.find("ended with 127"), std::string::npos) << message;
}

TEST(FrameHelper, ThatCrashesFailsOrLiesMakesAMessageWithTheFile) {
    for (const auto& [does, words] :
         {std::pair{"kill -SEGV $$", "ended by signal 11"}, std::pair{"exit 9", "ended with 9"},
          std::pair{"exit 0", "frame 1 is missing"}, std::pair{"echo junk >&2; exit 1", "with 1"},
          std::pair{"echo is odd >&2; echo Do this >&2; exit 1", "ct.dcm: is odd. Do this"}}) {
        const std::string message = refusal_with_helper_that(does);
        EXPECT_NE(message.find(words), std::string::npos) << does << ": " << message;
        EXPECT_NE(message.find("ct.dcm"), std::string::npos) << message;
    }
}

TEST(FrameHelper, IsKilledWhenTheJobIsCancelledAndLeavesNothing) {
    const EnhancedFile file(patterned());
    const TemporaryFolder folder;
    const fs::path note = folder / "temporary folder";
    Job job;
    job.observe([&](JobEvent) {
        if (!bytes_of_file(note).empty()) job.cancel();
    });
    DicomSlice slice = read_dicom_slice(file.path()).value();
    {
        SplitFrames split(
            helper_that(folder, "printf %s \"$2\" > '" + note.string() + "'; exec sleep 60"));
        EXPECT_THROW(split.split({slice}, job), Cancelled);
        EXPECT_TRUE(fs::exists(bytes_of_file(note)));
    }
    EXPECT_FALSE(fs::exists(bytes_of_file(note)));
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);  // no child is left, not even a dead one
}

}  // namespace
}  // namespace hepatica
