// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/isolines.h"

#include "base/order.h"
#include "film/plate_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

constexpr std::uint32_t no_edge = UINT32_MAX;

/// The middle one of the numbers of a pixel and its eight neighbours, without those that are not
/// finite; 0 if there is none.
double middle_around(const NumberField& field, int x, int y) {
    std::array<double, 9> around{};
    std::size_t count = 0;
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) {
            // Beyond the edge it goes on as at the edge.
            const double value =
                field.at(std::clamp(i, 0, field.width - 1), std::clamp(j, 0, field.height - 1));
            if (std::isfinite(value)) around[count++] = value;
        }
    if (count == 0) return 0;
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(count / 2);
    put_nth(around.begin(), middle, around.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

/// Calls make(x, y) for each pixel of a field of that size.
template <class Make>
NumberField made_field(int width, int height, const Make& make) {
    NumberField field{width, height, {}};
    field.numbers.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) field.numbers.push_back(make(x, y));
    return field;
}

/// The field with each number averaged with those `apart` pixels away and twice that, by the
/// weights of a spline, and less the more it differs from them in units of the noise.
NumberField averaged(const NumberField& field, const NumberField& noise, int apart) {
    constexpr std::array<double, 5> spline = {1, 4, 6, 4, 1};
    return made_field(field.width, field.height, [&](int x, int y) {
        const double here = field.at(x, y), unit = noise.at(x, y);
        if (!(unit > 0)) return here;
        double sum = 0, weights = 0;
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) {
                const int u = x + i * apart, v = y + j * apart;
                if (u < 0 || v < 0 || u >= field.width || v >= field.height) continue;
                const double there = field.at(u, v), away = (there - here) / unit;
                const double near = std::fmax(1 - away * away / 9, 0);
                const double weight = spline[static_cast<std::size_t>(i + 2)] *
                                      spline[static_cast<std::size_t>(j + 2)] * near * near;
                sum += weight * there;
                weights += weight;
            }
        return sum / weights;
    });
}

/// Finds the lines of one value. Crossings of the edges between neighbouring pixels are joined
/// across the squares of four pixels.
class LineFinder {
public:
    LineFinder(const NumberField& field, double step) : field_(field), step_(step) {}

    void find(double value, double shortest, std::vector<Isoline>& lines) {
        value_ = value;
        next_.assign(2 * field_.numbers.size(), {no_edge, no_edge});
        std::vector<std::uint32_t> begun;
        for (int y = 0; y + 1 < field_.height; ++y)
            for (int x = 0; x + 1 < field_.width; ++x) join(x, y, begun);
        // Lines with ends first, then closed ones.
        for (const bool closed : {false, true})
            for (const std::uint32_t edge : begun) {
                const auto& [one, other] = next_[edge];
                if (one == no_edge || (other == no_edge) == closed) continue;
                Isoline line = followed(edge);
                if (line.length >= shortest) lines.push_back(std::move(line));
            }
    }

private:
    std::uint32_t edge(int x, int y, bool downward) const {
        return 2 * (static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(field_.width) +
                    static_cast<std::uint32_t>(x)) +
               (downward ? 1 : 0);
    }

    void connect(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& begun) {
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
            auto& ways = next_[from];
            (ways[0] == no_edge ? ways[0] : ways[1]) = to;
            begun.push_back(from);
        }
    }

    void join(int x, int y, std::vector<std::uint32_t>& begun) {
        const std::array<double, 4> corners = {field_.at(x, y), field_.at(x + 1, y),
                                               field_.at(x + 1, y + 1), field_.at(x, y + 1)};
        const auto [least, most] = std::ranges::minmax(corners);
        if (least >= value_ || most < value_ || most - least > step_) return;
        const std::array<std::uint32_t, 4> edges = {edge(x, y, false), edge(x + 1, y, true),
                                                    edge(x, y + 1, false), edge(x, y, true)};
        std::array<std::uint32_t, 4> crossed{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if ((corners[k] >= value_) != (corners[(k + 1) % 4] >= value_))
                crossed[count++] = edges[k];
        if (count == 2) return connect(crossed[0], crossed[1], begun);
        // A saddle: its middle decides which corners hang together.
        const double middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        const std::size_t turn = (middle >= value_) == (corners[0] >= value_) ? 0 : 1;
        connect(crossed[turn], crossed[turn + 1], begun);
        connect(crossed[turn + 2], crossed[(turn + 3) % 4], begun);
    }

    Vec2 crossing(std::uint32_t edge) const {
        const auto width = static_cast<std::uint32_t>(field_.width);
        const auto x = static_cast<int>(edge / 2 % width), y = static_cast<int>(edge / 2 / width);
        const bool downward = edge % 2 == 1;
        const double from = field_.at(x, y),
                     to = downward ? field_.at(x, y + 1) : field_.at(x + 1, y);
        const double share = (value_ - from) / (to - from);
        return Vec2(x + 0.5, y + 0.5) + share * (downward ? Vec2(0, 1) : Vec2(1, 0));
    }

    /// The line from an edge on, which is taken out of the list of connections.
    Isoline followed(std::uint32_t from) {
        Isoline line{value_, {crossing(from)}, 0};
        while (true) {
            const std::uint32_t to = next_[from][0] != no_edge ? next_[from][0] : next_[from][1];
            if (to == no_edge) return line;
            std::ranges::replace(next_[from], to, no_edge);
            auto& back = next_[to];
            (back[0] == from ? back[0] : back[1]) = no_edge;
            const Vec2 point = crossing(to);
            line.length += glm::length(point - line.points.back());
            line.points.push_back(point);
            from = to;
        }
    }

    const NumberField& field_;
    double step_;
    double value_ = 0;
    std::vector<std::array<std::uint32_t, 2>> next_;  ///< from each edge
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
    return glm::length(p - a - share * along);
}

/// A part of the picture, from the first pixel up to before the last.
struct PlateBox {
    int left, top, right, bottom;

    bool meets(const PlateBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// Draws lines into a buffer of coverages, chooses gaps in them for numbers, and paints all.
class LinePainter {
public:
    LinePainter(const IsolineLook& look, int bottom, Image& picture)
        : look_(look),
          picture_(picture),
          height_(std::min(bottom, picture.height)),
          cover_(picture.pixels.size(), 0.0F),
          line_(picture.pixels.size(), 0) {}

    void paint(const std::vector<Isoline>& lines) {
        for (std::uint32_t i = 0; i < lines.size(); ++i) draw(lines[i], i);
        std::vector<std::pair<PlateBox, const Isoline*>> labels;
        for (std::uint32_t i = 0; i < lines.size(); ++i)
            if (const auto box = place_of_number(lines[i], i, labels))
                labels.emplace_back(*box, &lines[i]);
        for (const auto& [box, line] : labels)
            for (int y = box.top; y < box.bottom; ++y)
                for (int x = box.left; x < box.right; ++x) cover_[number(x, y)] = 0;
        for (std::size_t i = 0; i < cover_.size(); ++i)
            if (cover_[i] > 0)
                picture_.pixels[i] = mix(picture_.pixels[i], look_.colour(lines[line_[i]].value),
                                         static_cast<double>(cover_[i]));
        for (const auto& [box, line] : labels)
            write_text(picture_, {box.left + margin(), box.top + margin()}, look_.text(line->value),
                       look_.size, look_.colour(line->value));
    }

private:
    std::size_t number(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
               static_cast<std::size_t>(x);
    }
    int margin() const { return 2 * look_.size; }

    void draw(const Isoline& line, std::uint32_t own) {
        const double half = 0.35 + 0.25 * look_.size;
        for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
            const Vec2 a = line.points[k], b = line.points[k + 1];
            const Vec2 low = min(a, b) - Vec2(half + 1), high = max(a, b) + Vec2(half + 1);
            for (int y = std::max(static_cast<int>(low.y), 0);
                 y < std::min(static_cast<int>(high.y) + 1, height_); ++y)
                for (int x = std::max(static_cast<int>(low.x), 0);
                     x < std::min(static_cast<int>(high.x) + 1, picture_.width); ++x) {
                    const double away = distance_to_segment(Vec2(x + 0.5, y + 0.5), a, b);
                    const auto cover = static_cast<float>(std::clamp(half + 0.5 - away, 0.0, 1.0));
                    const std::size_t pixel = number(x, y);
                    if (!(cover > cover_[pixel])) continue;
                    cover_[pixel] = cover;
                    line_[pixel] = own;
                }
        }
    }

    /// Where the number of a line stands: around one of its points, with little of other lines in
    /// the way, where the line is straight. Nothing for lines that are short beside their number.
    std::optional<PlateBox> place_of_number(
        const Isoline& line, std::uint32_t own,
        const std::vector<std::pair<PlateBox, const Isoline*>>& taken) const {
        const int width =
                      text_width(look_.text(line.value), look_.size) - look_.size + 2 * margin(),
                  height = letter_height * look_.size + 2 * margin();
        if (line.length < 4.0 * width) return {};
        std::optional<PlateBox> best;
        double least = 0.3 * width * height;
        const std::size_t steps = std::max<std::size_t>(line.points.size() / 64, 1);
        for (std::size_t k = 0; k < line.points.size(); k += steps) {
            const int left = static_cast<int>(line.points[k].x) - width / 2,
                      top = static_cast<int>(line.points[k].y) - height / 2;
            const PlateBox box{left, top, left + width, top + height};
            if (left < 0 || top < 0 || box.right > picture_.width || box.bottom > height_) continue;
            const PlateBox wide{left - width, top - height, box.right + width, box.bottom + height};
            if (std::ranges::any_of(taken,
                                    [&](const auto& each) { return wide.meets(each.first); }))
                continue;
            double others = 0, covered = 0;
            for (int y = top; y < box.bottom; ++y)
                for (int x = left; x < box.right; ++x) {
                    const auto cover = static_cast<double>(cover_[number(x, y)]);
                    (line_[number(x, y)] == own ? covered : others) += cover;
                }
            const double cost = 4 * others + covered;
            if (cost >= least) continue;
            least = cost;
            best = box;
        }
        return best;
    }

    const IsolineLook& look_;
    Image& picture_;
    int height_;
    std::vector<float> cover_;         ///< of each pixel by a line
    std::vector<std::uint32_t> line_;  ///< that covers the pixel
};

}  // namespace

NumberField calmed(const Image& values) {
    const NumberField given =
        made_field(values.width, values.height, [&](int x, int y) { return values.at(x, y).r; });
    NumberField field = made_field(values.width, values.height,
                                   [&](int x, int y) { return middle_around(given, x, y); });
    // The middle of nine numbers differs from the one in the middle by the noise only, also on a
    // slope.
    const NumberField off = made_field(values.width, values.height, [&](int x, int y) {
        const double away = std::abs(given.at(x, y) - field.at(x, y));
        return std::isfinite(away) ? away : 0;
    });
    constexpr double noises = 2.5;
    const NumberField noise = made_field(values.width, values.height, [&](int x, int y) {
        return noises * middle_around(off, x, y);
    });
    for (const int apart : {1, 2, 4, 2, 1}) field = averaged(field, noise, apart);
    return field;
}

std::vector<Isoline> isolines_of(const NumberField& field, double step, double most,
                                 double shortest) {
    std::vector<Isoline> lines;
    LineFinder finder(field, step);
    constexpr double rounding = 1 + 1e-9;
    for (int i = 1; i * step <= most * rounding; ++i) finder.find(i * step, shortest, lines);
    return lines;
}

void draw_isolines(const std::vector<Isoline>& lines, const IsolineLook& look, int bottom,
                   Image& picture) {
    LinePainter(look, bottom, picture).paint(lines);
}

}  // namespace candelabra
