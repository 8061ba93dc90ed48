// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_place.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <cmath>
#include <regex>

#include "ui/words.h"

namespace hepatica {
namespace {

QString along(double mm, int decimals, QChar positive, QChar negative) {
    return QString("%1 %L2")
        .arg(mm < 0.0 ? negative : positive)
        .arg(std::abs(mm), 0, 'f', decimals);
}

QString in_words(double mm, int decimals, const QString& positive, const QString& negative) {
    return (mm < 0.0 ? negative : positive).arg(QLocale().toString(std::abs(mm), 'f', decimals));
}

}  // namespace

QString patient_place(const Vec3& position_mm, int decimals) {
    return QString("%1  %2  %3 mm")
        .arg(along(position_mm.x(), decimals, 'L', 'R'), along(position_mm.y(), decimals, 'P', 'A'),
             along(position_mm.z(), decimals, 'H', 'F'));
}

std::optional<Vec3> read_patient_place(const QString& text) {
    static const QRegularExpression lettered(
        R"(^\s*([LR])\s*(\d+(?:[.,]\d+)?)\s+([PA])\s*(\d+(?:[.,]\d+)?)\s+([HF])\s*(\d+(?:[.,]\d+)?)\s*(?:mm)?\s*$)");
    static const QRegularExpression numbers(
        R"(^\s*(-?\d+(?:[.,]\d+)?)\s+(-?\d+(?:[.,]\d+)?)\s+(-?\d+(?:[.,]\d+)?)\s*(?:mm)?\s*$)");
    const auto value = [](QString number) { return number.replace(',', '.').toDouble(); };
    Vec3 place_mm;
    if (const auto found = lettered.match(text); found.hasMatch()) {
        constexpr std::array negative{'R', 'A', 'F'};
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_negative =
                found.captured(2 * axis + 1) == QChar(negative[static_cast<std::size_t>(axis)]);
            place_mm[axis] = (is_negative ? -1.0 : 1.0) * value(found.captured(2 * axis + 2));
        }
        return place_mm;
    }
    const auto found = numbers.match(text);
    if (!found.hasMatch()) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) place_mm[axis] = value(found.captured(axis + 1));
    return place_mm;
}

QString patient_place_in_words(const Vec3& position_mm, int decimals) {
    return QStringList{
        in_words(position_mm.x(), decimals, Words::tr("%1 mm left"), Words::tr("%1 mm right")),
        in_words(position_mm.y(), decimals, Words::tr("%1 mm back"), Words::tr("%1 mm front")),
        in_words(position_mm.z(), decimals, Words::tr("%1 mm headwards"),
                 Words::tr("%1 mm feetwards"))}
        .join(", ");
}

QString places_in_words(const QString& text) {
    static const QRegularExpression place(R"((?<![\d.])-?\d+\.\d, -?\d+\.\d, -?\d+\.\d mm\b)");
    QString said;
    qsizetype end = 0;
    for (auto next = place.globalMatch(text); next.hasNext();) {
        const QRegularExpressionMatch found = next.next();
        said += text.mid(end, found.capturedStart() - end);
        said += patient_place_in_words(*position_of(found.captured().toStdString()));
        end = found.capturedEnd();
    }
    return said + text.mid(end);
}

std::optional<Vec3> position_of(const std::string& place) {
    static const std::regex tenths(R"((-?\d+\.\d), (-?\d+\.\d), (-?\d+\.\d) mm)");
    std::smatch found;
    if (!std::regex_match(place, found, tenths)) return std::nullopt;
    Vec3 position_mm;
    for (int axis = 0; axis < 3; ++axis)
        position_mm[axis] =
            QString::fromStdString(found[static_cast<std::size_t>(axis) + 1]).toDouble();
    return position_mm;
}

}  // namespace hepatica
