// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the three-dimensional view's legend: only what is shown at the moment is explained.
// Depends on no toolkit; legend.h draws them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/vascular_system.h"
#include "core/scene/frame.h"
#include "render/palette.h"
#include "render/picture_words.h"

namespace hepatica {

// Everything that the legend depends on.
struct LegendContent {
    std::vector<VascularSystem>
        systems;                // systems whose colour is visible, ordered as vascular_systems
    std::vector<int> segments;  // liver segments whose colour is visible, ascending
    bool injected = false;
    bool reached_before = false;  // what an injection before has reached is visible
    double drug_time_s = 0.0, drug_end_s = 0.0;
    bool touched = false;    // a tool is in use, or a vessel is pulled
    bool stretched = false;  // they have the colours of their stretch instead of their systems'
    bool warned = false;     // vessels near their limit are coloured
    bool torn = false;
    bool lined = false;  // a cut line holds still
    bool bleeds = false;
    bool gaps = false;    // gaps that might be bridged, or branches that might be vessels
    bool places = false;  // places of a lesson that are not reached yet
    bool places_reached = false;
    bool tumours = false;
    bool target = false;       // of the drug, where nothing else covers it
    bool target_lit = false;   // the part of it that is highlighted
    bool lit = false;          // vessels beside the target are highlighted
    bool lit_branch = false;   // the highlight is a chosen branch, not what the pointer is on
    bool branch_line = false;  // the line of a chosen branch is drawn
    bool bright = false;       // systems have their bright colours
    bool operator==(const LegendContent&) const = default;
};

// Finds the systems and segments whose colours TreeActor shows. A vertex without a system counts as
// unknown. Vertices that the drug has reached, or did in an injection before, show the colour of
// that instead and do not count.
void set_colours_shown(LegendContent& content, const std::vector<VascularSystem>& systems,
                       const std::vector<std::uint8_t>& segments, const DrugView& drug = {});
// Finds whether the colours of the drug's target and of the highlight are visible; both as
// TreeActor has them. What the drug reached has other colours, as above.
void set_highlights_shown(LegendContent& content, const std::vector<std::uint8_t>& target,
                          const std::vector<std::uint8_t>& highlight, const DrugView& drug = {});
// Takes drug, tool, pull and tear from the frame. The drug's scale ends at `least_drug_end_s` or
// later.
void set_frame_shown(LegendContent& content, const Frame& frame, bool warnings,
                     double least_drug_end_s = 0.0);

// One row. A single colour is a swatch before the text; several colours are a bar below it.
struct LegendRow {
    std::string text;
    std::string at_right;  // right-aligned in the same line
    std::vector<Colour> colours;
    std::vector<std::pair<double, std::string>>
        ticks;                     // labels below the bar: position in [0, 1] along it
    std::optional<double> marker;  // position of the marker across the bar, in [0, 1]
    bool faint = false;            // an explanation of the row above it
    bool minor = false;            // left out first where the picture has no room
    bool passing = false;          // comes and goes with the pointer
    std::vector<std::pair<Colour, std::string>> beside = {};  // more swatches in the same line
    bool needed = false;  // left out last: without it the picture cannot be read
};

// The rows from top to bottom. The drug's colours come before the colours of systems and segments.
std::vector<LegendRow> legend_rows(const LegendContent& content, const PictureWords& words = {});

// A rectangle of the picture in device pixels, y upwards.
struct PictureBox {
    double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
};
// True if the interiors of the two rectangles intersect.
bool overlap(const PictureBox& a, const PictureBox& b);

// Index of the legend's corner: the first that covers the fewest vertices. At least one value is
// required.
std::size_t least_covered(const std::vector<int>& vertices_within);

}  // namespace hepatica
