// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a report's page as PDF: pictures as wide as the text, no heading alone at the foot of a
// page.
#pragma once

#include <filesystem>
#include <string>

namespace hepatica {

// Writes a page's HTML, whose pictures are in the folder, as PDF. Needs a QGuiApplication.
void print_pdf(const std::string& html, const std::filesystem::path& folder,
               const std::filesystem::path& file);

}  // namespace hepatica
