// SPDX-License-Identifier: GPL-3.0-or-later
// A picture in memory, read from a render window, and written to and read from PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

class vtkRenderWindow;

namespace hepatica {

// Largest width and height of a picture in pixels.
inline constexpr int largest_picture_px = 16384;

// Red, green, blue, 8 bits each; rows from the top, no padding.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

// The result of the window's last Render(); its context must be current.
Picture read_picture(vtkRenderWindow& window);

// Writes atomically. Throws InputError, naming the file, where it cannot be written.
void write_png(const std::filesystem::path& file, const Picture& picture);
// Throws InputError, naming the file, where it is missing or not a PNG of 8-bit RGB.
Picture read_png(const std::filesystem::path& file);

}  // namespace hepatica
