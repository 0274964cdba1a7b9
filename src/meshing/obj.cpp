// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/obj.h"

#include "meshing/used_corners.h"
#include "text/message.h"

namespace candelabra {

std::string obj(const Mesh& mesh) {
    const Mesh used = with_used_corners(mesh);
    std::string text;
    const auto line = [&](char word, const auto& a, const auto& b, const auto& c) {
        append_part(text, word);
        for (const auto& part : {a, b, c}) {
            append_part(text, ' ');
            append_part(text, part);
        }
        append_part(text, '\n');
    };
    for (const Vec3& p : used.vertices) line('v', p.x, p.y, p.z);
    for (const Face& face : used.faces) line('f', face[0] + 1, face[1] + 1, face[2] + 1);
    return text;
}

}  // namespace candelabra
