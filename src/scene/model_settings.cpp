// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/model_settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo ModelSettings::vocabulary = described<ModelSettings>([] {
    using F = Field<ModelSettings>;
    return schema<ModelSettings>(
        "model",
        {"A model from a file of glTF, OBJ, FBX, Collada, 3MF, PLY, STL or OFF, with its parts, "
         "materials and lights. What emits in it is a luminaire. In camera { }: a camera of it.",
         "model { file \"lantern.gltf\" }", "model { file \"lantern.gltf\" part \"Lamp\" scale 2 }",
         "model { file \"lantern.gltf\" replace \"Iron\" texture { pigment { rgb <0.5, 0.1, 0.1> } "
         "} }",
         "camera { model { file \"lantern.gltf\" part \"View\" } }"},
        F{"file", &ModelSettings::file, item, "the file"},
        F{"part", &ModelSettings::part, item,
          "the name of one of its parts, which stands on the origin; in camera { }, of a camera"});
});

}  // namespace candelabra
