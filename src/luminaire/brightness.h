// SPDX-License-Identifier: GPL-3.0-or-later
// Map of the brightness of a luminaire whose radiance varies, such as a television screen: a raster
// of cells for each of its faces. The luminaire draws most of its points from the map and the rest
// as if it glowed evenly, so that areas that the map misses are sampled too.
#pragma once

#include "luminaire/bright_cells.h"

#include "base/short_list.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <variant>

namespace candelabra {

/// A flat face: a parallelogram, or the part of it within an outline.
struct BrightFace {
    enum Outline {
        whole,
        triangle,  ///< the half at the corner
        disc       ///< the ellipse that touches all four sides, less its hole
    };
    Vec3 corner, side1, side2;
    Outline outline = whole;
    double hole = 0;  ///< of discs: radius of the hole as a fraction of the disc's
};

class Brightness {
    struct Face;

public:
    /// Unevenness from which curved surfaces are better sampled by a map than by their formula.
    static constexpr double uneven = 3;
    /// Maximum number of cells of a face in each direction; each is evaluated at four points.
    static constexpr int max_cells = 128;

    /// Makes a map of flat faces. For solids, the cross product of the sides points outwards, and
    /// only faces that are turned to a point light it. `luminance` is evaluated at points of the
    /// faces. If it is 0 everywhere, nothing is ever drawn from the map.
    Brightness(const std::vector<BrightFace>&, bool solid, int cells,
               FunctionRef<double(const Vec3&)> luminance);

    /// Makes a map of a sphere, with `cells` cells around it and from pole to pole.
    Brightness(const Vec3& centre, double radius, int cells,
               FunctionRef<double(const Vec3&)> luminance);

    /// Mean luminance over the area of all faces.
    double mean() const { return mean_; }
    /// Mean of the squared luminance over the square of the mean luminance; 1 if the map is dark.
    double unevenness() const { return mean_ > 0 ? mean_square_ / (mean_ * mean_) : 1; }

    /// The map as seen from a point: the distribution from which points are drawn there.
    class View {
    public:
        View(const Brightness&, const Vec3& from);
        /// Whether a point can be drawn: some face that is turned to the point is not dark.
        bool any() const { return !weights_.empty() && weights_.back() > 0; }
        struct Drawn {
            Vec3 position;   ///< may lie beyond the outline of its face
            double density;  ///< per steradian; 0 where the face is seen edge-on or from behind
        };
        /// Precondition: any().
        Drawn draw(const Vec2& u) const;
        /// Density per steradian with which draw() returns this point of the surface.
        double density(const Vec3& position) const;

    private:
        double weight(const Face&) const;
        std::span<const double> weights() const { return {weights_.data(), weights_.size()}; }
        double density(std::size_t face, const Vec3& position, double of_face) const;
        std::size_t face_at(const Vec3& position) const;
        /// Height (or cosine) relative to the side that shines: above 0 if that side is seen.
        double seen(double height) const {
            return sides_ == 0 ? std::abs(height) : sides_ * height;
        }

        const Brightness& map_;
        Vec3 from_;
        int sides_;  ///< sides that are seen: outer (1), inner (-1), or both (0)
        ShortList<double, 72> weights_;  ///< prefix sums over the faces
    };

private:
    struct Flat {
        Vec3 corner, side1, side2;
        Vec3 normal;  ///< unit
        /// Dot products of these with an offset from the corner give coordinates along the sides.
        Vec3 across1, across2;

        Vec3 middle() const { return corner + 0.5 * (side1 + side2); }
        Vec3 normal_at(const Vec3&) const { return normal; }
        /// Signed distance of a point from the plane of the face.
        double height(const Vec3& point) const { return dot(point - corner, normal); }
        Vec3 at(const Vec2& place) const;
        Vec2 place_of(const Vec3& position) const;
    };
    /// Part of a sphere between two heights and two angles around the y axis. Equal steps of height
    /// and angle make patches of equal area.
    struct Patch {
        Vec3 centre;
        double radius;
        double low, rise;                 ///< of a sphere of radius 1: heights from -1 to 1
        double start, turn;               ///< fractions of a turn
        Vec3 outwards;                    ///< unit, from the centre to the patch's middle
        double reach_cosine, reach_sine;  ///< of the angle between that and the farthest corner

        Vec3 middle() const { return centre + radius * outwards; }
        Vec3 normal_at(const Vec3& position) const { return unit(position - centre); }
        /// Height of a point above the patch; above 0 if the point is in front of any part of it.
        double height(const Vec3& point) const;
        Vec3 at(const Vec2& place) const;
        Vec2 place_of(const Vec3& position) const;
    };
    struct Face {
        std::variant<Flat, Patch> shape;
        double area;  ///< including the part that the outline leaves out
        BrightCells cells;
    };
    void take_means();

    std::vector<Face> faces_;
    bool solid_;
    double mean_ = 0, mean_square_ = 0;
};

}  // namespace candelabra
