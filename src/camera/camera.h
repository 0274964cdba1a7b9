// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras: from a point of the picture to a ray. POV-Ray 3.7's meaning of location, direction,
// right, up, sky, angle and look_at, in its order of evaluation.
#pragma once

#include "base/handle.h"
#include "base/ray.h"
#include "base/transform.h"
#include "camera/mesh_camera.h"
#include "vocabulary/kinds.h"

#include <optional>
#include <string>

namespace candelabra {

/// What every camera has. Left-handed by default: x to the right, y up, z into the picture.
struct View {
    Vec3 location = Vec3(0);
    std::optional<Vec3> direction;
    std::optional<Vec3> right;
    std::optional<Vec3> up;
    Vec3 sky = Vec3(0, 1, 0);
    std::optional<Vec3> look_at;
    std::optional<double> angle;
    double aperture = 0;  ///< what is not at the focal point is blurred; 0: all is sharp
    int blur_samples = 0;
    int max_blur_samples = 0;  ///< 0: blur_samples is the greatest number
    std::optional<Vec3> focal_point;
    double variance = 1e-4;
    double confidence = 0.9;
    double shutter = 0;   ///< how far the clock runs on while the picture is taken
    int moments = 8;      ///< of that time; the picture is the mean of all
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
/// A round picture: equal angles are equal lengths from its middle.
struct Fisheye : View {
    static const ItemInfo vocabulary;
};
/// Wide angles, with edges that bend.
struct UltraWideAngle : View {
    static const ItemInfo vocabulary;
};
/// For a dome: a fisheye of 180 degrees whose lower part is left out.
struct Omnimax : View {
    static const ItemInfo vocabulary;
};
/// Half a turn, straight upright lines.
struct Panoramic : View {
    static const ItemInfo vocabulary;
};
/// The picture on a cylinder: 1 upright, 2 lying; 3 and 4 the same with rays that start on its
/// axis.
struct CylinderCamera : View {
    int type = 1;

    static const ItemInfo vocabulary;
};
/// All around: longitude and latitude.
struct SphericalCamera : View {
    std::optional<double> vertical_angle;

    static const ItemInfo vocabulary;
};
/// Rays from the faces of meshes.
struct MeshCamera : View {
    Handle<MeshRays> from;

    static const ItemInfo vocabulary;
};
/// Every camera; the first is the one that a block without a type means.
using Camera = std::variant<Perspective, Orthographic, Fisheye, UltraWideAngle, Omnimax, Panoramic,
                            CylinderCamera, SphericalCamera, MeshCamera>;

/// How points of the picture become directions; cylinders are counted from the first.
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
    mesh  ///< see Projection::mesh
};

/// How many rays a pixel of a blurred picture gets: until its mean is known as well as is asked.
struct BlurRule {
    int least = 1, most = 1;
    double variance = 0;    ///< of the mean, in each of red, green and blue
    double confidence = 0;  ///< in the variance

    /// The variance of the mean with which so many rays are enough.
    double allowed(int rays) const;
};

/// A camera ready to send rays.
struct Projection {
    Vec3 location, direction, right, up;
    bool parallel = false;  ///< rays start apart from each other
    Lens lens = Lens::flat;
    double angle = 0;  ///< of the field, in radians, where the lens has one
    double vertical_angle = 0;
    double lens_radius = 0;  ///< 0: a pinhole
    double focal_distance = 0;
    BlurRule blur = {};
    Handle<MeshLens> mesh = {};  ///< says where rays go; null: ray() does

    bool blurs() const { return lens_radius > 0 && blur.most > 1; }

    /// Where the pattern of the camera's normal is asked for a point of the picture. Measured from
    /// POV-Ray: a coordinate that stands for an angle is that angle in radians; round pictures have
    /// the angle around their middle and the angle away from it.
    Vec3 normal_place(double u, double v) const;

    /// A ray that starts at another point of the lens and meets the first one in the plane that is
    /// sharp; the point is uniform where `place` is uniform in [0, 1)^2.
    Ray through_lens(const Ray&, Vec2 place) const;

    /// Ray through (u, v): (-1/2, -1/2) is the bottom left corner, (1/2, 1/2) the top right.
    /// Direction of unit length; zero where the picture has no ray.
    Ray ray(double u, double v) const;
};

/// Of a camera that is still read: what `look_at` and `angle` do, done at once. Before language
/// version 3.5 the order of the words counted.
void settle(Camera&);

/// What is wrong with the camera as a whole, as a sentence; empty when nothing is.
std::string problem(const Camera&);

/// Precondition: problem() is empty.
Projection projection(const Camera&);

}  // namespace candelabra
