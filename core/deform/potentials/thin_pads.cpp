// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/thin_pads.h"

#include <algorithm>
#include <utility>

#include "core/deform/potentials/tool_pad.h"

namespace hepatica {
namespace {

std::array<int, 3> ascending(std::array<int, 3> corners) {
    std::ranges::sort(corners);
    return corners;
}

// The thickest pad in which a triangle with this gap stores nothing, in spite of the share that is
// taken off its gap because it may bulge.
double unpressed_pad_mm(double gap_mm) {
    return gap_mm / (1.0 + ToolPad::dip_of_pad);
}

// That of every triangle in the tool's pad, for its least gap to any part; ascending by corners.
std::vector<ThinPad> unpressed_pads(const Tool& tool, const SurfacePatches& surface,
                                    std::span<const Vec3> positions_mm) {
    std::vector<ThinPad> pads;
    for (const ToolPart& part : tool.parts)
        for (const NearTriangle& near : near_capsule(part.shape, surface, positions_mm,
                                                     (1.0 + ToolPad::dip_of_pad) * tool.pad_mm))
            pads.push_back(
                {ascending(surface.triangles()[near.triangle]), unpressed_pad_mm(near.gap_mm)});
    std::ranges::sort(pads, [](const ThinPad& a, const ThinPad& b) {
        return std::pair(a.corners, a.pad_mm) < std::pair(b.corners, b.pad_mm);
    });
    const auto same = [](const ThinPad& a, const ThinPad& b) { return a.corners == b.corners; };
    pads.erase(std::unique(pads.begin(), pads.end(), same), pads.end());
    return pads;
}

// Null where there is none. `pads` ascend by corners, as the corners do.
const ThinPad* find_pad(std::span<const ThinPad> pads, const std::array<int, 3>& corners) {
    const auto found = std::ranges::lower_bound(pads, corners, {}, &ThinPad::corners);
    return found != pads.end() && found->corners == corners ? &*found : nullptr;
}

}  // namespace

double pad_of_triangle_mm(const Tool& tool, const std::array<int, 3>& corners) {
    if (tool.thin_pads.empty()) return tool.pad_mm;
    const ThinPad* const thin = find_pad(tool.thin_pads, ascending(corners));
    return thin ? thin->pad_mm : tool.pad_mm;
}

std::vector<ThinPad> pads_before_split(const Tool& tool, const SurfacePatches& surface,
                                       std::span<const Vec3> positions_mm) {
    std::vector<ThinPad> before = unpressed_pads(tool, surface, positions_mm);
    for (ThinPad& pad : before) pad.pad_mm = pad_of_triangle_mm(tool, pad.corners);
    return before;
}

std::vector<ThinPad> thin_pads_after_split(std::span<const ThinPad> before, const Tool& tool,
                                           const SurfacePatches& surface,
                                           std::span<const int> node_before,
                                           std::span<const Vec3> positions_mm) {
    std::vector<ThinPad> thin = unpressed_pads(tool, surface, positions_mm);
    for (ThinPad& pad : thin) {
        std::array<int, 3> corners = pad.corners;
        for (int& v : corners) v = node_before[v];
        if (const ThinPad* const was_bare = find_pad(before, ascending(corners)))
            pad.pad_mm = was_bare->pad_mm;
    }
    std::erase_if(
        thin, [&](const ThinPad& pad) { return pad.pad_mm <= 0.0 || pad.pad_mm >= tool.pad_mm; });
    return thin;
}

void grow_thin_pads(Tool& tool, const SurfacePatches& surface, std::span<const Vec3> positions_mm) {
    if (tool.thin_pads.empty()) return;
    const std::vector<ThinPad> near = unpressed_pads(tool, surface, positions_mm);
    std::erase_if(tool.thin_pads, [&](ThinPad& thin) {
        const ThinPad* const unpressed = find_pad(near, thin.corners);
        if (!unpressed) return true;
        thin.pad_mm = std::max(thin.pad_mm, unpressed->pad_mm);
        return thin.pad_mm >= tool.pad_mm;
    });
}

}  // namespace hepatica
