// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"

namespace candelabra::proof {

const std::vector<Law>& laws() {
    static const std::vector<Law> all = {
        {"superposition", "The picture by several lights is the sum of those by each.",
         nonlinear | gathers, staged, superposition},
        {"light", "A thousand times the light is a thousand times the picture.", nonlinear, staged,
         more_light},
        {"motion", "The scene moved, turned or mirrored with its camera is the same picture.",
         directions, staged, motion},
        {"size", "The scene at another size is the same picture.", directions | lengths | bends,
         staged, other_size},
        {"receiving", "What a point receives is what a camera there sees.",
         sources | hides | refracts | photon_light | moves | gathers | tiny_light | aside | veils,
         staged, receiving},
        {"chance", "A lamp that is sampled gives what it gives if it is found by chance.",
         hides | refracts | photon_light | gathers | tiny_light, staged, found_by_chance},
        // As in POV-Ray, air dims a source's light also where a solid keeps the air out.
        {"point", "A fading light source gives what a tiny ball of its power gives.",
         fogs | photon_light | gathers | endless, staged, point_or_ball},
        {"furnace", "What is white, or glows as much as it takes, is not seen before white.",
         gains | glows | sources | dims | bends | hides | photon_light | gathers | aside | moves |
             nonlinear,
         in_furnace, constant_one},
        {"white", "No finish reflects more light than it gets, whatever the elevation.",
         gains | glows | sources | dims | hides | photon_light | gathers | aside | moves |
             nonlinear,
         white_floor, at_most_white},
        {"strategies", "All strategies give the same mean.", no_trait, staged, any_strategy},
        {"indices", "All indices give the same bytes.", no_trait, staged, any_index},
        {"adaptive", "More samples where neighbours are noisy change no mean.", no_trait, staged,
         more_where_noisy},
        {"reflected", "Reflected luminaires change no mean.", no_trait, in_corner,
         with_reflected_luminaires},
        {"photons", "Photons bring the light that paths find by chance.",
         sources | tiny_light | gathers | hides | dims | in_lens, in_photons, photons_or_chance},
        {"writing", "What is written in another way is the same scene.", no_trait, staged,
         other_writing},
        {"instances",
         "A union that stands in many places is stored once, or taken apart: the same mean.",
         no_trait, with_copies, stored_once},
        {"running", "Threads, shards and interruptions change no byte.", no_trait, staged,
         other_runs},
        {"program", "A file made in shards, or from states, is the file made at once.", no_trait,
         staged, other_programs},
        {"outliers",
         "No sample is far brighter than its pixel where a shadow ray to each lamp has none.",
         gathers | photon_light, staged, no_glaring_samples},
        {"dark", "Lamps cost no rays where nothing receives light.", dims | gathers | photon_light,
         staged, free_in_the_dark},
        {"meters", "A meter reads the sum of what its lamps give.",
         nonlinear | gathers | fogs | hides, staged, meters_by_parts},
        {"roads", "A road whose table is that of a diffuse floor is as bright as one.",
         refracts | fogs | dims | gathers | hides | photon_light | gains | veils | tiny_light |
             in_lens,
         on_road, roads_by_tables},
    };
    return all;
}

}  // namespace candelabra::proof
