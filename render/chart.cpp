// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

#include "core/base/csv_cell.h"
#include "render/text_style.h"

namespace hepatica {
namespace {

constexpr std::array<Colour, 7> okabe_ito{{{0.000, 0.447, 0.698},
                                           {0.835, 0.369, 0.000},
                                           {0.000, 0.620, 0.451},
                                           {0.800, 0.475, 0.655},
                                           {0.337, 0.706, 0.914},
                                           {0.902, 0.624, 0.000},
                                           {0.0, 0.0, 0.0}}};
constexpr Colour ink{0.13, 0.15, 0.18};

bool drawable(const Chart& chart, double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && (!chart.logarithmic_x || x > 0.0) &&
           (!chart.logarithmic_y || y > 0.0);
}

// VTK's logarithmic axes take the logarithm twice once a plot was updated. So the plots are given
// logarithms, and the axes are labelled with the decades.
double on_axis(double value, bool logarithmic) {
    return logarithmic ? std::log10(value) : value;
}

void add_curve(vtkChartXY& plots, const Chart& chart, std::size_t index) {
    const Curve& curve = chart.curves[index];
    vtkNew<vtkDoubleArray> x;
    vtkNew<vtkDoubleArray> y;
    x->SetName("x");
    y->SetName(curve.name.empty() ? " " : curve.name.c_str());
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!drawable(chart, curve.x[i], curve.y[i])) continue;
        x->InsertNextValue(on_axis(curve.x[i], chart.logarithmic_x));
        y->InsertNextValue(on_axis(curve.y[i], chart.logarithmic_y));
    }
    if (x->GetNumberOfTuples() == 0) return;
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    vtkPlot* plot = plots.AddPlot(curve.points_only ? vtkChart::POINTS : vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    const Colour colour = curve_colour(index);
    plot->SetColor(colour[0], colour[1], colour[2]);
    plot->SetWidth(2.5f);
    if (curve.points_only) {
        auto* points = vtkPlotPoints::SafeDownCast(plot);
        points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
        points->SetMarkerSize(9.0f);
    }
}

struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
};

Range range_of(const Chart& chart, std::vector<double> Curve::*values) {
    Range range;
    for (const Curve& curve : chart.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!drawable(chart, curve.x[i], curve.y[i])) continue;
            range.lowest = std::min(range.lowest, (curve.*values)[i]);
            range.highest = std::max(range.highest, (curve.*values)[i]);
        }
    }
    return range;
}

std::string decade_name(int exponent) {
    if (exponent >= -2 && exponent <= 3) {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << std::pow(10.0, exponent);
        return text.str();
    }
    return "1e" + std::to_string(exponent);
}

void name_decades(vtkAxis& axis, const Range& range) {
    if (!(range.lowest <= range.highest)) return;
    const int first = static_cast<int>(std::floor(std::log10(range.lowest) + 1e-9));
    const int last =
        std::max(first + 1, static_cast<int>(std::ceil(std::log10(range.highest) - 1e-9)));
    const int stride = 1 + (last - first) / 10;
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> names;
    for (int exponent = first; exponent <= last; exponent += stride) {
        places->InsertNextValue(exponent);
        names->InsertNextValue(decade_name(exponent));
    }
    axis.SetCustomTickPositions(places, names);
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetRange(first, last);
}

struct Corner {
    int across;  // vtkChartLegend's horizontal alignment
    int up;      // its vertical one
};

// The corner with the fewest points of the curves, where the legend hides least.
Corner emptiest_corner(const Chart& chart) {
    constexpr double width = 0.45, height = 0.35;  // share of the plot that a legend may cover
    const auto share = [](double value, const Range& range, bool logarithmic) {
        const double low = on_axis(range.lowest, logarithmic);
        const double extent = on_axis(range.highest, logarithmic) - low;
        return extent > 0.0 ? (on_axis(value, logarithmic) - low) / extent : 0.5;
    };
    const Range across = range_of(chart, &Curve::x);
    const Range up = range_of(chart, &Curve::y);
    std::array<int, 4> points{};  // left top, right top, left bottom, right bottom
    for (const Curve& curve : chart.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!drawable(chart, curve.x[i], curve.y[i])) continue;
            const double x = share(curve.x[i], across, chart.logarithmic_x);
            const double y = share(curve.y[i], up, chart.logarithmic_y);
            points[0] += x < width && y > 1.0 - height;
            points[1] += x > 1.0 - width && y > 1.0 - height;
            points[2] += x < width && y < height;
            points[3] += x > 1.0 - width && y < height;
        }
    const auto best = std::min_element(points.begin(), points.end()) - points.begin();
    return {best % 2 == 0 ? vtkChartLegend::LEFT : vtkChartLegend::RIGHT,
            best < 2 ? vtkChartLegend::TOP : vtkChartLegend::BOTTOM};
}

void style_axis(vtkAxis& axis, const std::string& label) {
    axis.SetTitle(label);
    style_text(*axis.GetTitleProperties(), 15, ink);
    style_text(*axis.GetLabelProperties(), 13, ink);
    axis.GetGridPen()->SetColorF(0.88, 0.89, 0.91);
    axis.GetPen()->SetColorF(ink[0], ink[1], ink[2]);
}

}  // namespace

Colour curve_colour(std::size_t index) {
    return okabe_ito[index % okabe_ito.size()];
}

std::string to_csv(const Chart& chart) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(17);
    text << "curve," << csv_cell(chart.x_label) << ',' << csv_cell(chart.y_label) << '\n';
    for (const Curve& curve : chart.curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            text << csv_cell(curve.name) << ',' << curve.x[i] << ',' << curve.y[i] << '\n';
        }
    }
    return text.str();
}

void draw_chart(vtkRenderWindow& window, const Chart& chart) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    vtkNew<vtkChartXY> plots;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) add_curve(*plots, chart, i);
    plots->SetTitle(chart.title);
    style_text(*plots->GetTitleProperties(), 17, ink);
    vtkAxis& across = *plots->GetAxis(vtkAxis::BOTTOM);
    vtkAxis& up = *plots->GetAxis(vtkAxis::LEFT);
    style_axis(across, chart.x_label);
    style_axis(up, chart.y_label);
    if (chart.logarithmic_x) name_decades(across, range_of(chart, &Curve::x));
    if (chart.logarithmic_y) name_decades(up, range_of(chart, &Curve::y));
    if (chart.curves.size() > 1) {
        plots->SetShowLegend(true);
        style_text(*plots->GetLegend()->GetLabelProperties(), 13, ink);
        const Corner corner = emptiest_corner(chart);
        plots->GetLegend()->SetHorizontalAlignment(corner.across);
        plots->GetLegend()->SetVerticalAlignment(corner.up);
    }
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(plots);
    actor->GetScene()->SetRenderer(renderer);
    renderer->AddActor(actor);
    window.AddRenderer(renderer);
    window.Render();
    window.RemoveRenderer(renderer);
}

}  // namespace hepatica
