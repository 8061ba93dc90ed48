// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace hepatica::palette {
namespace {

// From deep red-brown to pale yellow: Brewer's sequential "YlOrBr" ramp reversed, which stands out
// against blue vessels both for normal and for red-green-blind eyes.
constexpr std::array<Colour, 6> drug_stops{{{0.60, 0.20, 0.016},
                                            {0.80, 0.30, 0.008},
                                            {0.925, 0.44, 0.078},
                                            {0.996, 0.60, 0.16},
                                            {0.996, 0.79, 0.38},
                                            {1.000, 0.96, 0.72}}};

constexpr std::array<Colour, 5> stretch_stops{{{0.38, 0.45, 0.52},
                                               {0.55, 0.47, 0.58},
                                               {0.74, 0.49, 0.66},
                                               {0.91, 0.53, 0.73},
                                               {0.98, 0.63, 0.82}}};
constexpr std::array<Colour, 5> bright_stretch_stops{{{0.53, 0.60, 0.68},
                                                      {0.69, 0.61, 0.72},
                                                      {0.86, 0.62, 0.76},
                                                      {0.98, 0.66, 0.82},
                                                      {1.00, 0.76, 0.92}}};

// At `fraction` of the way along the stops; values outside [0, 1] are clamped.
template <std::size_t n>
Colour between(const std::array<Colour, n>& stops, double fraction) {
    constexpr int intervals = static_cast<int>(n) - 1;
    const double place = std::clamp(fraction, 0.0, 1.0) * intervals;
    const int below = std::min(static_cast<int>(place), intervals - 1);
    return mixed(stops[static_cast<std::size_t>(below)], stops[static_cast<std::size_t>(below) + 1],
                 place - below);
}

double luminance(const Colour& colour) {
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

}  // namespace

double contrast(const Colour& one, const Colour& other) {
    const double a = luminance(one) + 0.05, b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
}

Colour mixed(const Colour& from, const Colour& to, double share) {
    Colour colour{};
    for (std::size_t c = 0; c < colour.size(); ++c) colour[c] = from[c] + share * (to[c] - from[c]);
    return colour;
}

Colour vessel_system(VascularSystem system, bool bright) {
    switch (system) {
        case VascularSystem::portal:
            return bright ? Colour{0.72, 0.56, 1.00} : Colour{0.44, 0.38, 0.82};
        case VascularSystem::hepatic:
            return bright ? Colour{0.20, 0.82, 1.00} : Colour{0.26, 0.58, 0.86};
        case VascularSystem::artery:
            return bright ? Colour{1.00, 0.46, 0.38} : Colour{0.83, 0.27, 0.25};
        case VascularSystem::unknown:
            break;
    }
    return bright ? Colour{0.70, 0.72, 0.78} : Colour{0.58, 0.60, 0.72};
}

Colour drug_target(bool bright) {
    return bright ? Colour{1.00, 0.08, 0.72} : Colour{0.78, 0.24, 0.62};
}

Colour lit_drug_target(bool bright) {
    return bright ? Colour{1.00, 0.40, 0.82} : Colour{0.94, 0.22, 1.00};
}

Colour reached_before(bool bright) {
    return bright ? Colour{0.61, 0.49, 0.52} : Colour{0.84, 0.68, 0.68};
}

Colour highlight(bool bright) {
    return bright ? Colour{0.30, 0.50, 0.95} : Colour{0.08, 0.76, 1.00};
}

Colour chosen_branch(bool bright) {
    return bright ? Colour{0.93, 0.80, 0.00} : Colour{1.00, 0.97, 0.25};
}

// Excludes blue, violet and red, which belong to the systems, and the light green of tumours. Found
// by a search that maximises the least distance between any two of these colours, and from each to
// those excluded, in the OKLab space (Ottosson 2020) as seen by normal and by colour-blind eyes
// (Machado et al. 2009). Segments that are neighbours have very different colours.
Colour liver_segment(int segment) {
    constexpr std::array<Colour, 8> colours{{{0.50, 0.27, 0.36},
                                             {1.00, 0.49, 0.01},
                                             {0.68, 0.98, 0.97},
                                             {0.01, 0.74, 0.45},
                                             {0.93, 0.97, 0.02},
                                             {0.57, 0.00, 0.60},
                                             {0.12, 0.55, 0.48},
                                             {0.89, 0.69, 0.89}}};
    return colours[static_cast<std::size_t>(std::clamp(segment, 1, 8) - 1)];
}

Colour weak_line() {
    return warning(vessel_system(VascularSystem::unknown), 1.0);
}

Colour warning(const Colour& vessel, double load) {
    constexpr Colour near_limit{1.00, 0.83, 0.20}, at_limit{0.95, 0.20, 0.10};
    constexpr double begin = 0.5, yellow = 0.7;
    const auto weighted = [](const Colour& a, const Colour& b, double share) {
        Colour mix{};
        for (int c = 0; c < 3; ++c) mix[c] = (1.0 - share) * a[c] + share * b[c];
        return mix;
    };
    if (load < begin) return vessel;
    if (load < yellow) return weighted(vessel, near_limit, (load - begin) / (yellow - begin));
    return weighted(near_limit, at_limit, std::min(1.0, (load - yellow) / (1.0 - yellow)));
}

Colour stretch(double factor, bool bright) {
    return between(bright ? bright_stretch_stops : stretch_stops,
                   std::log(std::max(factor, 1.0)) / std::log(largest_stretch));
}

Colour drug(double fraction) {
    return between(drug_stops, fraction);
}

std::string drug_glsl() {
    std::ostringstream code;
    code.imbue(std::locale::classic());
    code << std::fixed;
    const auto vec3 = [&](const Colour& c) {
        code << "vec3(" << c[0] << ", " << c[1] << ", " << c[2] << ")";
    };
    constexpr std::size_t intervals = drug_stops.size() - 1;
    code << "vec3 drugColour(float fraction) {\n  float place = clamp(fraction, 0.0, 1.0) * "
         << static_cast<double>(intervals) << ";\n  vec3 mixed = ";
    vec3(drug_stops[0]);
    code << ";\n";
    for (std::size_t i = 0; i < intervals; ++i) {
        code << "  mixed = mix(mixed, ";
        vec3(drug_stops[i + 1]);
        code << ", clamp(place - " << static_cast<double>(i) << ", 0.0, 1.0));\n";
    }
    code << "  return mixed;\n}\n";
    return code.str();
}

}  // namespace hepatica::palette
