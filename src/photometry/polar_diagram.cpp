// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/polar_diagram.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr int turn_degrees = 360;
// Of the picture, in its own units.
constexpr double paper_size = 520, middle_x = 260, middle_y = 270, radius = 210, foot = 60;

std::string rounded(double value) { return message(std::round(100 * value) / 100); }

/// Rounds up to 1, 2 or 5 times a power of ten.
double round_step(double least) {
    double power = 1;
    while (power > least) power /= 10;
    while (power * 10 <= least) power *= 10;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least) return factor * power;
    return 10 * power;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
    return message("<text x=\"", rounded(x), "\" y=\"", rounded(y), "\" text-anchor=\"", anchor,
                   "\">", escaped(text), "</text>\n");
}

/// A point of the diagram: straight down is below the middle, positive angles are on the right.
Vec2 on_paper(double degrees, double distance) {
    const auto [sine, cosine] = math::sin_cos(degrees * radians_per_degree);
    return {middle_x + radius * distance * sine, middle_y + radius * distance * cosine};
}

/// Circles of intensity and rays of angles.
std::string grid(double step, double most) {
    std::string svg = "<g fill=\"none\" stroke=\"#c8c8c8\">\n";
    for (double value = step; value < most * 1.001; value += step)
        svg += message("<circle cx=\"", rounded(middle_x), "\" cy=\"", rounded(middle_y), "\" r=\"",
                       rounded(radius * value / most), "\"/>\n");
    constexpr int apart = 30;
    for (int angle = 0; angle < turn_degrees; angle += apart) {
        const Vec2 end = on_paper(angle, 1);
        svg += message("<path d=\"M", rounded(middle_x), ' ', rounded(middle_y), 'L',
                       rounded(end.x), ' ', rounded(end.y), "\"/>\n");
    }
    svg += "</g>\n<g font-size=\"11\" fill=\"#666\">\n";
    for (double value = step; value < most * 1.001; value += step)
        svg += label(middle_x + 3, middle_y + radius * value / most - 3, "start",
                     message(std::round(1e6 * value) / 1e6));
    for (int angle = apart; angle < turn_degrees / 2; angle += apart)
        for (const int sign : {-1, 1}) {
            const Vec2 at = on_paper(sign * angle, 1.06);
            svg += label(at.x, at.y + 4, "middle", message(angle));
        }
    return svg + "</g>\n";
}

std::string curve(const PhotometricWeb& web, const WebSection& section, double most) {
    std::string path;
    for (int angle = -turn_degrees / 2; angle <= turn_degrees / 2; ++angle) {
        const Vec2 at = on_paper(angle, intensity_in(web, section, angle) / most);
        path += message(path.empty() ? "M" : "L", rounded(at.x), ' ', rounded(at.y));
    }
    return message("<path d=\"", path, "\" fill=\"none\" stroke=\"",
                   section.solid ? "#b03000\"" : "#0050a0\" stroke-dasharray=\"7 4\"",
                   " stroke-width=\"2\"/>\n");
}

double greatest_in(const PhotometricWeb& web, const std::array<WebSection, 2>& sections) {
    double greatest = 0;
    for (const WebSection& section : sections)
        for (int angle = 0; angle < 2 * turn_degrees; ++angle)
            greatest = std::max(greatest, intensity_in(web, section, angle / 2.0));
    return greatest;
}

}  // namespace

std::array<WebSection, 2> sections_of(const PhotometricFile& file) {
    const Vec3 x(1, 0, 0), y(0, 1, 0), down(0, 0, -1);
    if (file.web.type() == WebType::a)
        return {WebSection{"vertical plane of the beam", x, -down, true},
                WebSection{"horizontal plane of the beam", x, -y, false}};
    const bool eulumdat = file.version == 0;
    // Which way the luminaire lies is a convention of each format, and files break it.
    return {WebSection{eulumdat ? "C0-C180, across the luminaire" : "0-180, along the luminaire",
                       down, x, true},
            WebSection{eulumdat ? "C90-C270, along the luminaire" : "90-270, across the luminaire",
                       down, y, false}};
}

double intensity_in(const PhotometricWeb& web, const WebSection& section, double degrees) {
    const auto [sine, cosine] = math::sin_cos(degrees * radians_per_degree);
    return web.intensity(cosine * section.start + sine * section.side);
}

double width_of_beam(const PhotometricWeb& web, const WebSection& section, double share) {
    constexpr int parts = 10;  // of a degree
    constexpr int half = turn_degrees / 2 * parts;
    const auto at = [&](int place) {
        return intensity_in(web, section, static_cast<double>(place) / parts);
    };
    int peak = 0;
    double most = at(0);
    for (int place = -half; place <= half; ++place)
        if (const double here = at(place); here > most) {
            most = here;
            peak = place;
        }
    if (!(most > 0)) return 0;
    int low = peak, high = peak;
    while (low > peak - half && at(low - 1) >= share * most) --low;
    while (high < peak + half && at(high + 1) >= share * most) ++high;
    return std::min(static_cast<double>(high - low) / parts, static_cast<double>(turn_degrees));
}

std::string polar_text(const PhotometricFile& file) {
    constexpr int columns = 61, lines = 31;  // cells are twice as high as wide
    const auto sections = sections_of(file);
    const double most = greatest_in(file.web, sections);
    std::array<std::string, lines> cells;
    cells.fill(std::string(columns, ' '));
    for (int line = 0; line < lines; ++line)
        cells[static_cast<std::size_t>(line)][columns / 2] = '|';
    cells[lines / 2] = std::string(columns, '-');
    cells[lines / 2][columns / 2] = '+';
    for (const WebSection& section : sections)
        for (int angle = 0; angle < 2 * turn_degrees; ++angle) {
            const double degrees = angle / 2.0;
            const double distance = most > 0 ? intensity_in(file.web, section, degrees) / most : 0;
            if (distance == 0) continue;
            const auto [sine, cosine] = math::sin_cos(degrees * radians_per_degree);
            const auto across = std::lround((columns / 2) * (1 + distance * sine)),
                       down = std::lround((lines / 2) * (1 + distance * cosine));
            char& cell = cells[static_cast<std::size_t>(down)][static_cast<std::size_t>(across)];
            const char mark = section.solid ? '*' : 'o', other = section.solid ? 'o' : '*';
            cell = cell == other || cell == '@' ? '@' : mark;
        }
    std::string text;
    for (const std::string& line : cells)
        text +=
            message("  ", std::string_view(line).substr(0, line.find_last_not_of(' ') + 1), '\n');
    return text + message("  * ", sections[0].name, "    o ", sections[1].name, '\n');
}

std::string polar_diagram(const PhotometricFile& file, std::string_view title) {
    const auto sections = sections_of(file);
    const double greatest = greatest_in(file.web, sections);
    constexpr int circles = 5;
    const double step = greatest > 0 ? round_step(greatest / circles) : 1;
    const double most = step * std::max(std::ceil(greatest / step), 1.0);
    std::string svg =
        message("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", rounded(paper_size),
                ' ', rounded(paper_size + foot),
                "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" "
                "fill=\"#fff\"/>\n<g font-size=\"15\" fill=\"#222\">\n",
                label(middle_x, 26, "middle", title), "</g>\n", grid(step, most));
    for (const WebSection& section : sections) svg += curve(file.web, section, most);
    svg += "<g font-size=\"13\">\n<g fill=\"#b03000\">" +
           label(20, paper_size + 12, "start", message("\xe2\x80\x94 ", sections[0].name)) +
           "</g><g fill=\"#0050a0\">" +
           label(20, paper_size + 32, "start", message("- - ", sections[1].name)) +
           "</g><g fill=\"#222\">" + label(paper_size - 20, paper_size + 12, "end", "candela") +
           label(paper_size - 20, paper_size + 32, "end",
                 message("flux ", std::round(10 * file.web.flux()) / 10, " lm, maximum ",
                         std::round(10 * file.web.greatest()) / 10, " cd")) +
           "</g>\n</g>\n</svg>\n";
    return svg;
}

}  // namespace candelabra
