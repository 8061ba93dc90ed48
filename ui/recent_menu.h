// SPDX-License-Identifier: GPL-3.0-or-later
// The files that were opened or saved last. What is not there any more is marked, and leaves the
// list when it is asked for.
#pragma once

#include <QMenu>
#include <functional>

#include "ui/settings.h"

namespace hepatica {

class RecentMenu : public QMenu {
  public:
    struct Callbacks {
        std::function<void(const QString& path)> open;
        std::function<void(const QString& path)> missing;
    };
    // `settings` must outlive it.
    RecentMenu(Settings& settings, Callbacks callbacks, QWidget* parent = nullptr);

    // As the settings are now; also whenever the menu is about to appear.
    void fill();

  private:
    void choose(const QString& path);

    Settings& settings_;
    Callbacks callbacks_;
};

}  // namespace hepatica
