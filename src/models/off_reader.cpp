// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/off_reader.h"

#include "models/fan.h"
#include "models/words.h"

#include <cstdint>

namespace candelabra {

namespace {

/// The next word outside of comments.
std::string_view off_word(std::string_view& text) {
    std::string_view word = polyhedra::next_word(text);
    for (; word.starts_with('#'); word = polyhedra::next_word(text)) polyhedra::skip_line(text);
    return word;
}

template <class Number>
bool take_number(std::string_view& text, Number& value) {
    return polyhedra::read_number(off_word(text), value);
}

std::string missing(const char* what, std::uint64_t number, std::uint64_t count) {
    return std::string(what) + " " + std::to_string(number) + " of " + std::to_string(count) +
           " is damaged, or missing";
}

bool take_face(std::string_view& text, std::vector<int>& corners) {
    std::uint64_t count = 0;
    if (!take_number(text, count)) return false;
    corners.clear();
    for (; count > 0; --count) {
        std::uint64_t corner = 0;
        if (!take_number(text, corner)) return false;
        corners.push_back(polyhedra::place(static_cast<double>(corner)));
    }
    return true;
}

}  // namespace

std::string polyhedra::read_off(std::string_view file, Polyhedron& made) {
    const std::string_view kind = off_word(file);
    // Texture coordinates, colours and normals follow the point's coordinates.
    if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF" && kind != "STOFF")
        return "it is no OBJ, PLY, STL or OFF file, or is damaged";
    const bool more = kind != "OFF";
    std::uint64_t points = 0, faces = 0, edges = 0;
    if (!take_number(file, points) || !take_number(file, faces) || !take_number(file, edges))
        return "its numbers of points, faces and edges are missing, or no text";
    for (std::uint64_t i = 0; i < points; ++i) {
        Polyhedron::Point& point = made.points.emplace_back();
        for (double& coordinate : point)
            if (!take_number(file, coordinate)) return missing("point", i, points);
        if (more) skip_line(file);
    }
    std::vector<int> corners;
    for (std::uint64_t i = 0; i < faces; ++i) {
        if (!take_face(file, corners)) return missing("face", i, faces);
        skip_line(file);  // a colour
        add_fan(corners, made.faces);
    }
    return {};
}

}  // namespace candelabra
