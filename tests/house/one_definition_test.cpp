// SPDX-License-Identifier: GPL-3.0-or-later
// Reads every header of the tree and fails where two define a class, struct, union or enum of one
// name in one namespace. No source that includes both would compile, and the linker, which does not
// see types, joins inline functions of the two (C++20 [basic.def.odr]).
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = HEPATICA_SOURCE_DIR;

// The source without comments, the content of literals and lines for the preprocessor.
std::string bare_code(const std::string& source) {
    std::string code;
    const std::size_t size = source.size();
    const auto skip_to = [&](std::size_t from, const char* end, std::size_t length) {
        const std::size_t found = source.find(end, from);
        return found == std::string::npos ? size : found + length;
    };
    bool line_begins = true;
    for (std::size_t i = 0; i < size;) {
        const char c = source[i];
        if (source.compare(i, 2, "//") == 0) {
            i = skip_to(i, "\n", 0);
        } else if (source.compare(i, 2, "/*") == 0) {
            i = skip_to(i + 2, "*/", 2);
        } else if (source.compare(i, 3, "R\"(") == 0) {
            i = skip_to(i + 3, ")\"", 2);
        } else if (c == '#' && line_begins) {
            do i = skip_to(i, "\n", 1);
            while (i < size && source[i - 2] == '\\');
        } else if (c == '"' ||
                   (c == '\'' &&
                    (i == 0 || !std::isalnum(static_cast<unsigned char>(source[i - 1]))))) {
            for (++i; i < size && source[i] != c; ++i)
                if (source[i] == '\\') ++i;
            ++i;
            code += "\"\"";
        } else {
            if (c == '\n')
                line_begins = true;
            else if (c != ' ')
                line_begins = false;
            code += c;
            ++i;
        }
    }
    return code;
}

// What stands before an opening brace: the name of a namespace, of a type, or nothing of both.
struct Opened {
    enum class Kind { name_space, type, other } kind = Kind::other;
    std::string name;
};

Opened opened_by(const std::string& before) {
    static const std::regex name_space(R"(\bnamespace\s+([\w:]+)\s*$)");
    // Nested types defined outside (struct Outer::Inner) have a name of their own.
    static const std::regex type(
        R"(\b(?:class|struct|union|enum(?:\s+class)?)\s+)"
        R"((?:alignas\s*\((?:[^()]|\([^()]*\))*\)\s*)?((?:\w+::)*\w+)(?:\s+final)?\s*(?::[^:].*)?$)");
    std::string line = before;
    for (char& c : line)
        if (c == '\n') c = ' ';
    std::smatch match;
    if (std::regex_search(line, match, name_space)) return {Opened::Kind::name_space, match[1]};
    if (std::regex_search(line, match, type)) return {Opened::Kind::type, match[1]};
    return {};
}

// The types that the source defines in namespaces, with their namespace; those within a type or an
// unnamed namespace are left out.
std::vector<std::string> types_of(const std::string& source) {
    std::vector<std::string> types;
    std::vector<Opened> open;
    std::string before;
    for (const char c : bare_code(source)) {
        if (c == '{') {
            open.push_back(opened_by(before));
            std::string scope;
            bool in_namespaces = true;
            for (std::size_t i = 0; i + 1 < open.size(); ++i) {
                in_namespaces = in_namespaces && open[i].kind == Opened::Kind::name_space;
                scope += open[i].name + "::";
            }
            if (in_namespaces && open.back().kind == Opened::Kind::type)
                types.push_back(scope + open.back().name);
        } else if (c == '}' && !open.empty()) {
            open.pop_back();
        }
        if (c == '{' || c == '}' || c == ';')
            before.clear();
        else
            before += c;
    }
    return types;
}

std::string content_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// By name, the headers that define it, where these are several.
std::map<std::string, std::set<std::string>> defined_twice(
    const std::map<std::string, std::string>& headers) {
    std::map<std::string, std::set<std::string>> where;
    for (const auto& [file, source] : headers)
        for (const std::string& type : types_of(source)) where[type].insert(file);
    std::erase_if(where, [](const auto& entry) { return entry.second.size() < 2; });
    return where;
}

TEST(OneDefinition, NoTwoHeadersDefineATypeOfOneName) {
    std::map<std::string, std::string> headers;
    std::size_t types = 0;
    for (const char* layer : {"core", "gpu", "render", "ui", "app", "bench"}) {
        if (!fs::exists(source_root / layer)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(source_root / layer)) {
            if (entry.path().extension() != ".h") continue;
            const std::string file = fs::relative(entry.path(), source_root).generic_string();
            headers[file] = content_of(entry.path());
            types += types_of(headers[file]).size();
        }
    }
    EXPECT_GT(types, 500u) << "the tree was not found at " << source_root;
    for (const auto& [type, files] : defined_twice(headers))
        for (const std::string& file : files) ADD_FAILURE() << type << " is defined in " << file;
}

TEST(OneDefinition, TheCheckItselfObjects) {
    const auto twice = [](const std::string& a, const std::string& b) {
        return defined_twice({{"a.h", a}, {"b.h", b}}).size();
    };
    EXPECT_EQ(twice("namespace n { struct A { int i = 0; }; }", "namespace n { class A {}; }"), 1u);
    EXPECT_EQ(twice("namespace n {\nclass A final : public B<1> {\n};\n}",
                    "namespace n { template <class T> struct A {}; }"),
              1u);
    EXPECT_EQ(twice("namespace n::m { enum class A : int { b }; }",
                    "namespace n { namespace m { enum A { c }; } }"),
              1u);
    EXPECT_EQ(twice("struct alignas(4 * sizeof(int)) A : B {};", "union A {};"), 1u);
    EXPECT_EQ(twice("struct A { int i; };",
                    "// struct A {\n/* struct A { */ const char* t = "
                    "\"struct A {\";\n#define A struct A {\n"),
              0u);
}

TEST(OneDefinition, LeavesDeclarationsAndNestedTypes) {
    const auto twice = [](const std::string& a, const std::string& b) {
        return defined_twice({{"a.h", a}, {"b.h", b}}).size();
    };
    EXPECT_EQ(twice("namespace n { struct A {}; }", "namespace n { struct A; }"), 0u);
    EXPECT_EQ(twice("namespace n { struct A {}; }", "namespace m { struct A {}; }"), 0u);
    EXPECT_EQ(twice("namespace n { struct A {}; }", "namespace n { struct B { struct A {}; }; }"),
              0u);
    EXPECT_EQ(twice("namespace n { struct A {}; }", "namespace n { struct A::B {}; }"), 0u);
    EXPECT_EQ(twice("namespace n { struct A {}; }", "namespace n { void f(struct A a) {} }"), 0u);
}

}  // namespace
