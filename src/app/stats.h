// SPDX-License-Identifier: GPL-3.0-or-later
// What a run cost: gathered by the commands, written as JSON for --stats and as a line for people.
#pragma once

#include "index/statistics.h"
#include "transport/light_ledger.h"

#include <cstddef>
#include <string>

namespace candelabra {

/// Time of the day's clock and of all threads together.
struct Phase {
    double seconds = 0;
    double cpu_seconds = 0;

    friend Phase operator-(const Phase& a, const Phase& b) {
        return {a.seconds - b.seconds, a.cpu_seconds - b.cpu_seconds};
    }
};

/// The time that has passed since some fixed moment: differences have a meaning.
Phase time_now();
/// Its seconds only. Asking for the time of all threads costs as much as a ray or two; rendering
/// asks for this one with every sample.
double seconds_now();

/// The most memory that this process has had.
std::size_t peak_memory_bytes();

class World;
struct RenderSettings;

struct RunStatistics {
    Phase parse;    ///< reading and evaluating the scene
    Phase compile;  ///< building the world
    Phase render;
    Phase total;  ///< of the whole run up to here
    std::size_t objects = 0;
    std::size_t primitives = 0;
    std::size_t luminaires = 0;
    std::size_t light_sources = 0;
    LightLedger rays;
    std::string index;  ///< its name
    TreeStatistics tree;
    std::size_t light_octree_bytes = 0;   ///< 0: another sampler was used
    std::size_t light_sampler_bytes = 0;  ///< whichever was used
    std::size_t peak_memory_bytes = 0;
    std::string light_sampler;
    int seed = 0;
    int threads = 0;  ///< that worked
    int width = 0;
    int height = 0;
    int samples = 0;  ///< asked for; 0: as many as each pixel needs
    int shadow_rays = 0;
    bool prepared_ahead = false;  ///< a frame, while the one before it was rendered
};

/// Fills in what the world and the settings say.
void complete(RunStatistics&, const World&, const RenderSettings&);

/// An object with a line for each entry; ends in a newline.
std::string to_json(const RunStatistics&);

/// "640 x 480 in 12.3 s: 7382 objects, 7381 luminaires (light_octree); 2.1 M camera, 9.7 M shadow,
/// 0 scattered rays"
std::string summary(const RunStatistics&);

/// A count in a few characters: 950, 12.3 k, 4.5 M, 1.2 G.
std::string short_count(double count);

}  // namespace candelabra
