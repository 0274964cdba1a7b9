// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of each law, one file each, and stages of their own. A new law is a file here, a line
// in this header and a line in the table of laws.cpp.
#pragma once

#include "proof/changes.h"

namespace candelabra::proof {

using Claims = std::vector<Claim>;

Claims superposition(const Script&, Dice&);
Claims more_light(const Script&, Dice&);
Claims motion(const Script&, Dice&);
Claims other_size(const Script&, Dice&);
Claims receiving(const Script&, Dice&);
Claims found_by_chance(const Script&, Dice&);
Claims point_or_ball(const Script&, Dice&);
Claims constant_one(const Script&, Dice&);
Claims at_most_white(const Script&, Dice&);
Claims any_strategy(const Script&, Dice&);
Claims any_index(const Script&, Dice&);
Claims more_where_noisy(const Script&, Dice&);
Claims with_reflected_luminaires(const Script&, Dice&);
Claims photons_or_chance(const Script&, Dice&);
Claims other_writing(const Script&, Dice&);
Claims stored_once(const Script&, Dice&);
Claims other_runs(const Script&, Dice&);
Claims other_programs(const Script&, Dice&);
Claims no_glaring_samples(const Script&, Dice&);
Claims free_in_the_dark(const Script&, Dice&);
Claims meters_by_parts(const Script&, Dice&);
Claims roads_by_tables(const Script&, Dice&);

Script in_furnace(Draft&);
Script white_floor(Draft&);
Script in_photons(Draft&);
Script in_corner(Draft&);
Script on_road(Draft&);
Script with_copies(Draft&);

}  // namespace candelabra::proof
