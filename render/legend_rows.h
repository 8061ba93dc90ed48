// SPDX-License-Identifier: GPL-3.0-or-later
// What the legend of the three-dimensional view says: of what is shown just now, and of nothing
// else. No toolkit; where it stands and how it is drawn is for legend.h.
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
    std::vector<VascularSystem> systems;  // of the vessels in their system's colour, as
                                          // vascular_systems orders them
    std::vector<int> segments;            // of the liver, whose colours are shown, ascending
    bool injected = false;
    double drug_time_s = 0.0, drug_end_s = 0.0;
    bool touched = false;  // a tool is in hand, or a vessel is pulled
    bool warned = false;   // what is near its limit is coloured
    bool torn = false;
    bool bleeds = false;
    bool gaps = false;    // that might be bridged
    bool places = false;  // of a lesson
    bool tumours = false;
    bool operator==(const LegendContent&) const = default;
};

// The systems and segments among vertices as TreeActor colours them; vertices of which no system is
// given are of an unknown one. Where the drug has come it covers them: what it has covered wholly
// is not shown.
void set_colours_shown(LegendContent& content, const std::vector<VascularSystem>& systems,
                       const std::vector<std::uint8_t>& segments, const DrugView& drug = {});
// What the frame adds: drug, tool, pull, tear. The drug's scale ends at `least_drug_end_s` or
// later.
void set_frame_shown(LegendContent& content, const Frame& frame, bool warnings,
                     double least_drug_end_s = 0.0);

// One entry. With one colour that stands before the text; with several they are a bar below it.
struct LegendRow {
    std::string text;
    std::string at_right;  // at the end of the same line
    std::vector<Colour> colours;
    std::vector<std::pair<double, std::string>> ticks;  // below the bar: place in [0, 1] along it
    std::optional<double> marker;                       // likewise, across it
    bool faint = false;                                 // an explanation of the row above
};

// From top to bottom. The drug's colours stand above those that it has not covered.
std::vector<LegendRow> legend_rows(const LegendContent& content, const PictureWords& words = {});

// A rectangle of the picture in device pixels, y upwards.
struct PictureBox {
    double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
};
bool overlap(const PictureBox& a, const PictureBox& b);

// The place of the legend: the first of them that holds no vertex of a vessel, or else the one
// that holds the fewest.
std::size_t least_covered(const std::vector<int>& vertices_within);

}  // namespace hepatica
