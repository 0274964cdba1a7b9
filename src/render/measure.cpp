// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure.h"

#include "base/circle.h"
#include "base/cosine_direction.h"
#include "base/degrees.h"
#include "base/elementary.h"
#include "base/parallel.h"
#include "meter/glare.h"
#include "photometry/light_colour.h"
#include "render/lamp_draw.h"
#include "transport/integrator.h"
#include "transport/lamp_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Samples of a batch in the first round; each further round doubles them.
constexpr std::uint32_t first_samples = 4;
constexpr std::uint32_t most_samples = 4096;
/// Batches have numbers of samples of their own, so that they share no photons.
constexpr std::uint32_t samples_apart = 1U << 24U;
constexpr std::size_t points_of_job = 8;

/// Sums of one batch at one place. Most quantities need one; glare needs the background, too.
using Sums = std::array<double, 2>;

/// Takes samples of the quantities of meters. A copy serves one thread.
class Prober {
public:
    /// `lamps` is needed by meters that look at lamps.
    Prober(const Shot& shot, const SentLight& sent, bool keeps_lamps,
           std::shared_ptr<const LampDraw> lamps)
        : shot_(shot),
          world_(*shot.world),
          units_(world_.rules.settings.light_units()),
          integrator_(shot, {.keeps_lamps = keeps_lamps, .sent = sent, .from_anywhere = true}),
          direct_(shot, ShadowRays{}),
          photons_(sent.photons),
          lamps_(std::move(lamps)) {}

    /// Adds a sample of the meter at a place.
    void add(const Meter& meter, const MeterPlace& place, const Key& key, Sums& sums) {
        direct_.use(photons_.begin(key.sample));
        const Sightline sight{place.direction, unit(meter.up)};
        switch (meter.measures()) {
            case Quantity::luminance:
                sums[0] += meter.surface ? road_luminance(*meter.surface, place, sight.up, key)
                                         : luminance(meter.eye.value_or(place.position),
                                                     looked(meter.cone, place.direction, key), key);
                return;
            case Quantity::ugr: {
                const WhiteElement eye(place.position, place.direction);
                // A sample may be below 0; only the mean of all has a meaning.
                sums[0] += (illuminance(eye, key) - illuminance_by_lamps(eye, key)) / pi;
                sums[1] += glare(place.position, sight, key);
                return;
            }
            case Quantity::threshold_increment:
                sums[0] += veil(place.position, sight, key);
                return;
            default:
                sums[0] += illuminance({place.position, faced(meter.measures(), sight, key)}, key);
        }
    }

    /// Adds what lamps contributed to the last sample, which was of an illuminance or a luminance.
    void add_lamps(const Meter& meter, const LampColumns& columns, std::span<double> by_column) {
        const double factor = meter.measures() == Quantity::luminance ? 1 : pi;
        std::vector<LampPart>& parts = integrator_.ledger().parts;
        for (const LampPart& part : parts) {
            const std::size_t column = columns.of(part.lamp);
            if (column >= columns.count) continue;
            const auto add = [&](std::size_t to, const Rgb& light) {
                by_column[to] += factor * units_.luminance(light_luminance(light));
            };
            if (columns.in_colours) {
                add(column, {part.light.r, 0, 0});
                add(column + 1, {0, part.light.g, 0});
                add(column + 2, {0, 0, part.light.b});
            } else {
                add(column, part.light);
            }
        }
        parts.clear();
    }

private:
    double illuminance(const WhiteElement& element, const Key& key) {
        return pi * units_.luminance(light_luminance(integrator_.element_radiance(element, key)));
    }

    /// The part of it that no surface has reflected, by the same random numbers.
    double illuminance_by_lamps(const WhiteElement& element, const Key& key) {
        return on_element(element,
                          [&](const LitLayer& layer) { return direct_(layer, key, ledger_); });
    }

    template <class Light>
    double on_element(const WhiteElement& element, const Light& light) {
        const MediaStack around = world_.containing(element.ray().origin);
        const Vertex vertex = element.vertex({around.data(), around.size()});
        const Layers layers = element.layers();
        const ShadingRules rules = shading_rules(world_);
        const Bsdf bsdf(with_layer(world_, vertex, layers.front()), rules);
        return pi * units_.luminance(light_luminance(light(LitLayer{vertex, bsdf, all_light})));
    }

    double luminance(const Vec3& from, const Vec3& direction, const Key& key) {
        return units_.luminance(light_luminance(integrator_.radiance(Ray{from, direction}, key)));
    }

    /// Where the small plane faces that stands for the sample.
    static Vec3 faced(Quantity quantity, const Sightline& sight, const Key& key) {
        const double u = uniform(key, Purpose::meter_u), v = uniform(key, Purpose::meter_v);
        const std::pair<Vec3, Vec3> across = perpendiculars(sight.up);
        const auto on_ball = [&](double height) {
            return std::sqrt(std::fmax(1 - height * height, 0)) *
                       on_circle(2 * pi * v, across.first, across.second) +
                   height * sight.up;
        };
        switch (quantity) {
            case Quantity::cylindrical:
                return on_circle(2 * pi * u, across.first, across.second);
            case Quantity::semi_cylindrical: {
                const Vec3 ahead = unit(sight.ahead - dot(sight.ahead, sight.up) * sight.up);
                return on_circle(pi * (u - 0.5), ahead, cross(sight.up, ahead));
            }
            case Quantity::hemispherical:
                return on_ball(u);
            case Quantity::spherical:
                return on_ball(2 * u - 1);
            default:
                return sight.ahead;
        }
    }

    /// A direction in the cone of an observer.
    static Vec3 looked(double cone, const Vec3& ahead, const Key& key) {
        if (!(cone > 0)) return ahead;
        const double depth =
            1 - uniform(key, Purpose::meter_u) * (1 - math::cos(cone * radians_per_degree));
        const auto [x, y] = perpendiculars(ahead);
        return unit(depth * ahead + std::sqrt(std::fmax(1 - depth * depth, 0)) *
                                        on_circle(2 * pi * uniform(key, Purpose::meter_v), x, y));
    }

    /// Calls use(direction, luminance, solid angle) for a sample of each luminaire that is visible
    /// in front of the observer. Of very many, it is called for some, with greater solid angles.
    template <class Use>
    void for_lamps(const Vec3& from, const Sightline& sight, const Key& key, const Use& use,
                   bool squares = false) {
        const auto count = static_cast<std::uint32_t>(world_.lights.luminaires.size());
        const double choice = uniform(key.with_branch(count + 1), Purpose::glare_u);
        // Samples of a place follow each other.
        const LampDraw::Sight here{from, sight.ahead, squares};
        if (!(sight_ == here)) {
            sight_ = here;
            chances_ = lamps_->chances(here);
        }
        chances_.draw(choice, [&](LightIndex lamp, double weight) {
            const Key own = key.with_branch(lamp + 1);
            const auto seen =
                sight_of_lamp(world_, lamp, from,
                              {uniform(own, Purpose::glare_u), uniform(own, Purpose::glare_v)});
            if (seen && dot(seen->direction, sight.ahead) > 0)
                use(seen->direction, luminance(from, seen->direction, own), weight / seen->density);
        });
    }

    double glare(const Vec3& from, const Sightline& sight, const Key& key) {
        double sum = 0;
        const auto add = [&](const Vec3& direction, double bright, double angle) {
            const double index = guth_index(sight, direction);
            if (index > 0) sum += bright * bright * angle / (index * index);
        };
        for_lamps(from, sight, key, add, true);
        for (std::uint32_t i = 0; i < world_.lights.sources.size(); ++i)
            sum += glare_of_source(i, from, sight, key);
        return sum;
    }

    /// The same sum for a light source, whose luminance times solid angle is the illuminance on a
    /// plane that faces it. By CIE 147, sources of less than 0.005 m2 count as if they had that
    /// area. Two estimates make the square, so that its mean is right.
    double glare_of_source(std::uint32_t number, const Vec3& from, const Sightline& sight,
                           const Key& key) {
        constexpr double least_area = 0.005;
        const PointLight& source = world_.lights.sources[number];
        const Incidence there = incidence(source, source.location, from);
        const double index = guth_index(sight, there.direction);
        const double metres = there.distance * units_.metres;
        const double angle =
            source.parallel ? 2 * pi * (1 - source.disc_edge) : least_area / (metres * metres);
        if (!(index > 0 && angle > 0)) return 0;
        const auto lit = [&](std::uint32_t branch) {
            return on_element({from, there.direction}, [&](const LitLayer& layer) {
                return direct_.from_source(number, 1, layer, key.with_branch(branch), ledger_);
            });
        };
        return lit(1) * lit(2) / (angle * index * index);
    }

    double veil(const Vec3& from, const Sightline& sight, const Key& key) {
        double sum = 0;
        for_lamps(from, sight, key, [&](const Vec3& direction, double bright, double angle) {
            sum += veil_factor(sight, direction) * bright * angle * dot(direction, sight.ahead);
        });
        return sum + from_sources({from, sight.ahead}, key, [&](const Vec3& direction) {
                   return veil_factor(sight, direction);
               });
    }

    /// Luminance of a road by the direct light of lamps and its table of reflection.
    double road_luminance(const RoadTable& road, const MeterPlace& place, const Vec3& up,
                          const Key& key) {
        const Vec3& from = place.position;
        double sum = 0;
        // What the lamps of a sight contributed to it counts as the sight does.
        std::vector<LampPart>& parts = integrator_.ledger().parts;
        std::size_t weighed = parts.size();
        for_lamps(from, {up, up}, key, [&](const Vec3& direction, double bright, double angle) {
            const double counts =
                road.coefficient(up, place.direction, direction) * angle * dot(direction, up);
            sum += counts * bright;
            for (; weighed < parts.size(); ++weighed) parts[weighed].light *= counts;
        });
        return sum + from_sources({from, up}, key, [&](const Vec3& direction) {
                   return road.coefficient(up, place.direction, direction);
               });
    }

    /// The illuminance of an element by light sources, each times a factor on its direction.
    template <class Factor>
    double from_sources(const WhiteElement& element, const Key& key, const Factor& factor) {
        const auto& sources = world_.lights.sources;
        LightLedger& kept = integrator_.ledger();
        double sum = 0;
        for (std::uint32_t i = 0; i < sources.size(); ++i) {
            const Incidence there =
                incidence(sources[i], sources[i].location, element.ray().origin);
            const double counts = factor(there.direction);
            if (counts > 0)
                sum += counts * on_element(element, [&](const LitLayer& layer) {
                           const Rgb light = direct_.from_source(i, 1, layer, key, ledger_);
                           if (kept.keeps_parts)
                               kept.parts.push_back({Lamp::source(i), counts * pi * light, false});
                           return light;
                       });
        }
        return sum;
    }

    const Shot& shot_;
    const World& world_;
    LightUnits units_;
    Integrator integrator_;
    DirectLight direct_;
    ServedGeneration<Photons> photons_;
    std::shared_ptr<const LampDraw> lamps_;  ///< shared by all copies
    std::optional<LampDraw::Sight> sight_;   ///< of chances_
    LampDraw::Chances chances_;
    LightLedger ledger_;
};

/// Finds the points inside of solids that have neither the eye nor a lamp inside, as rooms have.
/// Meshes do not count.
class Solids {
public:
    explicit Solids(const Shot& shot) : shot_(shot), world_(*shot.world) {}

    bool bury(const Vec3& point) {
        bool buried = false;
        // Any line out of a solid meets its surface.
        const Ray way_out{point, unit(Vec3(0.61, 0.53, 0.59))};
        world_.along(way_out, 0, RayKind::light, [&](const Hit& hit, double) {
            buried = world_.contains_point(hit.primitive, point) && !is_room(hit.primitive);
            return !buried;
        });
        return buried;
    }

private:
    bool is_room(PrimitiveIndex solid) {
        const auto [known, fresh] = rooms_.try_emplace(solid, false);
        if (!fresh) return known->second;
        const auto holds = [&](const Vec3& place) { return world_.contains_point(solid, place); };
        return known->second = holds(shot_.view.camera.location) ||
                               std::ranges::any_of(world_.lights.sources,
                                                   [&](const PointLight& source) {
                                                       return holds(source.location);
                                                   }) ||
                               world_.lights.luminaires.any_of([&](const Luminaire& luminaire) {
                                   return holds(bounds(luminaire).centre);
                               });
    }

    const Shot& shot_;
    const World& world_;
    std::map<PrimitiveIndex, bool> rooms_;
};

/// A meter at work.
struct Task {
    const Meter& meter;
    std::uint64_t first_key;  ///< of its places
    MeterReading reading;
    std::vector<std::array<Sums, batch_count>> sums;  ///< of each place
    std::vector<bool> buried = {};                    ///< whether each place is in a solid
    /// Of each half of the batches: sums of each place and column.
    std::array<std::vector<double>, 2> by_column = {};
    double scale = 1;  ///< factor on results
    double road = 0;   ///< mean luminance for a threshold increment
    std::uint32_t of_batch = 0;
    bool done = false;

    double value(const Sums& mean) const {
        switch (meter.measures()) {
            case Quantity::ugr:
                return mean[0] > 0 ? unified_glare_rating(mean[0], scale * mean[1]) : 0;
            case Quantity::threshold_increment:
                return road > 0 ? threshold_increment(scale * mean[0], road) : 0;
            default:
                return scale * mean[0];
        }
    }

    /// Makes the reading of the sums.
    void read() {
        const std::size_t count = sums.size();
        std::vector<double> values(count);
        std::vector<Batches> batches(count);
        reading.values.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            Sums all{};
            for (std::size_t b = 0; b < batch_count; ++b) {
                Sums mean = sums[i][b];
                for (double& each : mean) each /= of_batch;
                for (std::size_t k = 0; k < all.size(); ++k) all[k] += mean[k] / batch_count;
                batches[i][b] = value(mean);
            }
            values[i] = value(all);
            reading.values[i] = with_interval(values[i], batches[i]);
        }
        summarise(values, batches);
        reading.samples = std::uint64_t{batch_count} * of_batch;
    }

    /// Makes the summary of the places that could have a meter.
    void summarise(const std::vector<double>& values, const std::vector<Batches>& batches) {
        std::vector<std::size_t> numbers;
        std::vector<double> counted;
        std::vector<Batches> counted_batches;
        reading.left_out.clear();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (buried[i] && values[i] == 0 && reading.values[i].error == 0) {
                reading.left_out.push_back(i);
                continue;
            }
            numbers.push_back(i);
            counted.push_back(values[i]);
            counted_batches.push_back(batches[i]);
        }
        if (counted.empty()) {
            reading.summary = summary_of(values, batches);
            return;
        }
        reading.summary = summary_of(counted, counted_batches);
        reading.summary.least = numbers[reading.summary.least];
        reading.summary.greatest = numbers[reading.summary.greatest];
    }

    /// Makes the halves of the reading.
    void divide() {
        constexpr std::size_t half = batch_count / 2;
        const double share = scale / (static_cast<double>(half) * of_batch);
        for (std::size_t h = 0; h < 2; ++h) {
            MeterHalf& made = reading.halves[h];
            for (const auto& batches : sums) {
                double sum = 0;
                for (std::size_t b = 0; b < half; ++b) sum += batches[h * half + b][0];
                made.values.push_back(share * sum);
            }
            made.by_column = by_column[h];
            for (double& each : made.by_column) each *= share;
        }
    }

    bool reaches(double until) const {
        return std::ranges::all_of(reading.values, [&](const MeterValue& each) {
            return each.error <= until * std::abs(each.value);
        });
    }
};

class Measuring {
public:
    Measuring(const Shot& shot, std::span<const Meter> meters, const MeasureSettings& settings)
        : settings_(settings),
          sent_{photons_of(shot, settings.seed, settings.threads), nullptr},
          fresh_(shot, sent_, settings.lamps.count > 0, lamps_for(meters, *shot.world)) {
        const World& world = *shot.world;
        const double metres = world.rules.settings.light_units().metres;
        std::uint64_t key = 0;
        Solids solids(shot);
        for (const Meter& meter : meters) {
            Task task{meter, key, {}, {}};
            task.reading.places = places_of(meter, metres);
            task.reading.area = length(cross(meter.along, meter.across)) * metres * metres;
            task.sums.resize(task.reading.places.size());
            for (const MeterPlace& place : task.reading.places)
                task.buried.push_back(solids.bury(place.position));
            task.scale = scale_of(meter, world);
            for (auto& each : task.by_column) each.resize(task.sums.size() * settings.lamps.count);
            key += task.sums.size();
            tasks_.push_back(std::move(task));
        }
    }

    std::vector<MeterReading> made() {
        const std::uint32_t wanted =
            settings_.samples > 0
                ? (static_cast<std::uint32_t>(settings_.samples) + batch_count - 1) / batch_count
                : most_samples;
        for (std::uint32_t level = std::min(first_samples, wanted);;
             level = std::min(2 * level, wanted)) {
            for (Task& task : tasks_)
                if (!task.done) go_on(task, level);
            judge();
            const bool ends = settings_.ended && settings_.ended();
            if (level >= wanted || ends || std::ranges::all_of(tasks_, &Task::done)) break;
        }
        std::vector<MeterReading> readings;
        for (Task& task : tasks_) {
            if (settings_.lamps.count > 0) task.divide();
            readings.push_back(std::move(task.reading));
        }
        return readings;
    }

private:
    /// Null if no meter looks at lamps one by one.
    static std::shared_ptr<const LampDraw> lamps_for(std::span<const Meter> meters,
                                                     const World& world) {
        const bool looks = std::ranges::any_of(meters, [](const Meter& meter) {
            const Quantity measures = meter.measures();
            return measures == Quantity::ugr || measures == Quantity::threshold_increment ||
                   (measures == Quantity::luminance && meter.surface);
        });
        return looks ? std::make_shared<LampDraw>(world.lights.luminaires) : nullptr;
    }

    static double scale_of(const Meter& meter, const World& world) {
        if (meter.measures() != Quantity::daylight_factor) return meter.maintenance;
        const double sky = free_sky(world, unit(meter.up));
        const double out = pi * world.rules.settings.light_units().luminance(sky);
        return out > 0 ? 100 * meter.maintenance / out : 0;
    }

    /// Brings all batches of all places to that number of samples.
    void go_on(Task& task, std::uint32_t level) {
        const std::size_t count = task.sums.size();
        const std::size_t parts = (count + points_of_job - 1) / points_of_job;
        // Photons of a batch are shared by all places, and not kept for long. Batches of a half
        // share the sums of lamps.
        const std::size_t at_once = sent_.photons || settings_.lamps.count > 0 ? 1 : batch_count;
        for (std::size_t batch = 0; batch < batch_count; batch += at_once)
            run_parallel(parts * at_once, settings_.threads, [&](std::size_t job) {
                const std::size_t first = job % parts * points_of_job;
                probe(task, batch + job / parts, first, std::min(first + points_of_job, count),
                      level);
            });
        task.of_batch = level;
    }

    void probe(Task& task, std::size_t batch, std::size_t first, std::size_t last,
               std::uint32_t level) {
        Prober prober = fresh_;
        for (std::size_t i = first; i < last; ++i) {
            Key key;
            key.pixel = mix(mix(static_cast<std::uint64_t>(settings_.seed)) +
                            (task.first_key + i) * batch_count + batch);
            for (std::uint32_t n = task.of_batch; n < level; ++n) {
                key.sample = static_cast<std::uint32_t>(batch) * samples_apart + n;
                prober.add(task.meter, task.reading.places[i], key, task.sums[i][batch]);
                if (settings_.lamps.count == 0) continue;
                std::vector<double>& sums = task.by_column[batch * 2 / batch_count];
                prober.add_lamps(task.meter, settings_.lamps,
                                 {sums.data() + i * settings_.lamps.count, settings_.lamps.count});
            }
        }
    }

    /// Reads all meters, those of roads first, and says which are done.
    void judge() {
        for (Task& task : tasks_)
            if (task.meter.measures() != Quantity::threshold_increment) task.read();
        for (Task& task : tasks_) {
            if (task.meter.measures() == Quantity::threshold_increment) {
                const auto road = std::ranges::find_if(tasks_, [&](const Task& each) {
                    return each.meter.name == task.meter.road &&
                           each.meter.measures() == Quantity::luminance;
                });
                task.road = road == tasks_.end() ? 0 : road->reading.summary.mean.value;
                task.read();
            }
            task.reading.reached = task.reaches(settings_.goal.error);
            const bool enough =
                task.reading.reached || !settings_.goal.counts(task.meter.measures());
            task.done = settings_.samples <= 0 && enough;
        }
    }

    const MeasureSettings& settings_;
    SentLight sent_;
    Prober fresh_;
    std::vector<Task> tasks_;
};

}  // namespace

double free_sky(const World& world, const Vec3& up) {
    // The mean over directions with equal cosines.
    constexpr int rings = 128, sectors = 256;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j)
            sum += light_luminance(
                world.sky_radiance(cosine_direction(up, {(i + 0.5) / rings, (j + 0.5) / sectors})));
    return sum / (rings * sectors);
}

std::vector<MeterReading> measure(const Shot& shot, std::span<const Meter> meters,
                                  const MeasureSettings& settings) {
    return Measuring(shot, meters, settings).made();
}

}  // namespace candelabra
