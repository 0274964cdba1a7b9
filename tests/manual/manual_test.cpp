// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the manual that teach: every scene in them renders, every part of a scene fits the
// scene before it, every command is one, and the example of each library macro works.
#include "editor/library_guide.h"
#include "options/options.h"
#include "session/lookalikes.h"
#include "support/shell.h"
#include "text/ascii.h"
#include "text/trimmed.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

namespace candelabra {

namespace {

const std::string source = CANDELABRA_SOURCE_DIR;

/// An example in a page: `.\" scene ring.pov` and what stands between .nf and .fi behind it.
struct Block {
    std::string kind, name, text;
};

std::string unescaped(const std::string& line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] != '\\' || i + 1 == line.size()) {
            text += line[i];
            continue;
        }
        ++i;
        if (line[i] == 'e') text += '\\';
        if (line[i] == '-') text += '-';
    }
    return text;
}

std::vector<Block> blocks_of(const std::string& page) {
    std::ifstream file(source + "/man/" + page + ".in");
    REQUIRE(file);
    std::vector<Block> blocks;
    const std::string sign = ".\\\" ";
    std::string line;
    bool inside = false;
    while (std::getline(file, line)) {
        if (line == ".fi") inside = false;
        if (inside) blocks.back().text += unescaped(line) + "\n";
        if (line == ".nf") inside = !blocks.empty();
        if (!line.starts_with(sign) || line.find("SPDX") != std::string::npos) continue;
        std::istringstream words(line.substr(sign.size()));
        Block block;
        words >> block.kind >> block.name;
        blocks.push_back(block);
    }
    return blocks;
}

/// The mean of all bytes of a PPM file behind its header of three lines.
double brightness(const std::string& ppm) {
    std::size_t at = 0;
    for (int line = 0; line < 3; ++line) at = ppm.find('\n', at) + 1;
    double sum = 0;
    for (std::size_t i = at; i < ppm.size(); ++i) sum += static_cast<unsigned char>(ppm[i]);
    return sum / static_cast<double>(ppm.size() - at);
}

void check_scene(Shell& shell, const std::string& name) {
    INFO(name);
    const int status = shell({shell.path(name), "+W32", "+H24", "--samples", "4",
                              "+O" + shell.path("out.ppm"), "+FP", "+WT1"});
    CAPTURE(shell.err);
    REQUIRE(status == 0);
    CHECK_FALSE(has(shell.err, "warning"));
    CHECK(brightness(shell.content("out.ppm")) > 4);
}

void check_command(const std::string& line) {
    INFO(line);
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        std::erase(word, '\'');  // the shell's
        words.push_back(word);
    }
    REQUIRE(words.size() > 1);
    CHECK(words[0] == "candelabra");
    if (words[1] == "develop" || words[1] == "share" ||
        words[1] == "relight") {  // options of a run, and others
        Shell shell;
        CHECK(shell({words.begin() + 1, words.end()}) == exit_status::file);
        CHECK(has(shell.err, "`" + words[2] + "`"));
        return;
    }
    const std::vector<std::string_view> arguments(words.begin() + 1, words.end());
    Diagnostics diagnostics;
    const Reader reader = [](const std::string&) { return "Input_File_Name=scene.pov\n"; };
    const Options options = read_options(arguments, diagnostics, reader);
    CHECK(diagnostics.all().empty());
    CHECK(options.scene.has_value());
}

/// The fenced blocks of Markdown. Their languages have the meanings that man/markdown.awk states.
std::vector<Block> blocks_of_markdown(const std::string& page) {
    std::ifstream file(source + "/man/" + page);
    REQUIRE(file);
    std::vector<Block> blocks;
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("```")) {
            if (inside) blocks.back().text += line + "\n";
            continue;
        }
        inside = !inside;
        if (!inside) continue;
        std::istringstream words(line.substr(3));
        std::string language;
        Block block;
        words >> language >> block.name;
        if (language == "pov") block.kind = block.name.empty() ? "fragment" : "scene";
        if (language == "csv") block.kind = "file";
        if (language == "sh") block.kind = "command";
        if (language == "text") block.kind = "output";
        INFO(line);
        CHECK_FALSE(block.kind.empty());
        blocks.push_back(block);
    }
    CHECK_FALSE(inside);
    return blocks;
}

void check_blocks(const std::vector<Block>& blocks, std::size_t scenes) {
    Shell shell;
    shell.library = source + "/stdlib";
    std::string whole;
    std::size_t count = 0;
    for (const Block& block : blocks) {
        if (block.kind == "file") shell.write(block.name, block.text);
        if (block.kind == "scene") {
            ++count;
            whole = block.text;
            shell.write(block.name, whole);
            check_scene(shell, block.name);
        }
        if (block.kind == "fragment") {
            REQUIRE_FALSE(whole.empty());
            shell.write("with_fragment.pov", whole + block.text);
            check_scene(shell, "with_fragment.pov");
        }
        if (block.kind == "command") {
            std::istringstream lines(block.text);
            for (std::string line; std::getline(lines, line);) check_command(line);
        }
    }
    CHECK(count == scenes);
}

void check_page(const std::string& page, std::size_t scenes) {
    INFO(page);
    check_blocks(blocks_of(page), scenes);
}

std::vector<double> numbers_of(std::string list) {
    std::ranges::replace(list, ',', ' ');
    std::istringstream stream(list);
    std::vector<double> result;
    for (double number; stream >> number;) result.push_back(number);
    return result;
}

/// The macro's example as a scene that prints the value with #debug.
std::string script_of(const LibraryMacro& macro, const std::string& file) {
    const std::string start =
        "#version 3.7; #include \"" + file +
        "\"\n#declare Stream = seed(1);\n"
        "#declare Bulb = sphere { 0, 0.06 pigment { rgb 1 } finish { emission 12 } }\n";
    const std::string& text = macro.example;
    if (macro.value.empty())
        return start + (file == "strings.inc" && !has(text, "sphere") ? "#debug " : "") + text +
               "\n";
    const std::size_t count = numbers_of(macro.value).size();
    const std::size_t last = text.rfind("; ");
    const std::size_t cut = last == std::string::npos ? 0 : last + 2;
    const std::string vector = count > 1 ? text.substr(cut) : text.substr(cut) + "*<1, 1>";
    return start + text.substr(0, cut) + "\n#debug vstr(" +
           std::to_string(std::max<std::size_t>(count, 2)) + ", " + vector + ", \",\", 0, 6)\n";
}

}  // namespace

TEST_CASE("the tutorial's scenes render, and its commands are commands", "[manual]") {
    check_blocks(blocks_of_markdown("tutorial.md"), 9);
}

TEST_CASE("the scenes of the page about lights render", "[manual]") {
    check_page("candelabra-lights.7", 9);
}

TEST_CASE("the scenes of the page for those from POV-Ray render", "[manual]") {
    check_page("candelabra-povray.7", 2);
}

TEST_CASE("the scene of the library's page renders", "[manual]") {
    check_page("candelabra-stdlib.7", 1);
}

TEST_CASE("each macro of the library that is for scenes has help and an example that works",
          "[manual]") {
    Shell shell;
    shell.library = source + "/stdlib";
    shell.write("lamps.csv", "x,y,z\n-1,0.6,0\n0,1.4,0\n1,0.6,0\n");
    shell.write("strings.csv", "x,y,z,string\n-1,0.6,0,Left\n0,1.4,0,Right\n1,0.6,0,Right\n");
    shell.write("film.csv", "255,0,0,0,255,0,0,0,255\n0,0,255,255,255,0,255,0,0\n");
    std::size_t count = 0;
    for (const LibraryFile& file : library_guide(shell.library))
        for (const LibraryMacro& macro : file.macros) {
            if (!macro.listed) continue;
            ++count;
            INFO(macro.name);
            CHECK_FALSE(macro.help.empty());
            REQUIRE_FALSE(macro.example.empty());
            shell.write("example.pov", script_of(macro, file.name));
            const int status = shell({shell.path("example.pov"), "--check", "--warn", "none",
                                      "--allow-write", shell.folder.string()});
            CAPTURE(shell.err);
            CHECK(status == 0);
            const std::vector<double> wanted = numbers_of(macro.value);
            const std::vector<double> told = numbers_of(shell.out + shell.err);
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                REQUIRE(i < told.size());
                CHECK(std::abs(told[i] - wanted[i]) < 1e-4);
            }
        }
    CHECK(count > 200);
}

TEST_CASE("each macro of the library that is for scenes states which arguments it accepts",
          "[manual]") {
    // Names that the macro declares for its caller.
    const std::set<std::string> results = {"Extents(Low", "Extents(High", "Isect(Point",
                                           "IsectN(Point", "IsectN(Normal"};
    std::size_t count = 0;
    for (const LibraryFile& file : library_guide(source + "/stdlib")) {
        std::ifstream stream(source + "/stdlib/" + file.name);
        const std::string text(std::istreambuf_iterator<char>(stream), {});
        for (const LibraryMacro& macro : file.macros) {
            const std::size_t at = text.find("#macro " + macro.name + "(");
            if (!macro.listed || at == std::string::npos) continue;
            const std::size_t open = text.find('(', at) + 1;
            std::istringstream list(text.substr(open, text.find(')', open) - open));
            for (std::string parameter; std::getline(list, parameter, ',');) {
                std::istringstream words(parameter);
                std::string name, kind;
                words >> name >> kind;
                if (name == "optional") words >> kind;
                INFO(file.name << ": " << macro.name << ": " << name);
                const bool states = !kind.empty() || name.find('[') != std::string::npos;
                CHECK((states || name.empty() || results.contains(macro.name + "(" + name)));
                ++count;
            }
        }
    }
    CHECK(count > 500);
}

TEST_CASE("the page on POV-Ray lists the looks that are only alike", "[manual]") {
    std::ifstream file(source + "/man/candelabra-povray.7.in");
    std::string page((std::istreambuf_iterator<char>(file)), {});
    std::ranges::replace(page, '\n', ' ');
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source + "/stdlib")) {
        std::ifstream library(entry.path());
        for (std::string line; std::getline(library, line);) {
            if (!line.starts_with(alike_mark)) continue;
            std::string_view list = std::string_view(line).substr(alike_mark.size());
            while (!list.empty()) {
                const std::string_view one = trimmed(take_until(list, ","), " ");
                INFO(entry.path().filename().string() << ": " << one);
                CHECK(page.find(one) != std::string::npos);
                ++found;
            }
        }
    }
    CHECK(found > 20);
}

}  // namespace candelabra
