// SPDX-License-Identifier: GPL-3.0-or-later
// When a recorded play took place. A file's own time is no answer: it changes with every copy.
#pragma once

#include <QDateTime>
#include <QString>
#include <filesystem>

namespace hepatica {

// Local time. As the recording's header says; of older recordings, when the result beside it says
// that the play ended. Invalid where neither tells, or nothing can be read.
QDateTime time_of_play(const std::filesystem::path& recording);

// Date and time of that, or that it is not known.
QString words_on_time_of_play(const std::filesystem::path& recording);

}  // namespace hepatica
