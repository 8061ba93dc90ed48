// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review_list.h"

#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// An event at most this long before the present moment counts as the present one.
constexpr double same_moment_s = 0.05;
constexpr double next_moment_s = 1e-3;
constexpr int time_role = Qt::UserRole;
constexpr int note_role = Qt::UserRole + 1;

// Visible on dark and light backgrounds; the text beside it says the same.
QColor colour_of(PlayEventKind kind) {
    switch (kind) {
        case PlayEventKind::hand:
            return {0x5b, 0x8f, 0xd0};
        case PlayEventKind::tool:
            return {0x2f, 0xa0, 0xac};
        case PlayEventKind::drug:
            return {0x92, 0x6c, 0xd8};
        case PlayEventKind::cut:
            return {0x8a, 0x8a, 0x8a};
        case PlayEventKind::near_tear:
            return {0xe8, 0x96, 0x20};
        case PlayEventKind::tear:
            return {0xe0, 0x4a, 0x4a};
        case PlayEventKind::blood:
            return {0xb8, 0x20, 0x40};
        case PlayEventKind::lesson:
            return {0x3f, 0xa0, 0x58};
        case PlayEventKind::not_passed:
            return {0xe0, 0x40, 0xb0};
        case PlayEventKind::trouble:
            break;
    }
    return {0xc8, 0xb0, 0x30};
}

QIcon square_of(const QColor& colour) {
    QPixmap pixmap(12, 12);
    pixmap.fill(colour);
    return pixmap;
}

struct Row {
    double at_s;
    QString text;
    QColor colour;
    int note;  // index of the note; -1: none
};

}  // namespace

ReviewList::ReviewList(QWidget* parent) : QListWidget(parent) {
    setAccessibleName(Words::tr("What happened, and notes"));
    setMinimumHeight(70);
}

void ReviewList::fill(std::vector<PlayEvent> events, std::vector<PlayEvent> beside,
                      std::vector<PlayNote> notes) {
    if (events == events_ && beside == beside_ && notes == notes_) return;
    events_ = std::move(events);
    beside_ = std::move(beside);
    notes_ = std::move(notes);
    std::vector<Row> rows;
    for (const PlayEvent& event : events_)
        rows.push_back({event.at_s, translated(event.text), colour_of(event.kind), -1});
    for (const PlayEvent& event : beside_)
        rows.push_back({event.at_s, Words::tr("beside: %1").arg(translated(event.text)),
                        colour_of(event.kind), -1});
    for (std::size_t i = 0; i < notes_.size(); ++i)
        rows.push_back({notes_[i].at_s, "✎ " + QString::fromStdString(notes_[i].text),
                        palette().color(QPalette::WindowText), static_cast<int>(i)});
    std::ranges::stable_sort(rows, {}, &Row::at_s);
    const QSignalBlocker quiet(this);
    clear();
    ticks_.clear();
    for (const Row& row : rows) {
        auto* item = new QListWidgetItem(square_of(row.colour),
                                         clock_text(row.at_s) + "   " + row.text, this);
        item->setData(time_role, row.at_s);
        item->setData(note_role, row.note);
        ticks_.push_back({row.at_s, row.colour});
    }
}

double ReviewList::at_s(int row) const {
    return item(row)->data(time_role).toDouble();
}

std::optional<std::size_t> ReviewList::note(int row) const {
    const int index = row < 0 ? -1 : item(row)->data(note_role).toInt();
    return index < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(index));
}

int ReviewList::next_row(double at_s, int direction) const {
    const double least_s = direction > 0 ? next_moment_s : same_moment_s;
    for (int i = 0; i < count(); ++i) {
        const int row = direction > 0 ? i : count() - 1 - i;
        if (direction * (this->at_s(row) - at_s) > least_s) return row;
    }
    return -1;
}

}  // namespace hepatica
