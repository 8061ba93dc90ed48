// SPDX-License-Identifier: GPL-3.0-or-later
// A chart as a file that a verb was asked for.
#pragma once

#include <filesystem>

#include "render/chart.h"

namespace hepatica {

// By the extension: .png draws the chart, .csv writes its curves. Throws UsageError for any other,
// and for .png where the program was built without pictures; InputError where it cannot be written.
void write_chart(const std::filesystem::path& file, const Chart& chart);

// The same refusals, before any work is done.
void require_chart_file(const std::filesystem::path& file);

}  // namespace hepatica
