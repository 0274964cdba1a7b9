// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras map a point of the picture to a ray. location, direction, right, up, sky, angle and
// look_at have POV-Ray 3.7's meaning, in its order of evaluation.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "camera/camera_functions.h"
#include "camera/lens_shape.h"
#include "camera/mesh_camera.h"
#include "vocabulary/kinds.h"

#include <optional>
#include <string>

namespace candelabra {

/// Settings that all cameras share. Left-handed by default: x to the right, y up, z into the
/// picture.
struct View {
    Vec3 location = Vec3(0);
    std::optional<Vec3> direction;
    std::optional<Vec3> right;
    std::optional<Vec3> up;
    double aspect = 1.33;  ///< length of `right` along x where it is not given
    Vec3 sky = Vec3(0, 1, 0);
    std::optional<Vec3> look_at;
    std::optional<double> angle;
    double aperture = 0;  ///< points out of focus are blurred; 0: everything is sharp
    Bokeh bokeh;          ///< their shape
    int blur_samples = 0;
    int max_blur_samples = 0;  ///< 0: blur_samples is the maximum
    std::optional<Vec3> focal_point;
    double variance = 1e-4;
    double confidence = 0.9;
    double shutter = 0;   ///< time by which the clock advances during the exposure
    int moments = 8;      ///< samples of that time, whose mean is the picture
    Transform transform;  ///< applied after everything else
};

/// All rays start at the camera.
struct Perspective : View {
    static const ItemInfo vocabulary;
};
/// All rays are parallel.
struct Orthographic : View {
    static const ItemInfo vocabulary;
};
/// A round picture: angles from the optical axis are proportional to distances from the centre.
struct Fisheye : View {
    static const ItemInfo vocabulary;
};
/// Wide angles, with curved edges.
struct UltraWideAngle : View {
    static const ItemInfo vocabulary;
};
/// For a dome: a fisheye of 180 degrees whose lower part is cut off.
struct Omnimax : View {
    static const ItemInfo vocabulary;
};
/// Half a turn; vertical lines stay straight.
struct Panoramic : View {
    static const ItemInfo vocabulary;
};
/// Projection onto a cylinder: 1 vertical, 2 horizontal; 3 and 4 likewise with rays that start on
/// its axis.
struct CylinderCamera : View {
    int type = 1;

    static const ItemInfo vocabulary;
};
/// The full sphere, by longitude and latitude.
struct SphericalCamera : View {
    std::optional<double> vertical_angle;

    static const ItemInfo vocabulary;
};
/// Rays from the faces of meshes.
struct MeshCamera : View {
    Handle<MeshRays> from;

    static const ItemInfo vocabulary;
};
/// Rays that functions of the place in the picture give, as in POV-Ray 3.8. The transform of the
/// camera and `look_at` do not apply to what functions give.
struct UserDefinedCamera : View {
    CameraFunctions from;     ///< where rays start; not given: at `location`
    CameraFunctions towards;  ///< where they go; not given: along `direction`

    static const ItemInfo vocabulary;
};
/// All cameras; the first is the default of a block without a type.
using Camera = std::variant<Perspective, Orthographic, Fisheye, UltraWideAngle, Omnimax, Panoramic,
                            CylinderCamera, SphericalCamera, MeshCamera, UserDefinedCamera>;

/// How points of the picture become directions. The cylinders are numbered from the first.
enum class Lens : std::uint8_t {
    flat,
    parallel,
    fisheye,
    ultra_wide,
    omnimax,
    panoramic,
    cylinder1,
    cylinder2,
    cylinder3,
    cylinder4,
    spherical,
    mesh,       ///< see Projection::mesh
    functions,  ///< see Projection::from and towards
};

/// Number of rays of a blurred pixel: as many as its mean needs for the requested accuracy.
struct BlurRays {
    int least = 1, most = 1;
    double variance = 0;    ///< of the mean, in each of red, green and blue
    double confidence = 0;  ///< probability with which the variance is met

    /// The variance of the mean at which this number of rays is enough.
    double allowed(int rays) const;
};

/// A camera prepared to generate rays.
struct Projection {
    Vec3 location, direction, right, up;
    bool parallel = false;  ///< rays start at different points
    Lens lens = Lens::flat;
    double angle = 0;  ///< of view, in radians, for lenses that have one
    double vertical_angle = 0;
    double lens_radius = 0;  ///< 0: pinhole
    double focal_distance = 0;
    BlurRays blur = {};
    LensShape lens_shape = {};
    Handle<MeshLens> mesh = {};  ///< generates the rays; null: ray() does
    /// Of a user_defined camera; `location` and `direction` are those of the middle.
    CameraFunctions from = {}, towards = {};

    bool blurs() const { return lens_radius > 0 && blur.most > 1; }

    /// Where the pattern of the camera's normal is evaluated for a point of the picture. Measured
    /// from POV-Ray: a coordinate that represents an angle is in radians; round pictures have the
    /// angle around their centre and the angle from the optical axis.
    Vec3 normal_place(double u, double v) const;

    /// A ray that starts at another point of the lens and meets the given one in the plane of
    /// focus. The point is uniform on the lens, or distributed as its shape says, if `place` is
    /// uniform in [0, 1)^2.
    Ray through_lens(const Ray&, Vec2 place) const;

    /// Ray through (u, v): (-1/2, -1/2) is the bottom left corner, (1/2, 1/2) the top right. The
    /// direction has unit length; it is zero where the picture has no ray.
    Ray ray(double u, double v) const;
};

/// Applies `look_at` and `angle` at once to a camera that is still being read. Before language
/// version 3.5 the order of the words mattered.
void settle(Camera&);

/// Error in the camera as a whole, as a sentence; empty when there is none.
std::string problem(const Camera&);

/// Whether `direction`, `right` and `up` lie in one plane, or one of them is zero: all that is seen
/// lies in a plane or on a line, or nothing is seen.
bool is_flattened(const Camera&);

/// Precondition: problem() is empty.
Projection projection(const Camera&);

/// The width of a pixel divided by its height, as lengths that the camera sees: 1 if balls are
/// round in the middle of the picture. Empty for cameras that bend straight lines in one direction
/// only, or whose vectors are zero. Precondition: the size is positive.
std::optional<double> pixel_aspect(const Projection&, int width, int height);

}  // namespace candelabra
