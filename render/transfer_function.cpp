// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/transfer_function.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hepatica {
namespace {

constexpr int steps = 64;  // intervals across the window

struct Step {
    double at;
    double value;
};

// Opacity of one millimetre across the window, from black (0) to white (1), at density 0.5. With
// the window intended for vessels (100, 300) tissue below muscle is invisible, liver a haze,
// enhanced blood translucent and bone opaque.
constexpr std::array composite{Step{0.42, 0.0},   Step{0.50, 0.022}, Step{0.62, 0.030},
                               Step{0.72, 0.060}, Step{0.88, 0.180}, Step{1.00, 0.600}};
constexpr std::array maximum{Step{0.30, 0.0}, Step{0.60, 0.20}, Step{1.00, 0.80}};
// The greys of a maximum intensity projection continue beyond the window's white, so that bones
// keep their shape. They end below the brightness of the text, so that the vessels stand out.
constexpr std::array greys{Step{0.0, 0.0}, Step{1.0, 0.50}, Step{3.0, 0.80}};

struct Tissue {
    double hu;
    Colour colour;
};

constexpr std::array tissues{
    Tissue{-100.0, {0.80, 0.68, 0.46}}, Tissue{40.0, {0.60, 0.32, 0.25}},
    Tissue{115.0, {0.62, 0.31, 0.22}},  Tissue{165.0, {0.80, 0.28, 0.21}},
    Tissue{230.0, {0.86, 0.48, 0.36}},  Tissue{300.0, {0.92, 0.86, 0.72}},
    Tissue{800.0, {0.98, 0.96, 0.88}},
};

template <std::size_t count>
double along(const std::array<Step, count>& curve, double at) {
    if (at <= curve.front().at) return curve.front().value;
    for (std::size_t i = 1; i < count; ++i) {
        const auto& [from, low] = curve[i - 1];
        const auto& [to, high] = curve[i];
        if (at < to) return low + (high - low) * (at - from) / (to - from);
    }
    return curve.back().value;
}

Colour tissue_at(double hu) {
    if (hu <= tissues.front().hu) return tissues.front().colour;
    for (std::size_t i = 1; i < tissues.size(); ++i) {
        const Tissue& from = tissues[i - 1];
        const Tissue& to = tissues[i];
        if (hu < to.hu)
            return palette::mixed(from.colour, to.colour, (hu - from.hu) / (to.hu - from.hu));
    }
    return tissues.back().colour;
}

// The opacity of a layer that is thicker by 16^(density - 0.5), a quarter to four times.
double thickened(double opacity, double density) {
    const double factor = std::pow(16.0, std::clamp(density, 0.0, 1.0) - 0.5);
    return 1.0 - std::pow(1.0 - opacity, factor);
}

}  // namespace

std::vector<TransferPoint> transfer_function(const VolumeLook& look, const ViewLook& room) {
    const bool grey = look.preset == VolumePreset::maximum_intensity;
    const double black = look.window.level_hu - 0.5 * look.window.width_hu;
    const auto point_at = [&](double at) -> TransferPoint {
        const double hu = black + at * look.window.width_hu;
        const double opacity = grey ? along(maximum, at) : along(composite, at);
        return {hu, thickened(opacity, look.density),
                grey ? palette::mixed(room.bottom, room.text, along(greys, at)) : tissue_at(hu)};
    };
    std::vector<TransferPoint> points;
    for (int i = 0; i <= steps; ++i) points.push_back(point_at(static_cast<double>(i) / steps));
    // Colours continue beyond the window's white.
    if (grey) points.push_back(point_at(greys.back().at));
    for (const Tissue& tissue : tissues)
        if (!grey && tissue.hu > points.back().hu)
            points.push_back({tissue.hu, points.back().opacity, tissue.colour});
    return points;
}

std::vector<GradientPoint> gradient_function() {
    return {{0.0, 0.04}, {10.0, 0.35}, {50.0, 1.0}};
}

}  // namespace hepatica
