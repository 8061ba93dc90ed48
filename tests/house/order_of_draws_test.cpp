// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources that draw random numbers and fails where one expression draws twice: in which
// order it does so is the compiler's choice (C++20 [expr.call]), and the same seed would give
// another patient. Draws within braces are made from left to right.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = HEPATICA_SOURCE_DIR;

std::string without_line_comments(const std::string& source) {
    static const std::regex comment("//[^\n]*");
    return std::regex_replace(source, comment, "");
}

// The source cut where one expression is over before the next begins: at semicolons, braces,
// questions with their answers, && and ||, and commas outside parentheses. It is cut too often
// rather than too seldom (behind an inner brace, at each reference): few draws are overlooked so.
std::vector<std::string> expressions_of(const std::string& source) {
    std::vector<std::string> expressions(1);
    int depth = 0;
    for (const char c : without_line_comments(source)) {
        const bool ends_all = c == ';' || c == '{' || c == '}';
        if (ends_all || c == '?' || c == ':' || c == '&' || c == '|' || (c == ',' && depth == 0)) {
            expressions.emplace_back();
            if (ends_all) depth = 0;
            continue;
        }
        if (c == '(') ++depth;
        if (c == ')') depth = std::max(0, depth - 1);
        expressions.back() += c;
    }
    return expressions;
}

// The names of all generators that the source declares, as alternatives of a regular expression.
std::string generators_of(const std::string& source) {
    static const std::regex declared(R"(\b(?:PhantomRandom|mt19937\w*)\s*&?\s+(\w+))");
    std::string names = "random_?";
    for (std::sregex_iterator at(source.begin(), source.end(), declared), end; at != end; ++at)
        names += "|" + (*at)[1].str();
    return "(?:" + names + ")";
}

// Expressions with more than one draw: by a call of the generator, or by a function that is given
// it.
std::vector<std::string> with_two_draws(const std::string& source) {
    const std::string name = generators_of(source);
    const std::regex draw("\\b" + name + R"(\s*(?:\.\s*\w+\s*\(|\(\s*\))|[(,]\s*)" + name +
                          R"(\s*[,)])");
    std::vector<std::string> found;
    for (const std::string& expression : expressions_of(source)) {
        const std::sregex_iterator first(expression.begin(), expression.end(), draw);
        if (std::distance(first, std::sregex_iterator()) > 1) found.push_back(expression);
    }
    return found;
}

TEST(OrderOfDraws, IsNotLeftToTheCompiler) {
    for (const char* room : {"phantom", "study"}) {
        int files = 0;
        for (const auto& entry : fs::directory_iterator(source_root / "core" / room)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            std::ifstream in(entry.path());
            const std::string source{std::istreambuf_iterator<char>(in), {}};
            for (const std::string& expression : with_two_draws(source))
                ADD_FAILURE() << entry.path() << " draws twice in one expression:" << expression;
            ++files;
        }
        EXPECT_GT(files, 10) << "core/" << room << " was not found at " << source_root;
    }
}

TEST(OrderOfDraws, TheCheckItselfObjects) {
    for (const char* source :
         {"a = across(b, random.uniform(0.0, c)) * random.uniform(0.0, 0.05) * d;",
          "Vec3 p(random.uniform() * x,\n  random.uniform() * y, z);",
          "a = whole(random, 0, 8) + random_.uniform();", "f(g(random), h(random));",
          "a = random() - random();",
          "[](const Vec3&, std::mt19937_64& r) { return Vec3(uniform(r, 0, 80), 0, uniform(r, 0, "
          "4)); }",
          "std::mt19937_64 own = random; goal = uniform(own, 0.0, 0.3) * random_direction(own);"})
        EXPECT_EQ(with_two_draws(source).size(), 1u) << source;
}

TEST(OrderOfDraws, LeavesWhatHasAnOrder) {
    for (const char* source :
         {"a = random.uniform(); b = random.uniform();",
          "const double a = random.uniform(0.8, 3.0), b = random.uniform(1.0, 6.0);",
          "Index3 at{int(random.uniform() * x), int(random.uniform() * y)};",
          "a = happens(random, 0.7) ? random.uniform(0.7, 2.0) : random.uniform(2.0, 5.0);",
          "a = happens(random, 0.7) && happens(random, 0.2);",
          "Grower(PhantomRandom& random) : random_(random) { draw(random); }",
          "std::mt19937_64 r(5); a = uniform(r, 0, 1); b = uniform(r, 0, 1);",
          "a = random.uniform();  // random.uniform() as well"})
        EXPECT_TRUE(with_two_draws(source).empty()) << source;
}

}  // namespace
