// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures laid on the space: as colours (image_map), as values (image_pattern), as bumps
// (bump_map), and as a choice of textures (material_map). The reader of the language puts in the
// texels; without any, nothing is shown.
#pragma once

#include "base/handle.h"
#include "base/texels.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// What all four have in common: which picture, and how it lies.
struct PictureMap {
    std::string file;
    Handle<Formula> function;  ///< instead of a file
    double gamma = 0;          ///< 0: what the file says, below 0: sRGB
    bool premultiplied = false;
    int map_type = 0;
    int interpolate = 0;
    bool once = false;
    Vec2 repeat = Vec2(1), offset = Vec2(0);
    bool use_color = false, use_index = false, use_alpha = false;
    Handle<Texels> texels;
};

struct ImageMap : PictureMap {
    /// `filter all 0.5` or `transmit 3, 0.5`.
    struct Adjustment {
        bool filter = false;
        int number = -1;  ///< of the colour in the file's table; below 0: all
        double amount = 0;
    };
    std::vector<Adjustment> adjustments;
    double filter = 0, transmit = 0;  ///< added to every texel, where there is no table

    /// Puts the adjustments into effect. Called once, when there are texels.
    void adjust();
    static constexpr int frequency = 0;
    static constexpr std::string_view home = "pigment";
    static const ItemInfo vocabulary;
};

struct ImagePattern : PictureMap {
    static constexpr int frequency = 0;
    static const ItemInfo vocabulary;
};

struct BumpMap : PictureMap {
    std::optional<double> bump_size;  ///< for the normal that it stands in

    static constexpr int frequency = 0;
    static constexpr std::string_view home = "normal";
    static const ItemInfo vocabulary;
};

struct MaterialMap : PictureMap {
    int textures = 1;  ///< how many there are to choose from

    static constexpr int frequency = 0;
    static constexpr std::string_view home = "texture";
    static const ItemInfo vocabulary;
};

/// The colour at a point; nothing where a picture that is there once only is missed.
std::optional<Colour> colour_at(const ImageMap&, const Vec3& point);

/// The direction in which the surface points there, where y is up, x and z lie along the picture,
/// and the bumps have this height; nothing where the picture is missed.
std::optional<Vec3> bump_at(const BumpMap&, const Vec3& point, double height);

double evaluate(const ImageMap&, const Vec3& point);  ///< brightness; 0 where it is missed
double evaluate(const ImagePattern&, const Vec3& point);
double evaluate(const BumpMap&, const Vec3& point);      ///< the same as an image_pattern's
double evaluate(const MaterialMap&, const Vec3& point);  ///< number of the texture

}  // namespace candelabra
