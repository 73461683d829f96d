// Twin of pool.toml.
#version 3.7;
#include "right_handed.inc"
global_settings {
    assumed_gamma 1.0
    ambient_light rgb <0.1, 0.1, 0.1>
    max_trace_level DeepestTrace
    adc_bailout LeastWeight
}
RightHandedCamera(<0.4, 2.0, 4.4>, <0.0, -0.35, 0.0>, 42.0)

// Mixed by the sine of the elevation: y runs over -1..1.
sky_sphere {
    pigment {
        gradient y
        color_map { [0.0 rgb <0.2, 0.2, 0.2>] [0.5 rgb <0.7, 0.75, 0.8>] [1.0 rgb <0.25, 0.4, 0.7>] }
        translate -0.5 * y
        scale 2
    }
}

light_source { <-2.0, 3.5, 2.0> rgb <0.6, 0.6, 0.55> }
DirectionalLight(<-0.8, -1.6, -0.5>, <0.4, 0.4, 0.4>)

// The bubble is cut out of the water: POV-Ray 3.7 forgets the reflection at the inner side of a medium in a medium.
difference {
    plane { y, 0 }
    sphere { <0.35, -0.6, 0.9>, 0.42 }
    Clear(1.33, <0.45, 0.12, 0.08>)
}
plane {
    y, -1.1
    Checker(<0.85, 0.85, 0.8>, <0.35, 0.5, 0.55>, 0.6, <0, -1.1, 0>, <1, 0, 0>, <0, 0, -1>)
}
sphere { <-0.8, 0.1, -0.3>, 0.55 Matte(<0.8, 0.35, 0.1>) }
cylinder { <0.9, -1.3, -0.9>, <1.1, 1.1, -0.8>, 0.16 Matte(<0.6, 0.6, 0.65>) }
