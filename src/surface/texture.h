// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's look: pigment, normal and finish.
#pragma once

#include "surface/bump.h"
#include "surface/finish.h"
#include "surface/pigment.h"

struct Texture {
    Pigment pigment;
    Bump normal;
    Finish finish;

    /// Looks the same wherever it is moved to.
    bool plain() const { return !pigment.pattern && !normal.pattern; }
};

/// The texture after a transformation of the object that carries it.
inline Texture transformed(Texture texture, const Transform& transform) {
    texture.pigment.transform = texture.pigment.transform.then(transform);
    texture.normal.transform = texture.normal.transform.then(transform);
    return texture;
}

/// Radiance that the surface emits at most; 0 when it is no luminaire.
inline Vec3 greatest_emission(const Texture& texture) {
    return glm::max(brightest(texture.pigment) * texture.finish.emission, Vec3(0));
}
