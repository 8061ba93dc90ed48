// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/time_of_play.h"

#include "core/lesson/attempts.h"
#include "core/session/recording_file.h"
#include "ui/date_words.h"
#include "ui/words.h"

namespace hepatica {

QDateTime time_of_play(const std::filesystem::path& recording) {
    const std::string in_header = played_at_in(recording);
    const std::string utc = in_header.empty() ? ended_at_beside(recording) : in_header;
    return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
}

QString words_on_time_of_play(const std::filesystem::path& recording) {
    const QDateTime played = time_of_play(recording);
    return played.isValid() ? date_words(played) : Words::tr("date unknown");
}

}  // namespace hepatica
