// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/brush_dab.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "app/command_line.h"
#include "core/base/error.h"

namespace hepatica {

BrushStroke dab(const std::string& option, const std::string& text, bool erases) {
    std::array<double, 4> numbers{};  // x, y, z, radius
    const char *at = text.data(), *const end = at + text.size();
    bool whole = true;
    for (std::size_t i = 0; i < numbers.size() && whole; ++i) {
        const auto [rest, error] = std::from_chars(at, end, numbers[i]);
        const bool last = i + 1 == numbers.size();
        whole = error == std::errc{} && std::isfinite(numbers[i]) &&
                (last ? rest == end : rest != end && *rest == ',');
        at = whole && !last ? rest + 1 : rest;
    }
    const auto [x, y, z, radius_mm] = numbers;
    if (!whole || !(radius_mm > 0.0 && radius_mm <= widest_brush_mm))
        throw UsageError("\"" + text + "\" is no ball", option,
                         "Write X,Y,Z,RADIUS in mm, the radius above 0 and up to 50");
    return {{Vec3(x, y, z)}, radius_mm, erases};
}

}  // namespace hepatica
