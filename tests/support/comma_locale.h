// SPDX-License-Identifier: GPL-3.0-or-later
// A locale with a decimal comma and grouped thousands, for as long as the object lives: what Qt or
// a host program may have set around us. C++ streams always get it; printf and strtod where the
// system has such a locale installed.
#pragma once

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <sstream>
#include <string>

namespace hepatica::test {

class CommaLocale {
  public:
    CommaLocale()
        : c_before_(std::setlocale(LC_NUMERIC, nullptr)),
          before_(std::locale::global(std::locale(std::locale::classic(), new Comma))) {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"})
            if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
        std::ostringstream text;
        text << 1234.5;
        EXPECT_EQ(text.str(), "1.234,5") << "the test itself does nothing";
    }
    ~CommaLocale() {
        std::locale::global(before_);
        std::setlocale(LC_NUMERIC, c_before_.c_str());
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

  private:
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };

    std::string c_before_;
    std::locale before_;
};

}  // namespace hepatica::test
