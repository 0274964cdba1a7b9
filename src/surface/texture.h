// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's look: pigment and finish.
#pragma once

#include "surface/finish.h"
#include "surface/pigment.h"

struct Texture {
    Pigment pigment;
    Finish finish;
};

/// The texture after a transformation of the object that carries it.
inline Texture transformed(Texture texture, const Transform& transform) {
    texture.pigment.transform = texture.pigment.transform.then(transform);
    return texture;
}

/// Radiance that the surface emits at most; 0 when it is no luminaire.
inline Vec3 greatest_emission(const Texture& texture) {
    return glm::max(brightest(texture.pigment) * texture.finish.emission, Vec3(0));
}
