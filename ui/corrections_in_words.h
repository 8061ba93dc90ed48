// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections, and what is offered to be one, in words for lists and menus: what was done, where,
// and to which vascular system. UI thread only.
#pragma once

#include <QString>
#include <QStringList>

#include "core/tree/extraction/gap_bridging.h"
#include "ui/workspace.h"

namespace hepatica {

inline constexpr double beside_wall_mm = 2.0;  // a place this close to a wall is the vessel's

bool gives_system(const TreeEdit& edit);

// "Branch deleted at L 12  P 40  H 155 mm (portal vein)". The place of a vessel that was taken away
// has the system that the vessel had.
QString text_of(const Workspace::Step& step, const PatientCase& patient);
// "63 %, gap of 4.1 mm".
QString text_of(const Bridge& bridge);

// All corrections of the patient who is open, in chronological order.
QStringList lines_of_history(const Workspace& workspace);

}  // namespace hepatica
