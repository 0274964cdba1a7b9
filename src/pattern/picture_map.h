// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures mapped into space: as colours (image_map), as values (image_pattern), as bumps
// (bump_map) and as a choice of textures (material_map). The evaluator supplies the texels; without
// them, nothing is shown.
#pragma once

#include "base/handle.h"
#include "base/rgb.h"
#include "base/texels.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The common part of all four: the picture and its mapping.
struct PictureMap {
    std::string file;
    Handle<Formula> function;  ///< replaces the file
    double gamma = 0;          ///< 0: as the file says, below 0: sRGB
    bool premultiplied = false;
    int map_type = 0;
    std::optional<int> picture;  ///< the file is a model, of which this is the picture's number
    std::string kind;  ///< the word before the file's name, such as `png`; empty: none
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
        int number = -1;  ///< index into the file's colour table; below 0: all
        double amount = 0;
    };
    std::vector<Adjustment> adjustments;
    Rgb tint = Rgb(1);                   ///< factor of all colours
    std::optional<double> alpha_cutoff;  ///< alpha is 0 below it, else 1; 0: there is none
    double filter = 0, transmit = 0;  ///< added to every texel if there is no table

    /// Applies the tint, the cutoff and the adjustments. Called once, after the texels have been
    /// set.
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
    bool tangent_space = false;       ///< the colours are directions, not heights
    std::optional<double> bump_size;  ///< for the normal that contains it

    static constexpr int frequency = 0;
    static constexpr std::string_view home = "normal";
    static const ItemInfo vocabulary;
};

struct MaterialMap : PictureMap {
    int textures = 1;  ///< number of textures to choose from

    static constexpr int frequency = 0;
    static constexpr std::string_view home = "texture";
    static const ItemInfo vocabulary;
};

/// Returns the colour at a point; nothing where the point misses a picture that is not repeated.
std::optional<Colour> colour_at(const ImageMap&, const Vec3& point);

/// Returns the surface normal at the point, where y points up, x and z lie along the picture, and
/// the bumps have the given height; nothing where the point misses the picture.
std::optional<Vec3> bump_at(const BumpMap&, const Vec3& point, double height);

/// Returns the direction that a picture in tangent space has at the point: x and y lie along the
/// picture, and z outwards, each from -1 to 1; nothing where the point misses the picture.
std::optional<Vec3> direction_at(const BumpMap&, const Vec3& point);

double evaluate(const ImageMap&, const Vec3& point);  ///< brightness; 0 where the point misses it
double evaluate(const ImagePattern&, const Vec3& point);
double evaluate(const BumpMap&, const Vec3& point);      ///< as for image_pattern
double evaluate(const MaterialMap&, const Vec3& point);  ///< number of the texture

}  // namespace candelabra
