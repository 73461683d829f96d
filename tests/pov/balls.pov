// Twin of balls.toml.
#version 3.7;
#include "right_handed.inc"
global_settings {
    assumed_gamma 1.0
    ambient_light rgb <0.12, 0.12, 0.15>
    max_trace_level DeepestTrace
    adc_bailout LeastWeight
}
RightHandedCamera(<0.5, 1.9, 5.5>, <0.1, 0.8, 0.0>, 40.0)

// Mixed by the sine of the elevation: y runs over -1..1.
sky_sphere {
    pigment {
        gradient y
        color_map { [0.0 rgb <0.25, 0.2, 0.2>] [0.5 rgb <0.75, 0.8, 0.85>] [1.0 rgb <0.15, 0.3, 0.65>] }
        translate -0.5 * y
        scale 2
    }
}

light_source { <3.0, 4.5, 3.5> rgb <0.7, 0.68, 0.6> fade_distance FadeDistance(0.02) fade_power 2 }
DirectionalLight(<1.0, -1.2, -0.5>, <0.3, 0.3, 0.35>)

plane { y, 0 Checker(<0.75, 0.72, 0.65>, <0.15, 0.2, 0.25>, 1.1, <0, 0, 0>, <1, 0, 0>, <0, 0, -1>) }
difference {
    sphere { <0.6, 0.8, 1.2>, 0.8 }
    sphere { <0.85, 1.0, 1.35>, 0.22 }
    Clear(1.5, <0.5, 0.15, 0.3>)
}
sphere { <0.25, 0.5, 1.2>, 0.2 Matte(<0.8, 0.15, 0.1>) }
sphere { <-1.3, 1.0, -0.4>, 1.0 Mirror(0.8, <1.0, 0.92, 0.8>, <0.3, 0.3, 0.35>) }
sphere { <1.5, 0.55, -1.2>, 0.55 Mirror(1.0, <0.9, 0.9, 0.95>, <1, 1, 1>) }
sphere {
    <-0.75, 0.35, 1.5>, 0.35
    texture {
        pigment { rgb <0.1, 0.35, 0.6> }
        finish { phong 0.5 phong_size 30 }
    }
}
sphere {
    <1.85, 0.3, 0.9>, 0.3
    texture {
        pigment { rgb <0.2, 0.1, 0.05> }
        // POV-Ray multiplies emission by the pigment.
        finish { emission rgb <0.7 / 0.2, 0.45 / 0.1, 0.15 / 0.05> }
    }
}
