// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>

#include "render/picture_words.h"
#include "ui/core_words.h"
#include "ui/words.h"

// A resource of a static library is not there by itself.
static void init_translations() {
    Q_INIT_RESOURCE(translations);
}

namespace hepatica {
namespace {

constexpr std::array choices{
    Language{"", Words::id("System")},
    Language{"en", "English"},
    Language{"de", "Deutsch"},
};

// One of each source of words; loading anew takes the words before away.
void load(QTranslator& translator, const QString& file, const QString& folder) {
    QCoreApplication::removeTranslator(&translator);
    if (translator.load(file, folder)) QCoreApplication::installTranslator(&translator);
}

bool is_known(const QString& code) {
    return !code.isEmpty() && std::ranges::any_of(choices, [&](const Language& language) {
        return code == language.code;
    });
}

}  // namespace

std::span<const Language> languages() {
    return choices;
}

QString language_of(const QString& chosen) {
    if (is_known(chosen)) return chosen;
    // In the order in which the user wants them: "de-AT", "en-US".
    for (const QString& wanted : QLocale::system().uiLanguages())
        if (const QString code = wanted.section('-', 0, 0); is_known(code)) return code;
    return "en";
}

void use_language(const QString& chosen) {
    static QTranslator own, of_qt;
    init_translations();
    const QString code = language_of(chosen);
    load(own, "hepatica_" + code, ":/translations");
    load(of_qt, "qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    const QLocale system = QLocale::system();
    QLocale numbers = system.language() == QLocale(code).language() ? system : QLocale(code);
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(numbers);
    set_picture_words([](const std::string& english) { return translated(english).toStdString(); });
}

}  // namespace hepatica
