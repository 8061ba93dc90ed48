// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/study/tradeoff.h"

namespace hepatica {
namespace {

std::string csv_of(const Tradeoff& tradeoff) {
    std::ostringstream out;
    out << "element,elements,solver,energy_tolerance,max_iterations,newton_iterations,dt_s,step_ms,"
           "frame_ms,linear_iterations,error_relative,motion_error_relative,on_front,quality\n";
    for (const TradeoffPoint& p : tradeoff.points)
        out << p.element << ',' << p.elements << ',' << name_of(p.options.solver) << ','
            << p.options.linear.energy_tolerance << ',' << p.options.linear.max_iterations << ','
            << p.options.newton_iterations << ',' << p.dt_s << ',' << p.step_ms << ',' << p.frame_ms
            << ',' << p.iterations << ',' << p.error_relative << ',' << p.motion_error_relative
            << ',' << p.on_front << ',' << p.quality << '\n';
    return out.str();
}

constexpr double width = 900, height = 600, left = 90, right = 210, top = 50, bottom = 70;

// A logarithmic axis over whole decades.
struct Axis {
    int low = 0;
    int high = 1;
    double from = 0.0;
    double to = 1.0;

    double place(double value) const {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
};

Axis axis_over(const std::vector<double>& values, double from, double to) {
    const auto [least, most] = std::ranges::minmax(values);
    Axis axis{static_cast<int>(std::floor(std::log10(least))),
              static_cast<int>(std::ceil(std::log10(most))), from, to};
    axis.high = std::max(axis.high, axis.low + 1);
    return axis;
}

void draw_axes(std::ostream& out, const Axis& x, const Axis& y) {
    const auto line = [&](double x1, double y1, double x2, double y2) {
        out << "<line x1='" << x1 << "' y1='" << y1 << "' x2='" << x2 << "' y2='" << y2
            << "' stroke='#ddd'/>\n";
    };
    const auto text = [&](double px, double py, const char* anchor, const std::string& words) {
        out << "<text x='" << px << "' y='" << py << "' text-anchor='" << anchor << "'>" << words
            << "</text>\n";
    };
    for (int d = x.low; d <= x.high; ++d) {
        const double px = x.place(std::pow(10.0, d));
        line(px, top, px, height - bottom);
        std::ostringstream label;
        label << std::pow(10.0, d);
        text(px, height - bottom + 20, "middle", label.str());
    }
    for (int d = y.low; d <= y.high; ++d) {
        const double py = y.place(std::pow(10.0, d));
        line(left, py, width - right, py);
        std::ostringstream label;
        label << 100.0 * std::pow(10.0, d) << " %";
        text(left - 8, py + 4, "end", label.str());
    }
    text((left + width - right) / 2, height - 20, "middle", "milliseconds a frame of 1/60 s");
    out << "<text transform='translate(22," << (top + height - bottom) / 2
        << ") rotate(-90)' text-anchor='middle'>error of the displacement at rest</text>\n";
}

std::string svg_of(const Tradeoff& tradeoff) {
    constexpr std::array colours{"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b"};
    std::vector<double> cost, error;
    std::map<std::string, std::size_t> colour_of;
    for (const TradeoffPoint& p : tradeoff.points) {
        cost.push_back(p.frame_ms);
        error.push_back(std::max(p.error_relative, 1e-5));
        colour_of.emplace(p.element, colour_of.size());
    }
    const Axis x = axis_over(cost, left, width - right), y = axis_over(error, height - bottom, top);
    std::ostringstream out;
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
        << "' font-family='sans-serif' font-size='13'>\n<rect width='100%' height='100%' "
           "fill='white'/>\n<text x='"
        << left << "' y='28' font-size='16'>Error against cost; reference: " << tradeoff.reference
        << "</text>\n";
    draw_axes(out, x, y);
    std::vector<std::array<double, 2>> front;
    for (std::size_t i = 0; i < cost.size(); ++i) {
        const TradeoffPoint& p = tradeoff.points[i];
        const double px = x.place(cost[i]), py = y.place(error[i]);
        if (p.on_front) front.push_back({px, py});
        out << "<circle cx='" << px << "' cy='" << py << "' r='" << (p.on_front ? 6 : 4)
            << "' fill='" << colours[colour_of[p.element] % colours.size()] << "' fill-opacity='"
            << (p.on_front ? 1.0 : 0.45) << "'><title>" << p.element << ' ' << p.elements << ", "
            << name_of(p.options.solver) << "</title></circle>\n";
    }
    std::ranges::sort(front);
    out << "<polyline fill='none' stroke='black' stroke-dasharray='4 3' points='";
    for (const auto& [px, py] : front) out << px << ',' << py << ' ';
    out << "'/>\n";
    for (const auto& [name, index] : colour_of)
        out << "<circle cx='" << width - right + 25 << "' cy='" << top + 20.0 + 22.0 * double(index)
            << "' r='5' fill='" << colours[index % colours.size()] << "'/><text x='"
            << width - right + 38 << "' y='" << top + 24.0 + 22.0 * double(index) << "'>" << name
            << "</text>\n";
    out << "<text x='" << width - right + 20 << "' y='"
        << top + 40.0 + 22.0 * double(colour_of.size()) << "'>- - Pareto front</text>\n</svg>\n";
    return out.str();
}

}  // namespace

void write_tradeoff(const Tradeoff& tradeoff, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw InputError(failure.message(), folder.string(), "Choose a folder that can be written");
    write_text_atomically(folder / "tradeoff.csv", csv_of(tradeoff));
    write_text_atomically(folder / "tradeoff.svg", svg_of(tradeoff));
}

}  // namespace hepatica
