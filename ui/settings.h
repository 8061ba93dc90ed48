// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that persist between runs. In safe mode they are neither read nor written, so that no
// setting can prevent the program from starting; they then last until the program ends. UI thread
// only.
#pragma once

#include <QByteArray>
#include <QRect>
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
    // In this INI file, for tests.
    explicit Settings(const QString& file);
    ~Settings();

    bool safe() const { return store_ == nullptr; }

    // Absolute paths, the newest first, at most ten.
    QStringList recent_files() const;
    void add_recent_file(const QString& path);
    void remove_recent_file(const QString& path);
    void clear_recent_files();

    QByteArray window_geometry() const;
    QByteArray window_layout() const;
    // Where the window lay if it had no frame, as without a window manager; else invalid.
    QRect unframed_window() const;
    void set_window(const QByteArray& geometry, const QByteArray& layout,
                    const QRect& unframed = {});

    // Place from which the CT with this digest was last read; empty if unknown. Paths often contain
    // patients' names: they are stored here and never in a case. Of images, and of patients below,
    // the 50 are kept that were remembered or asked for last.
    QString place_of_image(const std::string& sha256);
    void remember_image(const std::string& sha256, const QString& path);

    // Places of the masks that a case was made with from the CT with this digest, for the same
    // reason kept here and never in a case. Empty: not known.
    struct MaskPlaces {
        QString liver{}, vessel{};
        QStringList tumours{};
    };
    MaskPlaces places_of_masks(const std::string& image_sha256);
    void remember_masks(const std::string& image_sha256, const MaskPlaces& places);

    // Where the case lay of a patient with this hash (hash_of()) who was recorded; empty where that
    // is not known. A recording names its patient by the hash alone.
    QString place_of_patient(std::uint64_t hash);
    void remember_patient(std::uint64_t hash, const QString& place);

    // Folder of recorded plays: in the user's data folder, in safe mode a temporary one.
    QString recordings_folder() const;
    // File for the unsaved lesson; empty in safe mode.
    QString lesson_draft() const;
    // Folder for copies of unsaved work; empty in safe mode.
    QString recovery_folder() const;

    // Folder of the library; case_folder() if none was chosen.
    QString library_folder() const;
    void set_library_folder(const QString& folder);

    // See theme_named(); empty: none chosen.
    QString theme() const;
    void set_theme(const QString& name);

    // See mouse_scheme_named(); empty: none chosen.
    QString mouse_scheme() const;
    void set_mouse_scheme(const QString& name);

    // See use_language(); empty: the system's language.
    QString language() const;
    void set_language(const QString& code);

    // Computes the steps of plays, see BackEnds; "cpu" by default.
    QString back_end() const;
    void set_back_end(const QString& name);

    // Whether curves appear by themselves: until the user closes them.
    bool curves_come() const;
    void set_curves_come(bool come);
    // Whether plays sound, see PlaySounds; off by default.
    bool sounds() const;
    void set_sounds(bool on);
    // See flow_units_named(); empty: none chosen.
    QString flow_units() const;
    void set_flow_units(const QString& name);

    // Name or number of the trainee; empty: none. Stored here and in the results of attempts made
    // under it.
    QString trainee() const;
    void set_trainee(const QString& name);

    // File of the course chosen last; empty: the built-in one.
    QString course() const;
    void set_course(const QString& file);

    // What vessels touch in free play, as chosen last; nullopt: never chosen.
    std::optional<UseContact> contact() const;
    void set_contact(const UseContact& contact);

    // Whether and how the CT is drawn as a volume; the grey window is not stored.
    bool volume_shown() const;
    void set_volume_shown(bool shown);
    VolumeLook volume_look() const;
    void set_volume_look(const VolumeLook& look);

    // Folder where a case was last opened or saved; by default the user's documents, else his home.
    QString case_folder() const;
    void set_case_folder(const QString& folder);

    // Asks for a file or a folder, beginning where one of this kind was chosen last; at first where
    // anything was. Keeps where the answer lies. Empty: not after all.
    enum class Kind { ct, lesson, course };
    using Ask = std::function<QString(const QString& folder)>;
    QString choose(Kind kind, const Ask& ask);

    // Folder of the last file opened or saved; the home folder at first.
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
    std::map<std::string, QString> images_in_safe_mode_;    // by digest
    std::map<std::string, MaskPlaces> masks_in_safe_mode_;  // by the CT's digest
};

}  // namespace hepatica
