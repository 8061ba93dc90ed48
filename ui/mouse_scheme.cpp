// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mouse_scheme.h"

#include <algorithm>
#include <array>

#include "ui/words.h"

namespace hepatica {
namespace {

std::optional<CameraGesture> usual(MouseButton button, const MouseModifiers& modifiers) {
    if (button == MouseButton::middle) return CameraGesture::pan;
    if (button == MouseButton::left && modifiers.shift) return CameraGesture::pan;
    if (button == MouseButton::right) return CameraGesture::orbit;
    return std::nullopt;
}

std::optional<CameraGesture> as_in_slicer(MouseButton button, const MouseModifiers& modifiers) {
    if (button == MouseButton::right) return CameraGesture::zoom;
    return usual(button, modifiers);
}

std::optional<CameraGesture> as_in_construction(MouseButton button,
                                                const MouseModifiers& modifiers) {
    if (button == MouseButton::right) return CameraGesture::pan;
    if (button == MouseButton::middle)
        return modifiers.shift     ? CameraGesture::zoom
               : modifiers.control ? CameraGesture::pan
                                   : CameraGesture::orbit;
    return usual(button, modifiers);
}

constexpr std::array schemes{
    MouseScheme{"usual", Words::id("&Usual"),
                Words::id("Right drag orbits, middle drag pans, the wheel zooms"), usual},
    MouseScheme{
        "slicer", Words::id("As in 3D &Slicer"),
        Words::id("Right drag zooms, middle drag pans; left drag beside the vessels orbits"),
        as_in_slicer},
    MouseScheme{"construction", Words::id("As in &CAD"),
                Words::id("Middle drag orbits, with Ctrl it pans, with Shift it zooms; right drag "
                          "pans"),
                as_in_construction},
};

}  // namespace

std::span<const MouseScheme> mouse_schemes() {
    return schemes;
}

const MouseScheme& mouse_scheme_named(const QString& name) {
    const auto* found =
        std::ranges::find_if(schemes, [&](const MouseScheme& s) { return name == s.name; });
    return found == schemes.end() ? schemes.front() : *found;
}

}  // namespace hepatica
