// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/internal.h"

#include "formula/algebraic.h"
#include "formula/fractal_noise.h"
#include "formula/solid.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr auto table = std::array{
    InternalFunction{0, "f_algbr_cyl1", 8, formula::algbr_cyl1},
    InternalFunction{1, "f_algbr_cyl2", 8, formula::algbr_cyl2},
    InternalFunction{2, "f_algbr_cyl3", 8, formula::algbr_cyl3},
    InternalFunction{3, "f_algbr_cyl4", 8, formula::algbr_cyl4},
    InternalFunction{4, "f_bicorn", 5, formula::bicorn},
    InternalFunction{5, "f_bifolia", 5, formula::bifolia},
    InternalFunction{6, "f_blob", 8, formula::blob},
    InternalFunction{7, "f_blob2", 7, formula::blob2},
    InternalFunction{8, "f_boy_surface", 5, formula::boy_surface},
    InternalFunction{9, "f_comma", 4, formula::comma},
    InternalFunction{10, "f_cross_ellipsoids", 7, formula::cross_ellipsoids},
    InternalFunction{11, "f_crossed_trough", 4, formula::crossed_trough},
    InternalFunction{12, "f_cubic_saddle", 4, formula::cubic_saddle},
    InternalFunction{13, "f_cushion", 4, formula::cushion},
    InternalFunction{14, "f_devils_curve", 4, formula::devils_curve},
    InternalFunction{15, "f_devils_curve_2d", 9, formula::devils_curve_2d},
    InternalFunction{16, "f_dupin_cyclid", 9, formula::dupin_cyclid},
    InternalFunction{17, "f_ellipsoid", 6, formula::ellipsoid},
    InternalFunction{18, "f_enneper", 4, formula::enneper},
    InternalFunction{19, "f_flange_cover", 7, formula::flange_cover},
    InternalFunction{20, "f_folium_surface", 6, formula::folium_surface},
    InternalFunction{21, "f_folium_surface_2d", 9, formula::folium_surface_2d},
    InternalFunction{22, "f_glob", 4, formula::glob},
    InternalFunction{23, "f_heart", 4, formula::heart},
    InternalFunction{24, "f_helical_torus", 13, formula::helical_torus},
    InternalFunction{25, "f_helix1", 10, formula::helix1},
    InternalFunction{26, "f_helix2", 10, formula::helix2},
    InternalFunction{27, "f_hex_x", 4, formula::hex_x},
    InternalFunction{28, "f_hex_y", 4, formula::hex_y},
    InternalFunction{29, "f_hetero_mf", 9, formula::hetero_mf},
    InternalFunction{30, "f_hunt_surface", 4, formula::hunt_surface},
    InternalFunction{31, "f_hyperbolic_torus", 6, formula::hyperbolic_torus},
    InternalFunction{32, "f_isect_ellipsoids", 7, formula::isect_ellipsoids},
    InternalFunction{33, "f_kampyle_of_eudoxus", 6, formula::kampyle_of_eudoxus},
    InternalFunction{34, "f_kampyle_of_eudoxus_2d", 9, formula::kampyle_of_eudoxus_2d},
    InternalFunction{35, "f_klein_bottle", 4, formula::klein_bottle},
    InternalFunction{36, "f_kummer_surface_v1", 4, formula::kummer_surface_v1},
    InternalFunction{37, "f_kummer_surface_v2", 7, formula::kummer_surface_v2},
    InternalFunction{38, "f_lemniscate_of_gerono", 4, formula::lemniscate_of_gerono},
    InternalFunction{39, "f_lemniscate_of_gerono_2d", 9, formula::lemniscate_of_gerono_2d},
    InternalFunction{40, "f_mesh1", 8, formula::mesh1},
    InternalFunction{41, "f_mitre", 4, formula::mitre},
    InternalFunction{42, "f_nodal_cubic", 4, formula::nodal_cubic},
    InternalFunction{43, "f_odd", 4, formula::cushion},
    InternalFunction{44, "f_ovals_of_cassini", 7, formula::ovals_of_cassini},
    InternalFunction{45, "f_paraboloid", 4, formula::paraboloid},
    InternalFunction{46, "f_parabolic_torus", 6, formula::parabolic_torus},
    InternalFunction{47, "f_ph", 3, formula::ph},
    InternalFunction{48, "f_pillow", 4, formula::pillow},
    InternalFunction{49, "f_piriform", 4, formula::piriform},
    InternalFunction{50, "f_piriform_2d", 10, formula::piriform_2d},
    InternalFunction{51, "f_poly4", 8, formula::poly4},
    InternalFunction{52, "f_polytubes", 9, formula::polytubes},
    InternalFunction{53, "f_quantum", 4, formula::quantum},
    InternalFunction{54, "f_quartic_paraboloid", 4, formula::quartic_paraboloid},
    InternalFunction{55, "f_quartic_saddle", 4, formula::quartic_saddle},
    InternalFunction{56, "f_quartic_cylinder", 6, formula::quartic_cylinder},
    InternalFunction{57, "f_r", 3, formula::r},
    InternalFunction{58, "f_ridge", 9, formula::ridge},
    InternalFunction{59, "f_ridged_mf", 9, formula::ridged_mf},
    InternalFunction{60, "f_rounded_box", 7, formula::rounded_box},
    InternalFunction{61, "f_sphere", 4, formula::sphere},
    InternalFunction{62, "f_spikes", 8, formula::spikes},
    InternalFunction{63, "f_spikes_2d", 7, formula::spikes_2d},
    InternalFunction{64, "f_spiral", 9, formula::spiral},
    InternalFunction{65, "f_steiners_roman", 4, formula::steiners_roman},
    InternalFunction{66, "f_strophoid", 7, formula::strophoid},
    InternalFunction{67, "f_strophoid_2d", 10, formula::strophoid_2d},
    InternalFunction{68, "f_superellipsoid", 5, formula::superellipsoid},
    InternalFunction{69, "f_th", 3, formula::th},
    InternalFunction{70, "f_torus", 5, formula::torus},
    InternalFunction{71, "f_torus2", 6, formula::torus2},
    InternalFunction{72, "f_torus_gumdrop", 4, formula::torus_gumdrop},
    InternalFunction{73, "f_umbrella", 4, formula::umbrella},
    InternalFunction{74, "f_witch_of_agnesi", 5, formula::witch_of_agnesi},
    InternalFunction{75, "f_witch_of_agnesi_2d", 9, formula::witch_of_agnesi_2d},
    InternalFunction{76, "f_noise3d", 3, formula::noise3d},
    InternalFunction{78, "f_noise_generator", 4, formula::noise_of_generator},
};

}  // namespace

const InternalFunction* internal_function(int number) {
    const auto found = std::ranges::lower_bound(table, number, {}, &InternalFunction::number);
    return found != table.end() && found->number == number ? &*found : nullptr;
}

std::span<const InternalFunction> internal_functions() { return table; }

}  // namespace candelabra
