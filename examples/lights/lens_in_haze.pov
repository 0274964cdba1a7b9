// SPDX-License-Identifier: CC0-1.0
// A glass ball gathers the light of a lamp into a beam that shows in the haze below it: photons
// light the air as well, because of the word media in the photons of global_settings.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    max_trace_level 8
    photons { count 30000 media 4 }
}

camera {
    location <0, 1.6, -7>
    right 4/3*x
    up y
    angle 44
    look_at <0.2, 1.45, 0>
}

light_source {
    <-3, 9, -1>, rgb <1.5, 1.4, 1.2>
    spotlight
    point_at <0, 2.4, 0>
    radius 8
    falloff 13
    photons { refraction on reflection on }
}

sphere {
    <0, 2.4, 0>, 0.7
    pigment { rgbt 1 }
    finish {
        ambient 0
        diffuse 0
        specular 0.8
        roughness 0.004
        reflection { 0.02, 1 fresnel }
        conserve_energy
    }
    interior { ior 1.5 }
    photons { target refraction on reflection on }
}

#declare Dull = finish { ambient 0 diffuse 0.7 }
plane { y, 0 pigment { rgb <0.35, 0.32, 0.30> } finish { Dull } }
plane { -z, -5 pigment { rgb <0.10, 0.11, 0.14> } finish { Dull } }

media { scattering { 1, 0.045 extinction 1 } }
