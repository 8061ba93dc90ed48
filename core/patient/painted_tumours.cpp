// SPDX-License-Identifier: GPL-3.0-or-later
// Applies tumour strokes to organ labels, on a grid grown around the liver.
#include "core/patient/painted_tumours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/image/filters.h"

namespace hepatica {

namespace {

constexpr double room_mm = 30.0;
static_assert(organ_label::first_tumour + most_tumours - 1 == 255);

// The first and last indices of the grid grown by room_mm, but not beyond the CT.
std::array<Index3, 2> grown_range(const Grid& grid, const Grid& ct) {
    Vec3 least = Vec3::Constant(-HUGE_VAL), most = Vec3::Constant(HUGE_VAL);
    if (ct.count() > 0) {
        std::swap(least, most);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at = grid.to_index(ct.to_mm((corner & 1) ? ct.dims[0] - 1 : 0,
                                                   (corner & 2) ? ct.dims[1] - 1 : 0,
                                                   (corner & 4) ? ct.dims[2] - 1 : 0));
            least = least.cwiseMin(at);
            most = most.cwiseMax(at);
        }
    }
    std::array<Index3, 2> range{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double room = std::floor(room_mm / grid.spacing_mm[i]);
        const double last = grid.dims[axis] - 1;
        range[0][axis] = static_cast<int>(std::min(0.0, std::max(std::round(least[i]), -room)));
        range[1][axis] =
            static_cast<int>(std::max(last, std::min(std::round(most[i]), last + room)));
    }
    return range;
}

Mask grown(const Mask& mask, const Grid& ct) {
    const auto [first, last] = grown_range(mask.grid, ct);
    Grid grid = mask.grid;
    for (std::size_t axis = 0; axis < 3; ++axis) grid.dims[axis] = last[axis] - first[axis] + 1;
    grid.origin_mm = mask.grid.to_mm(first[0], first[1], first[2]);
    Mask larger(grid);
    paste(mask, {-first[0], -first[1], -first[2]}, larger);
    return larger;
}

bool is_stroke(const TreeEdit& edit) {
    return is_tumour_stroke(edit.kind);
}

}  // namespace

std::vector<Tumour> tumours_in(const Mask& organs) {
    std::array<std::size_t, most_tumours + 1> voxels{};
    std::array<Vec3, most_tumours + 1> sums;
    sums.fill(Vec3::Zero());
    for (std::size_t i = 0; i < organs.voxels.size(); ++i) {
        const auto number = static_cast<std::size_t>(tumour_of(organs.voxels[i]));
        if (number == 0) continue;
        const auto [x, y, z] = organs.grid.index_of(i);
        ++voxels[number];
        sums[number] += Vec3(x, y, z);
    }
    std::vector<Tumour> found;
    for (std::size_t n = 1; n < voxels.size(); ++n) {
        const auto count = static_cast<double>(voxels[n]);
        if (voxels[n] > 0)
            found.push_back({static_cast<int>(n), count * organs.grid.spacing_mm.prod() / 1000.0,
                             organs.grid.to_mm(sums[n] / count)});
    }
    return found;
}

int tumour_of(std::uint8_t label) {
    return std::max(0, label - organ_label::first_tumour + 1);
}

std::uint8_t label_of_tumour(int number) {
    return static_cast<std::uint8_t>(organ_label::first_tumour + number - 1);
}

Mask tumour_voxels(const Mask& organs) {
    Mask tumours = organs;
    for (std::uint8_t& voxel : tumours.voxels) voxel = static_cast<std::uint8_t>(tumour_of(voxel));
    return tumours;
}

std::string numbers_of(const std::vector<Tumour>& tumours) {
    std::string text;
    for (const Tumour& tumour : tumours)
        text += (text.empty() ? "" : ", ") + std::to_string(tumour.number);
    return text.empty() ? "none" : text;
}

int number_for_new(const std::vector<Tumour>& tumours) {
    const int above = tumours.empty() ? 1 : tumours.back().number + 1;
    if (above <= most_tumours) return above;
    for (int number = 1; number <= most_tumours; ++number)
        if (std::ranges::find(tumours, number, &Tumour::number) == tumours.end()) return number;
    return 0;
}

TreeEdit tumour_edit(const BrushStroke& stroke, int tumour) {
    TreeEdit edit;
    edit.kind = stroke.erases ? TreeEditKind::erase_tumour : TreeEditKind::paint_tumour;
    edit.at_mm = stroke.path_mm.front();
    edit.path_mm = stroke.path_mm;
    edit.radii_mm = {stroke.radius_mm};
    edit.tumour = tumour;
    return edit;
}

BrushStroke stroke_of(const TreeEdit& edit) {
    return {edit.path_mm, edit.radii_mm.front(), edit.kind == TreeEditKind::erase_tumour};
}

std::vector<TreeEdit> tumour_strokes(const std::vector<TreeEdit>& edits) {
    std::vector<TreeEdit> strokes;
    std::ranges::copy_if(edits, std::back_inserter(strokes), is_stroke);
    return strokes;
}

std::vector<TreeEdit> tree_edits(const std::vector<TreeEdit>& edits) {
    std::vector<TreeEdit> others;
    std::ranges::copy_if(edits, std::back_inserter(others),
                         [](const TreeEdit& edit) { return changes_tree(edit.kind); });
    return others;
}

bool may_hold_tumours(const PatientCase& patient) {
    if (!patient.organs.voxels.empty())
        return std::ranges::any_of(patient.organs.voxels, [](auto v) { return tumour_of(v) > 0; });
    if (std::ranges::any_of(patient.corrections.edits, is_stroke)) return true;
    const auto parameters = nlohmann::json::parse(patient.source.parameters_json, nullptr, false);
    return parameters.is_object() && parameters.contains("tumour_masks_given");
}

Mask unpainted_organs(const PatientCase& patient) {
    const Mask& kept = patient.corrections.unpainted;
    if (kept.voxels.empty()) return patient.organs;
    const bool none = std::ranges::none_of(kept.voxels, [](auto voxel) { return voxel != 0; });
    return none ? Mask() : kept;
}

Mask tumour_canvas(const PatientCase& patient) {
    const Mask organs = unpainted_organs(patient);
    if (!organs.voxels.empty()) return grown(organs, patient.source.image_grid);
    return patient.mask.voxels.empty() ? Mask() : Mask(patient.mask.grid);
}

bool reaches_beyond(const BrushStroke& stroke, const Grid& canvas) {
    const Vec3 radius = stroke.radius_mm * canvas.spacing_mm.cwiseInverse();
    return std::ranges::any_of(stroke.path_mm, [&](const Vec3& place) {
        const Vec3 at = canvas.to_index(place);
        for (int axis = 0; axis < 3; ++axis)
            if (at[axis] - radius[axis] < -0.5 ||
                at[axis] + radius[axis] > canvas.dims[static_cast<std::size_t>(axis)] - 0.5)
                return true;
        return false;
    });
}

std::size_t paint_tumour(const TreeEdit& stroke, const Mask& canvas, Mask& organs) {
    const bool erases = stroke.kind == TreeEditKind::erase_tumour;
    std::size_t changes = 0;
    sweep(stroke_of(stroke), organs.grid, [&](std::size_t offset) {
        std::uint8_t& voxel = organs.voxels[offset];
        const int here = tumour_of(voxel);
        if (erases) {
            if (here == 0 || (stroke.tumour != 0 && stroke.tumour != here)) return;
            const std::uint8_t before = canvas.voxels[offset];
            voxel = tumour_of(before) > 0 ? organ_label::liver : before;
        } else {
            if (here != 0 || voxel == organ_label::cava) return;
            voxel = label_of_tumour(stroke.tumour);
        }
        ++changes;
    });
    return changes;
}

std::optional<std::size_t> paint_tumours(PatientCase& patient, const std::vector<TreeEdit>& edits) {
    std::optional<std::size_t> idle;
    Mask& kept = patient.corrections.unpainted;
    Mask unpainted = unpainted_organs(patient);
    if (std::ranges::none_of(edits, is_stroke)) {
        if (!kept.voxels.empty()) patient.organs = std::move(unpainted);
        kept = {};
        return idle;
    }
    Mask canvas = tumour_canvas(patient);
    if (canvas.voxels.empty()) return idle;
    patient.organs = canvas;
    for (std::size_t i = 0; i < edits.size(); ++i)
        if (is_stroke(edits[i]) && paint_tumour(edits[i], canvas, patient.organs) == 0 && !idle)
            idle = i;
    // Without organs, a mask of zeros records that in the file.
    kept = unpainted.voxels.empty() ? std::move(canvas) : std::move(unpainted);
    return idle;
}

void set_tumour_strokes(PatientCase& patient, const std::vector<TreeEdit>& edits) {
    Corrections& corrections = patient.corrections;
    if (corrections.edits.empty() && !edits.empty()) corrections.extracted = patient.tree;
    if (edits.empty()) corrections.extracted = {};
    corrections.edits = edits;
    paint_tumours(patient, edits);
}

}  // namespace hepatica
