// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/layout.h"

#include "editor/edited_file.h"
#include "text/loader.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <utility>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("indentation stops growing, and any nesting takes linear time") {
    constexpr std::size_t deep = 20'000;
    const auto repeated = [](std::string_view text, std::size_t times) {
        std::string result;
        for (std::size_t i = 0; i < times; ++i) result += text;
        return result;
    };
    for (const auto& [open, close] :
         {std::pair{"union {\n", "}\n"}, std::pair{"f(1 +\n", ")\n"},
          std::pair{"#if (1)\n", "#end\n"}, std::pair{"{\n#while (1)\n", "}\n#end\n"},
          std::pair{"{\n", "#break\n"}}) {
        INFO(open);
        const std::string text = repeated(open, deep) + repeated(close, deep);
        const std::string better = laid_out(text);
        CHECK(better.size() < text.size() + 260 * 4 * deep);
        CHECK(laid_out(better) == better);
    }
    const std::string better = laid_out(repeated("union {\n", 100) + repeated("}\n", 100));
    CHECK(better.find("\n" + std::string(256, ' ') + "union {\n") != std::string::npos);
    CHECK(better.find(std::string(257, ' ')) == std::string::npos);
}

TEST_CASE("texts are laid out") {
    struct Case {
        std::string_view written, better;
    };
    const Case cases[] = {
        {"", ""},
        {"\n\n  \n", ""},
        {"sphere{0,1}", "sphere{0,1}\n"},
        {"union {\nsphere { 0, 1\npigment { rgb 1 } }  \n}\n",
         "union {\n    sphere { 0, 1\n        pigment { rgb 1 } }\n}\n"},
        {"union { object {\nA\n}\n}\n", "union { object {\n    A\n}\n}\n"},
        {"#if (A)\nB\n#else\n#if (C) D\n#end\n#end\n",
         "#if (A)\n    B\n#else\n    #if (C) D\n    #end\n#end\n"},
        {"#switch (A)\n#case (1)\nB\n#break\n#else C\n#end\n",
         "#switch (A)\n    #case (1)\n        B\n    #break\n    #else C\n#end\n"},
        {"#declare A =\n1 +\n2;\n", "#declare A =\n    1 +\n    2;\n"},
        {"#declare A = f(1,\n2, (3 +\n4));\n",
         "#declare A = f(1,\n               2, (3 +\n                   4));\n"},
        {"matrix <\n1, A.x,\n0>\nB\n", "matrix <\n    1, A.x,\n    0>\nB\n"},
        {"#if (A < 1)\nB\n#end\n", "#if (A < 1)\n    B\n#end\n"},
        // Braces that branches leave open for the text after them.
        {"#if (M) merge {\n#else union {\n#end\nA\n}\nB\n",
         "#if (M) merge {\n#else union {\n#end\n    A\n}\nB\n"},
        // The include guard does not indent.
        {"#ifndef (A)\n#declare A = 1;\n#end\n", "#ifndef (A)\n#declare A = 1;\n#end\n"},
        {"A\n\n\n\n\nB\n\n", "A\n\n\nB\n"},
        {"A   \r\n  B\r\n", "A\r\nB\r\n"},
        // Comments and strings of several lines are kept unchanged.
        {"{\n/* one\n  two  \n*/  A\n}", "{\n    /* one\n  two  \n*/  A\n}\n"},
        {"{\n\"one  \n  two\" // three \n}", "{\n    \"one  \n  two\" // three\n}\n"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.written);
        CHECK(laid_out(each.written) == each.better);
        CHECK(laid_out(each.better) == each.better);
    }
}

namespace {

/// Returns the tokens without the blanks in and between them.
std::vector<std::string> words(const std::string& text) {
    Names names;
    const EditedFile file = read_tokens(text, names);
    std::vector<std::string> all;
    for (const Token& token : file.tokens) {
        std::string word(file.part({token.first, token.last}));
        if (token.kind != TokenKind::text) std::erase_if(word, [](char c) { return c <= ' '; });
        all.push_back(std::move(word));
    }
    return all;
}

}  // namespace

TEST_CASE("laying out the library and the examples changes no token, and nothing the second time") {
    int count = 0;
    for (const char* folder : {"stdlib", "examples"})
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(CANDELABRA_SOURCE_DIR) / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".pov" && ending != ".inc") continue;
            const std::string text = disk_reader()(entry.path().string()).value();
            const std::string better = laid_out(text);
            CAPTURE(entry.path());
            CHECK(words(better) == words(text));
            CHECK(laid_out(better) == better);
            ++count;
        }
    CHECK(count > 60);
}

namespace {

/// Returns the text with the lines of a part laid out; the part is between the two | signs.
std::string lines_laid_out(const std::string& marked) {
    const std::size_t first = marked.find('|');
    const std::size_t last = marked.find('|', first + 1) - 1;
    std::string text = marked;
    std::erase(text, '|');
    const auto part = [&](std::size_t from, std::size_t to) {
        return Part{static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)};
    };
    const LaidOutPart better = laid_out_lines(text, part(first, last));
    text.replace(better.place.first, better.place.last - better.place.first, better.text);
    const std::size_t end = better.place.first + better.text.size();
    const LaidOutPart again = laid_out_lines(text, part(better.place.first, end));
    CHECK(again.text ==
          std::string_view(text).substr(again.place.first, again.place.last - again.place.first));
    return text;
}

}  // namespace

TEST_CASE("lines of a part are laid out below what stands around them") {
    CHECK(lines_laid_out("union {\n  sphere {\n|0, 1\n}|\n }\n") ==
          "union {\n  sphere {\n      0, 1\n  }\n }\n");
    CHECK(lines_laid_out("union {\n\tsphere {\n0|, |1 \n}}\n") ==
          "union {\n\tsphere {\n        0, 1\n}}\n");
    // A part that ends at the beginning of a line does not include that line.
    CHECK(lines_laid_out("|  A\n|  B\n") == "A\n  B\n");
    CHECK(lines_laid_out("  A\n||  B\n") == "  A\nB\n");
    CHECK(lines_laid_out("A\n\n\n|\n\nB|") == "A\n\n\nB\n");
    CHECK(lines_laid_out("A\n|\n\n|") == "A\n");
    CHECK(lines_laid_out("||").empty());
    CHECK(lines_laid_out("{\n/* one\n|  two|\n*/  A\n}\n") == "{\n/* one\n  two\n*/  A\n}\n");
}

TEST_CASE("lines of a text that is laid out stay as they are") {
    int count = 0;
    for (const char* folder : {"stdlib", "examples/gallery", "examples/lights"})
        for (const auto& entry : fs::directory_iterator(fs::path(CANDELABRA_SOURCE_DIR) / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".pov" && ending != ".inc") continue;
            const std::string text = laid_out(disk_reader()(entry.path().string()).value());
            for (std::size_t i = 0; i < 9; ++i) {
                const Part part{static_cast<std::uint32_t>(i * text.size() / 9),
                                static_cast<std::uint32_t>((i + 1) * text.size() / 9)};
                const LaidOutPart same = laid_out_lines(text, part);
                CAPTURE(entry.path(), i);
                CHECK(same.text ==
                      text.substr(same.place.first, same.place.last - same.place.first));
                ++count;
            }
        }
    CHECK(count > 400);
}

TEST_CASE("the part that is all lines gets the layout of all lines") {
    for (const std::string text :
         {"", " ", "\n\n", "union{\nA\n}", "#if(A)\nB\n#else\nC\n#end", "A \r\n B\r\n\r\n"}) {
        CAPTURE(text);
        const LaidOutPart all = laid_out_lines(text, {0, static_cast<std::uint32_t>(text.size())});
        CHECK(all.text == laid_out(text));
        CHECK(all.place.last == text.size());
    }
}

}  // namespace candelabra
