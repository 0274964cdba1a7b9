// SPDX-License-Identifier: GPL-3.0-or-later
// The word cutaway_textures: parts of an intersection or a difference that have no texture show
// what they cut through. Called by the reader of objects when the block has ended.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// An intersection or a difference.
inline bool cuts(const Union& whole) {
    return whole.csg == Csg::intersection || whole.csg == Csg::difference;
}

/// Gives each part without a texture those of the others that contain the point: of a difference,
/// the first one's; of an intersection, the mean of all. Of a union within, the parts that contain
/// the point count; with more than four of them, the first that does, of 64 objects at most. What
/// `usual` is for: parts of such a union without a texture. Parts of which there is nothing to show
/// are left as they are.
void cut_away(Union&, const Handle<Texture>& usual);

}  // namespace candelabra
