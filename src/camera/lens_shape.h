// SPDX-License-Identifier: GPL-3.0-or-later
// The opening of a camera's lens: the shape that points of light take where they are out of focus.
#pragma once

#include "base/vector.h"
#include "vocabulary/item_info.h"

#include <vector>

namespace candelabra {

/// The blades of an aperture.
struct Bokeh {
    int blades = 0;    ///< corners of the opening; below 3: it is round
    double angle = 0;  ///< degrees by which it is turned, counter-clockwise as the camera sees it

    static const ItemInfo vocabulary;
};

/// Cells in each direction of a picture that is an opening.
inline constexpr int lens_cells = 128;

/// Maps random numbers to points of the opening.
class LensShape {
public:
    /// A round opening.
    LensShape() = default;
    /// A regular polygon whose corners lie on the round opening.
    explicit LensShape(const Bokeh&);
    /// A picture over the square around the round opening: points are as frequent as they are
    /// bright. `brightness` has lens_cells * lens_cells values of 0 and more, in rows from the
    /// bottom. A black picture leaves the opening round.
    explicit LensShape(const std::vector<double>& brightness);

    bool is_picture() const { return !sums_.empty(); }
    bool is_round() const { return !is_picture() && blades_.blades < least_corners; }
    /// The polygon, unless the opening is a picture.
    const Bokeh& blades() const { return blades_; }

    /// Returns a point of the opening, with the radius as unit: x to the right and y upwards as the
    /// camera sees the blurred point. Uniform in the opening, or distributed as the picture, if
    /// `place` is uniform in [0, 1)^2.
    Vec2 point(Vec2 place) const;

private:
    static constexpr int least_corners = 3;

    Bokeh blades_;
    std::vector<double> sums_;  ///< of the brightness up to each cell; empty: no picture
};

}  // namespace candelabra
