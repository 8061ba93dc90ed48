// SPDX-License-Identifier: GPL-3.0-or-later
// The manual pages say of each program what its --help says: the same verbs, the same options.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/support/shell.h"

namespace hepatica {
namespace {

using Names = std::set<std::string>;

std::string help_of(const std::string& program) {
    const test::ShellAnswer answer = test::shell("env -u DISPLAY -u WAYLAND_DISPLAY " + program);
    EXPECT_EQ(answer.exit_code, 0) << answer.output;
    return answer.output;
}

// Without roff's backslashes before hyphens.
std::string page(const std::string& name) {
    std::ifstream in(std::string(HEPATICA_PACKAGING) + "/" + name);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return std::regex_replace(text, std::regex(R"(\\-)"), "-");
}

Names all_of(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    Names names;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end;
         ++match)
        names.insert((*match)[1]);
    return names;
}

// Verbs stand after "Subcommands:", indented by two.
Names verbs_in(const std::string& help) {
    const std::size_t list = help.find("Subcommands:\n");
    if (list == std::string::npos) return {};
    return all_of(help.substr(list), R"(\n  ([a-z][a-z-]*) )");
}

// Of a section of the page, up to the next.
std::string section(const std::string& text, const std::string& title) {
    const std::size_t begin = text.find("\n.SH " + title + "\n");
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find("\n.SH ", begin + 1) - begin);
}

TEST(ManPages, NameEveryVerbAndNoOther) {
    const Names verbs = verbs_in(help_of(HEPATICA_CLI " --help"));
    EXPECT_GT(verbs.size(), 15U);
    EXPECT_EQ(all_of(section(page("hepatica-cli.1"), "VERBS"), R"(\n\.TP\n\.B ([a-z-]+))"), verbs)
        << "packaging/hepatica-cli.1 lists them";
}

TEST(ManPages, NameEveryBenchmark) {
    const Names benchmarks = verbs_in(help_of(HEPATICA_CLI " bench --help"));
    EXPECT_GT(benchmarks.size(), 5U);
    EXPECT_EQ(all_of(section(page("hepatica-cli.1"), "VERBS"), R"(\n\.BR ([a-z-]+) [,.])"),
              benchmarks)
        << "packaging/hepatica-cli.1 lists them under bench";
}

TEST(ManPages, NameEveryOptionOfBothPrograms) {
    const char* const option = R"((--[a-z]+(?:-[a-z]+)*))";
    EXPECT_EQ(all_of(section(page("hepatica-cli.1"), "OPTIONS"), option),
              all_of(help_of(HEPATICA_CLI " --help"), R"(\n  (?:-h,)?(--[a-z-]+))"));
    const Names options =
        all_of(help_of(HEPATICA_WINDOW " --help"), R"(\n  (?:-[a-z], )?(--[a-z-]+))");
    EXPECT_THAT(options, testing::Contains("--built-in"));
    EXPECT_EQ(all_of(section(page("hepatica.1"), "OPTIONS"), option), options)
        << "packaging/hepatica.1 lists them";
}

TEST(ManPages, AreWrittenAsRoffWantsThem) {
    if (test::shell("command -v groff").exit_code != 0) GTEST_SKIP() << "groff is not installed";
    for (const char* name : {"hepatica.1", "hepatica-cli.1"}) {
        const test::ShellAnswer answer = test::shell(
            "groff -man -ww -Tutf8 '" HEPATICA_PACKAGING "/" + std::string(name) + "' > /dev/null");
        EXPECT_EQ(answer.exit_code, 0);
        EXPECT_EQ(answer.output, "") << name;
    }
}

}  // namespace
}  // namespace hepatica
