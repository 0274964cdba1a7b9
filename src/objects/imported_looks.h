// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of imported models as textures and interiors. Called by imported_content.cpp.
#pragma once

#include "base/rgb.h"
#include "imports/imported_model.h"
#include "meshing/model_import.h"
#include "reading/block.h"

#include <map>

namespace candelabra {

/// What a material gives an object.
struct ImportedLook {
    Handle<Texture> texture;    ///< null: that of the object around it
    Handle<Interior> interior;  ///< null: that of the object around it
};

/// What materials have that the language has not, for one warning.
struct LeftOutLooks {
    int heights = 0;  ///< materials with maps of heights
    int dim = 0;    ///< materials whose light has a picture, and whose colour has another
    int averaged =
        0;  ///< materials with maps of metallic and roughness, which count by their means
};

class ImportedLooks {
public:
    /// All arguments outlive the object. `path` is that of the model.
    ImportedLooks(OpenBlock& block, const ImportedModel& model, std::string path)
        : block_(block), model_(model), path_(std::move(path)) {}

    ImportedLook look(const ImportedMaterial&);

    const LeftOutLooks& left_out() const { return left_out_; }

private:
    struct Shown {
        std::string file;           ///< its own, or that of the model
        std::optional<int> number;  ///< in the model, if it is there
        Handle<Texels> texels;
    };
    /// A picture of the model, coded for colours or as stored; null after a diagnostic.
    const Shown& shown(int picture, TexelCoding::Decode);
    std::optional<Found> find(const ImportedFile&, int number);
    Pigment pigment(int picture, const Rgb& factor, const ImportedMaterial&, double transmit);
    Bump bumps(const ImportedMaterial&);
    Finish finish(const ImportedMaterial&);
    void glow(const ImportedMaterial&, Texture&);
    Rgb in_scene(const std::array<double, 3>& stated) const;

    OpenBlock& block_;
    const ImportedModel& model_;
    std::string path_;
    LeftOutLooks left_out_;
    std::map<std::pair<int, TexelCoding::Decode>, Shown> pictures_;
};

}  // namespace candelabra
