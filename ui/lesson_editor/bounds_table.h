// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of a lesson as rows that can be edited: a quantity, of which mark, at least or at most,
// and the number with its unit.
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "core/lesson/predicate.h"

class QVBoxLayout;

namespace hepatica {

class BoundsTable : public QWidget {
  public:
    // `row`: the number of the one that was changed; empty where one came or went.
    using Changed =
        std::function<void(const std::string& row, const std::vector<Predicate>& bounds)>;
    // `name`: of the object, and of its fields with the row's number ("goal0quantity"). `first`:
    // what a row that is added asks for.
    BoundsTable(const QString& title, const QString& name, const Predicate& first, Changed changed);

    void show_bounds(const std::vector<Predicate>& bounds, const std::vector<std::string>& marks);
    const std::vector<Predicate>& bounds() const { return bounds_; }

  private:
    QWidget* make_row(std::size_t index);
    void fill();
    void set(std::size_t index, const Predicate& bound, bool other_quantity);

    QString name_;
    Predicate first_;
    Changed changed_;
    std::vector<Predicate> bounds_;
    std::vector<std::string> marks_;
    QVBoxLayout* rows_;
    bool filling_ = false;
};

}  // namespace hepatica
