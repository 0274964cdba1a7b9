// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/ply.h"

#include "text/message.h"

#include <bit>

namespace {

/// The lowest byte first, on any machine.
template <class Whole>
void append(std::string& text, Whole value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
        text += static_cast<char>(value >> (8 * i) & 0xFF);
}

}  // namespace

std::string ply(const Mesh& mesh) {
    std::vector<std::uint32_t> places(mesh.vertices.size());
    std::vector<Vec3> used;
    std::string faces;
    faces.reserve(13 * mesh.faces.size());
    for (const Face& face : mesh.faces) {
        faces += '\3';
        for (const int corner : face) {
            std::uint32_t& place = places[static_cast<std::size_t>(corner)];
            if (place == 0) {
                used.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
                place = static_cast<std::uint32_t>(used.size());
            }
            append(faces, place - 1);
        }
    }
    std::string text =
        message("ply\nformat binary_little_endian 1.0\nelement vertex ", used.size(),
                "\nproperty double x\nproperty double y\nproperty double z\n"
                "element face ",
                mesh.faces.size(), "\nproperty list uchar uint vertex_indices\nend_header\n");
    text.reserve(text.size() + 24 * used.size() + faces.size());
    for (const Vec3& p : used)
        for (int axis = 0; axis < 3; ++axis) append(text, std::bit_cast<std::uint64_t>(p[axis]));
    return text + faces;
}
