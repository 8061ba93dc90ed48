// SPDX-License-Identifier: GPL-3.0-or-later
// A model, learned on synthetic patients, of which lines are vessels, and its file.
#pragma once

#include <filesystem>
#include <string>

#include "core/links/piece_forest.h"

namespace hepatica {

struct LinkModel {
    std::string made_by;       // the command that makes the same file
    double line_share = 0.75;  // line_share (0.3 to 1.5) of the candidate lines, see
                               // DetectionOptions
    double kept_share = 0.6;   // pieces are kept from about this share of vessel on, 0 to 1
    PieceForest forest;
};

// JSON: {"format": "hepatica-links", "version": 1, "made_by", "line_share", "kept_share",
// "features": [names], "trees": [[[feature, threshold, up_to, above] or [share], ...], ...]}.
// Throws InputError, naming the file and what is wrong with it.
LinkModel read_link_model(const std::filesystem::path& file);

// The file that comes with the program. Throws InputError where it is missing.
std::filesystem::path shipped_link_model();

// Writes the file atomically. Throws InputError where it cannot be written.
void write_link_model(const std::filesystem::path& file, const LinkModel& model);

}  // namespace hepatica
