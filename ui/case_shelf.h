// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of the library: for each case of a folder a drawing of the vessels, facts and doubts,
// lessons and attempts. No widgets; made on a worker thread.
#pragma once

#include <QImage>
#include <QString>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/tree/vessel_tree.h"
#include "ui/shelved_lessons.h"

namespace hepatica {

struct ShelvedCase {
    std::filesystem::path place;
    QString name;    // of the file, without its extension
    QImage drawing;  // null if the case cannot be read
    QString facts;   // HTML: lengths, systems, doubts, attempts; or why it cannot be read
    bool readable = false;
    std::vector<ShelvedLesson> lessons{};  // that go with it, see lessons_of()
};

// The vessels from the front in the colours of their systems and to scale, on a transparent ground.
QImage drawing_of(const VesselTree& tree, const QSize& size);

// The cases directly in `folder`, by name; unreadable ones tell why. Reads no voxels; a case takes
// 0.1 s, at most 1 s. `recordings` is the folder of the user's plays. One stage of `job`. Throws
// InputError if the folder cannot be read, and Cancelled.
std::vector<ShelvedCase> cases_in(const std::filesystem::path& folder,
                                  const std::filesystem::path& recordings, Job& job);

}  // namespace hepatica
