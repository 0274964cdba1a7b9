// SPDX-License-Identifier: GPL-3.0-or-later
// Names in messages for values that are parts of a scene and not items with a vocabulary.
#pragma once

#include "interpret/value.h"

#include <vector>

namespace candelabra {

struct Bump;
struct ColourStop;
struct DeclaredCamera;
struct DeclaredMaterial;
struct NormalStop;
struct Pigment;
struct PigmentStop;
struct PlacedLight;
struct SlopeStop;
struct Texture;
struct TextureStop;

template <>
struct KindName<Texture> : Named<"a texture"> {};
template <>
struct KindName<Pigment> : Named<"a pigment"> {};
template <>
struct KindName<Bump> : Named<"a normal"> {};
template <>
struct KindName<std::vector<TextureStop>> : Named<"a texture map"> {};
template <>
struct KindName<std::vector<PigmentStop>> : Named<"a pigment map"> {};
template <>
struct KindName<std::vector<NormalStop>> : Named<"a normal map"> {};
template <>
struct KindName<std::vector<ColourStop>> : Named<"a colour map"> {};
template <>
struct KindName<std::vector<SlopeStop>> : Named<"a slope map"> {};
template <>
struct KindName<DeclaredMaterial> : Named<"a material"> {};
template <>
struct KindName<DeclaredCamera> : Named<"a camera"> {};
template <>
struct KindName<PlacedLight> : Named<"a light source"> {};

}  // namespace candelabra
