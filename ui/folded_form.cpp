// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/folded_form.h"

#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace hepatica {

FoldedForm::FoldedForm(const QString& title, QWidget* parent)
    : QWidget(parent),
      title_(new QToolButton(this)),
      content_(new QWidget(this)),
      form_(new QFormLayout(content_)) {
    title_->setText(title);
    title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    title_->setAutoRaise(true);
    title_->setCheckable(true);
    title_->setFocusPolicy(Qt::StrongFocus);
    connect(title_, &QToolButton::toggled, this, [this](bool open) { unfold(open); });
    form_->setContentsMargins(0, 0, 0, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(title_);
    column->addWidget(content_);
    unfold(false);
}

void FoldedForm::unfold(bool open) {
    title_->setChecked(open);
    title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    content_->setVisible(open);
}

bool FoldedForm::is_open() const {
    return title_->isChecked();
}

}  // namespace hepatica
