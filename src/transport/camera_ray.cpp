// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/camera_ray.h"

#include "camera/sample_turns.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Like camera_ray(), without a lens.
Ray pinhole_ray(const World& world, const WorldView& view, double u, double v) {
    Ray ray = view.camera.ray(u, v);
    if (ray.direction != Vec3(0) && view.camera_normal.pattern)
        ray.direction = bumped(view.camera_normal, ray.direction, view.camera.normal_place(u, v),
                               world.pattern_scene());
    return ray;
}

struct Place {
    double u, v;
};

/// Returns the coordinates that Projection::ray takes.
Place on_screen(const PicturePoint& at, Vec2 place) {
    return {(at.x + place.x) / at.width - 0.5, 0.5 - (at.y + place.y) / at.height};
}

Ray mesh_ray(const Projection& camera, const PicturePoint& at, Place place, std::uint32_t number) {
    // As in POV-Ray, where faces stand for pixels the first row is seen twice, and the last one
    // never.
    return camera.mesh->ray(
        {at.x, std::max(at.y - 1, 0), at.width, at.height, number, place.u + 0.5, place.v + 0.5});
}

}  // namespace

Ray camera_ray(const Shot& shot, double u, double v, const Key& key) {
    const Ray ray = pinhole_ray(*shot.world, shot.view, u, v);
    if (ray.direction == Vec3(0) || shot.view.camera.lens_radius == 0) return ray;
    return shot.view.camera.through_lens(
        ray, {uniform(key, Purpose::lens_u), uniform(key, Purpose::lens_v)});
}

Ray ray_through(const Shot& shot, const PicturePoint& at, Vec2 place, const Key& key) {
    const Place p = on_screen(at, place);
    const Projection& camera = shot.view.camera;
    if (!camera.mesh) return camera_ray(shot, p.u, p.v, key);
    const auto rays = static_cast<std::uint32_t>(camera.mesh->rays_per_pixel());
    return mesh_ray(camera, at, p, item_in_turn(Turns::camera_rays, rays, key));
}

Ray middle_ray(const World& world, const WorldView& view, const PicturePoint& at) {
    const Place p = on_screen(at, {0.5, 0.5});
    return view.camera.mesh ? mesh_ray(view.camera, at, p, 0) : pinhole_ray(world, view, p.u, p.v);
}

}  // namespace candelabra
