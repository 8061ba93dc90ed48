// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of a folder as a library shows them: a drawing of each patient's vessels from the
// front, what is known and doubted of him, which lessons go with him and how they went. No widgets:
// made on a worker.
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
    QString name;    // of the file, without its ending
    QImage drawing;  // null where the case cannot be read
    QString facts;   // HTML: lengths, systems, doubts, attempts; or why it cannot be read
    bool readable = false;
    std::vector<ShelvedLesson> lessons{};  // that go with it, see lessons_of()
};

// The vessels from the front, each as wide as it is and in its system's colour, on a clear ground.
QImage drawing_of(const VesselTree& tree, const QSize& size);

// Those in the folder itself, by name. What cannot be read says why. Reads no voxels; a case takes
// a tenth of a second, at most a second. `recordings`: where this user's plays lie. Begins one
// stage; throws InputError where the folder cannot be read, Cancelled.
std::vector<ShelvedCase> cases_in(const std::filesystem::path& folder,
                                  const std::filesystem::path& recordings, Job& job);

}  // namespace hepatica
