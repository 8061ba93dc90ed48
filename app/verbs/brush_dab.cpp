// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/brush_dab.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "app/command_line.h"
#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double most_radius_mm = 50.0;

}  // namespace

BrushStroke dab(const std::string& option, const std::string& text, bool erases) {
    const auto comma = std::min(text.find_last_of(','), text.size());
    const auto numbers = parse_triple(option, text.substr(0, comma));
    const char* const end = text.data() + text.size();
    double radius_mm = 0.0;
    const auto [rest, error] =
        std::from_chars(std::min(text.data() + comma + 1, end), end, radius_mm);
    if (error != std::errc{} || rest != end || !(radius_mm > 0.0 && radius_mm <= most_radius_mm))
        throw UsageError("\"" + text + "\" is no ball", option,
                         "Write X,Y,Z,RADIUS in mm, the radius above 0 and up to 50");
    return {{Vec3(numbers[0], numbers[1], numbers[2])}, radius_mm, erases};
}

}  // namespace hepatica
