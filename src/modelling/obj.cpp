// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/obj.h"

#include <array>
#include <charconv>

namespace {

/// The shortest text that reads back as the number.
template <class Number>
void append_number(std::string& text, Number number) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text += ' ';
    text.append(digits.data(), written.ptr);
}

}  // namespace

std::string obj(const Mesh& mesh) {
    std::vector<int> places(mesh.vertices.size());
    int used = 0;
    std::string corners, faces;
    for (const Face& face : mesh.faces) {
        faces += 'f';
        for (const int corner : face) {
            int& place = places[static_cast<std::size_t>(corner)];
            if (place == 0) {
                const Vec3& p = mesh.vertices[static_cast<std::size_t>(corner)];
                corners += 'v';
                for (int axis = 0; axis < 3; ++axis) append_number(corners, p[axis]);
                corners += '\n';
                place = ++used;
            }
            append_number(faces, place);
        }
        faces += '\n';
    }
    return corners + faces;
}
