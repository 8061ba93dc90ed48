// SPDX-License-Identifier: GPL-3.0-or-later
// What was learned on synthetic patients about which lines are vessels, as a small file.
#pragma once

#include <filesystem>
#include <string>

#include "core/links/piece_forest.h"

namespace hepatica {

struct LinkModel {
    std::string made_by;       // the command that makes the same file again
    double line_share = 0.75;  // how permissive the lines are that it chooses from (0.3 to 1.5);
                               // see DetectionOptions
    double kept_share = 0.6;   // pieces of which at least this share should be vessel are kept
    PieceForest forest;
};

// JSON: {"format": "hepatica-links", "version": 1, "made_by", "line_share", "kept_share",
// "features": [names], "trees": [[[feature, threshold, up_to, above] or [share], ...], ...]}.
// Throws InputError, naming the file and what is wrong with it.
LinkModel read_link_model(const std::filesystem::path& file);

// Appears whole or not at all. Throws InputError where it cannot be written.
void write_link_model(const std::filesystem::path& file, const LinkModel& model);

}  // namespace hepatica
