// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a Tradeoff as CSV and SVG: write_tradeoff() of tradeoff.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "core/base/atomic_write.h"
#include "core/base/csv_cell.h"
#include "core/base/error.h"
#include "core/study/tradeoff.h"

namespace hepatica {
namespace {

std::string csv_of(const Tradeoff& tradeoff) {
    std::ostringstream out;
    out << "element,elements,region,back_end,device,solver,energy_tolerance,max_iterations,newton_"
           "iterations,dt_s,"
           "step_ms,frame_ms,linear_iterations,error_relative,rest_error_relative,on_front,quality,"
           "not_measured\n";
    for (const TradeoffPoint& p : tradeoff.points)
        out << p.element << ',' << p.elements << ',' << p.region << ',' << p.back_end << ','
            << csv_cell(p.device) << ',' << name_of(p.options.solver) << ','
            << p.options.linear.energy_tolerance << ',' << p.options.linear.max_iterations << ','
            << p.options.newton_iterations << ',' << p.dt_s << ',' << p.step_ms << ',' << p.frame_ms
            << ',' << p.iterations << ',' << p.error_relative << ',' << p.rest_error_relative << ','
            << p.on_front << ',' << p.quality << ',' << csv_cell(p.not_measured) << '\n';
    return out.str();
}

constexpr double width = 960, height = 620, left = 90, right = 230, top = 70, bottom = 70;

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

void draw_axes(std::ostream& out, const Axis& x, const Axis& y, const std::string& error_name) {
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
        << ") rotate(-90)' text-anchor='middle'>" << error_name << "</text>\n";
}

constexpr std::array colours{"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b"};

std::string words_of(const TradeoffPoint& point) {
    std::ostringstream words;
    words << point.element;
    if (point.options.substeps > 1) words << " x" << point.options.substeps;
    if (point.options.newton_iterations > 1) words << " N" << point.options.newton_iterations;
    if (point.options.solver != LinearSolverKind::automatic)
        words << ' ' << name_of(point.options.solver);
    if (point.options.linear.energy_tolerance == 0.0)
        words << ' ' << point.options.linear.max_iterations;
    if (!point.device.empty()) words << ", " << point.back_end;
    return words.str();
}

// Filled circle: the body's own mesh, whole; square: only the live region; ring: another mesh.
void draw_point(std::ostream& out, const TradeoffPoint& p, double x, double y, const char* colour) {
    const double r = p.on_front ? 6.0 : 4.0;
    const std::string opacity = p.on_front ? "1" : "0.45";
    if (p.region == "live")
        out << "<rect x='" << x - r << "' y='" << y - r << "' width='" << 2 * r << "' height='"
            << 2 * r << "' fill='" << colour << "' fill-opacity='" << opacity << "'>";
    else if (!p.own_mesh)
        out << "<circle cx='" << x << "' cy='" << y << "' r='" << r << "' fill='none' stroke='"
            << colour << "' stroke-width='2'>";
    else
        out << "<circle cx='" << x << "' cy='" << y << "' r='" << r << "' fill='" << colour
            << "' fill-opacity='" << opacity << "'>";
    out << "<title>" << words_of(p) << ", " << p.elements << " elements</title>"
        << (p.region == "live" ? "</rect>\n" : "</circle>\n");
    if (p.on_front)
        out << "<text x='" << x + 9 << "' y='" << y - 7 << "' font-size='11'>" << words_of(p)
            << "</text>\n";
}

void draw_legend(std::ostream& out, const std::map<std::string, std::size_t>& colour_of,
                 bool meshes) {
    const double x = width - right + 25;
    double y = top + 20.0;
    const auto line = [&](const std::string& words) {
        out << "<text x='" << x + 13 << "' y='" << y + 4 << "'>" << words << "</text>\n";
        y += 22.0;
    };
    for (const auto& [name, index] : colour_of) {
        out << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='"
            << colours[index % colours.size()] << "'/>\n";
        line(name);
    }
    line("x4: four substeps a frame");
    line("N5: five Newton iterates");
    if (meshes) line("square: only the live region");
    if (meshes) line("ring: another mesh size");
    line("- - Pareto front");
}

std::string svg_of(const Tradeoff& tradeoff, const std::string& error_name) {
    std::vector<TradeoffPoint> measured;
    std::vector<double> cost, error;
    std::map<std::string, std::size_t> colour_of;
    bool meshes = false;
    for (const TradeoffPoint& p : tradeoff.points) {
        if (!is_measured(p)) continue;
        measured.push_back(p);
        cost.push_back(p.frame_ms);
        error.push_back(std::max(p.error_relative, 1e-5));
        colour_of.emplace(p.element, colour_of.size());
        meshes = meshes || !p.own_mesh || p.region == "live";
    }
    std::ostringstream out;
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
        << "' font-family='sans-serif' font-size='13'>\n<rect width='100%' height='100%' "
           "fill='white'/>\n<text x='"
        << left << "' y='26' font-size='16'>Error against cost</text>\n<text x='" << left
        << "' y='48' font-size='12'>reference: " << tradeoff.reference << "</text>\n";
    if (!measured.empty()) {
        const Axis x = axis_over(cost, left, width - right),
                   y = axis_over(error, height - bottom, top);
        draw_axes(out, x, y, error_name);
        std::vector<std::array<double, 2>> front;
        for (std::size_t i = 0; i < cost.size(); ++i) {
            const double px = x.place(cost[i]), py = y.place(error[i]);
            if (measured[i].on_front) front.push_back({px, py});
            draw_point(out, measured[i], px, py,
                       colours[colour_of[measured[i].element] % colours.size()]);
        }
        std::ranges::sort(front);
        out << "<polyline fill='none' stroke='black' stroke-dasharray='4 3' points='";
        for (const auto& [px, py] : front) out << px << ',' << py << ' ';
        out << "'/>\n";
    }
    draw_legend(out, colour_of, meshes);
    out << "</svg>\n";
    return out.str();
}

}  // namespace

void write_tradeoff(const Tradeoff& tradeoff, const std::filesystem::path& folder,
                    const std::string& error_name) {
    write_files_atomically(folder, [&](const std::filesystem::path& temporary) {
        write_text_atomically(temporary / "tradeoff.csv", csv_of(tradeoff));
        write_text_atomically(temporary / "tradeoff.svg", svg_of(tradeoff, error_name));
    });
}

}  // namespace hepatica
