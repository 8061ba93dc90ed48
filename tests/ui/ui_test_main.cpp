// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <clocale>

#include "ui/language.h"
#include "ui/opengl_probe.h"
#include "ui/theme.h"

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    hepatica::prepare_opengl();
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    hepatica::use_language("en");  // whatever the machine speaks
    hepatica::apply_theme(application);
    return RUN_ALL_TESTS();
}
