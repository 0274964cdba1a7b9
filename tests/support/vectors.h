// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts with what POV-Ray 3.7 printed for them (*.json, one file a group): `prints`, `fails` when
// it stopped with an error, `writes` for the bytes (as characters) of o.txt. `prefix` stands before
// a script, or before all of a group. A script that does not agree yet says why in `unmatched`:
// "not yet: torus", or "deliberate: ..." where POV-Ray's answer is not one to follow. The test
// fails when such a script begins to agree, so that the line is taken away; UPDATE_EXPECTED=1 takes
// away all that can go.
#pragma once

#include <string>

namespace candelabra {

/// Runs all scripts in a folder below tests/; says how many there were.
std::size_t check_scripts(const std::string& folder);

}  // namespace candelabra
