// SPDX-License-Identifier: GPL-3.0-or-later
// A chart of curves with one pair of axes: its data, its export as CSV, and its picture, drawn by
// VTK.
#pragma once

#include <string>
#include <vector>

#include "render/palette.h"

class vtkRenderWindow;

namespace hepatica {

struct Curve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;  // as many as x; points that are not finite are left out
    bool points_only = false;
};

struct Chart {
    std::string title;
    std::string x_label;  // with its unit: "Time (s)"
    std::string y_label;
    std::vector<Curve> curves;
    bool logarithmic_x = false;  // points with a value <= 0 are left out
    bool logarithmic_y = false;
};

// Colour of the curve with this index, from the palette of Okabe and Ito, which colour-blind
// readers can tell apart. It repeats after 7.
Colour curve_colour(std::size_t index);

// One row per point: curve, x, y. Decimal points, 17 significant digits. Points that are not finite
// are kept.
std::string to_csv(const Chart& chart);

// Draws the chart on white into the whole window, whose context must be current and which must hold
// nothing else.
void draw_chart(vtkRenderWindow& window, const Chart& chart);

}  // namespace hepatica
