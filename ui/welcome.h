// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the empty view: the ways to begin.
#pragma once

#include <QFrame>
#include <functional>

#include "ui/actions.h"

namespace hepatica {

class Welcome : public QFrame {
  public:
    // `lessons`: shows the list of lessons.
    Welcome(const Actions& actions, std::function<void()> lessons, QWidget* parent);

  protected:
    // Keeps itself in the middle of its parent.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void centre();
};

}  // namespace hepatica
