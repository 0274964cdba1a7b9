// SPDX-License-Identifier: GPL-3.0-or-later
// Internal functions that are distances, or resemble distances: tubes, helices, boxes, waves in a
// plane, and the coordinates of a point by radius and angles. Called through the table in
// internal.cpp. Arguments are x, y, z, then p0, p1, ...; the formulas are those of POV-Ray 3.7.
#pragma once

namespace candelabra {

namespace formula {

double blob(const double* arguments);
double blob2(const double* arguments);
double comma(const double* arguments);
double cross_ellipsoids(const double* arguments);
double ellipsoid(const double* arguments);
double flange_cover(const double* arguments);
double helical_torus(const double* arguments);
double helix1(const double* arguments);
double helix2(const double* arguments);
double hex_x(const double* arguments);
double hex_y(const double* arguments);
double isect_ellipsoids(const double* arguments);
double mesh1(const double* arguments);
double ph(const double* arguments);
double poly4(const double* arguments);
double polytubes(const double* arguments);
double quantum(const double* arguments);
double r(const double* arguments);
double rounded_box(const double* arguments);
double sphere(const double* arguments);
double spikes(const double* arguments);
double spikes_2d(const double* arguments);
double spiral(const double* arguments);
double superellipsoid(const double* arguments);
double th(const double* arguments);
double torus(const double* arguments);

}  // namespace formula

}  // namespace candelabra
