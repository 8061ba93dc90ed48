// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a chart to a file that the user named.
#pragma once

#include <filesystem>

#include "render/chart.h"

namespace hepatica {

// By the extension: .png draws the chart, .csv writes its curves. Throws UsageError for any other
// extension, and for .png in a build without pictures; InputError where the file cannot be written.
void write_chart(const std::filesystem::path& file, const Chart& chart);

// Throws the same UsageErrors, before any work is done.
void require_chart_file(const std::filesystem::path& file);

}  // namespace hepatica
