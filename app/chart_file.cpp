// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart_file.h"

#include <charconv>
#include <string>

#include "core/base/atomic_write.h"
#include "core/base/csv_cell.h"
#include "core/base/error.h"
#include "core/base/file_extension.h"
#ifdef HEPATICA_HAS_RENDER
#include "render/offscreen_picture.h"
#endif

namespace hepatica {

namespace {

std::string rows_of(const Chart& chart) {
    std::string text = "curve,x,y\n";
    const auto append = [&](double value) {
        char digits[40];
        text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    };
    for (const Curve& curve : chart.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            text += csv_cell(curve.name) + ",";
            append(curve.x[i]);
            text += ',';
            append(curve.y[i]);
            text += '\n';
        }
    return text;
}

}  // namespace

void require_chart_file(const std::filesystem::path& file) {
    const std::string extension = extension_of(file);
    if (extension == ".csv") return;
    if (extension != ".png")
        throw UsageError("cannot draw a plot as '" + extension + "'", file.string(),
                         "Name a file that ends in .png or .csv");
#ifndef HEPATICA_HAS_RENDER
    throw UsageError("this program was built without pictures", file.string(),
                     "Name a file that ends in .csv");
#endif
}

void write_chart(const std::filesystem::path& file, const Chart& chart) {
    require_chart_file(file);
    if (extension_of(file) == ".csv") {
        write_text_atomically(file, rows_of(chart));
        return;
    }
#ifdef HEPATICA_HAS_RENDER
    write_png(file, draw_chart(chart).picture);
#endif
}

}  // namespace hepatica
