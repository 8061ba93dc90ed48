// SPDX-License-Identifier: GPL-3.0-or-later
// Writes equally spaced pictures as a film: an MP4 file by the program ffmpeg, or a folder of
// numbered PNG files.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>

namespace hepatica {

struct Film {
    double end_s = 0.0;  // time of the last picture, at least; the first is at 0
    double pictures_per_s = 25.0;
    std::function<QImage(double at_s)> picture;

    // Number of pictures.
    int count() const;
    double at_s(int number) const { return number / pictures_per_s; }
};

// Path of the program; empty if it is not installed.
QString ffmpeg_program();

// NAME.mp4 is made by `ffmpeg`; any other place is a folder that gets 00000.png, 00001.png, ... and
// is new or empty. Nothing remains on failure. `go_on` is called with the share done
// before every picture and repeatedly while ffmpeg runs; if it returns false, Cancelled is thrown.
// Throws InputError if the place cannot be written, if ffmpeg is needed but missing, or if it fails
// (with its last message).
void write_film(const Film& film, const std::filesystem::path& place, const QString& ffmpeg,
                const std::function<bool(double share)>& go_on);

}  // namespace hepatica
