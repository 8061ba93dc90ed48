// SPDX-License-Identifier: GPL-3.0-or-later
// Menu of the files opened or saved last. Missing ones are marked and removed from the list when
// chosen.
#pragma once

#include <QMenu>
#include <functional>

#include "ui/settings.h"

namespace hepatica {

// UI thread only.
class RecentMenu : public QMenu {
  public:
    struct Callbacks {
        std::function<void(const QString& path)> open;
        std::function<void(const QString& path)> missing;
    };
    // `settings` must outlive the menu.
    RecentMenu(Settings& settings, Callbacks callbacks, QWidget* parent = nullptr);

    // Fills the menu from the settings; called whenever it is about to appear.
    void fill();

  private:
    void choose(const QString& path);

    Settings& settings_;
    Callbacks callbacks_;
};

}  // namespace hepatica
