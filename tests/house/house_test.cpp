// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the source's layout, checked: who may include whom, who may include which library, a
// test for each source file, the map of the source, licence lines, file sizes, and no mutable
// globals.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

const fs::path root = CANDELABRA_SOURCE_DIR;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> lines_of(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::vector<fs::path> files_below(const fs::path& folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && extensions.count(entry.path().extension().string()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// The modules. src/packaging has files for desktops, editors and packagers, and no source;
/// src/system has what stands in for sources of modules on other systems; src/python is the module
/// of Python, and src/playground a page, which are no part of the program.
std::vector<fs::path> folders_of_source() {
    const std::set<std::string> others = {"packaging", "playground", "python", "system"};
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(root / "src"))
        if (entry.is_directory() && others.count(entry.path().filename().string()) == 0)
            folders.push_back(entry.path());
    return folders;
}

struct Module {
    std::set<std::string> uses;
    std::set<std::string> libraries;
};

/// The table of modules in CMakeLists.txt.
std::map<std::string, Module> modules() {
    std::map<std::string, Module> result;
    const std::string text = read(root / "CMakeLists.txt");
    const std::regex line(R"(\nadd_module\((\w+)([^)]*)\))");
    for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) {
        Module& module = result[(*i)[1]];
        std::istringstream words((*i)[2].str());
        std::string section;
        for (std::string word; words >> word;) {
            if (word == "USES" || word == "WITH" || word == "GENERATED")
                section = word;
            else if (section == "USES")
                module.uses.insert(word);
            else if (section == "WITH")
                module.libraries.insert(word);
        }
    }
    return result;
}

std::vector<std::string> includes_of(const fs::path& path, const std::regex& form) {
    std::vector<std::string> result;
    for (const std::string& line : lines_of(path)) {
        std::smatch match;
        if (std::regex_search(line, match, form)) result.push_back(match[1]);
    }
    return result;
}

std::string output_of(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer;
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        output.append(buffer.data(), n);
    REQUIRE(pclose(pipe) == 0);
    return output;
}

}  // namespace

TEST_CASE("a module includes only the modules that its line in CMakeLists.txt names", "[house]") {
    const auto table = modules();
    REQUIRE(table.size() > 15);
    const std::regex own(R"re(^#include "(\w+)/)re");
    for (const auto& [name, module] : table)
        for (const fs::path& file : files_below(root / "src" / name, {".h", ".cpp"}))
            for (const std::string& other : includes_of(file, own)) {
                INFO(file << " includes " << other);
                const bool made = name == "syntax" && other == "generated";  // from grammar/
                CHECK((other == name || made || module.uses.count(other) == 1));
            }
}

TEST_CASE("each folder of src is a module", "[house]") {
    const auto table = modules();
    for (const fs::path& folder : folders_of_source())
        CHECK(table.count(folder.filename().string()) == 1);
}

TEST_CASE("a library is included only where its use is stated", "[house]") {
    const std::vector<std::pair<std::string, std::set<std::string>>> rules = {
        {"CGAL/", {"cgal"}},
        {"assimp/", {"imports"}},
        {"OpenImageIO/", {"oiio"}},
        {"glpk", {"solver"}},
        {"glm/", {"base"}},
        {"iostream", {"app", "tasks"}},
        {"seccomp", {"app"}},
        {"linux/", {"app"}},
        {"oneapi/", {"base", "index", "lighting"}}};
    const std::regex library(R"(^#include <(\S+)>)");
    for (const fs::path& file : files_below(root / "src", {".h", ".cpp"})) {
        const std::string module = file.parent_path().filename().string();
        for (const std::string& header : includes_of(file, library))
            for (const auto& [prefix, allowed] : rules) {
                INFO(file << " includes " << header);
                CHECK((header.rfind(prefix, 0) != 0 || allowed.count(module) == 1));
            }
    }
}

TEST_CASE("each source file has a test, and each test a source file", "[house]") {
    // What is tested through what uses it, by the folder or file that does.
    const std::set<std::string> elsewhere = {"app/main.cpp", "python/module.cpp"};
    for (const fs::path& file : files_below(root / "src", {".cpp"})) {
        const fs::path name = fs::relative(file, root / "src");
        if (*name.begin() == "system") continue;
        fs::path test = root / "tests" / name;
        test.replace_filename(file.stem().string() + "_test.cpp");
        INFO(name << " has no " << test);
        CHECK((fs::exists(test) || elsewhere.count(name.string()) == 1));
        INFO(name << " needs no exemption any more");
        CHECK_FALSE((fs::exists(test) && elsewhere.count(name.string()) == 1));
    }
    for (const fs::path& folder : folders_of_source())
        for (const fs::path& test : fs::exists(root / "tests" / folder.filename())
                                        ? files_below(root / "tests" / folder.filename(), {".cpp"})
                                        : std::vector<fs::path>()) {
            std::string stem = test.stem().string();
            REQUIRE(stem.size() > 5);
            stem.resize(stem.size() - 5);
            const fs::path base = folder / stem;
            INFO(test << " tests nothing of that name");
            CHECK((fs::exists(base.string() + ".cpp") || fs::exists(base.string() + ".h")));
        }
}

TEST_CASE("what stands in for a source on another system has its name", "[house]") {
    int count = 0;
    for (const fs::path& file : files_below(root / "src/system", {".h", ".cpp"})) {
        const fs::path module = file.parent_path(), system = module.parent_path();
        const fs::path source = root / "src" / module.filename() / file.filename();
        INFO(file << " stands in for nothing");
        CHECK(fs::exists(source));
        CHECK(system.parent_path() == root / "src/system");
        CHECK(fs::exists(system / "system.cmake"));
        ++count;
    }
    CHECK(count > 10);
}

TEST_CASE("the map of the source names every module", "[house]") {
    const std::string map = read(root / "src/README.md");
    REQUIRE_FALSE(map.empty());
    std::set<std::string> named;
    const std::regex row(R"(\n- `(src/)?(\w+)/`)");
    for (std::sregex_iterator i(map.begin(), map.end(), row), end; i != end; ++i)
        if ((*i)[1].matched) named.insert((*i)[2]);
    std::set<std::string> present;
    for (const fs::path& folder : folders_of_source()) present.insert(folder.filename().string());
    CHECK(named == present);
}

TEST_CASE("the README is an entrance, and leads to pages and pictures that there are", "[house]") {
    CHECK(fs::file_size(root / "README.md") <= 8192);
    const std::regex link(R"(!\[[^\]]*\]\(([^)]+)\)|`([\w/]+/README\.md)`)");
    for (const fs::path& page : files_below(root, {".md"})) {
        if (page.lexically_relative(root).string().starts_with("build")) continue;
        const std::string text = read(page);
        for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
            const bool picture = (*i)[1].matched;
            INFO(page << " leads to " << (*i)[0]);
            CHECK(fs::exists((picture ? page.parent_path() : root) / (*i)[picture ? 1 : 2].str()));
        }
    }
}

TEST_CASE("each file states its licence", "[house]") {
    const auto check = [](const fs::path& file, const std::string& licence) {
        std::vector<std::string> lines = lines_of(file);
        lines.resize(std::max<std::size_t>(lines.size(), 2));
        INFO(file << " does not state " << licence);
        CHECK((lines[0] + lines[1]).find("SPDX-License-Identifier: " + licence) !=
              std::string::npos);
    };
    for (const char* folder : {"src", "tests", "grammar", "man"})
        for (const fs::path& file :
             files_below(root / folder, {".h", ".cpp", ".yy", ".re", ".in", ".awk", ".sh", ".cmake"}))
            check(file, "GPL-3.0-or-later");
    for (const char* folder : {"stdlib", "examples"})
        for (const fs::path& file : files_below(root / folder, {".pov", ".inc"}))
            check(file, "CC0-1.0");
}

TEST_CASE("files stay short and lines narrow", "[house]") {
    constexpr std::size_t most = 600, aim = 300;
    std::string long_ones;
    for (const fs::path& file : files_below(root / "src", {".h", ".cpp"})) {
        const auto lines = lines_of(file);
        INFO(file);
        CHECK(lines.size() <= most);
        if (lines.size() > aim)
            long_ones +=
                "\n" + fs::relative(file, root).string() + ": " + std::to_string(lines.size());
        for (const std::string& line : lines) {
            // Characters, not bytes: a continuation byte is none.
            const auto width =
                std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; });
            INFO(line);
            CHECK(width <= 100);
        }
    }
    if (!long_ones.empty()) WARN("files of more than " << aim << " lines:" << long_ones);
}

TEST_CASE("functions stay small", "[house]") {
    constexpr std::size_t limit = 80;
    // A function begins in a line that ends in a brace, and ends where one stands as far to the left.
    const std::regex begins(
        R"(^( {0,4})(?! |namespace|struct|class|enum|union|extern|if |for |while )"
        R"(|switch |else|return|\}|//|#|public|private|template).*[^=] \{$)");
    for (const fs::path& file : files_below(root / "src", {".h", ".cpp"})) {
        const auto lines = lines_of(file);
        for (std::size_t first = 0; first < lines.size(); ++first) {
            std::smatch found;
            if (!std::regex_search(lines[first], found, begins)) continue;
            const std::string end = found[1].str() + "}";
            std::size_t last = first + 1;
            while (last < lines.size() && lines[last].rfind(end, 0) != 0) ++last;
            if (last == lines.size() || lines[last] != end) continue;  // what it begins is a value
            INFO(file << ":" << first + 1 << ": " << lines[first]);
            CHECK(last - first - 1 <= limit);
        }
    }
}

TEST_CASE("no order that the standard leaves open reaches a result", "[house]") {
    // base/order.h has orders that follow from the input. Sorting by operator< is allowed: what is
    // equal by it is the same. In cellular.cpp no two keys are equal, and the compiler sorts.
    const std::regex open(
        R"(\b(nth_element|partition|partial_sort(_copy)?|(push|pop|make|sort)_heap|)"
        R"(priority_queue|reduce|transform_reduce)\s*[(<])");
    const std::regex sorted(R"(std::(ranges::)?sort\()");
    const std::regex by_itself(
        R"(std::(ranges::sort\([\w.]+\)|sort\(([\w.]+)\.begin\(\)[ +\w]*, \2\.end\(\)\));)");
    for (const fs::path& file : files_below(root / "src", {".h", ".cpp"})) {
        if (file.filename() == "order.h" || file.filename() == "cellular.cpp") continue;
        for (const std::string& line : lines_of(file)) {
            INFO(file << ": " << line);
            CHECK_FALSE(std::regex_search(line, open));
            CHECK((!std::regex_search(line, sorted) || std::regex_search(line, by_itself)));
        }
    }
}

TEST_CASE("nothing needs more of ranges than clang 14 compiles", "[house]") {
    // With the C++ library of g++ 12 it takes neither views nor algorithms that return subranges.
    const std::regex unknown(
        R"(std::(views::|ranges::(unique|remove|remove_if|partition|stable_partition|rotate|)"
        R"(search|equal_range|find_end|subrange|views::)\b))");
    for (const char* folder : {"src", "tests"}) {
        for (const fs::path& file : files_below(root / folder, {".h", ".cpp"})) {
            if (file.filename() == "house_test.cpp") continue;
            for (const std::string& line : lines_of(file)) {
                INFO(file << ": " << line);
                CHECK_FALSE(std::regex_search(line, unknown));
            }
        }
    }
}

TEST_CASE("there are no mutable globals", "[house]") {
    for (const auto& [name, module] : modules()) {
        const fs::path archive = fs::path(CANDELABRA_BINARY).parent_path() / ("lib" + name + ".a");
        if (!fs::exists(archive)) continue;  // headers only
        std::istringstream symbols(output_of("objdump -tC '" + archive.string() + "'"));
        // Objects in writable sections; what the compiler guards or the libraries' headers bring
        // along is not ours.
        const std::regex writable(
            R"(^\S+\s+.*\sO\s+(\.data|\.bss|\.tbss|\.tdata)(\.(?!rel\.ro)\S*)?\s+\S+\s+(.*)$)");
        const std::regex local(R"(\)( const)?::\w+$)");  // constants of one function
        const std::regex foreign(
            R"(^(guard variable|\.hidden|DW\.|std::|tbb::|oneapi::|OpenImageIO|fmt::|__))");
        for (std::string line; std::getline(symbols, line);) {
            std::smatch match;
            if (!std::regex_match(line, match, writable) ||
                std::regex_search(match[3].str(), foreign) ||
                std::regex_search(match[3].str(), local))
                continue;
            FAIL_CHECK("lib" << name << ".a: " << match[3].str());
        }
    }
}

TEST_CASE("no function of the C library whose last bits depend on the machine is used", "[house]") {
    // base/elementary.h has those whose bits do not. Compilers may compute them with constants, so
    // that the sources are searched as well as the machine code, which has those of templates.
    const std::string names =
        "(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|"
        "erfc?|[lt]gamma|j[01n]|y[01n])[fl]?";
    const std::regex called("\\b(std|glm)::" + names + "\\b|__builtin_" + names +
                            "\\b|_distribution\\b|std::(shuffle|sample|generate_canonical)\\b");
    const std::regex header(R"(^#include <(complex|glm/gt[cx]/.*)>)");
    for (const fs::path& file : files_below(root / "src", {".h", ".cpp"}))
        for (const std::string& line : lines_of(file)) {
            INFO(file << ": " << line);
            CHECK_FALSE(std::regex_search(line, called));
            CHECK_FALSE(std::regex_search(line, header));
        }
    const std::regex symbol("^\\s*U (" + names + "|c(" + names +
                            "|sqrt[fl]?|abs[fl]?|arg[fl]?))(@.*)?$");
    const fs::path build = fs::path(CANDELABRA_BINARY).parent_path();
    int loaded = 0;
    for (const auto& [name, module] : modules())
        for (const std::string& file : {"lib" + name + ".a", "libcandelabra_" + name + ".so"}) {
            if (!fs::exists(build / file)) continue;
            const bool archive = file.ends_with(".a");
            loaded += !archive;
            std::istringstream symbols(
                output_of((archive ? "nm -u '" : "nm -Du '") + (build / file).string() + "'"));
            // By these, CGAL chooses how it searches for what is found in any case, and prints.
            const std::regex harmless(name == "cgal" ? R"(^\s*U (log|log10f|sincos)(@.*)?$)"
                                                     : "$.");
            for (std::string line; std::getline(symbols, line);)
                if (std::regex_match(line, symbol) && !std::regex_match(line, harmless))
                    FAIL_CHECK(file << ": " << line);
        }
    CHECK(loaded == 4);
}

TEST_CASE("each line of the threat model names tests that there are", "[house]") {
    std::string tests;
    for (const fs::path& path : files_below(root / "tests", {".cpp"})) tests += read(path);
    // Long names are broken over lines.
    tests = std::regex_replace(tests, std::regex("\"\\s+\""), "");
    int names = 0;
    for (const std::string& line : lines_of(root / "src/text/README.md")) {
        if (!line.starts_with("| ") || line == "| rule | test |" || line == "| may | test |")
            continue;
        const std::string cell = line.substr(line.rfind(" | ") + 3);
        const std::regex quoted("`([^`]+)`");
        for (std::sregex_iterator i(cell.begin(), cell.end(), quoted), end; i != end; ++i) {
            const std::string name = (*i)[1];
            INFO(name);
            ++names;
            if (name.starts_with("tests/"))
                CHECK(fs::exists(root / name));
            else if (name.starts_with("fuzz_"))
                CHECK(fs::exists(root / "tests/fuzz" / (name.substr(5) + "_fuzz.cpp")));
            else
                CHECK(tests.find("\"" + name + "\"") != std::string::npos);
        }
    }
    CHECK(names > 40);
}

}  // namespace candelabra
