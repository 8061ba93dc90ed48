// SPDX-License-Identifier: GPL-3.0-or-later
// The vascular systems of the liver: one numbering for masks, tree files, seeds, edits and pictures
// (1 portal vein, 2 hepatic veins, 3 artery, 255 unknown), and one set of names for the screen, the
// command line and JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/vector.h"

namespace hepatica {

enum class VascularSystem : std::uint8_t {
    portal = 1,
    hepatic = 2,
    artery = 3,
    unknown = 255,  // a vessel that has not been assigned
};

inline constexpr std::array vascular_systems{VascularSystem::portal, VascularSystem::hepatic,
                                             VascularSystem::artery, VascularSystem::unknown};

constexpr int number_of(VascularSystem system) {
    return static_cast<int>(system);
}

// The name in files and on the command line: portal, hepatic, artery or unknown.
std::string name_of(VascularSystem system);
// The name on the screen: portal vein, hepatic veins, artery or unknown system.
std::string title_of(VascularSystem system);

// The system of a number or of a name; none if there is no such system. A text may be either.
std::optional<VascularSystem> system_numbered(int number);
std::optional<VascularSystem> system_named(std::string_view name_or_number);

// For messages: "1 portal, 2 hepatic, 3 artery, 255 unknown".
std::string list_of_systems();

// A point inside a vessel, in patient space (LPS, mm), and the system that the vessel belongs to.
struct VesselSeed {
    Vec3 position_mm = Vec3::Zero();
    VascularSystem system = VascularSystem::unknown;

    bool operator==(const VesselSeed&) const = default;
};

}  // namespace hepatica
