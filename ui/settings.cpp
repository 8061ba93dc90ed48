// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/scene_spec.h"

namespace hepatica {
namespace {

constexpr int most_recent_files = 10;
const char* const recent_key = "recent_files";
// Version of the layout: a state saved with other docks is not restored.
const char* const layout_key = "window/layout_1";
const char* const geometry_key = "window/geometry";
const char* const unframed_key = "window/unframed";
const char* const images_key = "images";
const char* const liver_masks_key = "liver_masks";
const char* const vessel_masks_key = "vessel_masks";
const char* const tumour_masks_key = "tumour_masks";
const char* const folder_key = "last_folder";
const char* const patients_key = "patients";
const char* const theme_key = "theme";
const char* const mouse_scheme_key = "mouse_scheme";
const char* const language_key = "language";
const char* const back_end_key = "back_end";
const char* const curves_come_key = "curves_come";
const char* const sounds_key = "sounds";
const char* const flow_units_key = "flow_units";
const char* const trainee_key = "trainee";
const char* const volume_key = "volume/shown";
const char* const volume_preset_key = "volume/preset";
const char* const volume_density_key = "volume/density";
const char* const library_key = "library_folder";
const char* const course_key = "course";
const char* const case_folder_key = "case_folder";
const char* const self_contact_key = "contact/vessels";
const char* const obstacles_key = "contact/obstacles";
const char* const friction_key = "contact/friction";
constexpr QChar place_separator = u'\n';  // of several in one value
constexpr qsizetype most_places = 50;     // of each group

// Places by key in a group of the settings. Beside the group lies a list of its keys, those used
// last first. Keys that it lacks are of an older program, or of one that ran at the same time, and
// count as the oldest.
void use_place(QSettings& store, const QString& group, const QString& key) {
    const QString list = group + "_used";
    QStringList used = store.value(list).toStringList();
    if (!used.isEmpty() && used.front() == key) return;
    used.removeAll(key);
    used.prepend(key);
    store.beginGroup(group);
    for (const QString& other : store.childKeys())
        if (!used.contains(other)) used.append(other);
    for (const QString& oldest : used.mid(most_places)) store.remove(oldest);
    store.endGroup();
    store.setValue(list, used.mid(0, most_places));
}

QString place_in(QSettings& store, const QString& group, const QString& key) {
    QString place = store.value(group + "/" + key).toString();
    if (!place.isEmpty()) use_place(store, group, key);
    return place;
}

void remember_in(QSettings& store, const QString& group, const QString& key, const QString& place) {
    store.setValue(group + "/" + key, place);
    use_place(store, group, key);
}

}  // namespace

Settings::Settings(Mode mode) {
    if (mode == Mode::remember) store_ = std::make_unique<QSettings>("Hepatica", "Hepatica");
}

Settings::Settings(const QString& file)
    : store_(std::make_unique<QSettings>(file, QSettings::IniFormat)) {}

Settings::~Settings() = default;

QStringList Settings::recent_files() const {
    return store_ ? store_->value(recent_key).toStringList() : recent_in_safe_mode_;
}

void Settings::add_recent_file(const QString& path) {
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    QStringList files = recent_files();
    files.removeAll(absolute);
    files.prepend(absolute);
    set_recent_files(files.mid(0, most_recent_files));
}

void Settings::remove_recent_file(const QString& path) {
    QStringList files = recent_files();
    files.removeAll(path);
    set_recent_files(files);
}

void Settings::set_recent_files(const QStringList& files) {
    if (store_) {
        store_->setValue(recent_key, files);
    } else {
        recent_in_safe_mode_ = files;
    }
}

void Settings::clear_recent_files() {
    recent_in_safe_mode_.clear();
    if (store_) store_->remove(recent_key);
}

QByteArray Settings::window_geometry() const {
    return store_ ? store_->value(geometry_key).toByteArray() : QByteArray();
}

QByteArray Settings::window_layout() const {
    return store_ ? store_->value(layout_key).toByteArray() : QByteArray();
}

QRect Settings::unframed_window() const {
    return store_ ? store_->value(unframed_key).toRect() : QRect();
}

void Settings::set_window(const QByteArray& geometry, const QByteArray& layout,
                          const QRect& unframed) {
    if (!store_) return;
    store_->setValue(geometry_key, geometry);
    store_->setValue(layout_key, layout);
    store_->setValue(unframed_key, unframed);
}

QString Settings::place_of_image(const std::string& sha256) {
    if (sha256.empty()) return {};
    if (store_) return place_in(*store_, images_key, QString::fromStdString(sha256));
    const auto found = images_in_safe_mode_.find(sha256);
    return found == images_in_safe_mode_.end() ? QString() : found->second;
}

void Settings::remember_image(const std::string& sha256, const QString& path) {
    if (sha256.empty()) return;
    const QString place = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    if (store_)
        remember_in(*store_, images_key, QString::fromStdString(sha256), place);
    else
        images_in_safe_mode_[sha256] = place;
}

Settings::MaskPlaces Settings::places_of_masks(const std::string& image_sha256) {
    if (image_sha256.empty()) return {};
    if (!store_) {
        const auto found = masks_in_safe_mode_.find(image_sha256);
        return found == masks_in_safe_mode_.end() ? MaskPlaces{} : found->second;
    }
    const QString key = QString::fromStdString(image_sha256);
    return {place_in(*store_, liver_masks_key, key), place_in(*store_, vessel_masks_key, key),
            place_in(*store_, tumour_masks_key, key).split(place_separator, Qt::SkipEmptyParts)};
}

void Settings::remember_masks(const std::string& image_sha256, const MaskPlaces& places) {
    if (image_sha256.empty()) return;
    if (!store_) {
        masks_in_safe_mode_[image_sha256] = places;
        return;
    }
    const QString key = QString::fromStdString(image_sha256);
    for (const auto& [group, place] :
         {std::pair(liver_masks_key, places.liver), std::pair(vessel_masks_key, places.vessel),
          std::pair(tumour_masks_key, places.tumours.join(place_separator))})
        if (!place.isEmpty()) remember_in(*store_, group, key, place);
}

QString Settings::recordings_folder() const {
    if (!store_) return QDir::tempPath() + "/hepatica-recordings";
    return data_folder() + "/recordings";
}

QString Settings::lesson_draft() const {
    return store_ ? data_folder() + "/unsaved-lesson.json" : QString();
}

QString Settings::recovery_folder() const {
    return store_ ? data_folder() + "/recovery" : QString();
}

QString Settings::data_folder() const {
    if (store_->format() == QSettings::IniFormat)  // its own file, see the constructor
        return QFileInfo(store_->fileName()).absolutePath();
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
}

QString Settings::theme() const {
    return store_ ? store_->value(theme_key).toString() : QString();
}

void Settings::set_theme(const QString& name) {
    if (store_) store_->setValue(theme_key, name);
}

QString Settings::mouse_scheme() const {
    return store_ ? store_->value(mouse_scheme_key).toString() : QString();
}

void Settings::set_mouse_scheme(const QString& name) {
    if (store_) store_->setValue(mouse_scheme_key, name);
}

QString Settings::language() const {
    return store_ ? store_->value(language_key).toString() : QString();
}

void Settings::set_language(const QString& code) {
    if (store_) store_->setValue(language_key, code);
}

QString Settings::back_end() const {
    return store_ ? store_->value(back_end_key, "cpu").toString() : QString("cpu");
}

void Settings::set_back_end(const QString& name) {
    if (store_) store_->setValue(back_end_key, name);
}

bool Settings::curves_come() const {
    return !store_ || store_->value(curves_come_key, true).toBool();
}

void Settings::set_curves_come(bool come) {
    if (store_) store_->setValue(curves_come_key, come);
}

bool Settings::sounds() const {
    return store_ && store_->value(sounds_key, false).toBool();
}

void Settings::set_sounds(bool on) {
    if (store_) store_->setValue(sounds_key, on);
}

QString Settings::flow_units() const {
    return store_ ? store_->value(flow_units_key).toString() : QString();
}

void Settings::set_flow_units(const QString& name) {
    if (store_) store_->setValue(flow_units_key, name);
}

QString Settings::trainee() const {
    return store_ ? store_->value(trainee_key).toString() : QString();
}

void Settings::set_trainee(const QString& name) {
    if (!store_) return;
    name.isEmpty() ? store_->remove(trainee_key) : store_->setValue(trainee_key, name);
}

QString Settings::course() const {
    return store_ ? store_->value(course_key).toString() : QString();
}

void Settings::set_course(const QString& file) {
    if (!store_) return;
    file.isEmpty() ? store_->remove(course_key) : store_->setValue(course_key, file);
}

// The file may hold invalid values.
std::optional<UseContact> Settings::contact() const {
    if (!store_ || !store_->contains(self_contact_key)) return std::nullopt;
    UseContact contact{store_->value(self_contact_key).toBool(),
                       store_->value(obstacles_key).toBool(), 0.0};
    const double friction = store_->value(friction_key).toDouble();
    if (std::isfinite(friction)) contact.friction = std::clamp(friction, 0.0, greatest_friction);
    return contact;
}

void Settings::set_contact(const UseContact& contact) {
    if (!store_) return;
    store_->setValue(self_contact_key, contact.self);
    store_->setValue(obstacles_key, contact.obstacles);
    store_->setValue(friction_key, contact.friction);
}

bool Settings::volume_shown() const {
    return store_ && store_->value(volume_key, false).toBool();
}

void Settings::set_volume_shown(bool shown) {
    if (store_) store_->setValue(volume_key, shown);
}

// The file may hold invalid values.
VolumeLook Settings::volume_look() const {
    VolumeLook look;
    if (!store_) return look;
    const std::string preset = store_->value(volume_preset_key).toString().toStdString();
    look.preset = volume_preset_named(preset).value_or(look.preset);
    const double density = store_->value(volume_density_key, look.density).toDouble();
    if (std::isfinite(density)) look.density = std::clamp(density, 0.0, 1.0);
    return look;
}

void Settings::set_volume_look(const VolumeLook& look) {
    if (!store_) return;
    const std::string_view preset = name_of(look.preset);
    store_->setValue(volume_preset_key,
                     QString::fromLatin1(preset.data(), static_cast<qsizetype>(preset.size())));
    store_->setValue(volume_density_key, look.density);
}

QString Settings::library_folder() const {
    return store_ ? store_->value(library_key, case_folder()).toString() : case_folder();
}

void Settings::set_library_folder(const QString& folder) {
    if (store_) store_->setValue(library_key, folder);
}

QString Settings::case_folder() const {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString kept =
        store_ ? store_->value(case_folder_key).toString() : case_folder_in_safe_mode_;
    return QFileInfo(kept).isDir()        ? kept
           : QFileInfo(documents).isDir() ? documents
                                          : QDir::homePath();
}

void Settings::set_case_folder(const QString& folder) {
    store_ ? store_->setValue(case_folder_key, folder) : void(case_folder_in_safe_mode_ = folder);
}

QString Settings::place_of_patient(std::uint64_t hash) {
    if (store_) return place_in(*store_, patients_key, QString::number(hash, 16));
    const auto found = patients_in_safe_mode_.find(hash);
    return found == patients_in_safe_mode_.end() ? QString() : found->second;
}

void Settings::remember_patient(std::uint64_t hash, const QString& place) {
    if (store_)
        remember_in(*store_, patients_key, QString::number(hash, 16), place);
    else
        patients_in_safe_mode_[hash] = place;
}

QString Settings::choose(Kind kind, const Ask& ask) {
    constexpr std::array names{"ct", "lesson", "course"};
    const QString key = QString("folders/") + names[static_cast<std::size_t>(kind)];
    const QString kept = store_ ? store_->value(key).toString() : folders_in_safe_mode_[kind];
    const QString chosen = ask(QFileInfo(kept).isDir() ? kept : last_folder());
    if (chosen.isEmpty()) return chosen;
    const QString folder = QFileInfo(chosen).absolutePath();
    store_ ? store_->setValue(key, folder) : void(folders_in_safe_mode_[kind] = folder);
    return chosen;
}

QString Settings::last_folder() const {
    if (store_) return store_->value(folder_key, QDir::homePath()).toString();
    return folder_in_safe_mode_.isEmpty() ? QDir::homePath() : folder_in_safe_mode_;
}

void Settings::set_last_folder(const QString& folder) {
    store_ ? store_->setValue(folder_key, folder) : void(folder_in_safe_mode_ = folder);
}

}  // namespace hepatica
