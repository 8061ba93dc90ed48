// SPDX-License-Identifier: GPL-3.0-or-later
// A case as a segmentation: each system and organ where its voxels are, under its own name, and in
// DICOM's under its code of SNOMED CT (DICOM PS3.16).
#include "core/opening/case_segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "core/base/vascular_system.h"
#include "core/image/volume_reader.h"
#include "core/image/volume_writer.h"
#include "core/patient/image_digest.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

struct Known {
    std::uint8_t label;
    std::string name, code;
};

const std::vector<Known> systems{
    {number_of(VascularSystem::portal), "Portal vein", "32764006"},
    {number_of(VascularSystem::hepatic), "Hepatic veins", "8993003"},
    {number_of(VascularSystem::artery), "Hepatic artery", "76015000"},
    {number_of(VascularSystem::unknown), "Vessels of the liver", "59820001"}};
const std::vector<Known> organs{{organ_label::liver, "Liver", "10200004"},
                                {organ_label::cava, "Inferior vena cava", "64131007"},
                                {organ_label::first_tumour, "Tumour 1", "108369006"},
                                {organ_label::first_tumour + 1, "Tumour 2", "108369006"}};

// The texts of an element in a file of explicit little endian, in the file's order.
std::vector<std::string> texts_of(const fs::path& file, const std::string& element_and_kind) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<std::string> texts;
    for (std::size_t at = bytes.find(element_and_kind); at != std::string::npos;
         at = bytes.find(element_and_kind, at + 1)) {
        const std::size_t length = static_cast<unsigned char>(bytes.at(at + 6)) +
                                   256u * static_cast<unsigned char>(bytes.at(at + 7));
        std::string text = bytes.substr(at + 8, length);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
        texts.push_back(text);
    }
    return texts;
}

class CaseSegmentation : public ::testing::Test {
  protected:
    CaseSegmentation() {
        fs::remove(file_);
        for (std::size_t i = 0; i < ct_.voxels.size(); ++i)
            ct_.voxels[i] = static_cast<std::int16_t>(i % 300);
        write_dicom_series(folder_ / "ct", ct_, {}, job_);
        patient_.source.image_sha256 = digest_of(ct_);
        patient_.source.image_grid = ct_.grid;
        patient_.source.name = "somebody";
    }
    // Every fourth slice shows the next label.
    Mask slices_of(const std::vector<Known>& known) const {
        Mask mask(ct_.grid);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = mask.grid.index_of(i);
            if (x > 2 && x < 9) mask.voxels[i] = known[static_cast<std::size_t>(z) % 4].label;
        }
        return mask;
    }

    const fs::path folder_ = fs::path(std::getenv("TEST_TMPDIR"));
    const fs::path file_ = folder_ / "out.dcm";
    Job job_;
    Volume ct_{Grid{{14, 12, 8}}};
    PatientCase patient_;
};

TEST_F(CaseSegmentation, NamesEachSystemAndOrganWhereItsVoxelsAre) {
    patient_.mask = slices_of(systems);
    patient_.organs = slices_of(organs);
    patient_.organs.at(11, 3, 2) = 5;  // no organ has this label
    write_case_segmentation(patient_, folder_ / "ct", file_, "1", job_);
    const std::vector<std::string> names = texts_of(file_, std::string("\x62\0\x05\0LO", 6));
    const std::vector<std::string> codes = texts_of(file_, std::string("\x08\0\0\x01SH", 6));
    ASSERT_EQ(names.size(), 8u);
    const auto expect_segment = [&](const Known& known, const Mask& of) {
        const auto found = std::ranges::find(names, known.name);
        ASSERT_NE(found, names.end()) << known.name;
        EXPECT_NE(std::ranges::find(codes, known.code), codes.end()) << known.name;
        const std::vector<int> wanted{static_cast<int>(found - names.begin()) + 1};
        const Mask mask = on_grid_of(ct_.grid, read_mask(file_, job_, wanted), "out");
        for (std::size_t i = 0; i < mask.voxels.size(); ++i)
            ASSERT_EQ(mask.voxels[i] != 0, of.voxels[i] == known.label) << known.name;
    };
    for (const Known& known : systems) expect_segment(known, patient_.mask);
    for (const Known& known : organs) expect_segment(known, patient_.organs);
}

TEST_F(CaseSegmentation, OfACaseWithoutVoxelsIsRefused) {
    try {
        write_case_segmentation(patient_, folder_ / "ct", file_, "1", job_);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("no voxels"), std::string::npos) << error.problem();
        EXPECT_EQ(error.place(), "somebody");
    }
    EXPECT_FALSE(fs::exists(file_));
}

// The names and label values of a .seg.nrrd's header, in its order.
std::vector<Known> segments_in(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<Known> segments;
    for (std::string line; std::getline(in, line) && !line.empty();) {
        const std::string value = line.substr(line.find('=') + 1);
        if (line.find("_LabelValue:=") != std::string::npos)
            segments.push_back({static_cast<std::uint8_t>(std::stoi(value)), "", ""});
        if (line.find("_Name:=") != std::string::npos) segments.back().name = value;
    }
    return segments;
}

TEST_F(CaseSegmentation, ForSlicerHasEachVoxelOnceAndVesselsBeforeOrgans) {
    patient_.mask = slices_of(systems);
    for (std::size_t i = 0; i < patient_.mask.voxels.size(); ++i)
        if (patient_.mask.grid.index_of(i)[1] > 5) patient_.mask.voxels[i] = 0;
    patient_.organs = slices_of(organs);
    patient_.organs.at(11, 3, 2) = 5;  // no organ has this label
    const fs::path file = folder_ / "out.seg.nrrd";
    write_case_labels(patient_, file, job_);
    const std::vector<Known> segments = segments_in(file);
    ASSERT_EQ(segments.size(), 8u);
    const auto value_of = [&](const std::vector<Known>& known, int label) {
        const auto at = std::ranges::find(known, label, [](const Known& k) { return k.label; });
        if (at == known.end()) return 0;
        const auto found = std::ranges::find(segments, at->name, &Known::name);
        EXPECT_NE(found, segments.end()) << at->name;
        return found != segments.end() ? found->label : -1;
    };
    const LabelMap labels = read_label_map(file, job_);
    ASSERT_TRUE(same_grid(labels.grid, ct_.grid));
    for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
        const int vessel = value_of(systems, patient_.mask.voxels[i]);
        const int organ = value_of(organs, patient_.organs.voxels[i]);
        ASSERT_EQ(labels.voxels[i], vessel != 0 ? vessel : organ) << i;
    }
    for (std::size_t i = 0; i < segments.size(); ++i) EXPECT_EQ(segments[i].label, i + 1);
}

// The case's voxels may be those of a part of the CT, and of another size.
TEST_F(CaseSegmentation, ForSlicerLiesOnTheGridOfTheCt) {
    Grid half{{14, 6, 4}};
    half.spacing_mm = {0.5, 0.5, 0.5};
    half.origin_mm = {2.75, 4.75, 1.75};
    patient_.mask = Mask(half, number_of(VascularSystem::portal));
    const fs::path file = folder_ / "part.seg.nrrd";
    write_case_labels(patient_, file, job_);
    const LabelMap labels = read_label_map(file, job_);
    ASSERT_TRUE(same_grid(labels.grid, ct_.grid));
    for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
        const auto [x, y, z] = ct_.grid.index_of(i);
        const bool inside = x >= 3 && x < 10 && y >= 5 && y < 8 && z >= 2 && z < 4;
        ASSERT_EQ(labels.voxels[i], inside ? 1 : 0) << x << ' ' << y << ' ' << z;
    }
}

TEST_F(CaseSegmentation, ForSlicerIsRefusedWithoutVoxelsAndForGridsThatAreNone) {
    const fs::path file = folder_ / "none.seg.nrrd";
    EXPECT_THROW(write_case_labels(patient_, file, job_), InputError);
    patient_.mask = slices_of(systems);
    const Grid good = patient_.source.image_grid;
    const std::function<void(Grid&)> damages[]{[](Grid& g) { g.dims[2] = 0; },
                                               [](Grid& g) { g.dims[0] = -1; },
                                               [](Grid& g) { g.spacing_mm[1] = 0.0; },
                                               [](Grid& g) { g.spacing_mm[0] = INFINITY; },
                                               [](Grid& g) { g.origin_mm[0] = NAN; },
                                               [](Grid& g) { g.direction(0, 1) = 0.5; },
                                               [](Grid& g) {
                                                   g.dims = {30000, 30000, 30000};
                                               }};
    for (const auto& damage : damages) {
        damage(patient_.source.image_grid);
        EXPECT_THROW(write_case_labels(patient_, file, job_), InputError);
        EXPECT_FALSE(fs::exists(file));
        patient_.source.image_grid = good;
    }
    EXPECT_NO_THROW(write_case_labels(patient_, file, job_));
}

}  // namespace
}  // namespace hepatica
