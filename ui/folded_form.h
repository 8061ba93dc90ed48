// SPDX-License-Identifier: GPL-3.0-or-later
// A form of settings that few need, folded behind its title until that is clicked.
#pragma once

#include <QWidget>

class QFormLayout;
class QToolButton;

namespace hepatica {

// UI thread only.
class FoldedForm : public QWidget {
  public:
    explicit FoldedForm(const QString& title, QWidget* parent);

    QFormLayout& form() { return *form_; }
    void unfold(bool open);
    bool is_open() const;

  private:
    QToolButton* title_;
    QWidget* content_;
    QFormLayout* form_;
};

}  // namespace hepatica
