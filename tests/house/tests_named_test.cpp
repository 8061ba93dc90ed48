// SPDX-License-Identifier: GPL-3.0-or-later
// Every test that the documents name is there: a filter that matches nothing passes, and holds
// nothing of what stands beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = HEPATICA_SOURCE_DIR;

// Stands in a test's name for the words of a parameter, which the sources do not tell.
constexpr char parameter = '\1';

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::smatch> all_matches(const std::string& text, const std::regex& expression) {
    return std::vector<std::smatch>(std::sregex_iterator(text.begin(), text.end(), expression),
                                    std::sregex_iterator());
}

// The names by which GoogleTest knows the tests of a source file.
std::vector<std::string> tests_in(const std::string& source) {
    static const std::regex instance(R"(INSTANTIATE_TEST_SUITE_P\(\s*(\w*)\s*,\s*(\w+))");
    static const std::regex test(R"(\b(TYPED_TEST|TEST_F|TEST_P|TEST)\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    std::map<std::string, std::vector<std::string>> instances;
    for (const std::smatch& match : all_matches(source, instance))
        instances[match[2].str()].push_back(match[1].length() > 0 ? match[1].str() + "/" : "");
    std::vector<std::string> names;
    for (const std::smatch& match : all_matches(source, test)) {
        const std::string kind = match[1], suite = match[2], name = match[3];
        if (kind == "TYPED_TEST")
            names.push_back(suite + "/" + parameter + "." + name);
        else if (kind != "TEST_P")
            names.push_back(suite + "." + name);
        else
            for (const std::string& of : instances[suite])
                names.push_back(of + suite + "." + name + "/" + parameter);
    }
    return names;
}

bool may_be_of_a_parameter(char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// Whether a pattern of --gtest_filter may match the name. Of a parameter only small letters, digits
// and underscores are believed: otherwise every pattern between two stars would match.
bool may_match(std::string_view pattern, std::string_view name) {
    if (pattern.empty()) return std::ranges::all_of(name, [](char c) { return c == parameter; });
    const char first = pattern.front();
    if (first == '*')
        return may_match(pattern.substr(1), name) ||
               (!name.empty() && may_match(pattern, name.substr(1)));
    if (name.empty()) return false;
    if (name.front() == parameter)
        return may_match(pattern, name.substr(1)) ||
               (may_be_of_a_parameter(first) && may_match(pattern.substr(1), name));
    return (first == '?' || first == name.front()) && may_match(pattern.substr(1), name.substr(1));
}

struct Named {
    std::string program;  // without _tests; empty where none is named
    std::string pattern;  // one, without colons
};

// The patterns of filters, and those between backquotes that look like Suite.Test or stand between
// quotation marks.
std::vector<Named> named_in(const std::string& document) {
    static const std::regex filter(
        R"((?:(\w+)_tests\s+)?--gtest_filter=(?:'([^']*)'|([^\s`')]+)))");
    static const std::regex quoted(R"(`'([\w*?/:.]*\*[\w*?/:.]*)'`)");
    static const std::regex bare(R"(`([\w*?/:.]+)`)");
    static const std::regex like_a_test(R"((^|[:*/])\*?[A-Z]\w*\*?\.(\*|[A-Z]))");
    std::vector<Named> found;
    const auto add = [&](const std::string& program, const std::string& patterns) {
        for (std::size_t begin = 0; begin < patterns.size();) {
            const std::size_t end = std::min(patterns.find(':', begin), patterns.size());
            if (end > begin) found.push_back({program, patterns.substr(begin, end - begin)});
            begin = end + 1;
        }
    };
    for (const std::smatch& match : all_matches(document, filter))
        add(match[1].str(), match[match[2].matched ? 2 : 3].str());
    for (const std::smatch& match : all_matches(document, quoted)) add("", match[1].str());
    for (const std::smatch& match : all_matches(document, bare))
        if (const std::string text = match[1]; std::regex_search(text, like_a_test)) add("", text);
    return found;
}

// The tests in each folder of tests, and the folder in which each test program is built.
struct TestTree {
    std::map<std::string, std::vector<std::string>> tests;
    std::map<std::string, std::string> folder_of_program;

    TestTree() {
        static const std::regex made(R"((?:hepatica_tests\(|add_executable\()(\w+))");
        const fs::path root = source_root / "tests";
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            const std::string folder = entry.path().lexically_relative(root).begin()->string();
            const std::string extension = entry.path().extension().string();
            if (extension == ".cpp" || extension == ".cu")
                std::ranges::copy(tests_in(text_of(entry.path())),
                                  std::back_inserter(tests[folder]));
            if (entry.path().filename() != "CMakeLists.txt") continue;
            const std::string list = text_of(entry.path());
            for (const std::smatch& match : all_matches(list, made)) {
                std::string program = match[1];
                if (program.ends_with("_tests")) program.resize(program.size() - 6);
                folder_of_program[program] = folder;
            }
        }
    }

    bool has(const Named& named) const {
        const auto place = folder_of_program.find(named.program);
        if (!named.program.empty() && place == folder_of_program.end()) return false;
        return std::ranges::any_of(tests, [&](const auto& folder) {
            return (named.program.empty() || place->second == folder.first) &&
                   std::ranges::any_of(folder.second, [&](const std::string& name) {
                       return may_match(named.pattern, name);
                   });
        });
    }
};

// Expects that each test that the file names is there, and returns how many it names.
int check(const TestTree& tree, const fs::path& file) {
    const std::vector<Named> all = named_in(text_of(file));
    for (const Named& named : all)
        EXPECT_TRUE(tree.has(named))
            << file << " names " << (named.program.empty() ? "" : named.program + "_tests with ")
            << named.pattern << ", which matches no test";
    return static_cast<int>(all.size());
}

TEST(TestsNamed, InDocumentsAreThere) {
    const TestTree tree;
    int checked = 0;
    for (const fs::path& folder : {source_root, source_root / "docs", source_root / "packaging"})
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".md") checked += check(tree, entry.path());
    EXPECT_GT(checked, 100) << "no documents were found at " << source_root;
}

// What ctest and a script run by a filter of their own.
TEST(TestsNamed, InListsAndScriptsAreThere) {
    const TestTree tree;
    int checked = check(tree, source_root / "scripts" / "gpu_check");
    for (const auto& entry : fs::recursive_directory_iterator(source_root / "tests"))
        if (entry.path().filename() == "CMakeLists.txt") checked += check(tree, entry.path());
    EXPECT_GE(checked, 5);
}

// The words of a list of sources that the thread sanitizer builds nothing of, see hepatica_tests().
std::set<std::string> beside_threads(const std::string& list) {
    const std::size_t threads = list.find("OF_THREADS");
    if (threads == std::string::npos) return {};
    const std::size_t sources = list.rfind("SOURCES", threads);
    std::istringstream words(list.substr(sources, threads - sources));
    return {std::istream_iterator<std::string>(words), {}};
}

// Names as ctest has them of the tests in some folders.
struct NamesOfCtest {
    std::vector<std::string> all, of_threads;  // of_threads: what the thread sanitizer builds

    explicit NamesOfCtest(const std::vector<std::string>& folders) {
        for (const std::string& folder : folders) {
            const fs::path root = source_root / "tests" / folder;
            const auto left_out = beside_threads(text_of(root / "CMakeLists.txt"));
            for (const auto& entry : fs::recursive_directory_iterator(root)) {
                if (entry.path().extension() != ".cpp") continue;
                const fs::path file = entry.path().lexically_relative(root);
                for (const std::string& test : tests_in(text_of(entry.path()))) {
                    all.push_back(folder + "." + test);
                    if (!left_out.contains(file.generic_string())) of_threads.push_back(all.back());
                }
            }
        }
    }
};

// Of an expression with alternatives, in parentheses or not, each one: a(b|c) is ab and ac.
std::vector<std::string> alternatives(const std::string& expression) {
    std::vector<std::string> found;
    std::size_t begin = 0, open = std::string::npos, close = std::string::npos;
    for (std::size_t at = 0, depth = 0; at <= expression.size(); ++at) {
        const char c = at < expression.size() ? expression[at] : '|';
        if (c == '(' && depth++ == 0 && open == std::string::npos) open = at;
        if (c == ')' && --depth == 0 && close == std::string::npos) close = at;
        if (c != '|' || depth > 0) continue;
        const std::string one = expression.substr(begin, at - begin);
        if (open == std::string::npos) {
            found.push_back(one);
        } else {
            const std::string before = expression.substr(begin, open - begin);
            for (const std::string& inner :
                 alternatives(expression.substr(open + 1, close - open - 1)))
                for (const std::string& after :
                     alternatives(expression.substr(close + 1, at - close - 1)))
                    found.push_back(before + inner + after);
        }
        begin = at + 1;
        open = close = std::string::npos;
    }
    return found;
}

bool any_is_called(const std::vector<std::string>& names, const std::string& expression) {
    const std::regex called(expression);
    return std::ranges::any_of(
        names, [&](const std::string& name) { return std::regex_search(name, called); });
}

// What ./test runs under the sanitizers and what it leaves out, in quotation marks or on lines of
// their own.
TEST(TestsNamed, InTheTestCommandAreThere) {
    const std::string command = text_of(source_root / "test");
    const std::size_t tsan = command.find("under tsan");
    ASSERT_NE(tsan, std::string::npos);
    static const std::regex expression(R"('(\^[^']*)'|\n +(\^\S+))");
    const NamesOfCtest names({"base", "flow", "deform", "tear", "fuzz", "session", "ui_threads"});
    int checked = 0;
    for (const std::smatch& match : all_matches(command, expression)) {
        const bool threads = static_cast<std::size_t>(match.position()) > tsan;
        for (const std::string& one : alternatives(match[match[1].matched ? 1 : 2].str())) {
            EXPECT_TRUE(any_is_called(threads ? names.of_threads : names.all, one)) << one;
            ++checked;
        }
    }
    EXPECT_GT(checked, 30);
    EXPECT_EQ(alternatives("a(b|c(d|e)f)g|h"),
              (std::vector<std::string>{"abg", "acdfg", "acefg", "h"}));
    EXPECT_TRUE(any_is_called(names.all, R"(^deform\.ManyContacts\.)"));
    EXPECT_FALSE(any_is_called(names.of_threads, R"(^deform\.ManyContacts\.)"));
    EXPECT_TRUE(any_is_called(names.of_threads, R"(^deform\.CpuStepper\.)"));
}

TEST(TestsNamed, TheCheckItselfObjects) {
    const std::vector<std::string> names = tests_in(
        "TEST(Cellar, IsDark) {}\nTEST_P(Barrel, OfWine) {}\nTYPED_TEST(Bottle, IsFull) {}\n"
        "INSTANTIATE_TEST_SUITE_P(Vintages, Barrel, testing::Bool());\n");
    const auto any = [&](const char* pattern) {
        return std::ranges::any_of(
            names, [&](const std::string& name) { return may_match(pattern, name); });
    };
    for (const char* there : {"Cellar.*", "Cellar.IsDark", "*Dark*", "Vintages/Barrel.*",
                              "*Barrel.OfWine*", "Bottle/*.IsFull", "*deep_one"})
        EXPECT_TRUE(any(there)) << there;
    for (const char* missing : {"Cellar.Dark", "Barrel.*", "Barrel.OfWine*", "*Attic*",
                                "Bottle.IsFull", "Cellar.IsDark?", "cellar.*"})
        EXPECT_FALSE(any(missing)) << missing;

    const std::vector<Named> named = named_in(
        "`flow_tests\n  --gtest_filter='A.*:*B*'`, `Suite.Test*`, `'*C*'`, `core/base/error.h`, "
        "`a.b`, `README.md`, --gtest_filter=D.E `x`");
    std::set<std::string> all;
    for (const Named& one : named) all.insert(one.program + " " + one.pattern);
    EXPECT_EQ(all, (std::set<std::string>{"flow A.*", "flow *B*", " Suite.Test*", " *C*", " D.E"}));
    const TestTree tree;
    EXPECT_TRUE(tree.has({"house", "TestsNamed.*"}));
    EXPECT_FALSE(tree.has({"flow", "TestsNamed.*"}));
    EXPECT_FALSE(tree.has({"cellar", "TestsNamed.*"}));
}

}  // namespace
