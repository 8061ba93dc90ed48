// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/legend_rows.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>

#include "core/base/number_text.h"
#include "core/tree/territories/segment_name.h"

namespace hepatica {
namespace {

constexpr int ramp_cells = 48;

int decimals_for(double range) {
    return range < 1.0 ? 2 : range < 20.0 ? 1 : 0;
}

std::string with_capital(std::string text) {
    if (!text.empty())
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

// The colour map follows the square root of time (drug_overlay.h), and a row says so.
void add_drug(const LegendContent& content, std::vector<LegendRow>& rows) {
    LegendRow ramp;
    const int decimals = decimals_for(content.drug_end_s);
    ramp.text = "Drug arrival (s)";
    ramp.at_right = "now " + fixed_text(std::min(content.drug_time_s, 1e6), decimals);
    for (int c = 0; c < ramp_cells; ++c)
        ramp.colours.push_back(palette::drug((c + 0.5) / ramp_cells));
    for (const double place : {0.0, 0.25, 0.5, 0.75, 1.0})
        ramp.ticks.emplace_back(
            place, fixed_text(content.drug_end_s * place * place, place == 0.0 ? 0 : decimals));
    ramp.marker = std::sqrt(std::clamp(content.drug_time_s / content.drug_end_s, 0.0, 1.0));
    rows.push_back(std::move(ramp));
    LegendRow axis;
    axis.text = "axis: square root of time";
    axis.faint = axis.minor = true;
    rows.push_back(std::move(axis));
    rows.push_back({"The drug's front", {}, {Colour{1.0, 1.0, 1.0}}, {}, {}, false, true});
}

void add_segments(const LegendContent& content, std::vector<LegendRow>& rows) {
    LegendRow bar;
    bar.text = "Liver segment";
    const auto count = static_cast<double>(content.segments.size());
    for (std::size_t s = 0; s < content.segments.size(); ++s) {
        bar.colours.push_back(palette::liver_segment(content.segments[s]));
        bar.ticks.emplace_back((static_cast<double>(s) + 0.5) / count,
                               segment_name(content.segments[s]));
    }
    // A row with one colour shows it as a swatch before the text, so the segment's name goes into
    // the text.
    if (bar.colours.size() == 1) {
        bar.text += " " + bar.ticks[0].second;
        bar.ticks.clear();
    }
    rows.push_back(std::move(bar));
}

void add_warnings(std::vector<LegendRow>& rows) {
    constexpr double from = 0.5;  // share of the limit below which a vessel keeps its own colour
    LegendRow ramp;
    ramp.text = "Load (% of what tears)";
    const Colour own = palette::vessel_system(VascularSystem::unknown);
    for (int c = 0; c < ramp_cells; ++c)
        ramp.colours.push_back(palette::warning(own, from + (1.0 - from) * (c + 0.5) / ramp_cells));
    ramp.ticks = {{0.0, "50"}, {0.5, "75"}, {1.0, "100"}};
    rows.push_back(std::move(ramp));
}

// The ramp follows the stretch's logarithm.
void add_stretch(bool bright, std::vector<LegendRow>& rows) {
    LegendRow ramp;
    ramp.text = "Stretch (length / length at rest)";
    const double all = std::log(palette::largest_stretch);
    for (int c = 0; c < ramp_cells; ++c)
        ramp.colours.push_back(palette::stretch(std::exp(all * (c + 0.5) / ramp_cells), bright));
    for (const double factor : {1.0, 1.2, 1.4, 1.6})
        ramp.ticks.emplace_back(std::log(factor) / all, fixed_text(factor, 1));
    rows.push_back(std::move(ramp));
}

}  // namespace

void set_colours_shown(LegendContent& content, const std::vector<VascularSystem>& systems,
                       const std::vector<std::uint8_t>& segments, const DrugView& drug) {
    // Arrays instead of sets, because this runs for every vertex in every frame while a drug flows.
    std::array<bool, 256> system_shown{}, segment_shown{};
    const auto place = [](VascularSystem system) { return static_cast<std::size_t>(system); };
    const std::size_t arrivals = drug.arrival_s ? drug.arrival_s->size() : 0;
    std::size_t count = std::max(systems.size(), segments.size());
    if (count == 0) count = std::max<std::size_t>(1, arrivals);
    content.reached_before = false;
    for (std::size_t v = 0; v < count; ++v) {
        if (drug.has_reached(v)) continue;
        if (drug.had_reached(v)) {
            content.reached_before = true;
            continue;
        }
        if (v < segments.size() && segments[v] != 0)
            segment_shown[segments[v]] = true;
        else
            system_shown[place(v < systems.size() ? systems[v] : VascularSystem::unknown)] = true;
    }
    content.systems.clear();
    std::ranges::copy_if(vascular_systems, std::back_inserter(content.systems),
                         [&](VascularSystem system) { return system_shown[place(system)]; });
    content.segments.clear();
    for (std::size_t segment = 1; segment < segment_shown.size(); ++segment)
        if (segment_shown[segment]) content.segments.push_back(static_cast<int>(segment));
}

void set_highlights_shown(LegendContent& content, const std::vector<std::uint8_t>& target,
                          const std::vector<std::uint8_t>& highlight, const DrugView& drug) {
    content.target = content.target_lit = content.lit = false;
    for (std::size_t v = 0; v < std::max(target.size(), highlight.size()); ++v) {
        const bool wanted = v < target.size() && target[v] != 0;
        const bool lit = v < highlight.size() && highlight[v] != 0;
        if (!wanted && !lit) continue;
        if (drug.has_reached(v) || drug.had_reached(v)) continue;
        (wanted ? lit ? content.target_lit : content.target : content.lit) = true;
    }
}

void set_frame_shown(LegendContent& content, const Frame& frame, bool warnings,
                     double least_drug_end_s) {
    content.injected = frame.drug.arrival_s != nullptr && frame.drug.end_s > 0.0;
    content.drug_time_s = content.injected ? frame.drug.time_s : 0.0;
    content.drug_end_s = content.injected ? std::max(frame.drug.end_s, least_drug_end_s) : 0.0;
    content.touched = frame.tool.has_value() || frame.grab.has_value();
    content.warned = warnings && frame.tear && frame.tear->loads;
    content.lined = frame.tear && frame.tear->weak_edges;
    content.torn = frame.tear && frame.tear->joints_broken > 0;
    content.bleeds = frame.tear && !frame.tear->leaks.empty() && frame.tear->leaked_g > 0.0;
}

namespace {

std::vector<LegendRow> rows_in_english(const LegendContent& content) {
    std::vector<LegendRow> rows;
    const auto swatch = [&](const std::string& text, const Colour& colour, bool minor = false) {
        rows.push_back({text, {}, {colour}, {}, {}, false, minor});
    };
    const auto needed = [&](const std::string& text, const Colour& colour) {
        swatch(text, colour);
        rows.back().needed = true;
    };
    if (content.tumours) swatch("Tumour", palette::tumour);
    if (content.touched) swatch("Touch and force", palette::touch, true);
    if (content.places) needed("A place of the lesson", palette::torn_circle);
    if (content.places_reached) swatch("A place that is reached", palette::reached, true);
    if (content.target) needed("Target of the drug", palette::drug_target(content.bright));
    const std::size_t steady = rows.size();
    const bool branch = content.lit_branch;
    if (content.target_lit)
        swatch(branch ? "Target, in the chosen branch" : "Target, downstream of the pointer",
               palette::lit_drug_target(content.bright), true);
    if (content.lit && !branch)
        swatch("Downstream of the pointer", palette::highlight(content.bright), true);
    for (std::size_t r = steady; r < rows.size(); ++r) rows[r].passing = !branch;
    if (content.branch_line || (content.lit && branch))
        needed("The chosen branch", palette::chosen_branch(content.bright));
    if (content.gaps) swatch("What may be a vessel, and how sure", palette::bridge, true);
    if (content.lined) swatch("Cut line, not torn yet", palette::weak_line(), true);
    if (content.torn) {
        swatch("Cut or torn", palette::torn);
        swatch("Inside of what is torn", palette::torn_inside, true);
    }
    if (content.bleeds) swatch("Blood (1/10 of the volume)", palette::bleeding);
    if (content.warned) add_warnings(rows);
    if (content.stretched) add_stretch(content.bright, rows);
    if (content.injected) add_drug(content, rows);
    if (content.reached_before)
        swatch("Reached by an earlier injection", palette::reached_before(content.bright));
    if (content.stretched) return rows;
    if (!content.segments.empty()) add_segments(content, rows);
    for (const VascularSystem system : content.systems)
        needed(with_capital(title_of(system)), palette::vessel_system(system, content.bright));
    return rows;
}

}  // namespace

std::vector<LegendRow> legend_rows(const LegendContent& content, const PictureWords& words) {
    std::vector<LegendRow> rows = rows_in_english(content);
    for (LegendRow& row : rows) {
        row.text = said(words, row.text);
        row.at_right = said(words, row.at_right);
        for (auto& [place, number] : row.ticks) number = said(words, number);
    }
    return rows;
}

bool overlap(const PictureBox& a, const PictureBox& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

std::size_t least_covered(const std::vector<int>& vertices_within) {
    return static_cast<std::size_t>(std::ranges::min_element(vertices_within) -
                                    vertices_within.begin());
}

}  // namespace hepatica
