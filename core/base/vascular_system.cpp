// SPDX-License-Identifier: GPL-3.0-or-later
// Names and numbers of the systems.
#include "core/base/vascular_system.h"

#include <algorithm>

namespace hepatica {

namespace {

struct Words {
    const char* name;
    const char* title;
};

Words words_of(VascularSystem system) {
    switch (system) {
        case VascularSystem::portal:
            return {"portal", "portal vein"};
        case VascularSystem::hepatic:
            return {"hepatic", "hepatic veins"};
        case VascularSystem::artery:
            return {"artery", "artery"};
        case VascularSystem::unknown:
            break;
    }
    return {"unknown", "unknown system"};
}

}  // namespace

std::string name_of(VascularSystem system) {
    return words_of(system).name;
}

std::string title_of(VascularSystem system) {
    return words_of(system).title;
}

std::optional<VascularSystem> system_numbered(int number) {
    const auto found = std::ranges::find(vascular_systems, number, number_of);
    return found == vascular_systems.end() ? std::nullopt : std::optional(*found);
}

std::optional<VascularSystem> system_named(std::string_view text) {
    const auto found = std::ranges::find_if(vascular_systems, [&](VascularSystem system) {
        return text == name_of(system) || text == std::to_string(number_of(system));
    });
    return found == vascular_systems.end() ? std::nullopt : std::optional(*found);
}

std::string list_of_systems() {
    std::string list;
    for (const VascularSystem system : vascular_systems)
        list +=
            (list.empty() ? "" : ", ") + std::to_string(number_of(system)) + " " + name_of(system);
    return list;
}

}  // namespace hepatica
