// SPDX-License-Identifier: GPL-3.0-or-later
// A plot of curves over one axis: as data, as CSV, and as a picture by VTK's chart.
#pragma once

#include <string>
#include <vector>

#include "render/palette.h"

class vtkRenderWindow;

namespace hepatica {

struct Curve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;  // as many as x; those that are not finite are left out
    bool points_only = false;
};

struct Chart {
    std::string title;
    std::string x_label;  // with its unit: "Time (s)"
    std::string y_label;
    std::vector<Curve> curves;
    bool logarithmic_x = false;  // all values > 0
    bool logarithmic_y = false;
};

// Colour of the curve with this index: Okabe and Ito's set, told apart by colour-blind readers.
Colour curve_colour(std::size_t index);

// One row per point: curve, x, y. Decimal points, 17 significant digits.
std::string to_csv(const Chart& chart);

// Draws the chart, black on white, into the whole window, whose context must be current. The window
// must hold nothing else.
void draw_chart(vtkRenderWindow& window, const Chart& chart);

}  // namespace hepatica
