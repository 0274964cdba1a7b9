// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/ply_reader.h"

#include "base/number_text.h"
#include "models/fan.h"
#include "models/words.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <system_error>

namespace candelabra {

namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Number> number_named(std::string_view name) {
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (name == names[i][0] || name == names[i][1]) return static_cast<Number>(i);
    return std::nullopt;
}

/// Meaning of a property. The first ones are numbers of points, the others lists of faces.
enum Role { x, y, z, nx, ny, nz, u, v, corners, uv_pairs, other };
constexpr std::size_t point_roles = corners;

Role role_of(std::string_view name, bool is_list) {
    struct Known {
        std::string_view name;
        Role role;
    };
    constexpr std::array<Known, 17> known{{{"x", x},
                                           {"y", y},
                                           {"z", z},
                                           {"nx", nx},
                                           {"ny", ny},
                                           {"nz", nz},
                                           {"u", u},
                                           {"v", v},
                                           {"s", u},
                                           {"t", v},
                                           {"texture_u", u},
                                           {"texture_v", v},
                                           {"texture_s", u},
                                           {"texture_t", v},
                                           {"vertex_indices", corners},
                                           {"vertex_index", corners},
                                           {"texcoord", uv_pairs}}};
    const auto* found = std::ranges::find(known, name, &Known::name);
    return found != known.end() && (found->role >= corners) == is_list ? found->role : other;
}

struct Property {
    Role role;
    Number type;
    std::optional<Number> length;  ///< of a list
};

struct Element {
    std::string_view name;
    std::uint64_t count;
    std::vector<Property> properties;

    bool has(Role role) const {
        return std::ranges::find(properties, role, &Property::role) != properties.end();
    }
};

enum class Coding { text, low_first, high_first };

using polyhedra::next_word;

/// Sequence of the numbers after the header; next() returns false at its end.
class Numbers {
public:
    Numbers(std::string_view rest, Coding coding) : rest_(rest), coding_(coding) {}

    bool next(Number type, double& value) {
        if (coding_ == Coding::text) return next_written(value);
        switch (type) {
            case Number::int8:
                return next_stored<std::int8_t>(value);
            case Number::uint8:
                return next_stored<std::uint8_t>(value);
            case Number::int16:
                return next_stored<std::int16_t>(value);
            case Number::uint16:
                return next_stored<std::uint16_t>(value);
            case Number::int32:
                return next_stored<std::int32_t>(value);
            case Number::uint32:
                return next_stored<std::uint32_t>(value);
            case Number::float32:
                return next_stored<float>(value);
            case Number::float64:
                return next_stored<double>(value);
        }
        return false;
    }

private:
    bool next_written(double& value) {
        std::string_view word = next_word(rest_);
        if (word.starts_with('+')) word.remove_prefix(1);
        return number_from(word.data(), word.data() + word.size(), value).ec == std::errc();
    }
    template <class Stored>
    bool next_stored(double& value) {
        std::array<char, sizeof(Stored)> bytes;
        if (rest_.size() < bytes.size()) return false;
        std::memcpy(bytes.data(), rest_.data(), bytes.size());
        rest_.remove_prefix(bytes.size());
        const bool low_first = coding_ == Coding::low_first;
        if (low_first != (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
        value = static_cast<double>(std::bit_cast<Stored>(bytes));
        return true;
    }

    std::string_view rest_;
    Coding coding_;
};

struct Header {
    Coding coding = Coding::text;
    std::vector<Element> elements = {};
};

/// Parses the line of a property after its first word.
std::optional<Property> property(std::string_view line) {
    std::string_view type = next_word(line);
    std::optional<Number> length;
    const bool is_list = type == "list";
    if (is_list) {
        length = number_named(next_word(line));
        type = next_word(line);
        if (!length) return std::nullopt;
    }
    const auto number = number_named(type);
    const std::string_view name = next_word(line);
    if (!number || name.empty()) return std::nullopt;
    return Property{role_of(name, is_list), *number, length};
}

/// Parses a line of the header; returns an error, or an empty string.
std::string take(std::string_view line, Header& header) {
    const std::string_view word = next_word(line);
    if (word == "format") {
        const std::string_view coding = next_word(line);
        if (coding != "ascii" && coding != "binary_little_endian" && coding != "binary_big_endian")
            return "its format is not known";
        header.coding = coding == "ascii"                  ? Coding::text
                        : coding == "binary_little_endian" ? Coding::low_first
                                                           : Coding::high_first;
    } else if (word == "element") {
        Element& element = header.elements.emplace_back(Element{next_word(line), 0, {}});
        const std::string_view count = next_word(line);
        if (number_from(count.data(), count.data() + count.size(), element.count).ec !=
            std::errc())
            return "an element of its header has no count";
    } else if (word == "property") {
        const auto found = property(line);
        if (!found || header.elements.empty()) return "a property of its header cannot be read";
        header.elements.back().properties.push_back(*found);
    }
    return {};
}

/// Parses the header and removes it from the front of the file.
std::string take_header(std::string_view& file, Header& header) {
    const std::string damaged = "it is no PLY file: its header has no end";
    for (bool first = true;; first = false) {
        const std::size_t end = file.find('\n');
        if (end == std::string_view::npos) return damaged;
        std::string_view line = file.substr(0, end);
        file.remove_prefix(end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (first && line != "ply") return "it is no PLY file: it does not begin with `ply`";
        if (line == "end_header") return {};
        const std::string wrong = take(line, header);
        if (!wrong.empty()) return wrong;
    }
}

/// A point, a face or another element.
struct Item {
    std::array<double, point_roles> numbers{};
    std::vector<double> corners{}, uv_pairs{};
};

bool take_item(Numbers& numbers, const Element& element, Item& item) {
    for (const Property& property : element.properties) {
        double value = 0;
        if (!numbers.next(property.length.value_or(property.type), value)) return false;
        if (!property.length) {
            if (property.role < point_roles) item.numbers[property.role] = value;
            continue;
        }
        std::vector<double>* const list = property.role == corners    ? &item.corners
                                          : property.role == uv_pairs ? &item.uv_pairs
                                                                      : nullptr;
        if (!(value >= 0)) return false;
        if (list) list->clear();
        for (double left = value; left >= 1; --left) {
            if (!numbers.next(property.type, value)) return false;
            if (list) list->push_back(value);
        }
    }
    return true;
}

void add_point(const Element& element, const Item& item, Polyhedron& shape, PolyhedronLook& look) {
    const auto& at = item.numbers;
    shape.points.push_back({at[x], at[y], at[z]});
    if (element.has(nx) && element.has(ny) && element.has(nz))
        look.normals.push_back({at[nx], at[ny], at[nz]});
    if (element.has(u) && element.has(v)) look.uvs.push_back({at[u], at[v]});
}

/// Texture coordinates of a face's corners replace those of the points; a face without any gets 0.
void add_face(const Element& element, const Item& item, Polyhedron& shape, PolyhedronLook& look) {
    const std::size_t count = item.corners.size();
    std::vector<int> places;
    for (const double corner : item.corners) places.push_back(polyhedra::place(corner));
    polyhedra::add_fan(places, shape.faces);
    if (!element.has(uv_pairs)) return;
    if (look.uv_faces.empty()) look.uvs.clear();
    const bool given = item.uv_pairs.size() == 2 * count;
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = static_cast<int>(look.uvs.size());
        look.uvs.push_back(
            {given ? item.uv_pairs[2 * i] : 0, given ? item.uv_pairs[2 * i + 1] : 0});
    }
    polyhedra::add_fan(places, look.uv_faces);
}

}  // namespace

std::string polyhedra::read_ply(std::string_view file, Polyhedron& shape, PolyhedronLook& look) {
    Header header;
    const std::string wrong = take_header(file, header);
    if (!wrong.empty()) return wrong;
    Numbers numbers(file, header.coding);
    for (const Element& element : header.elements) {
        const bool points = element.name == "vertex", faces = element.name == "face";
        if (points && !(element.has(x) && element.has(y) && element.has(z)))
            return "its points have no x, y and z";
        if (faces && !element.has(corners)) return "its faces have no `vertex_indices`";
        if (element.properties.empty()) continue;
        Item item;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (!take_item(numbers, element, item))
                return "`" + std::string(element.name) + "` " + std::to_string(i) + " of " +
                       std::to_string(element.count) + " is damaged, or missing";
            if (points) add_point(element, item, shape, look);
            if (faces) add_face(element, item, shape, look);
        }
    }
    return {};
}

}  // namespace candelabra
