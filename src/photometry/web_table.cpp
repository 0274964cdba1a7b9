// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/web_table.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

constexpr double full_turn = 360, half_turn = 180, quarter_turn = 90;
constexpr double same_angle = 0.01;  ///< degrees

bool about(double a, double b) { return std::abs(a - b) <= same_angle; }

std::size_t rows(const WebTable& table) { return table.vertical.size(); }

std::vector<double> plane(const WebTable& table, std::size_t number) {
    const auto first = table.candela.begin() + static_cast<std::ptrdiff_t>(number * rows(table));
    return {first, first + static_cast<std::ptrdiff_t>(rows(table))};
}

void add_plane(WebTable& table, double angle, const std::vector<double>& values) {
    table.horizontal.push_back(angle);
    table.candela.insert(table.candela.end(), values.begin(), values.end());
}

/// Adds the planes that a mirror at the last one makes.
void mirror_at_end(WebTable& table) {
    const double end = table.horizontal.back();
    for (std::size_t i = table.horizontal.size() - 1; i-- > 0;)
        add_plane(table, 2 * end - table.horizontal[i], plane(table, i));
}

/// Puts what a mirror at the first plane makes before it.
void mirror_at_start(WebTable& table) {
    const double start = table.horizontal.front();
    WebTable made{table.type, table.vertical, {}, {}};
    for (std::size_t i = table.horizontal.size(); i-- > 1;)
        add_plane(made, 2 * start - table.horizontal[i], plane(table, i));
    for (std::size_t i = 0; i < table.horizontal.size(); ++i)
        add_plane(made, table.horizontal[i], plane(table, i));
    table = std::move(made);
}

/// The same for the vertical angles.
void mirror_rows_at_start(WebTable& table) {
    const double start = table.vertical.front();
    const std::size_t count = rows(table);
    std::vector<double> vertical, candela;
    for (std::size_t row = count; row-- > 1;) vertical.push_back(2 * start - table.vertical[row]);
    vertical.insert(vertical.end(), table.vertical.begin(), table.vertical.end());
    for (std::size_t p = 0; p < table.horizontal.size(); ++p) {
        const std::vector<double> values = plane(table, p);
        candela.insert(candela.end(), values.rbegin(), values.rend() - 1);
        candela.insert(candela.end(), values.begin(), values.end());
    }
    table.vertical = std::move(vertical);
    table.candela = std::move(candela);
}

/// Straight down and straight up all planes show the same direction, so they get their mean. The
/// table is closed.
void join_poles(WebTable& table, std::vector<std::string>& notes) {
    constexpr double noticeable = 0.05;
    for (const std::size_t row : {std::size_t{0}, rows(table) - 1}) {
        const double angle = table.vertical[row];
        if (!about(angle, 0) && !about(angle, half_turn)) continue;
        double sum = 0, least = table.candela[row], most = least;
        const std::size_t last = table.candela.size() - rows(table);  // the first plane again
        for (std::size_t at = row; at < last; at += rows(table)) {
            sum += table.candela[at];
            least = std::min(least, table.candela[at]);
            most = std::max(most, table.candela[at]);
        }
        if (least == most) continue;
        if (most - least > noticeable * most)
            notes.push_back(message("the planes differ at ", angle, " degrees, from ", least,
                                    " to ", most, " cd: their mean is taken"));
        const double mean = sum / static_cast<double>(table.horizontal.size() - 1);
        for (std::size_t at = row; at < table.candela.size(); at += rows(table))
            table.candela[at] = mean;
    }
}

/// Completes a table of type C by the range of its planes.
std::string complete_around(WebTable& table, std::string& symmetry,
                            std::vector<std::string>& notes) {
    const double first = table.horizontal.front(), span = table.horizontal.back() - first;
    if (table.horizontal.size() == 1) {
        if (!about(first, 0))
            notes.push_back(message("the only plane is at ", first, " degrees and not at 0"));
        symmetry = "axial";
        add_plane(table, first + full_turn, plane(table, 0));
    } else if (about(span, quarter_turn)) {
        symmetry = "quadrant";
        mirror_at_end(table);
        mirror_at_end(table);
    } else if (about(span, half_turn)) {
        double axis = std::fmod(first, half_turn);
        if (axis < 0) axis += half_turn;
        if (about(axis, half_turn)) axis = 0;
        symmetry = message("bilateral ", axis, "-", axis + half_turn);
        mirror_at_end(table);
    } else if (span > half_turn && span < full_turn + same_angle) {
        symmetry = "none";
    } else {
        return message("its planes go from ", first, " to ", table.horizontal.back(),
                       " degrees: a symmetry has planes over 90 or 180 degrees, others need 360");
    }
    return {};
}

/// Completes a table of type A or B, whose angles may begin at 0.
std::string complete_beam(WebTable& table, std::string& symmetry, std::vector<std::string>& notes) {
    const bool lateral = about(table.horizontal.front(), 0),
               vertical = about(table.vertical.front(), 0);
    if (table.horizontal.size() < 2) return "a table of type A or B needs two horizontal angles";
    if (lateral) mirror_at_start(table);
    if (vertical) {
        mirror_rows_at_start(table);
        notes.push_back(
            "the vertical angles begin at 0: what is above is taken to be the same below");
    }
    symmetry = lateral && vertical ? "quadrant"
               : lateral           ? "lateral"
               : vertical          ? "vertical"
                                   : "none";
    return {};
}

}  // namespace

PhotometricWeb closed_web(WebTable table, std::vector<std::string>& notes) {
    const double first = table.horizontal.front(), end = first + full_turn;
    const std::vector<double> start = plane(table, 0);
    if (about(table.horizontal.back(), end)) {
        const std::vector<double> again = plane(table, table.horizontal.size() - 1);
        if (again != start)
            notes.push_back(message("the planes ", first, " and ", table.horizontal.back(),
                                    " are the same direction and differ: ", first, " is taken"));
        table.horizontal.back() = end;
        std::ranges::copy(start, table.candela.end() - static_cast<std::ptrdiff_t>(rows(table)));
    } else {
        add_plane(table, end, start);
    }
    join_poles(table, notes);
    return PhotometricWeb(table.type, std::move(table.vertical), std::move(table.horizontal),
                          std::move(table.candela));
}

std::string complete_table(WebTable table, PhotometricWeb& web, std::string& symmetry,
                           std::vector<std::string>& notes) {
    const bool around = table.type == WebType::c;
    std::string problem =
        around ? complete_around(table, symmetry, notes) : complete_beam(table, symmetry, notes);
    if (!problem.empty()) return problem;
    if (!around) {
        web = PhotometricWeb(table.type, std::move(table.vertical), std::move(table.horizontal),
                             std::move(table.candela));
        return {};
    }
    if (!about(table.horizontal.back(), table.horizontal.front() + full_turn))
        notes.push_back(message("the plane ", table.horizontal.front() + full_turn,
                                " is missing: closed with plane ", table.horizontal.front()));
    web = closed_web(std::move(table), notes);
    return {};
}

}  // namespace candelabra
