// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/ply.h"

#include "meshing/used_corners.h"
#include "text/message.h"

#include <bit>

namespace candelabra {

namespace {

/// Appends the bytes in little-endian order, on any machine.
template <class Whole>
void append(std::string& text, Whole value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
        text += static_cast<char>(value >> (8 * i) & 0xFF);
}

}  // namespace

std::string ply(const Mesh& mesh) {
    const Mesh used = with_used_corners(mesh);
    std::string text =
        message("ply\nformat binary_little_endian 1.0\nelement vertex ", used.vertices.size(),
                "\nproperty double x\nproperty double y\nproperty double z\n"
                "element face ",
                used.faces.size(), "\nproperty list uchar uint vertex_indices\nend_header\n");
    text.reserve(text.size() + 24 * used.vertices.size() + 13 * used.faces.size());
    for (const Vec3& p : used.vertices)
        for (int axis = 0; axis < 3; ++axis) append(text, std::bit_cast<std::uint64_t>(p[axis]));
    for (const Face& face : used.faces) {
        text += '\3';
        for (const int corner : face) append(text, static_cast<std::uint32_t>(corner));
    }
    return text;
}

}  // namespace candelabra
