// SPDX-License-Identifier: GPL-3.0-or-later
// What the window remembers from one start to the next. In safe mode it neither reads nor writes,
// so that no setting can keep the program from starting: what is remembered then ends with the
// program.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/session/command.h"
#include "render/volume_look.h"

class QSettings;

namespace hepatica {

class Settings {
  public:
    enum class Mode { remember, safe };

    explicit Settings(Mode mode);
    // In a file of its own, for tests.
    explicit Settings(const QString& file);
    ~Settings();

    bool safe() const { return store_ == nullptr; }

    // Newest first, ten at most. Absolute paths, whatever was given.
    QStringList recent_files() const;
    void add_recent_file(const QString& path);
    void remove_recent_file(const QString& path);
    void clear_recent_files();

    QByteArray window_geometry() const;
    QByteArray window_layout() const;
    void set_window(const QByteArray& geometry, const QByteArray& layout);

    // Where the CT with this digest lay when it was last read; empty where that is not known.
    // Paths name patients often: they stay here, and are never written into a case.
    QString place_of_image(const std::string& sha256) const;
    void remember_image(const std::string& sha256, const QString& path);

    // Where the case lay of a patient with this hash (hash_of()) who was recorded; empty where that
    // is not known. A recording names its patient by the hash alone.
    QString place_of_patient(std::uint64_t hash) const;
    void remember_patient(std::uint64_t hash, const QString& place);

    // Where plays of lessons are kept: with the user's data, in safe mode with what is temporary.
    QString recordings_folder() const;
    // Where a lesson that is not saved yet is kept; empty in safe mode, which keeps none.
    QString lesson_draft() const;
    // Where copies of unsaved work are kept; empty in safe mode, which keeps none.
    QString recovery_folder() const;

    // Where the library looks for cases; the last folder as long as none was chosen.
    QString library_folder() const;
    void set_library_folder(const QString& folder);

    // See theme_named(); empty: none was chosen.
    QString theme() const;
    void set_theme(const QString& name);

    // See mouse_scheme_named(); empty: none was chosen.
    QString mouse_scheme() const;
    void set_mouse_scheme(const QString& name);

    // See use_language(); empty: the system's.
    QString language() const;
    void set_language(const QString& code);

    // What makes the steps of plays, see BackEnds; at first the processor.
    QString back_end() const;
    void set_back_end(const QString& name);

    // The curves come by themselves: the user has not closed them since they asked for them last.
    bool curves_come() const;
    void set_curves_come(bool come);
    // See flow_units_named(); empty: none was chosen.
    QString flow_units() const;
    void set_flow_units(const QString& name);

    // The name or number that a trainee gave for his attempts; empty: none. Stays here and in the
    // results of the attempts that he made under it.
    QString trainee() const;
    void set_trainee(const QString& name);

    // The file of the course that was chosen last; empty: the program's own.
    QString course() const;
    void set_course(const QString& file);

    // What vessels touch in free play, as it was chosen last; none: never chosen.
    std::optional<UseContact> contact() const;
    void set_contact(const UseContact& contact);

    // Whether the CT is drawn as a volume, and how; the grey window is not kept.
    bool volume_shown() const;
    void set_volume_shown(bool shown);
    VolumeLook volume_look() const;
    void set_volume_look(const VolumeLook& look);

    // Where a case was opened or saved last; at first where the user's documents are.
    QString case_folder() const;
    void set_case_folder(const QString& folder);

    // Asks for a file or a folder, beginning where one of this kind was chosen last; at first where
    // anything was. Keeps where the answer lies. Empty: not after all.
    enum class Kind { ct, lesson, course };
    using Ask = std::function<QString(const QString& folder)>;
    QString choose(Kind kind, const Ask& ask);

    QString last_folder() const;
    void set_last_folder(const QString& folder);

  private:
    QString data_folder() const;
    void set_recent_files(const QStringList& files);

    std::unique_ptr<QSettings> store_;  // null in safe mode
    QStringList recent_in_safe_mode_;
    QString folder_in_safe_mode_, case_folder_in_safe_mode_;
    std::map<Kind, QString> folders_in_safe_mode_;
    std::map<std::uint64_t, QString> patients_in_safe_mode_;
    std::map<std::string, QString> images_in_safe_mode_;  // by their digests
};

}  // namespace hepatica
