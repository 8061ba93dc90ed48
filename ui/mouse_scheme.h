// SPDX-License-Identifier: GPL-3.0-or-later
// Which mouse buttons orbit, pan and zoom the view: the program's own scheme, that of 3D Slicer, or
// that of CAD programs. What the left button does to vessels is the same in all.
#pragma once

#include <QString>
#include <optional>
#include <span>

namespace hepatica {

enum class MouseButton { left, middle, right };

struct MouseModifiers {
    bool shift = false;
    bool control = false;
    bool alt = false;
};

enum class CameraGesture { orbit, pan, zoom };

struct MouseScheme {
    const char* name;   // in the settings
    const char* words;  // English, for Words::tr
    const char* tip;    // likewise
    // The camera gesture of a drag, wherever it begins; nullopt: what lies under it decides.
    std::optional<CameraGesture> (*camera)(MouseButton button, const MouseModifiers& modifiers);
};

// The first is the usual one.
std::span<const MouseScheme> mouse_schemes();
// The usual scheme if there is none of this name.
const MouseScheme& mouse_scheme_named(const QString& name);

}  // namespace hepatica
