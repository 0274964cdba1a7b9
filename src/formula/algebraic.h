// SPDX-License-Identifier: GPL-3.0-or-later
// Internal functions that are polynomials: classical algebraic surfaces and curves. Called through
// the table in internal.cpp. Arguments are x, y, z, then p0, p1, ...; the formulas are those of
// POV-Ray 3.7.
#pragma once

namespace candelabra {

namespace formula {

double algbr_cyl1(const double* arguments);
double algbr_cyl2(const double* arguments);
double algbr_cyl3(const double* arguments);
double algbr_cyl4(const double* arguments);
double bicorn(const double* arguments);
double bifolia(const double* arguments);
double boy_surface(const double* arguments);
double crossed_trough(const double* arguments);
double cubic_saddle(const double* arguments);
double cushion(const double* arguments);
double devils_curve(const double* arguments);
double devils_curve_2d(const double* arguments);
double dupin_cyclid(const double* arguments);
double enneper(const double* arguments);
double folium_surface(const double* arguments);
double folium_surface_2d(const double* arguments);
double glob(const double* arguments);
double heart(const double* arguments);
double hunt_surface(const double* arguments);
double hyperbolic_torus(const double* arguments);
double kampyle_of_eudoxus(const double* arguments);
double kampyle_of_eudoxus_2d(const double* arguments);
double klein_bottle(const double* arguments);
double kummer_surface_v1(const double* arguments);
double kummer_surface_v2(const double* arguments);
double lemniscate_of_gerono(const double* arguments);
double lemniscate_of_gerono_2d(const double* arguments);
double mitre(const double* arguments);
double nodal_cubic(const double* arguments);
double ovals_of_cassini(const double* arguments);
double parabolic_torus(const double* arguments);
double paraboloid(const double* arguments);
double pillow(const double* arguments);
double piriform(const double* arguments);
double piriform_2d(const double* arguments);
double quartic_cylinder(const double* arguments);
double quartic_paraboloid(const double* arguments);
double quartic_saddle(const double* arguments);
double steiners_roman(const double* arguments);
double strophoid(const double* arguments);
double strophoid_2d(const double* arguments);
double torus2(const double* arguments);
double torus_gumdrop(const double* arguments);
double umbrella(const double* arguments);
double witch_of_agnesi(const double* arguments);
double witch_of_agnesi_2d(const double* arguments);

}  // namespace formula

}  // namespace candelabra
