// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recent_menu.h"

#include <QFileInfo>
#include <utility>

#include "ui/words.h"

namespace hepatica {

RecentMenu::RecentMenu(Settings& settings, Callbacks callbacks, QWidget* parent)
    : QMenu(Words::tr("Open recen&t"), parent),
      settings_(settings),
      callbacks_(std::move(callbacks)) {
    connect(this, &QMenu::aboutToShow, this, [this] { fill(); });
}

void RecentMenu::fill() {
    clear();
    for (const QString& path : settings_.recent_files()) {
        QString text = path;
        text.replace("&", "&&");
        addAction(QFileInfo::exists(path) ? text : text + "   " + Words::tr("(missing)"), this,
                  [this, path] { choose(path); });
    }
    addSeparator();
    addAction(Words::tr("&Clear"), this, [this] { settings_.clear_recent_files(); });
}

void RecentMenu::choose(const QString& path) {
    if (QFileInfo::exists(path)) return callbacks_.open(path);
    settings_.remove_recent_file(path);
    callbacks_.missing(path);
}

}  // namespace hepatica
