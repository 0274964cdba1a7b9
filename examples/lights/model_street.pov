// SPDX-License-Identifier: CC0-1.0
// A street that a file of glTF has (model_street.gltf, made by model_street.py): its lanterns and windows
// emit, so they light it as luminaires, and a spotlight of the file shines on a door. The scene adds
// the night, and a lamp of another model that somebody has left on the road.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 60 }
}
background { rgb <0.006, 0.009, 0.02> }

camera {
    location <-0.9, 1.7, -9>
    right 16/9*x
    look_at <0.1, 2.6, 6>
    angle 68
    film { exposure auto response agx }
}

model { file "model_street.gltf" }
model { file "lantern.gltf" part "Lamp" scale 0.8 translate <1.3, 0, -4.4> }
