// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures at even spacing in time as a film: one MP4 file where the program ffmpeg is installed,
// or a folder of numbered PNG files, from which any such program makes one.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>

namespace hepatica {

struct Film {
    double end_s = 0.0;  // of the last picture, at least; the first is at 0
    double pictures_per_s = 25.0;
    std::function<QImage(double at_s)> picture;

    int count() const;
    double at_s(int number) const { return number / pictures_per_s; }
};

// Where the program is; empty where it is not installed.
QString ffmpeg_program();

// NAME.mp4 is made by `ffmpeg`; any other place is a folder, which gets 00000.png, 00001.png, ...
// A folder that holds such pictures already is refused. All of the film or nothing of it. `go_on`
// is asked before every picture, with how much is done, and for as long as ffmpeg runs; where it
// says no, Cancelled is thrown. Throws InputError where the place cannot be written, there is no
// ffmpeg for a file, or it fails (with the last thing it said).
void write_film(const Film& film, const std::filesystem::path& place, const QString& ffmpeg,
                const std::function<bool(double share)>& go_on);

}  // namespace hepatica
