// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/translations.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QXmlStreamReader>

namespace hepatica::testing {
namespace {

void read_forms(QXmlStreamReader& xml, Translation& one) {
    one.finished = !xml.attributes().hasAttribute("type");
    if (!one.numbered) {
        one.forms << xml.readElementText();
        return;
    }
    while (xml.readNextStartElement()) one.forms << xml.readElementText();
}

Translation read_message(QXmlStreamReader& xml) {
    Translation one;
    one.numbered = xml.attributes().value("numerus") == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source"))
            one.source = xml.readElementText();
        else if (xml.name() == QLatin1String("translation"))
            read_forms(xml, one);
        else
            xml.skipCurrentElement();
    }
    return one;
}

}  // namespace

QString translation_file(const char* language) {
    return QString(HEPATICA_SOURCE_DIR "/translations/hepatica_%1.ts").arg(language);
}

std::vector<Translation> translations_in(const QString& file) {
    QFile opened(file);
    EXPECT_TRUE(opened.open(QIODevice::ReadOnly)) << file.toStdString();
    QXmlStreamReader xml(&opened);
    std::vector<Translation> all;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement &&
            xml.name() == QLatin1String("message"))
            all.push_back(read_message(xml));
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return all;
}

}  // namespace hepatica::testing
