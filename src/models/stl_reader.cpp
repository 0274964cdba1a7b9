// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/stl_reader.h"

#include "models/words.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace candelabra {

namespace {

using polyhedra::next_word;

constexpr std::size_t stl_head = 84, stl_triangle = 50;

/// Four bytes as a word, little-endian.
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

class Triangles {
public:
    explicit Triangles(Polyhedron& made) : made_(made) {}

    /// Returns false for points that are not finite, since those have no order.
    bool add(const Polyhedron::Point& point) {
        for (const double coordinate : point)
            if (!std::isfinite(coordinate)) return false;
        const auto [found, added] =
            places_.try_emplace(point, static_cast<int>(made_.points.size()));
        if (added) made_.points.push_back(point);
        corners_.push_back(found->second);
        return true;
    }
    /// Returns false when the triangle does not have three corners.
    bool close() {
        const bool good = corners_.size() == 3;
        if (good) made_.faces.push_back({corners_[0], corners_[1], corners_[2]});
        corners_.clear();
        return good;
    }
    bool is_open() const { return !corners_.empty(); }

private:
    Polyhedron& made_;
    std::map<Polyhedron::Point, int> places_;
    std::vector<int> corners_;
};

constexpr auto no_number = "a point of it is not three finite numbers";
constexpr auto no_triangle = "a facet of it has not three corners";

std::string read_binary(std::string_view file, std::size_t count, Polyhedron& made) {
    Triangles triangles(made);
    constexpr std::size_t normal = 12, corner = 12;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = stl_head + i * stl_triangle + normal + k * corner;
            Polyhedron::Point point{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                point[axis] = std::bit_cast<float>(word_at(file, at + 4 * axis));
            if (!triangles.add(point)) return no_number;
        }
        triangles.close();
    }
    return {};
}

std::string read_written(std::string_view file, Polyhedron& made) {
    if (next_word(file) != "solid") return "it is no STL file, or ends too early";
    polyhedra::skip_line(file);
    Triangles triangles(made);
    for (auto word = next_word(file); !word.empty(); word = next_word(file)) {
        if (word == "vertex") {
            Polyhedron::Point point{};
            for (double& coordinate : point)
                if (!polyhedra::read_number(next_word(file), coordinate)) return no_number;
            if (!triangles.add(point)) return no_number;
        } else if (word == "endfacet") {
            if (!triangles.close()) return no_triangle;
        } else if (word == "solid" || word == "endsolid") {
            polyhedra::skip_line(file);  // a name
        }
    }
    return triangles.is_open() ? "it ends within a facet" : "";
}

}  // namespace

std::string polyhedra::read_stl(std::string_view file, Polyhedron& made) {
    if (file.size() < stl_head) return read_written(file, made);
    const std::size_t count = word_at(file, stl_head - 4);
    const std::size_t room = (file.size() - stl_head) / stl_triangle;
    const bool exact = count == room && (file.size() - stl_head) % stl_triangle == 0;
    // Some writers begin binary files with the first word of text files, and some append to them.
    if (exact || (count <= room && !file.starts_with("solid")))
        return read_binary(file, count, made);
    return read_written(file, made);
}

}  // namespace candelabra
