// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a report's page as PDF: no heading alone at the foot of a page, every picture on one page
// with its caption, and pictures narrower than the text where that leaves less of a page white.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hepatica {

// Writes a page's HTML, whose pictures are in the folder, as PDF, atomically. Needs a
// QGuiApplication. Throws InputError where it cannot be written.
void print_pdf(const std::string& html, const std::filesystem::path& folder,
               const std::filesystem::path& file);

// How such a PDF comes out.
struct PrintedPages {
    // On which pages, from 0, each picture and the end of its caption lie.
    struct OfPicture {
        int picture = 0, caption = 0;
    };
    std::vector<OfPicture> pictures;
    // The largest share of a page but the last that is white at its foot.
    double largest_white = 0.0;
};
PrintedPages printed_pages(const std::string& html, const std::filesystem::path& folder);

}  // namespace hepatica
