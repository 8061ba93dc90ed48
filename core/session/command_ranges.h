// SPDX-License-Identifier: GPL-3.0-or-later
// What the numbers of commands in a file may be. A value beyond it is damage or a mistake, and a
// step from it may never end.
#pragma once

#include <string_view>

#include "core/base/number_range.h"

namespace hepatica {

// By the field's name, which holds its unit: "point_mm". Of a vector it holds for each coordinate.
// Every field of a command that is a real number has one.
NumberRange range_of(std::string_view field);

}  // namespace hepatica
