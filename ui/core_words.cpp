// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/core_words.h"

#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/core_sentences.h"
#include "ui/patient_place.h"
#include "ui/window_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// A sentence of core with placeholders: "segment %1 of %2".
struct Pattern {
    const char* id;
    QString begin;  // the text before the first placeholder
    QRegularExpression shape;
    std::vector<int> order;  // the placeholder that each group of the expression fills
};

constexpr int deepest = 6;  // nesting depth of sentences within sentences

QString expression_of(const QString& sentence, std::vector<int>& order) {
    QString expression;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const bool is_place =
            sentence[i] == '%' && i + 1 < sentence.size() && sentence[i + 1].isDigit();
        if (!is_place) {
            expression += QRegularExpression::escape(sentence.mid(i, 1));
            continue;
        }
        order.push_back(sentence[++i].digitValue());
        expression += "(.+?)";
    }
    return expression;
}

// Length without the % signs: how much text of its own a pattern has.
qsizetype letters_of(const char* sentence) {
    return QString::fromUtf8(sentence).remove('%').size();
}

// Core's sentences, each as core writes it and as changed by in_window_words().
struct Sentences {
    QHash<QString, const char*> whole;
    std::vector<Pattern> patterns;  // the longest first

    Sentences() {
        for (const char* id : core_sentences()) {
            add(QString::fromUtf8(id), id);
            add(QString::fromStdString(in_window_words(id)), id);
        }
        std::ranges::stable_sort(patterns, [](const Pattern& a, const Pattern& b) {
            return letters_of(a.id) > letters_of(b.id);
        });
    }

    void add(const QString& sentence, const char* id) {
        Pattern pattern{id, sentence.section('%', 0, 0), {}, {}};
        const QString expression = expression_of(sentence, pattern.order);
        if (pattern.order.empty()) {
            whole.insert(sentence, id);
            return;
        }
        pattern.shape.setPattern(QRegularExpression::anchoredPattern(expression));
        pattern.shape.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
        patterns.push_back(std::move(pattern));
    }
};

const Sentences& sentences() {
    static const Sentences all;
    return all;
}

// Writes 3.25 or 12.5 mN with the language's decimal sign; text that only resembles a number
// (1.2.840, p1.hep, 2.x) stays.
QString number_in_words(const QString& text) {
    static const QRegularExpression decimal(
        R"(^(-?\d+)\.(\d+(?:e[+-]\d+)?)((?: [^\s\d.]{1,6}[23]?){0,2})$)");
    const QRegularExpressionMatch match = decimal.match(text);
    if (!match.hasMatch()) return text;
    return match.captured(1) + QLocale().decimalPoint() + match.captured(2) + match.captured(3);
}

QString in_words(const QString& english, int depth);

// Translates inserted names, numbers and lists.
QString part_in_words(const QString& part, int depth) {
    // As quoted_name() writes what a person called something.
    if (part.startsWith(QChar(0x201c)) && part.endsWith(QChar(0x201d)) &&
        part.count(QChar(0x201d)) == 1)
        return part;
    return depth >= deepest ? number_in_words(part) : in_words(part, depth + 1);
}

QString in_words(const QString& english, int depth) {
    if (const QString number = number_in_words(english); number != english) return number;
    if (const auto found = sentences().whole.constFind(english); found != sentences().whole.cend())
        return Words::tr(*found);
    // Failures and stages of the window itself, written in core's style.
    if (const QString whole = Words::tr(english.toUtf8().constData()); whole != english)
        return whole;
    for (const Pattern& pattern : sentences().patterns) {
        if (!english.startsWith(pattern.begin)) continue;
        const QRegularExpressionMatch match = pattern.shape.match(english);
        if (!match.hasMatch()) continue;
        QString text = Words::tr(pattern.id);
        // All placeholders at once: an inserted name that contains "%1" is not a placeholder.
        QString filled;
        for (qsizetype i = 0; i < text.size(); ++i) {
            const int place = text[i] == '%' && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
            const auto group = std::ranges::find(pattern.order, place);
            if (place < 1 || group == pattern.order.end()) {
                filled += text[i];
                continue;
            }
            const auto number = static_cast<int>(group - pattern.order.begin()) + 1;
            filled += part_in_words(match.captured(number), depth);
            ++i;
        }
        return filled;
    }
    return english;
}

// In English, or without a translation, nothing has to be looked up.
bool is_english() {
    const char* const any = core_sentences().front();
    return Words::tr(any) == QString::fromUtf8(any);
}

}  // namespace

QString translated(const std::string& english) {
    const QString text = QString::fromStdString(english);
    return places_in_words(is_english() ? text : in_words(text, 0));
}

}  // namespace hepatica
