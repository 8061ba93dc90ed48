// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM segmentations: bits packed over the borders of bytes, slices left out, segments that
// overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/image/volume_reader.h"
#include "tests/image/enhanced_ct.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;
using namespace testing_support;

// 13 x 11 pixels a slice: 143 bits, so that frames begin within bytes.
bool in_liver(int x, int y, int z) {
    return z >= 2 && z <= 7 && (x + 2 * y + z) % 3 != 0;
}
bool in_vessel(int x, int y, int z) {
    return (z == 3 || z == 6) && x > 4 && y < 6;
}

struct Frame {
    int segment = 1;
    int z = 0;
};

struct Segmentation {
    Segmentation() {
        for (int z = 2; z <= 7; ++z) frames.push_back({1, z});
        for (const int z : {6, 3}) frames.push_back({4, z});
    }
    bool is_set(const Frame& frame, int x, int y) const {
        return frame.segment == 1 ? in_liver(x, y, frame.z) : in_vessel(x, y, frame.z);
    }

    gdcm::DataSet group_of(const Frame& frame) const {
        const Vec3 p =
            grid.to_mm(0, 0, frame.z) + (aside_mm * frame.z) * grid.direction.col(1) +
            ((frame.segment == 4 ? vessel_ahead_mm : 0.0) + (frame.z == 4 ? one_ahead_mm : 0.0) +
             wider_later_mm * std::max(0, frame.z - 20)) *
                grid.direction.col(2);
        gdcm::DataSet place, segment, group;
        put(place, gdcm::Tag(0x0020, 0x0032), gdcm::VR::DS, number_list({p.x(), p.y(), p.z()}));
        put_sequence(group, plane_position, {place});
        put(segment, gdcm::Tag(0x0062, 0x000b), gdcm::VR::US, word_of(frame.segment));
        if (with_segments) put_sequence(group, gdcm::Tag(0x0062, 0x000a), {segment});
        if (frame.z == 4 && one_turned != 0.0)
            put_sequence(group, plane_orientation, {axes_of(one_turned)});
        return group;
    }

    // Of a slice whose rows are turned towards the normal.
    gdcm::DataSet axes_of(double turned) const {
        gdcm::DataSet axes;
        const Vec3 row = (grid.direction.col(0) + turned * grid.direction.col(2)).normalized();
        const Vec3 column = grid.direction.col(1);
        put(axes, gdcm::Tag(0x0020, 0x0037), gdcm::VR::DS,
            number_list({row.x(), row.y(), row.z(), column.x(), column.y(), column.z()}));
        return axes;
    }

    std::string packed_pixels() const {
        std::string bytes;
        std::size_t bit = 0;
        for (const Frame& frame : frames)
            for (int y = 0; y < grid.dims[1]; ++y)
                for (int x = 0; x < grid.dims[0]; ++x, ++bit) {
                    if (bit % 8 == 0) bytes += '\0';
                    if (is_set(frame, x, y)) bytes.back() |= static_cast<char>(1 << (bit % 8));
                }
        return bytes;
    }
    // Halves of 200 and a little more or less.
    std::string fractions() const {
        std::string bytes;
        for (const Frame& frame : frames)
            for (int y = 0; y < grid.dims[1]; ++y)
                for (int x = 0; x < grid.dims[0]; ++x)
                    bytes += static_cast<char>(is_set(frame, x, y) ? 100 + x : 99 - x);
        return bytes;
    }

    void write(const fs::path& file) const {
        gdcm::Writer writer;
        gdcm::DataSet& data = writer.GetFile().GetDataSet();
        put(data, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, sop_class);
        put(data, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, "2.25.99");
        put(data, gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, "SEG");
        put(data, gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, "2.25.98");
        put(data, gdcm::Tag(0x0028, 0x0002), gdcm::VR::US, word_of(1));
        put(data, gdcm::Tag(0x0028, 0x0004), gdcm::VR::CS, "MONOCHROME2");
        put(data, gdcm::Tag(0x0028, 0x0008), gdcm::VR::IS, std::to_string(frames.size()));
        put(data, gdcm::Tag(0x0028, 0x0010), gdcm::VR::US, word_of(grid.dims[1]));
        put(data, gdcm::Tag(0x0028, 0x0011), gdcm::VR::US, word_of(grid.dims[0]));
        const int bits = type == "BINARY" ? 1 : 8;
        put(data, gdcm::Tag(0x0028, 0x0100), gdcm::VR::US, word_of(bits));
        put(data, gdcm::Tag(0x0028, 0x0101), gdcm::VR::US, word_of(bits));
        put(data, gdcm::Tag(0x0028, 0x0102), gdcm::VR::US, word_of(bits - 1));
        put(data, gdcm::Tag(0x0028, 0x0103), gdcm::VR::US, word_of(0));
        put(data, gdcm::Tag(0x0062, 0x0001), gdcm::VR::CS, type);
        put(data, gdcm::Tag(0x0062, 0x000e), gdcm::VR::US, word_of(whole));
        gdcm::DataSet measures, shared;
        put(measures, gdcm::Tag(0x0028, 0x0030), gdcm::VR::DS,
            number_list({grid.spacing_mm[1], grid.spacing_mm[0]}));
        if (stated_spacing_mm > 0.0)
            put(measures, gdcm::Tag(0x0018, 0x0088), gdcm::VR::DS,
                number_list({stated_spacing_mm}));
        put_sequence(shared, plane_orientation, {axes_of(0.0)});
        put_sequence(shared, pixel_measures, {measures});
        put_sequence(data, gdcm::Tag(0x5200, 0x9229), {shared});
        std::vector<gdcm::DataSet> groups;
        for (const Frame& frame : frames) groups.push_back(group_of(frame));
        put_sequence(data, per_frame_groups, groups);
        std::string bytes = type == "BINARY" ? packed_pixels() : fractions();
        if (bytes.size() % 2 != 0) bytes += '\0';
        bytes.resize(bytes.size() - missing_bytes);
        put(data, gdcm::Tag(0x7fe0, 0x0010), gdcm::VR::OB, bytes);
        writer.GetFile().GetHeader().SetDataSetTransferSyntax(
            gdcm::TransferSyntax::ExplicitVRLittleEndian);
        writer.SetFileName(file.c_str());
        ASSERT_TRUE(writer.Write());
    }

    Grid grid = turned_grid();
    std::vector<Frame> frames;
    std::string sop_class = "1.2.840.10008.5.1.4.1.1.66.4";
    std::string type = "BINARY";
    int whole = 200;  // of a fraction
    double stated_spacing_mm = 1.5;
    double aside_mm = 0.0;         // that each slice lies off the one before
    double vessel_ahead_mm = 0.0;  // that the vessel's slices lie off the liver's
    double one_ahead_mm = 0.0;     // that one slice of the liver lies off its place
    double wider_later_mm = 0.0;   // that each gap from slice 20 on is wider
    double one_turned = 0.0;       // of the same slice, towards the normal
    bool with_segments = true;
    std::size_t missing_bytes = 0;
};

struct SegmentationFile {
    explicit SegmentationFile(const Segmentation& what) { what.write(path()); }
    fs::path path() const { return folder / "seg.dcm"; }
    Mask mask(const std::vector<int>& labels = {}) const {
        Job job;
        return on_grid_of(turned_grid(), read_mask(path(), job, labels), "seg.dcm");
    }
    std::string refusal_of_file() const {
        return refusal([&] { mask(); });
    }
    TemporaryFolder folder;
};

void expect_mask(const Mask& mask, const std::function<bool(int, int, int)>& truth) {
    ASSERT_TRUE(same_grid(mask.grid, turned_grid()));
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = mask.grid.index_of(i);
        ASSERT_EQ(mask.voxels[i], truth(x, y, z) ? 1 : 0) << x << ", " << y << ", " << z;
    }
}

TEST(DicomSegmentation, EverySegmentLiesWhereItWasDrawnOnTheCt) {
    for (const char* type : {"BINARY", "FRACTIONAL"}) {
        Segmentation drawn;
        drawn.type = type;
        const SegmentationFile file(drawn);
        expect_mask(file.mask({1}), in_liver);
        expect_mask(file.mask({4}), in_vessel);
        expect_mask(file.mask(),
                    [](int x, int y, int z) { return in_liver(x, y, z) || in_vessel(x, y, z); });
    }
}

TEST(DicomSegmentation, IsALabelMapWhoseHigherSegmentStandsWhereTheyOverlap) {
    for (const bool reversed : {false, true}) {
        Segmentation drawn;
        if (reversed) std::ranges::reverse(drawn.frames);
        const SegmentationFile file(drawn);
        Job job;
        const LabelMap labels =
            on_grid_of(turned_grid(), read_label_map(file.path(), job), "seg.dcm");
        for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
            const auto [x, y, z] = labels.grid.index_of(i);
            ASSERT_EQ(labels.voxels[i], in_vessel(x, y, z) ? 4 : in_liver(x, y, z) ? 1 : 0);
        }
    }
}

// Axes are rounded, and far from the origin a slice's own normal leads to another level. Measured
// along its own, the turned slice would lie where the next one does, 1.8 mm away.
TEST(DicomSegmentation, OfASliceTurnedALittleLiesWhereItWasDrawnFarFromTheOrigin) {
    for (const double turned : {-9e-4, 9e-4}) {
        Segmentation drawn;
        drawn.grid.origin_mm = 2000.0 * drawn.grid.direction.col(0);
        drawn.one_turned = turned;
        const SegmentationFile file(drawn);
        Job job;
        const std::vector<int> liver{1};
        const Mask mask = on_grid_of(drawn.grid, read_mask(file.path(), job, liver), "seg.dcm");
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = mask.grid.index_of(i);
            ASSERT_EQ(mask.voxels[i], in_liver(x, y, z) ? 1 : 0) << x << ", " << y << ", " << z;
        }
    }
}

// The vessel is in two slices, three apart: only the stated spacing tells of those between.
TEST(DicomSegmentation, MayLeaveOutSlicesAndThenNeedsTheirSpacing) {
    Segmentation sparse;
    sparse.frames = {{4, 3}, {4, 6}};
    expect_mask(SegmentationFile(sparse).mask(), in_vessel);
    sparse.frames = {{4, 3}};
    expect_mask(SegmentationFile(sparse).mask(),
                [](int x, int y, int z) { return z == 3 && in_vessel(x, y, z); });
    sparse.stated_spacing_mm = 0.0;
    const std::string message = SegmentationFile(sparse).refusal_of_file();
    EXPECT_NE(message.find("seg.dcm: has one slice and no spacing of slices (0018,0088)"),
              std::string::npos)
        << message;
}

TEST(DicomSegmentation, OfAnotherStatedSpacingIsReadByItsPositions) {
    Segmentation drawn;
    for (const double stated_mm : {4.0, 1.56}) {
        drawn.stated_spacing_mm = stated_mm;
        expect_mask(SegmentationFile(drawn).mask({1}), in_liver);
    }
}

// A stated spacing that is near enough to be believed leads astray over the whole extent: 40 slices
// 2.5 mm apart reach as far as 42 of 2.4 mm.
TEST(DicomSegmentation, OfManySlicesHasAsManyWhereTheirSpacingIsStatedALittleWrong) {
    Segmentation drawn;
    drawn.grid.dims[2] = 40;
    drawn.grid.spacing_mm[2] = 2.5;
    drawn.frames.clear();
    for (int z = 0; z < 40; ++z)
        if (z != 20) drawn.frames.push_back({1, z});
    drawn.stated_spacing_mm = 2.4;
    const SegmentationFile file(drawn);
    Job job;
    const Mask mask = read_mask(file.path(), job);
    ASSERT_TRUE(same_grid(mask.grid, drawn.grid)) << mask.grid.dims[2] << " slices";
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = mask.grid.index_of(i);
        ASSERT_EQ(mask.voxels[i], in_liver(x, y, z) ? 1 : 0) << x << ", " << y << ", " << z;
    }
}

// Positions are rounded: they may lie a tenth of a step beside their places.
TEST(DicomSegmentation, OfSlicesALittleUnevenIsReadAndOfMoreIsRefused) {
    Segmentation drawn;
    drawn.one_ahead_mm = 0.08 * 1.5;
    EXPECT_EQ(SegmentationFile(drawn).refusal_of_file(), "");
    drawn.one_ahead_mm = 0.12 * 1.5;
    EXPECT_NE(SegmentationFile(drawn).refusal_of_file().find("lie between others"),
              std::string::npos);
}

TEST(BadDicomSegmentation, IsRefusedWithFileReasonAndRemedy) {
    const std::string remedy = "Export the segmentation as NIfTI or NRRD";
    const auto expect = [&](const Segmentation& drawn, const std::string& words) {
        const std::string message = SegmentationFile(drawn).refusal_of_file();
        for (const std::string& part : {std::string("seg.dcm"), words, remedy})
            EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    };
    Segmentation odd;
    odd.type = "LABELMAP";
    expect(odd, "of the type \"LABELMAP\" (0062,0001) with 8 bits");
    odd.sop_class = "1.2.840.10008.5.1.4.1.1.66.7";  // of label maps
    expect(odd, "of the type \"LABELMAP\" (0062,0001) with 8 bits");
    Segmentation of_nothing;
    of_nothing.type = "FRACTIONAL";
    of_nothing.whole = 0;
    expect(of_nothing, "the whole of its fractions is 0 (0062,000e)");
    Segmentation short_of_bytes;
    short_of_bytes.missing_bytes = 2;  // of 8 x 143 bits
    expect(short_of_bytes, "holds 142 bytes of pixels, but 8 frames of 143 pixels take 143");
    Segmentation nameless;
    nameless.with_segments = false;
    expect(nameless, "frame 1 names no segment (0062,000b)");
    Segmentation tilted;
    tilted.aside_mm = 0.5;
    expect(tilted, "tilted gantry");
    Segmentation uneven;
    uneven.stated_spacing_mm = 0.0;
    uneven.frames = {{1, 2}, {1, 4}, {1, 7}};
    expect(uneven, "has slices 4.5 mm apart where 3 mm lie between others");
}

// Each gap is near enough to the others, but slices in the middle would lie 1.2 mm beside their
// places.
TEST(BadDicomSegmentation, WhoseDistanceOfSlicesChangesIsRefusedByTheSlice) {
    Segmentation drawn;
    drawn.grid.dims[2] = 40;
    drawn.frames.clear();
    for (int z = 0; z < 40; ++z) drawn.frames.push_back({1, z});
    drawn.wider_later_mm = 0.08 * 1.5;
    const std::string message = SegmentationFile(drawn).refusal_of_file();
    EXPECT_NE(message.find("seg.dcm: has slices whose distance changes: slice 21 lies"),
              std::string::npos)
        << message;
}

// They are not taken for one slice.
TEST(BadDicomSegmentation, OfSlicesMuchNearerThanTheirSpacingDoesNotFitItsCt) {
    Segmentation drawn;
    drawn.vessel_ahead_mm = 0.1;
    EXPECT_NE(SegmentationFile(drawn).refusal_of_file().find("seg.dcm"), std::string::npos);
}

TEST(BadDicomSegmentation, CutShortAnywhereIsRefused) {
    const SegmentationFile file{Segmentation()};
    const std::string whole = bytes_of_file(file.path());
    for (std::size_t bytes = 140; bytes < whole.size(); bytes += 1 + whole.size() / 30) {
        write_bytes(file.path(), whole.substr(0, bytes));
        EXPECT_NE(file.refusal_of_file(), "") << bytes << " of " << whole.size();
    }
}

}  // namespace
}  // namespace hepatica
