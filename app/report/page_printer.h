// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a report's page as PDF: pictures as wide as the text, no heading alone at the foot of a
// page, and every picture on one page with its caption.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hepatica {

// Writes a page's HTML, whose pictures are in the folder, as PDF, atomically. Needs a
// QGuiApplication. Throws InputError where it cannot be written.
void print_pdf(const std::string& html, const std::filesystem::path& folder,
               const std::filesystem::path& file);

// On which pages, from 0, each picture and the end of its caption come to lie in such a PDF.
struct PicturePages {
    int picture = 0, caption = 0;
};
std::vector<PicturePages> pages_of_pictures(const std::string& html,
                                            const std::filesystem::path& folder);

}  // namespace hepatica
