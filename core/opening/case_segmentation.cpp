// SPDX-License-Identifier: GPL-3.0-or-later
// Maps systems and organs of a case to segments with names, colours and SNOMED codes.
#include "core/opening/case_segmentation.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/vascular_system.h"
#include "core/image/memory_limit.h"
#include "core/image/segmentation_writer.h"
#include "core/image/volume_writer.h"
#include "core/opening/patient_image.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// Codes of DICOM PS3.16: categories from context group CID 7150, veins from CID 12114, organs from
// the groups that CID 7151 includes.
const SnomedConcept anatomical_structure{"91723000", "Anatomical Structure"};
const SnomedConcept abnormal_structure{"49755003", "Morphologically Abnormal Structure"};

SegmentMeaning meaning_of(VascularSystem system) {
    switch (system) {
        case VascularSystem::portal:
            return {
                "Portal vein", anatomical_structure, {"32764006", "Portal vein"}, {120, 110, 204}};
        case VascularSystem::hepatic:
            return {
                "Hepatic veins", anatomical_structure, {"8993003", "Hepatic vein"}, {69, 140, 217}};
        case VascularSystem::artery:
            return {"Hepatic artery",
                    anatomical_structure,
                    {"76015000", "Hepatic artery"},
                    {212, 69, 64}};
        case VascularSystem::unknown:
            break;
    }
    return {"Vessels of the liver",
            anatomical_structure,
            {"59820001", "Blood vessel"},
            {148, 153, 184}};
}

// None for a label that stands for no organ (organ_label in patient_case.h).
std::optional<SegmentMeaning> meaning_of_organ(std::uint8_t label) {
    if (label == organ_label::liver)
        return SegmentMeaning{"Liver", anatomical_structure, {"10200004", "Liver"}, {171, 115, 94}};
    if (label == organ_label::cava)
        return SegmentMeaning{"Inferior vena cava",
                              anatomical_structure,
                              {"64131007", "Inferior vena cava"},
                              {40, 90, 160}};
    if (label < organ_label::first_tumour) return std::nullopt;
    const int number = label - organ_label::first_tumour + 1;
    return SegmentMeaning{"Tumour " + std::to_string(number),
                          abnormal_structure,
                          {"108369006", "Neoplasm"},
                          {220, 190, 60}};
}

// Collects the layers to write and numbers the labels that occur in them.
class Segments {
  public:
    void add(const Mask& voxels, std::optional<SegmentMeaning> (*meaning)(std::uint8_t)) {
        if (voxels.voxels.empty()) return;
        SegmentLayer layer{&voxels, {}};
        for (const std::uint8_t label : std::set(voxels.voxels.begin(), voxels.voxels.end())) {
            const auto known = label == 0 ? std::nullopt : meaning(label);
            if (!known) continue;
            layer.segment_of[label] = meanings.size();
            meanings.push_back(*known);
        }
        layers.push_back(std::move(layer));
    }

    std::vector<SegmentMeaning> meanings;
    std::vector<SegmentLayer> layers;
};

// Vessels first, which lie in organs. Throws InputError where the case has no voxels.
Segments segments_of(const PatientCase& patient) {
    if (patient.mask.voxels.empty() && patient.organs.voxels.empty())
        throw InputError("holds no voxels of vessels or organs", patient.source.name,
                         "Reconstruct the case from its CT");
    Segments segments;
    segments.add(patient.mask, [](std::uint8_t label) {
        return std::optional(meaning_of(static_cast<VascularSystem>(label)));
    });
    segments.add(patient.organs, meaning_of_organ);
    return segments;
}

// A case's file may come from anybody.
void require_usable(const Grid& grid, const std::string& name) {
    const Mat3 product = grid.direction.transpose() * grid.direction;
    bool usable = grid.origin_mm.allFinite() && grid.spacing_mm.allFinite() &&
                  grid.spacing_mm.minCoeff() > 0.0 && product.isIdentity(1e-6);
    for (const int n : grid.dims) usable = usable && n > 0;
    if (!usable)
        throw InputError("does not say which voxels its CT had", name,
                         "Reconstruct the case from its CT");
    require_memory(bytes_of(grid.dims[0], grid.dims[1], grid.dims[2], sizeof(std::uint16_t)), name);
}

// 0, or the number from 1 of the first layer's segment at this position.
std::uint16_t number_at(const std::vector<SegmentLayer>& layers, const Vec3& position_mm) {
    for (const SegmentLayer& layer : layers) {
        const auto found = layer.segment_of.find(value_at(*layer.voxels, position_mm));
        if (found != layer.segment_of.end()) return static_cast<std::uint16_t>(found->second + 1);
    }
    return 0;
}

std::vector<SegmentDescription> descriptions_of(const std::vector<SegmentMeaning>& meanings) {
    std::vector<SegmentDescription> descriptions;
    for (const SegmentMeaning& meaning : meanings) {
        const auto [red, green, blue] = meaning.srgb;
        descriptions.push_back({static_cast<std::uint16_t>(descriptions.size() + 1), meaning.label,
                                Vec3(red, green, blue) / 255.0});
    }
    return descriptions;
}

}  // namespace

void write_case_segmentation(const PatientCase& patient, const fs::path& ct, const fs::path& file,
                             const std::string& program_version, Job& job) {
    const Segments segments = segments_of(patient);
    const int series = found_image_of(patient, ct, job).series;
    write_dicom_segmentation(file, segments.meanings, segments.layers, ct, series, program_version,
                             job);
}

void write_case_labels(const PatientCase& patient, const fs::path& file, Job& job) {
    const Segments segments = segments_of(patient);
    const Grid& grid = patient.source.image_grid;
    require_usable(grid, patient.source.name);
    job.begin_stage("Writing the segmentation");
    LabelMap labels(grid);
    parallel_blocks(static_cast<std::size_t>(grid.dims[2]), 1, [&](std::size_t z, std::size_t) {
        job.throw_if_cancelled();
        std::size_t i = grid.offset(0, 0, static_cast<int>(z));
        for (int y = 0; y < grid.dims[1]; ++y)
            for (int x = 0; x < grid.dims[0]; ++x, ++i)
                labels.voxels[i] =
                    number_at(segments.layers, grid.to_mm(x, y, static_cast<int>(z)));
    });
    write_segmentation(file, labels, descriptions_of(segments.meanings));
}

}  // namespace hepatica
