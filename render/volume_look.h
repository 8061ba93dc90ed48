// SPDX-License-Identifier: GPL-3.0-or-later
// How a CT is rendered as a volume around the vessels: preset, density, and window of Hounsfield
// units.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "core/image/slice.h"

namespace hepatica {

enum class VolumePreset { vessels_and_bones, maximum_intensity };

// In the order of VolumePreset; used in settings and on the command line.
inline constexpr std::array<std::string_view, 2> volume_preset_names{"vessels-and-bones",
                                                                     "maximum-intensity"};

inline std::string_view name_of(VolumePreset preset) {
    return volume_preset_names[static_cast<std::size_t>(preset)];
}

inline std::optional<VolumePreset> volume_preset_named(std::string_view name) {
    for (std::size_t p = 0; p < volume_preset_names.size(); ++p)
        if (volume_preset_names[p] == name) return static_cast<VolumePreset>(p);
    return std::nullopt;
}

struct VolumeLook {
    VolumePreset preset = VolumePreset::vessels_and_bones;
    double density = 0.5;  // 0: nearly transparent, 1: nearly solid
    // The grey window of the slices: what they show black is transparent, and what they show white
    // is dense.
    GreyWindow window{};
};

}  // namespace hepatica
