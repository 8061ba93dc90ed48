// SPDX-License-Identifier: GPL-3.0-or-later
// Panel in the empty view that offers ways to begin. UI thread only.
#pragma once

#include <QFrame>
#include <functional>

#include "ui/actions.h"

namespace hepatica {

class Welcome : public QFrame {
  public:
    // `lessons` shows the course.
    Welcome(const Actions& actions, std::function<void()> lessons, QWidget* parent);
    // A message covers this many points at the top of the parent: the panel moves below it where it
    // would lie under it.
    void keep_clear(int top);

  protected:
    // Keeps the panel in the middle of its parent.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void centre();

    int covered_top_ = 0;
};

}  // namespace hepatica
