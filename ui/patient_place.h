// SPDX-License-Identifier: GPL-3.0-or-later
// A position in patient coordinates as radiologists read it: distance to the left or right, back or
// front, head or feet from the origin of the CT.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/base/vector.h"

namespace hepatica {

// "L 12  P 40  H 155 mm" for no decimals; the decimal separator is that of the language.
QString patient_place(const Vec3& position_mm, int decimals = 0);

// Reads a place as patient_place() writes it, with a comma or a point, or as three numbers to the
// left, back and head; nullopt: the text is another.
std::optional<Vec3> read_patient_place(const QString& text);

// "12 mm left, 40 mm back, 155 mm headwards", for sentences: not everybody knows the letters.
QString patient_place_in_words(const Vec3& position_mm, int decimals = 0);

// A text in which every place that core wrote is said in words.
QString places_in_words(const QString& text);

// The position that core writes into messages as place_text() (core/base/patient_space.h); nullopt:
// the text is another.
std::optional<Vec3> position_of(const std::string& place);

}  // namespace hepatica
