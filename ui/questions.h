// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs that ask about unsaved patients and lessons, the series of a CT, and the place of a CT.
// UI thread only.
#pragma once

#include <filesystem>
#include <optional>

#include "ui/lesson_editor/lesson_editor.h"
#include "ui/patient_keeper.h"
#include "ui/settings.h"

class QWidget;

namespace hepatica {

// `parent` and `settings` must outlive the result.
PatientKeeper::Questions questions_in_dialogs(QWidget& parent, const Settings& settings);

// Folder of a DICOM series or a volume file; asks for the kind first, because no native dialog
// offers both. nullopt: cancelled.
std::optional<std::filesystem::path> ask_where_ct_lies(QWidget& parent, Settings& settings);

// Whether a file may be written that names the patient as the CT does.
bool ask_export_with_name(QWidget& parent);

// The window that a question or message about `own` must have as its parent: `own`, or `window`
// while that is hidden. The keys go back to the parent.
QWidget& shown_of(QWidget& own, QWidget& window);

// Shows a failure in a message box in front of `window`. Returns at once.
void tell_failure(QWidget& window, const QString& doing, const Failure& failure);

// Asks about the unsaved lesson `name`; `kept`: a copy is on disk, so that it may be left for
// later.
UnsavedLesson ask_unsaved_lesson(QWidget& parent, const std::string& name, bool kept);

}  // namespace hepatica
