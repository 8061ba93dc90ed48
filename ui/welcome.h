// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the empty view: three ways to begin.
#pragma once

#include <QFrame>

#include "ui/actions.h"

namespace hepatica {

class Welcome : public QFrame {
  public:
    explicit Welcome(const Actions& actions, QWidget* parent);

  protected:
    // Keeps itself in the middle of its parent.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void centre();
};

}  // namespace hepatica
