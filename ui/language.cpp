// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>

#include "ui/words.h"

// Resources of a static library must be initialised explicitly.
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

// Loads a source of translations, replacing the former one.
void load(const QString& source, const QString& code, const QString& folder) {
    QCoreApplication* program = QCoreApplication::instance();
    auto* translator = program->findChild<QTranslator*>(source);
    if (!translator) {
        translator = new QTranslator(program);
        translator->setObjectName(source);
    }
    QCoreApplication::removeTranslator(translator);
    if (translator->load(source + "_" + code, folder))
        QCoreApplication::installTranslator(translator);
}

QString spoken = "en";

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
    // In the user's order of preference: "de-AT", "en-US".
    for (const QString& wanted : QLocale::system().uiLanguages())
        if (const QString code = wanted.section('-', 0, 0); is_known(code)) return code;
    return "en";
}

void use_language(const QString& chosen) {
    init_translations();
    const QString code = language_of(chosen);
    spoken = code;
    load("hepatica", code, ":/translations");
    load("qtbase", code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    // The locale by its name: QLocale::system() itself asks the environment again for single
    // numbers, but not for numbers within a sentence.
    const QLocale system = QLocale::system();
    QLocale numbers(system.language() == QLocale(code).language() ? system.name() : code);
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(numbers);
}

QString spoken_language() {
    return spoken;
}

}  // namespace hepatica
