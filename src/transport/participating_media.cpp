// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/participating_media.h"

#include "base/running_sums.h"
#include "medium/transmittance.h"
#include "transport/air_photon_light.h"
#include "transport/path_steps.h"
#include "transport/photons.h"
#include "world/volumes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// Bounds on the number of points along a segment at which media are evaluated.
constexpr int min_places = 8, max_places = 64;
/// If samples differ in any case, light sources are sampled at one of this many points.
constexpr int places_for_lit = 4;
/// Number of points on a camera ray at which the light is sampled that a strategy chooses.
constexpr int choice_places = 4;
/// The same for reflected luminaires: "Light in air".
constexpr int reflected_places = 8;
/// Maximum number of light sources whose unoccluded light is evaluated to find bright points; the
/// light of more sources tells little.
constexpr std::size_t max_telling = 16;
/// Number of photons evaluated on a camera ray in inhomogeneous media.
constexpr int photon_choices = 8;
/// Number of diagonals of the box Sky::near, beyond its centre, that count as near.
constexpr double wide = 2;
/// Fraction of the choices that take any place, as luminaires that seem bright may be occluded.
constexpr double any_place = 0.1;

int effort(const MediaList& media) {
    double most = 0;
    for (const Media* each : media)
        most = std::fmax(most, static_cast<double>(each->intervals) *
                                   std::max(each->samples, each->max_samples));
    return static_cast<int>(std::clamp<double>(most, min_places, max_places));
}

/// Whether a medium loses at least what it scatters, by what it says.
bool adds_no_light(const Media& medium) {
    const Scattering& s = medium.scattering;
    return min_component(medium.absorption) >= 0 &&
           (!medium.scatters() ||
            (s.physical && s.extinction >= 1 && min_component(s.colour) >= 0));
}

/// Whether all ways on from a place together have more light than is lost there, although the media
/// say otherwise. A debug build checks it.
[[maybe_unused]] bool adds_light(const PhaseFunction& phase, MediaView media, const Vec3& position,
                                 const PatternScene& scene) {
    for (const Media* each : media)
        if (!adds_no_light(*each) || min_component(density(*each, position, scene)) < 0)
            return false;
    const Rgb lost = coefficients(media, position, scene).extinction;
    return max_component(phase.share() - lost) > 1e-9 * max_component(lost);
}

double brightness_of(const MediaPlace& place) {
    return max_abs_component(place.weight * place.scattering);
}

}  // namespace

ParticipatingMedia::ParticipatingMedia(const Shot& shot) : world_(*shot.world), near_(shot.near) {
    if (!world_.facts.has_media) return;
    lights_all_ = !world_.facts.differs_by_light;
    joined_ = shot.joined != nullptr;
    chooses_ = joined_ || world_.lights.any_glowing() || !world_.sky.light.empty();
    for (const SourceSet& set : world_.lights.source_sets) {
        has_other_sources_ |= &set != shot.joined;
        if (!set.drawn()) sources_.insert(sources_.end(), set.lights.begin(), set.lights.end());
    }
    if (sources_.size() > max_telling) sources_.clear();
}

/// Distance from a point within which most of the lit media lie.
double ParticipatingMedia::near(const Vec3& from) const {
    return near_.empty() ? 0 : length(from - near_.centre()) + wide * length(near_.size());
}

void ParticipatingMedia::fill(const PathState& path, double distance) {
    media_.clear();
    add_followed(world_, {path.media.data(), path.media.size()}, std::isfinite(distance), media_);
}

/// Whether the emission of one of the media in the solids around the path shows at a point. A ray
/// that leaves a solid through an opening meets its media outside as well, as in POV-Ray; but some
/// glow only within.
bool ParticipatingMedia::shows(const PathState& path, std::size_t number, const Vec3& point) const {
    for (const PrimitiveIndex solid : path.media) {
        const Material& material = world_.material(solid);
        const std::size_t count = material.interior ? material.interior->media.size() : 0;
        if (number < count)
            return !glows_within(world_, material) || is_within(world_, solid, point);
        number -= count;
    }
    return true;
}

/// Finds which light of lamps at the places of the march reflected luminaires have taken.
void ParticipatingMedia::find_taken(const PathState& path, const ReflectedLight* reflected) {
    open_.clear();
    for (const MediaPlace& place : march_.places) {
        double taken = 0;
        if (reflected && path.taken.by_reflected)
            taken = 1;
        else if (reflected && path.taken.cosine > 0)
            taken = reflected->share_in_air(path.ray.at(place.distance), path.taken.cosine,
                                            place.distance);
        open_.push_back(1 - taken);
    }
}

double ParticipatingMedia::brightness(std::size_t place, bool others) const {
    return brightness_of(march_.places[place]) * (others ? 1 : open_[place]);
}

Veil ParticipatingMedia::along(const PathState& path, double distance, DirectLight& direct_light,
                               LightLedger& ledger, ReflectedLight* by_reflected, int reflections) {
    reflects_ = by_reflected != nullptr;
    march_.veil = {};
    march_.places.clear();
    if (!world_.facts.has_media) return {};
    fill(path, distance);
    if (media_.empty()) return {};
    places_ = path.depth + path.bounces > 0 ? min_places : effort(media_);
    light_ = path.scattered ? LightInAir::repeatedly_only : LightInAir::any;
    // In homogeneous media only the light differs, so that more places cost little.
    const int count = homogeneous(view_of(media_)) ? 2 * places_ : places_;
    const auto worth = [&](std::span<const Vec3> places, std::span<double> values) {
        expect_light(direct_light, places, values);
    };
    const MediaStretch::Worth expected(worth);
    const bool scatters =
        std::ranges::any_of(media_, [&](const Media* each) { return each->scatters(light_); });
    // Media of solids come first.
    MediaList own;
    if (std::isfinite(distance)) add_media(world_, {path.media.data(), path.media.size()}, own);
    const auto glows = [&](std::size_t number, const Vec3& point) {
        return number >= own.size() || shows(path, number, point);
    };
    const MediaStretch::Shows where(glows);
    const bool somewhere = world_.lights.glow_beside_openings &&
                           std::ranges::any_of(path.media, [&](PrimitiveIndex solid) {
                               return glows_within(world_, world_.material(solid));
                           });
    march(
        view_of(media_),
        {path.ray, std::min(distance, end_of_air), near(path.ray.origin), count,
         scatters ? &expected : nullptr, path.taken.lamps(), somewhere ? &where : nullptr, light_},
        world_.pattern_scene(), path.key, march_);
    Veil veil = march_.veil;
    if (march_.of_luminaires != Rgb(0))
        record_volume(ledger, world_, {path.media.data(), path.media.size()},
                      path.throughput * march_.of_luminaires);
    if (!march_.places.empty()) {
        find_taken(path, by_reflected);
        veil.added += scattered(path, direct_light, ledger);
        if (by_reflected && reflections > 0)
            veil.added += reflected(path, *by_reflected, reflections, ledger);
    }
    if (scatters && direct_light.photons() && collects_photons(view_of(media_)))
        veil.added += light_of_air_photons(world_, direct_light.photons()->in_air,
                                           {path, std::min(distance, end_of_air), view_of(media_),
                                            path.depth > 0 ? 1 : photon_choices},
                                           ledger);
    return veil;
}

template <class Expected, class Use>
void ParticipatingMedia::choose(const Key& key, int count, Expected expected, Use use) {
    sums_.clear();
    double total = 0;
    for (std::size_t i = 0; i < march_.places.size(); ++i) sums_.push_back(total += expected(i));
    if (!(total > 0) || !std::isfinite(total)) return;
    const double shift = uniform(key, Purpose::media_choice);
    for (int i = 0; i < count; ++i) {
        const std::span<const double> sums(sums_);
        const std::size_t found = drawn_share(sums, (i + shift) / count).index;
        use(found, i, total / (count * weight_of(sums, found)));
    }
}

/// Unoccluded light of the sources at a point, if the sources are few.
double ParticipatingMedia::unshadowed(const Vec3& position) const {
    if (sources_.empty()) return 1;
    double sum = 0;
    for (const std::uint32_t number : sources_) {
        const PointLight& light = world_.lights.sources[number];
        sum += std::abs(grey(incidence(light, light.location, position).colour));
    }
    return sum;
}

/// Expected light at a point of what the strategy of the shot chooses, up to a constant factor.
double ParticipatingMedia::choice_at(const DirectLight& direct_light, const Vec3& position) const {
    if (traits(world_.rules.settings.light_sampler).by_transmittance) return 1;
    if (const auto known = direct_light.expected_choice(position)) return *known;
    if (!world_.lights.any_glowing()) return 1;
    const Vec3 away = position - near_.centre(), half = 0.5 * near_.size();
    return 1 / (dot(away, away) + dot(half, half));
}

/// Adds the light expected at places to their worth. Light of sources that are all asked and of
/// what is chosen counts in equal parts, as their scales differ.
void ParticipatingMedia::expect_light(const DirectLight& direct_light, std::span<const Vec3> places,
                                      std::span<double> worth) const {
    const auto add = [&](auto light) {
        ShortList<double, 16> found;
        double total = 0;
        for (const Vec3& place : places) {
            found.push_back(light(place));
            total += found.back();
        }
        for (std::size_t i = 0; i < found.size() && total > 0; ++i) worth[i] += found[i] / total;
    };
    if (!sources_.empty()) add([&](const Vec3& place) { return unshadowed(place); });
    if (chooses_) add([&](const Vec3& place) { return choice_at(direct_light, place); });
}

/// Radiance towards the viewer by light of lamps that media scatter at the places of the march.
Rgb ParticipatingMedia::scattered(const PathState& path, DirectLight& direct_light,
                                  LightLedger& ledger) {
    const PatternScene scene = world_.pattern_scene();
    const std::span<const PrimitiveIndex> solids(path.media.data(), path.media.size());
    Rgb sum(0);
    EachKindOnce once;
    const auto light = [&](std::size_t index, const Key& key, double per_chance, LightKinds kinds) {
        const MediaPlace& place = march_.places[index];
        per_chance *= open_[index];
        const Vertex vertex = vertex_in_air(world_, path.ray, place.distance, solids);
        const PhaseFunction phase(view_of(media_), vertex.position(), path.ray.direction, scene,
                                  per_chance * place.weight, light_);
        sum += direct_light(
            {.vertex = vertex, .scatterer = phase, .light = kinds, .throughput = path.throughput},
            key, ledger);
    };
    if (has_other_sources_) {
        const Key key = path.key.branched(Branch::medium, 0);
        const LightKinds kinds = once.take(joined_ ? LightKinds{LightKind::sources} : all_sources);
        const int count = lights_all_ ? places_ : std::max(1, places_ / places_for_lit);
        choose(
            key, count,
            [&](std::size_t i) {
                return brightness(i, false) * unshadowed(path.ray.at(march_.places[i].distance));
            },
            [&](std::size_t place, int number, double per_chance) {
                light(place, key.part(count, number), per_chance, kinds);
            });
    }
    if (!chooses_) return sum;
    ShortList<double, 64> given;
    double mean = 0;
    for (std::size_t i = 0; i < march_.places.size(); ++i) {
        const double own = brightness(i, false);
        given.push_back(
            own > 0 ? own * choice_at(direct_light, path.ray.at(march_.places[i].distance)) : 0);
        mean += given.back() / static_cast<double>(march_.places.size());
    }
    LightKinds kinds = once.take({LightKind::luminaires, LightKind::sky});
    if (joined_) kinds = kinds.with(once.take({LightKind::drawn_sources}));
    const Key key = path.key.branched(Branch::medium, 1);
    const int count = path.depth + path.bounces > 0 ? 1 : choice_places;
    choose(
        key, count,
        [&](std::size_t i) {
            const double own = brightness(i, false);
            if (!(mean > 0)) return own;  // nothing is known
            return own > 0 ? given[i] + any_place * mean : 0;
        },
        [&](std::size_t place, int number, double per_chance) {
            light(place, key.part(count, number), per_chance, kinds);
        });
    return sum;
}

/// Radiance towards the viewer by light of reflected luminaires that media scatter at the places of
/// the march.
Rgb ParticipatingMedia::reflected(const PathState& path, ReflectedLight& by_reflected,
                                  int reflections, LightLedger& ledger) {
    const PatternScene scene = world_.pattern_scene();
    const std::span<const PrimitiveIndex> solids(path.media.data(), path.media.size());
    const Key key = path.key.branched(Branch::medium, 2);
    const int count = path.depth + path.bounces > 0 ? 1 : reflected_places;
    Rgb sum(0);
    choose(
        key, count, [&](std::size_t i) { return brightness(i, false); },
        [&](std::size_t index, int number, double per_chance) {
            const MediaPlace& place = march_.places[index];
            const Vertex vertex = vertex_in_air(world_, path.ray, place.distance, solids);
            const auto phase_of = [&](LightInAir light) {
                return PhaseFunction(view_of(media_), vertex.position(), path.ray.direction, scene,
                                     per_chance * open_[index] * place.weight, light);
            };
            const PhaseFunction phase = phase_of(light_),
                                again = phase_of(LightInAir::repeatedly_only);
            ReflectedLight::Counted counted{reflections};
            if (!path.scattered) counted.of_scattered = Scatterer(again);
            const LitLayer lit{.vertex = vertex,
                               .scatterer = phase,
                               .light = all_light,
                               .throughput = path.throughput};
            sum += by_reflected({world_, lit, false, ledger}, counted, key.part(count, number));
        });
    return sum;
}

double ParticipatingMedia::scattering(bool others) const {
    double sum = 0;
    for (std::size_t i = 0; i < march_.places.size(); ++i) sum += brightness(i, others);
    return sum;
}

PathState ParticipatingMedia::scattered_path(const PathState& path, bool others) const {
    const double total = scattering(others);
    double target = uniform(path.key, Purpose::media_lobe) * total, u = 0;
    std::size_t index = march_.places.size() - 1;
    for (std::size_t i = 0; i < march_.places.size(); ++i) {
        const double own = brightness(i, others);
        if (!(own > 0)) continue;
        index = i;
        if (target < own) {
            u = target / own;
            break;
        }
        target -= own;
    }
    const MediaPlace* place = &march_.places[index];
    PathState next = path;
    const PatternScene scene = world_.pattern_scene();
    const Vec3 position = path.ray.at(place->distance);
    const auto phase_of = [&](LightInAir light) {
        return PhaseFunction(view_of(media_), position, path.ray.direction, scene, Rgb(1), light);
    };
    PhaseFunction phase = phase_of(light_);
    if (!phase.answers_light()) return next.dimmed(Rgb(0));
    assert(!adds_light(phase, view_of(media_), position, scene));
    // The path remembers whether a medium without `multiple` has scattered it.
    const double repeatedly = phase.multiple();
    const bool once = u >= repeatedly;
    if (repeatedly > 0 && repeatedly < 1) {
        phase = phase_of(once ? LightInAir::once_only : LightInAir::repeatedly_only);
        next.dim(Rgb(1 / (once ? 1 - repeatedly : repeatedly)));
    }
    const Vec3 direction = phase.sample({uniform(path.key, Purpose::media_direction_u),
                                         uniform(path.key, Purpose::media_direction_v)});
    // Light from one steradian of radiance 1 is light of colour 1/pi.
    next.dim(place->weight * (total / brightness_of(*place)) * phase.evaluate(direction) /
             (std::numbers::pi * phase.pdf(direction)));
    next = path_from_air(next, position, direction);
    // Photons in the air bring what mirrors send to it.
    next.taken.scatter(true, phase.collects() && world_.rules.settings.photons.media > 0);
    next.taken.leave_diffuse_surfaces();
    if (reflects_) {
        next.taken.by_reflected =
            others && uniform(path.key, Purpose::near_reflection) >= open_[index];
        if (!next.taken.by_reflected) next.taken.cosine = 1;
    }
    next.scattered |= once;
    return next;
}

}  // namespace candelabra
