// SPDX-License-Identifier: GPL-3.0-or-later
// The questions that keep a patient and a lesson from being lost, which series is meant, and where
// a CT lies, as dialogs.
#pragma once

#include <filesystem>
#include <optional>

#include "ui/lesson_editor/lesson_editor.h"
#include "ui/patient_keeper.h"
#include "ui/settings.h"

class QWidget;

namespace hepatica {

// Both must outlive what is returned.
PatientKeeper::Questions questions_in_dialogs(QWidget& parent, const Settings& settings);

// The folder of a DICOM series or a file, as the person says: no dialog of the desktop takes both.
// None: not after all.
std::optional<std::filesystem::path> ask_where_ct_lies(QWidget& parent, Settings& settings);

// What went wrong in a window of its own: before it, where it is seen. Returns at once.
void tell_failure(QWidget& window, const QString& doing, const Failure& failure);

// About a lesson of that name; `kept`: a copy of it is on disk, so that it may be left for later.
UnsavedLesson ask_unsaved_lesson(QWidget& parent, const std::string& name, bool kept);

}  // namespace hepatica
