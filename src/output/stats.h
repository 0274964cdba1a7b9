// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a run, gathered by the commands and written as JSON for --stats and as a line for
// people.
#pragma once

#include "index/statistics.h"
#include "transport/light_ledger.h"

#include <cstddef>
#include <string>
#include <vector>

namespace candelabra {

/// Wall-clock time, and CPU time of all threads together.
struct Phase {
    double seconds = 0;
    double cpu_seconds = 0;

    friend Phase operator-(const Phase& a, const Phase& b) {
        return {a.seconds - b.seconds, a.cpu_seconds - b.cpu_seconds};
    }
};

/// Returns the time since a fixed but arbitrary moment; only differences are meaningful.
Phase time_now();
/// Returns only its seconds. The CPU time costs as much as a ray or two to read; rendering calls
/// this with every sample.
double seconds_now();

/// Returns the peak memory of this process in bytes.
std::size_t peak_memory_bytes();

struct RenderSettings;
struct Shot;
class SourceStore;

/// The lights that one statement makes.
struct LightStatistics {
    std::string name;        ///< as layers and weights call them
    std::string statement;   ///< its place and its beginning
    double light = 0;        ///< share of all light that reached hits from lights
    double rays = 0;         ///< share of the shadow rays
    std::size_t lights = 0;  ///< their number
};

struct RunStatistics {
    Phase parse;    ///< reading and evaluating the scene
    Phase compile;  ///< building the world
    Phase render;
    Phase total;  ///< of the whole run so far
    std::size_t objects = 0;
    std::size_t primitives = 0;
    std::size_t luminaires = 0;
    std::size_t light_sources = 0;
    LightLedger rays;
    std::vector<LightStatistics> lights;  ///< in the order of layers; empty: not counted apart
    std::string index;  ///< its name
    TreeStatistics tree;
    std::size_t light_octree_bytes = 0;   ///< 0: another sampler was used
    std::size_t light_sampler_bytes = 0;  ///< of the sampler in use
    std::size_t peak_memory_bytes = 0;
    std::string light_sampler;
    int seed = 0;
    int threads = 0;  ///< worker threads
    int width = 0;
    int height = 0;
    int samples = 0;  ///< requested; 0: as many as each pixel needs
    int shadow_rays = 0;
    bool prepared_ahead = false;  ///< the frame was prepared while the previous one was rendered
};

/// Fills in the entries that come from the world and the settings.
void complete(RunStatistics&, const Shot&, const RenderSettings&, const SourceStore&);

/// Returns a JSON object with one entry per line and a final newline.
std::string to_json(const RunStatistics&);

/// "640 x 480 in 12.3 s: 7382 objects, 7381 luminaires (light_octree); 2.1 M camera, 9.7 M shadow,
/// 0 scattered rays"
std::string summary(const RunStatistics&);

/// Formats a count in a few characters: 950, 12.3 k, 4.5 M, 1.2 G.
std::string short_count(double count);

}  // namespace candelabra
