// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/csv.h"

#include "text/message.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// "names | cells / cells": strings in quotes, nothing for an empty number; or the error.
std::string table_of(std::string_view text, const std::vector<std::string_view>& options = {},
                     std::size_t most = 1000) {
    CsvForm form;
    for (const std::string_view each : options) REQUIRE(form.take(each));
    CsvProblem problem;
    const auto table = read_csv(text, form, most, problem);
    if (!table) return problem.too_many ? "too many" : problem.message;
    std::string result;
    for (const std::string& name : table->names) result += name + " ";
    if (!table->names.empty()) result += "| ";
    for (std::size_t i = 0; i < table->rows * table->columns; ++i) {
        if (i > 0) result += i % table->columns == 0 ? " / " : " ";
        if (table->cells.empty()) {
            result += std::isnan(table->numbers[i]) ? "" : message(table->numbers[i]);
            continue;
        }
        const auto kind = table->kinds[i % table->columns];
        const std::string& cell = table->cells[i];
        result += kind == CsvTable::Kind::strings   ? "'" + cell + "'"
                  : kind == CsvTable::Kind::colours ? "colour " + cell
                                                    : cell;
    }
    return result;
}

}  // namespace

TEST_CASE("the first cell that makes a column of numbers text is known", "[csv]") {
    const auto strays = [](std::string_view text) {
        CsvProblem problem;
        const auto table = read_csv(text, {}, 1000, problem);
        REQUIRE(table);
        std::string result;
        for (const CsvStray& stray : table->strays)
            result += message(stray.column, ' ',
                              text.substr(stray.first, stray.last - stray.first), ' ');
        return result;
    };
    CHECK(strays("x,y\n1,2\n2,n/a\n3,4\n5,none\n") == "");  // half of y is text
    CHECK(strays("x,y\n1,2\n2,n/a\n3,4\n") == "1 n/a ");
    CHECK(strays("x,y,z\n1,0,0\n2,0,0\nTotal,,\n") == "0 Total ");
    CHECK(strays("id,x\na,1\nb,2\n") == "");
    CHECK(strays("1,2\n3,4\n") == "");
}

TEST_CASE("tables in the forms that programs write", "[csv]") {
    struct Case {
        const char* text;
        const char* table;
    };
    const Case cases[] = {
        {"1,2,3\n4,5,6\n", "1 2 3 / 4 5 6"},
        {"x,y\n1,2", "x y | 1 2"},
        {"\xEF\xBB\xBFx;y\r\n1,5;-2\r\n\r\n+3;4e2\r\n", "x y | 1.5 -2 / 3 400"},
        {"a\tb\n1\t\n\t2\n", "a b | 1  /  2"},
        {"x y  z\n 1 2\t3\n", "x y z | 1 2 3"},
        {"1 | 2\n3 | 4\n", "1 2 / 3 4"},
        {"1,\t2\n3,\t4", "1 2 / 3 4"},
        {"# by hand\n1, 2 // here\n\n// there\n3, 4 # and here\n", "1 2 / 3 4"},
        {"[0.1, 0.2, 0.3],\n[1, 2, 3],\n", "0.1 0.2 0.3 / 1 2 3"},
        {"[[1, 2],\n [3, 4]]", "1 2 / 3 4"},
        {"(1 2 3)\n(4 5 6)", "1 2 3 / 4 5 6"},
        {"1, 2,\n3, 4,\n", "1 2 / 3 4"},
        {"1, 2;\n3, 4;\n", "1 2 / 3 4"},
        {"1\n2\n3", "1 / 2 / 3"},
        {"name,x\nred,1\n\"a, \"\"b\"\"\",2", "name x | 'red' 1 / 'a, \"b\"' 2"},
        {"name,x\n\"two\nlines\",1\nb,", "name x | 'two\nlines' 1 / 'b' "},
        {"\"1\",\"2\"\n\"3\",\"4\"", "1 2 / 3 4"},
        {"#ff8800,1\n#00f,2", "colour #ff8800 1 / colour #00f 2"},
        {"x,n\n1,nan\n2,3", "x n | 1  / 2 3"},
        {"a,b\n1e-400,1e999", "a b | 1e-400 '1e999'"},
        {"x\n0x10", "x | '0x10'"},
        {"a,b\nx,y", "a b | 'x' 'y'"},
        {"(a),b\n1,2", "(a) b | 1 2"},
        {"12345678901234567890,0.1234567890123456789\n1,2",
         "1.2345678901234567e+19 0.12345678901234568 / 1 2"},
        {"1.000000000000000000e+00 2.5e-1\n1 2", "1 0.25 / 1 2"},
    };
    for (const Case& c : cases) {
        INFO(c.text);
        CHECK(table_of(c.text) == c.table);
    }
    CHECK(table_of("a\n0." + std::string(330, '0') + "1") == "a | 0");
}

TEST_CASE("options say what cannot be found", "[csv]") {
    CHECK(table_of("a,b\nc,d", {"no_header"}) == "'a' 'b' / 'c' 'd'");
    CHECK(table_of("2020,2021\n1,2", {"header"}) == "2020 2021 | 1 2");
    CHECK(table_of("a,b\n007,2", {"text"}) == "a b | '007' '2'");
    CHECK(table_of("a;b,c\n1;2,5", {"semicolon"}) == "a b,c | 1 2.5");
    CHECK(table_of("a;b,c\n1;2,5", {"comma"}) == "a;b c | '1;2' 5");
    CHECK(table_of("a b c", {"comma", "no_header"}) == "'a b c'");
    CHECK(table_of("a b\tc\n1\t2", {"tab"}) == "a b c | 1 2");
    CHECK(table_of("a|b", {"bar", "no_header"}) == "'a' 'b'");
    CHECK(table_of("a,b c", {"blank", "no_header"}) == "'a,b' 'c'");
    CsvForm form;
    CHECK_FALSE(form.take("comas"));
}

TEST_CASE("what is no table says why", "[csv]") {
    CHECK(table_of("") == "is empty");
    CHECK(table_of("// nothing\n\n") == "is empty");
    CHECK(table_of("x,y\n") == "has a header and no row");
    CHECK(table_of("x,y\n1,2\n3\n") == "has 1 cell, and the header has 2");
    CHECK(table_of("1,2\n3,4,5\n") == "has 3 cells, and the first row has 2");
    CHECK(table_of("a,b\nc,d,e") == "has 3 cells, and the header has 2");
    CHECK(table_of("a,b\n1,\"2\n3,4\n") == "begins a quoted cell that does not end");
    CHECK(table_of("a,b\n1,\"2\"3\n") == "has something behind a quoted cell");
    CHECK(table_of("1,2\n3,4\n5,6", {}, 4) == "too many");
    CHECK(table_of("1,2,3\n", {}, 2) == "too many");
    CHECK(table_of("a,b\nc,d\ne,f\n", {}, 3) == "too many");
}

TEST_CASE("the place of a short row is its line", "[csv]") {
    CsvProblem problem;
    const std::string_view text = "1,2\n3,4\n\n 5 \n6,7\n";
    CHECK_FALSE(read_csv(text, {}, 100, problem));
    CHECK(text.substr(problem.first, problem.last - problem.first) == "5");
}

TEST_CASE("numbers are rounded as everywhere", "[csv]") {
    std::string text;
    std::vector<double> expected;
    for (const char* each :
         {"0.1", "-0.3", "123456789.123456", "0.000000000000001", "999999999999999", "4.35", "1e22",
          "1.7976931348623157e308", "5e-324", ".5", "-.25"}) {
        text += std::string(each) + "\n";
        expected.push_back(std::strtod(each, nullptr));
    }
    CsvProblem problem;
    const auto table = read_csv(text, {}, 100, problem);
    REQUIRE(table);
    CHECK(table->numbers == expected);
}

TEST_CASE("colours of displays", "[csv]") {
    CHECK(csv_colour("#ff0033") == std::array<double, 4>{1, 0, 0.2, 1});
    CHECK(csv_colour("#f03") == std::array<double, 4>{1, 0, 0.2, 1});
    CHECK(csv_colour("#FF003333") == std::array<double, 4>{1, 0, 0.2, 0.2});
}

}  // namespace candelabra
