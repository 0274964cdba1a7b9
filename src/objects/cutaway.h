// SPDX-License-Identifier: GPL-3.0-or-later
// Implements cutaway_textures: parts of an intersection or a difference without a texture show the
// textures of the objects that they cut. Called by the reader of objects when the block has ended.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// An intersection or a difference.
inline bool cuts(const Union& whole) {
    return whole.csg == Csg::intersection || whole.csg == Csg::difference;
}

/// Gives each part without a texture the textures of the other parts that contain the point: in a
/// difference those of the first part, in an intersection the mean of all. A part that consists of
/// others passes them on to those of its parts, at any depth, that have no texture and find none in
/// a cut of their own. As a source of textures, a nested union
/// contributes those of its parts that contain the point; while more than four textures are left to
/// combine, the first such part decides. At most 64 objects are searched for each part. Parts of a
/// nested union without a texture show `usual`. A part for which no texture is found is left as it
/// is.
void cut_away(Union&, const Handle<Texture>& usual);

}  // namespace candelabra
