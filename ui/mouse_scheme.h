// SPDX-License-Identifier: GPL-3.0-or-later
// Which buttons of the mouse turn, move and zoom the view: as here from the first, as in 3D Slicer,
// or as in programs for construction. What the left button does to vessels is the same in all.
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
    // What a drag does to the camera wherever it begins; none: what is under it decides.
    std::optional<CameraGesture> (*camera)(MouseButton button, const MouseModifiers& modifiers);
};

// The first is the usual one.
std::span<const MouseScheme> mouse_schemes();
// The usual one where no scheme is called so.
const MouseScheme& mouse_scheme_named(const QString& name);

}  // namespace hepatica
