// SPDX-License-Identifier: GPL-3.0-or-later
// Labels connected pieces of the masks and transfers them to the grid of the organs.
#include "core/reconstruction/tumours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/number_text.h"
#include "core/image/morphology.h"
#include "core/image/volume_reader.h"
#include "core/image/voxel_loop.h"
#include "core/patient/patient_case.h"

namespace hepatica {

namespace {

void warn_of_too_many(const Components& pieces, std::vector<std::string>& warnings) {
    if (pieces.sizes.size() <= most_tumours) return;
    std::size_t voxels = 0;
    for (std::size_t i = most_tumours; i < pieces.sizes.size(); ++i) voxels += pieces.sizes[i];
    const double ml = static_cast<double>(voxels) * pieces.labels.grid.spacing_mm.prod() / 1000.0;
    warnings.push_back("The tumours' masks hold " + std::to_string(pieces.sizes.size()) +
                       " separate pieces, and a case holds " + std::to_string(most_tumours) +
                       " tumours at most: the " +
                       std::to_string(pieces.sizes.size() - most_tumours) +
                       " smallest are left out, " + number_text(ml) +
                       " ml together. Remove specks from the masks.");
}

}  // namespace

Mask read_tumours(const std::vector<std::filesystem::path>& files, const Grid& ct_grid,
                  std::vector<std::string>& warnings, Job& job) {
    Mask any = filled_image(ct_grid, std::uint8_t{0}, job);
    for (const std::filesystem::path& file : files) {
        const Mask one = on_grid_of(ct_grid, read_mask(file, job), file.string());
        for_each_voxel(any.voxels.size(), job, [&](std::size_t i) {
            if (one.voxels[i] != 0) any.voxels[i] = 1;
        });
    }
    const Components pieces = connected_components(any, Connectivity::all26, job);
    warn_of_too_many(pieces, warnings);
    Mask tumours = filled_image(ct_grid, std::uint8_t{0}, job);
    for_each_voxel(tumours.voxels.size(), job, [&](std::size_t i) {
        if (pieces.labels.voxels[i] <= most_tumours)
            tumours.voxels[i] = static_cast<std::uint8_t>(pieces.labels.voxels[i]);
    });
    return tumours;
}

void warn_of_tumours_outside(const Mask& tumours, const Grid& organs,
                             std::vector<std::string>& warnings, const Job& job) {
    std::array<std::size_t, most_tumours + 1> all{}, outside{};
    for_each_voxel_in_order(tumours.voxels.size(), job, [&](std::size_t i) {
        const std::uint8_t tumour = tumours.voxels[i];
        if (tumour == 0) return;
        ++all[tumour];
        const auto [x, y, z] = tumours.grid.index_of(i);
        const Vec3 at = organs.to_index(tumours.grid.to_mm(x, y, z));
        if (!organs.contains(static_cast<int>(std::lround(at.x())),
                             static_cast<int>(std::lround(at.y())),
                             static_cast<int>(std::lround(at.z()))))
            ++outside[tumour];
    });
    constexpr std::size_t least_share = 100;  // as a fraction of 1
    std::string numbers;
    std::size_t lost = 0, whole = 0;
    for (std::size_t tumour = 1; tumour < all.size(); ++tumour) {
        if (outside[tumour] == 0 || least_share * outside[tumour] < all[tumour]) continue;
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(tumour);
        lost += outside[tumour];
        whole += all[tumour];
    }
    if (lost == 0) return;
    const double voxel_ml = tumours.grid.spacing_mm.prod() / 1000.0;
    warnings.push_back(
        "Of the tumours numbered " + numbers + " from the masks " +
        number_text(voxel_ml * static_cast<double>(lost)) + " of " +
        number_text(voxel_ml * static_cast<double>(whole)) +
        " ml lie outside the box about the liver and are left out of the case. Check that the "
        "masks of tumours and liver are of this CT, or give a liver mask that includes them.");
}

void add_tumours(const Mask& tumours, Mask& organs) {
    const Grid& grid = organs.grid;
    for (std::size_t i = 0; i < organs.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 at = tumours.grid.to_index(grid.to_mm(x, y, z));
        const int u = static_cast<int>(std::lround(at.x())),
                  v = static_cast<int>(std::lround(at.y())),
                  w = static_cast<int>(std::lround(at.z()));
        if (!tumours.grid.contains(u, v, w)) continue;
        if (const std::uint8_t tumour = tumours.at(u, v, w); tumour != 0)
            organs.voxels[i] = static_cast<std::uint8_t>(organ_label::first_tumour + tumour - 1);
    }
}

}  // namespace hepatica
