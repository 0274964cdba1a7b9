// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/csv_rows.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string cells_of(std::string_view line, char separator) {
    CsvRows rows(line, 100);
    std::vector<CsvCell> cells;
    CsvProblem problem;
    if (!rows.find_row()) return "none";
    if (!rows.take_row(separator, cells, problem)) return problem.message;
    std::string result;
    for (const CsvCell& each : cells) result += "[" + rows.content(each) + "]";
    return result;
}

}  // namespace

TEST_CASE("the cells of a line", "[csv]") {
    CHECK(cells_of("a, b ,,c", ',') == "[a][b][][c]");
    CHECK(cells_of("a  b\tc ", ' ') == "[a][b][c]");
    CHECK(cells_of("\"a b\" c \"d\"", ' ') == "[a b][c][d]");
    CHECK(cells_of(" \"a,b\" , c", ',') == "[a,b][c]");
    CHECK(cells_of("a,// c", ',') == "[a][// c]");
    CHECK(cells_of("a, b // c", ',') == "[a][b]");
    CHECK(cells_of("a\t\tb", '\t') == "[a][][b]");
    CHECK(cells_of("<1, 2>", ',') == "[1][2]");
    CHECK(cells_of("[1, 2], // c", ',') == "[1][2]");
    CHECK(cells_of("1, 2;", ',') == "[1][2]");
    CHECK(cells_of("#comment", ',') == "none");
    CHECK(cells_of("#abc,2", ',') == "[#abc][2]");
}

TEST_CASE("the separator of a line", "[csv]") {
    const auto separator = [](std::string_view line) { return CsvRows(line, 9).find_separator(); };
    CHECK(separator("a,b;c") == ';');
    CHECK(separator("a b,c") == ',');
    CHECK(separator("\"a;b\",c") == ',');
    CHECK(separator("a b\tc") == '\t');
    CHECK(separator("a|b c") == '|');
    CHECK(separator("a b") == ' ');
    CHECK(separator("1, 2;") == ',');
    CHECK(separator("alone") == ',');
}

TEST_CASE("a row of plain numbers is taken at once, or nothing of it", "[csv]") {
    std::vector<double> numbers;
    CsvRows rows("1, 2\r\n3,x\n", 9);
    CHECK(rows.take_numbers(',', 2, numbers));
    CHECK_FALSE(rows.take_numbers(',', 2, numbers));
    CHECK(numbers == std::vector<double>{1, 2});
    CHECK(rows.find_row());
    CHECK(rows.text().substr(rows.at()) == "3,x\n");
}

}  // namespace candelabra
