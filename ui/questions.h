// SPDX-License-Identifier: GPL-3.0-or-later
// The questions that keep a patient from being lost, and which series is meant, as dialogs.
#pragma once

#include "ui/patient_keeper.h"
#include "ui/settings.h"

class QWidget;

namespace hepatica {

// Both must outlive what is returned.
PatientKeeper::Questions questions_in_dialogs(QWidget& parent, const Settings& settings);

}  // namespace hepatica
