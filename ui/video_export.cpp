// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video_export.h"

#include <QProcess>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/base/atomic_write.h"
#include "core/base/error.h"
#include "core/base/job.h"
#include "core/base/temporary_folder.h"
#include "ui/paths.h"
#include "ui/words.h"

namespace hepatica {

namespace fs = std::filesystem;

namespace {

// Share of the total work; the rest is ffmpeg's.
constexpr double share_of_pictures = 0.9;
constexpr int look_ms = 50;

// Codecs need even widths and heights.
QImage even(const QImage& picture) {
    return picture.copy(0, 0, picture.width() & ~1, picture.height() & ~1)
        .convertToFormat(QImage::Format_RGB32);
}

std::string picture_name(int number) {
    return QString("%1.png").arg(number, 5, 10, QChar('0')).toStdString();
}

void write_pictures(const Film& film, const fs::path& folder, double share,
                    const std::function<bool(double)>& go_on) {
    for (int k = 0; k < film.count(); ++k) {
        if (!go_on(share * k / film.count())) throw Cancelled();
        const fs::path file = folder / picture_name(k);
        if (!even(film.picture(film.at_s(k))).save(to_text(file), "PNG"))
            throw InputError(Words::id("cannot be written"), folder.string(),
                             Words::id("Choose a disk with more room"));
    }
}

void write_folder_of_pictures(const Film& film, const fs::path& place,
                              const std::function<bool(double)>& go_on) {
    const bool stood_there = fs::exists(place);
    if (stood_there && (!fs::is_directory(place) || !fs::is_empty(place)))
        throw InputError(Words::id("is there already, and not empty"), place.string(),
                         Words::id("Give the folder of pictures another name"));
    try {
        write_files_atomically(
            place, [&](const fs::path& folder) { write_pictures(film, folder, 1.0, go_on); });
    } catch (...) {
        std::error_code not_empty;
        if (!stood_there) fs::remove(place, not_empty);
        throw;
    }
}

void encode(const Film& film, const fs::path& pictures, const fs::path& file, const QString& ffmpeg,
            const std::function<bool(double)>& go_on) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    // The folder's name could contain a pattern of ffmpeg.
    process.setWorkingDirectory(to_text(pictures));
    process.start(ffmpeg,
                  {"-y", "-loglevel", "error", "-framerate", QString::number(film.pictures_per_s),
                   "-i", "%05d.png", "-pix_fmt", "yuv420p", to_text(fs::absolute(file))});
    while (!process.waitForFinished(look_ms) && process.state() != QProcess::NotRunning) {
        if (go_on(share_of_pictures)) continue;
        process.kill();
        process.waitForFinished();
        throw Cancelled();
    }
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0 &&
        process.error() != QProcess::FailedToStart)
        return;
    const QString said = QString::fromUtf8(process.readAll()).trimmed().section('\n', -1);
    throw InputError(Words::tr("ffmpeg could not make it: %1")
                         .arg(said.isEmpty() ? process.errorString() : said)
                         .toStdString(),
                     file.filename().string(), Words::id("Save a folder of pictures instead"));
}

}  // namespace

int Film::count() const {
    return 1 + static_cast<int>(std::ceil(end_s * pictures_per_s - 1e-9));
}

QString ffmpeg_program() {
    return QStandardPaths::findExecutable("ffmpeg");
}

void write_film(const Film& film, const fs::path& place, const QString& ffmpeg,
                const std::function<bool(double)>& go_on) {
    if (!to_text(place).endsWith(".mp4", Qt::CaseInsensitive))
        return write_folder_of_pictures(film, place, go_on);
    if (ffmpeg.isEmpty())
        throw InputError(
            Words::id("needs the program ffmpeg, which is not installed"), place.string(),
            Words::id("Install it (apt install ffmpeg), or save a folder of pictures"));
    const TemporaryFolder pictures;
    write_pictures(film, pictures.path(), share_of_pictures, go_on);
    write_file_atomically(
        place, [&](const fs::path& file) { encode(film, pictures.path(), file, ffmpeg, go_on); });
}

}  // namespace hepatica
