// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/algebraic.h"

#include "formula/values.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("polynomial surfaces have POV-Ray's values", "[formula]") {
    check_values({
        {"f_algbr_cyl1", {0.35, 0.55, 0.75, 0.95, 1.15}, 0.03679845},
        {"f_algbr_cyl2", {0.35, 0.55, 0.75, 0.95, 1.15}, 0.01461234},
        {"f_algbr_cyl3", {0.35, 0.55, 0.75, 0.95, 1.15}, -0.05970814},
        {"f_algbr_cyl4", {0.35, 0.55, 0.75, 0.95, 1.15}, -0.04179007},
        {"f_bicorn", {0.35, 0.55}, -0.12525928},
        {"f_bifolia", {0.35, 0.55}, -0.09087252},
        {"f_boy_surface", {0.35, 0.55}, -10.00000000},
        {"f_crossed_trough", {0.35}, -0.13607199},
        {"f_cubic_saddle", {0.35}, -0.18399605},
        {"f_cushion", {0.35}, -0.40414071},
        {"f_devils_curve", {0.35}, -0.05446981},
        {"f_devils_curve_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, -0.01929029},
        {"f_dupin_cyclid", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, -0.12623824},
        {"f_enneper", {0.35}, 0.00260484},
        {"f_folium_surface", {0.35, 0.55, 0.75}, 0.15544923},
        {"f_folium_surface_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, -0.26134317},
        {"f_glob", {0.35}, -0.17333783},
        {"f_heart", {0.35}, -0.00197906},
        {"f_hunt_surface", {0.35}, 10.00000000},
        {"f_hyperbolic_torus", {0.35, 0.55, 0.75}, -0.13105462},
        {"f_kampyle_of_eudoxus", {0.35, 0.55, 0.75}, -0.17936002},
        {"f_kampyle_of_eudoxus_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, -0.06606829},
        {"f_klein_bottle", {0.35}, -1.06804537},
        {"f_kummer_surface_v1", {0.35}, -0.15505871},
        {"f_kummer_surface_v2", {0.35, 0.55, 0.75, 0.95}, 0.18091698},
        {"f_lemniscate_of_gerono", {0.35}, -0.14505232},
        {"f_lemniscate_of_gerono_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, -0.05615304},
        {"f_mitre", {0.35}, -0.04958446},
        {"f_nodal_cubic", {0.35}, -0.46385325},
        {"f_odd", {0.35}, -0.40414071},
        {"f_ovals_of_cassini", {0.35, 0.55, 0.75, 0.95}, -0.04421730},
        {"f_paraboloid", {0.35}, -0.00035000},
        {"f_parabolic_torus", {0.35, 0.55, 0.75}, -0.05437801},
        {"f_pillow", {0.35}, -0.15802074},
        {"f_piriform", {0.35}, 0.16826047},
        {"f_piriform_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35, 1.55}, -0.05805086},
        {"f_quartic_paraboloid", {0.35}, 0.10682167},
        {"f_quartic_saddle", {0.35}, 0.18071368},
        {"f_quartic_cylinder", {0.35, 0.55, 0.75}, -0.04932223},
        {"f_steiners_roman", {0.35}, -0.01094565},
        {"f_strophoid", {0.35, 0.55, 0.75, 0.95}, -0.05109439},
        {"f_strophoid_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35, 1.55}, -0.10824904},
        {"f_torus2", {0.35, 0.55, 0.75}, 0.13844993},
        {"f_torus_gumdrop", {0.35}, -2.41959249},
        {"f_umbrella", {0.35}, 0.01412530},
        {"f_witch_of_agnesi", {0.35, 0.55}, 0.04976300},
        {"f_witch_of_agnesi_2d", {0.35, 0.55, 0.75, 0.95, 1.15, 1.35}, 0.18201287},
    });
}

TEST_CASE("Enneper's surface has no pole", "[formula]") {
    CHECK(value_of("f_enneper", {0.074, -0.527, -0.077, 0.1}) == Approx(0.0377746018));
    CHECK(value_of("f_enneper", {-0.557, 0.938, 0.132, 1.198}) == Approx(0.1563573051));
}

}  // namespace candelabra
