// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/volumes.h"

#include "base/elementary.h"
#include "base/random.h"
#include "luminaire/volume.h"
#include "text/message.h"
#include "world/prototype.h"

#include <algorithm>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace candelabra {

namespace {

/// Approximate number of boxes into which all volumes together, and one volume, are cut; and the
/// maximum number of boxes along one axis.
constexpr double max_boxes = 8192, max_boxes_of_one = 128, longest = 64;
/// Number of points that are evaluated in each cell of a box.
constexpr std::uint32_t points_in_cell = 2;
/// Minimum mean brightness of a box, as a fraction of that of all: the points may miss something.
constexpr double min_of_mean = 0.01;

Rgb emission_of_media(const World& world, PrimitiveIndex volume, const Vec3& point) {
    Rgb sum(0);
    for (const Media& media : world.material(volume).interior->media)
        if (media.luminaire) sum += density(media, point, world.pattern_scene()) * media.emission;
    return sum;
}

/// Upper bound of the emission per unit of length anywhere in the volume.
Rgb greatest_emission_of(const World& world, PrimitiveIndex volume) {
    Rgb sum(0);
    for (const Media& media : world.material(volume).interior->media)
        if (media.luminaire) sum += max_density(media) * abs(media.emission);
    return sum;
}

/// A box cut into boxes of similar length and width.
class Cut {
public:
    Cut(const Box& box, double count) : box_(box) {
        const Vec3 size = box.size();
        const double edge = math::cbrt(size.x * size.y * size.z / count);
        for (int axis = 0; axis < 3; ++axis)
            number_[axis] = std::clamp(std::round(size[axis] / edge), 1.0, longest);
    }

    std::size_t count() const {
        return static_cast<std::size_t>(number_.x * number_.y * number_.z);
    }
    Box part(std::size_t number) const {
        Vec3 place;
        for (int axis = 0; axis < 3; ++axis) {
            const auto here = static_cast<std::size_t>(number_[axis]);
            place[axis] = static_cast<double>(number % here);
            number /= here;
        }
        const Vec3 size = box_.size();
        return {box_.low + place / number_ * size, box_.low + (place + Vec3(1)) / number_ * size};
    }

private:
    Box box_;
    Vec3 number_;
};

/// Samples the emission of one volume.
class VolumeSurvey {
public:
    using Cells = std::array<double, EmissionGrid::count>;

    VolumeSurvey(const World& world, PrimitiveIndex volume) : world_(world), volume_(volume) {}

    /// Brightness of the cells of the box with that number.
    Cells brightness(const Box& box, std::size_t number) const {
        constexpr auto side = EmissionGrid::side;
        const Vec3 size = box.size() / static_cast<double>(side);
        Cells cells{};
        for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
            const Vec3 corner(cell % side, cell / side % side, cell / (side * side));
            for (std::uint32_t i = 0; i < points_in_cell; ++i) {
                Vec3 within;
                for (std::uint32_t axis = 0; axis < 3; ++axis)
                    within[static_cast<int>(axis)] =
                        uniform(Key::of(Survey::seen_area, number, cell * points_in_cell + i, axis),
                                Purpose::survey);
                const Vec3 point = box.low + (corner + within) * size;
                if (world_.contains_point(volume_, point))
                    cells[cell] +=
                        luminance(abs(emission_of_media(world_, volume_, point))) / points_in_cell;
            }
        }
        return cells;
    }

private:
    const World& world_;
    PrimitiveIndex volume_;
};

class VolumeMaker {
public:
    VolumeMaker(World& world, double boxes_of_one, bool surveyed)
        : world_(world), boxes_(boxes_of_one), surveyed_(surveyed) {}

    void add(PrimitiveIndex volume, std::uint32_t statement, const Box& box) {
        const Cut cut(box, boxes_);
        const VolumeSurvey survey(world_, volume);
        std::vector<VolumeSurvey::Cells> cells(cut.count());
        double mean = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (surveyed_) cells[i] = survey.brightness(cut.part(i), i);
            for (const double each : cells[i])
                mean += each / static_cast<double>(cells.size() * EmissionGrid::count);
        }
        const Rgb greatest = greatest_emission_of(world_, volume);
        const double least = min_of_mean * (mean > 0 ? mean : luminance(greatest));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Box part = cut.part(i);
            world_.lights.media.push_back({part, make_handle<EmissionGrid>(cells[i], least),
                                           length(part.size()) * greatest, volume});
            world_.provenance.statement_of_luminaire.push_back(statement);
        }
    }

private:
    World& world_;
    double boxes_;
    bool surveyed_;
};

template <class S, class... Others>
constexpr bool one_of = (std::is_same_v<S, Others> || ...);

/// Whether rays may pass between the inside and the outside of a shape other than through its
/// surface; also said of shapes of which that depends on their numbers.
bool is_open(const BuiltShape& shape) {
    return visit_shape(
        []<class S>(const S& s) {
            if constexpr (requires { s.open; }) return s.open;
            return one_of<S, Disc, Triangle, SmoothTriangle, BuiltPolygon, BuiltBicubicPatch,
                          BuiltParametric, BuiltMesh, BuiltLathe, BuiltPrism>;
        },
        shape);
}

/// The same for an item.
bool has_openings(const Geometry& geometry, std::uint32_t item) {
    if (const Instance* placed = geometry.instance(item)) {
        const Prototype& prototype = geometry.prototype_of(*placed);
        const Geometry& own = prototype.geometry;
        for (std::uint32_t i = 0; i < own.item_count(); ++i)
            if ((prototype.clear || !own.is_triangle(i)) && has_openings(own, i)) return true;
        return false;
    }
    return geometry.visit(
        item, [](const SpherePrimitive&) { return false; },
        [](const TrianglePrimitive&) { return true; },
        [](const PlacedShape& placed) { return is_open(placed.shape); },
        [](const PlacedComposite& placed) {
            const Composite& whole = *placed.composite;
            bool open = whole.has_openings();
            for (std::uint32_t i = 0; !open && i < whole.leaf_count(); ++i)
                open = is_open(whole.leaf(i).shape);
            return open;
        });
}

}  // namespace

bool has_openings(const World& world) {
    const Geometry& geometry = world.geometry;
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item) {
        const bool noted = geometry.is_triangle(item) ? world.material(item).transparent
                                                      : world.is_noted_solid(item);
        if (noted && has_openings(geometry, item)) return true;
    }
    return false;
}

bool is_same_solid(const World& world, PrimitiveIndex a, PrimitiveIndex b) {
    const Geometry& geometry = world.geometry;
    return world.solid(a) == world.solid(b) ||
           (!geometry.is_instanced(a) && geometry.item_of(a) == geometry.item_of(b));
}

bool lights_from_inside(const Material& material) {
    return material.interior && std::ranges::any_of(material.interior->media, &Media::luminaire);
}

bool glows_within(const World& world, const Material& material) {
    return material.interior &&
           std::ranges::any_of(material.interior->media, [&](const Media& media) {
               return media.luminaire || (world.facts.keeps_energy && media.emission != Rgb(0));
           });
}

namespace {

/// Leaves the emission inside of a primitive's item to chance, as if its media were no luminaires.
/// Bounded items with its material keep theirs.
void leave_to_chance(World& world, PrimitiveIndex primitive) {
    Appearance& looks = world.appearance;
    const Geometry& geometry = world.geometry;
    const std::uint32_t item = geometry.item_of(primitive);
    std::unordered_map<std::uint32_t, std::uint32_t> known;
    // The primitives of an item are consecutive.
    PrimitiveIndex i = primitive;
    while (i > 0 && geometry.item_of(i - 1) == item) --i;
    for (; i < looks.material_of.size() && geometry.item_of(i) == item; ++i) {
        const std::uint32_t old = looks.material_of[i];
        if (!looks.materials[old].interior) continue;
        const auto [found, added] =
            known.try_emplace(old, static_cast<std::uint32_t>(looks.materials.size()));
        if (added) {
            Material own = looks.materials[old];
            for (Media& media : own.interior.edit().media) media.luminaire = false;
            looks.materials.push_back(std::move(own));
        }
        looks.material_of[i] = found->second;
    }
}

}  // namespace

void add_volumes(World& world, std::span<const GlowingPrimitive> glowing, bool surveyed,
                 Diagnostics& diagnostics) {
    const Geometry& geometry = world.geometry;
    const double share = max_boxes / std::max<double>(static_cast<double>(glowing.size()), 1);
    VolumeMaker maker(world, surveyed ? std::clamp(share, 1.0, max_boxes_of_one) : 1, surveyed);
    std::uint32_t last = no_primitive;
    for (const GlowingPrimitive& glow : glowing) {
        const PrimitiveIndex primitive = geometry.primitive(glow.kind, glow.index);
        const std::uint32_t item = geometry.item_of(primitive);
        // The leaves of a composite are consecutive.
        if (std::exchange(last, item) == item) continue;
        const Box box = geometry.inside_bounds(item);
        const Vec3 size = box.size();
        if (!finite(box)) {
            leave_to_chance(world, primitive);
            diagnostics.add(
                warning(Fault::degenerate, glow.span,
                        "media without bounds are no luminaire: only `path_traced` finds their "
                        "light, by chance")
                    .with_help("put them into a large `box`, which can be sampled"));
        } else if (size.x * size.y * size.z > 0) {
            const auto first = static_cast<LightIndex>(world.lights.glowing());
            world.lights.volumes.push_back({primitive, first});
            maker.add(primitive, glow.statement, box);
        }
    }
}

void find_openings(World& world) {
    world.lights.glow_beside_openings =
        std::ranges::any_of(
            world.appearance.materials,
            [&](const Material& material) { return glows_within(world, material); }) &&
        has_openings(world);
}

namespace {

/// Number of the parts that share the volume's media among those solids, but at least 1.
int parts_there(const World& world, PrimitiveIndex volume, std::span<const PrimitiveIndex> solids) {
    const auto count = std::ranges::count_if(
        solids, [&](PrimitiveIndex solid) { return is_same_solid(world, solid, volume); });
    return std::max(static_cast<int>(count), 1);
}

bool all_hollow(const World& world, std::span<const PrimitiveIndex> solids) {
    return std::ranges::all_of(solids, [&](PrimitiveIndex s) { return world.material(s).hollow; });
}

}  // namespace

Rgb volume_emission(const World& world, PrimitiveIndex volume, const Vec3& point) {
    if (!world.contains_point(volume, point)) return Rgb(0);
    const EnteredSolids there = world.containing(point);
    const std::span<const PrimitiveIndex> solids(there.data(), there.size());
    const int parts = parts_there(world, volume, solids);
    if (parts % 2 == 0 || !all_hollow(world, solids)) return Rgb(0);
    return emission_of_media(world, volume, point) / static_cast<double>(parts);
}

Rgb volume_emission(const World& world, PrimitiveIndex volume, const SightOfVolume& sight) {
    const Vec3 point = sight.ray.at(sight.distance);
    if (!world.lights.glow_beside_openings) return volume_emission(world, volume, point);
    if (!world.contains_point(volume, point)) return Rgb(0);
    const EnteredSolids there = world.containing(point);
    const int parts = parts_there(world, volume, {there.data(), there.size()});
    EnteredSolids entered(sight.solids.begin(), sight.solids.end());
    bool ends = false;
    world.along(sight.ray, sight.tolerance, RayKind::gathering, [&](const Hit& hit, double t) {
        ends = t > sight.distance;
        if (!ends) world.pass(hit.primitive, entered);
        return !ends;
    });
    const std::span<const PrimitiveIndex> solids(entered.data(), entered.size());
    const bool seen = std::ranges::any_of(
        solids, [&](PrimitiveIndex solid) { return is_same_solid(world, solid, volume); });
    if (!ends || !seen || !all_hollow(world, solids)) return Rgb(0);
    return emission_of_media(world, volume, point) / static_cast<double>(parts);
}

bool is_within(const World& world, PrimitiveIndex solid, const Vec3& point) {
    if (world.contains_point(solid, point)) return true;
    return world.material(solid).shared_interior != 0 &&
           std::ranges::any_of(world.containing(point), [&](PrimitiveIndex there) {
               return is_same_solid(world, there, solid);
           });
}

const GlowingVolume* volume_among(const World& world, std::span<const PrimitiveIndex> solids) {
    for (std::size_t i = solids.size(); i-- > 0;) {
        const auto found =
            std::ranges::find_if(world.lights.volumes, [&](const GlowingVolume& volume) {
                return is_same_solid(world, volume.primitive, solids[i]);
            });
        if (found != world.lights.volumes.end()) return &*found;
    }
    return nullptr;
}

}  // namespace candelabra
