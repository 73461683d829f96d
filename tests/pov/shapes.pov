// Twin of shapes.toml.
#version 3.7;
#include "right_handed.inc"
global_settings {
    assumed_gamma 1.0
    ambient_light rgb <0.06, 0.06, 0.08>
    max_trace_level DeepestTrace
    adc_bailout LeastWeight
}
RightHandedCamera(<-0.6, 3.6, 5.9>, <0.0, 0.7, 0.0>, 36.0)
background { rgb <0.35, 0.45, 0.6> }

light_source {
    <-2.0, 5.0, 3.0> rgb <0.6, 0.55, 0.5>
    spotlight point_at <-2.0, 5.0, 3.0> + <1.7, -4.6, -2.4>
    radius 24 falloff 24 tightness 6
}
light_source { <2.5, 3.5, 2.5> rgb <0.9, 0.9, 0.9> fade_distance FadeDistance(0.05) fade_power 2 }
DirectionalLight(<-0.5, -1.0, -0.7>, <0.25, 0.28, 0.3>)

// The fourth corner follows; the pattern runs in metres along both edges.
#macro Parallelogram(Corner, EdgeU, EdgeV)
    polygon { 5, Corner, Corner + EdgeU, Corner + EdgeU + EdgeV, Corner + EdgeV, Corner }
#end

plane { y, 0 Matte(<0.6, 0.58, 0.55>) }
object {
    Parallelogram(<-3.1, 0.05, 0.9>, <1.5, 0.0, 0.35>, <0.5, 0.6, -1.3>)
    Checker(<0.7, 0.6, 0.3>, <0.2, 0.3, 0.2>, 0.3, <-3.1, 0.05, 0.9>,
            vnormalize(<1.5, 0.0, 0.35>), vnormalize(<0.5, 0.6, -1.3>))
}
object {
    Parallelogram(<-1.5, 0.1, -2.2>, <3.4, 0.0, -0.5>, <0.0, 2.0, -0.3>)
    Mirror(0.85, <1, 1, 1>, <0.1, 0.1, 0.1>)
}
cylinder { <-0.55, 0.02, 0.9>, <-0.55, 0.92, 0.9>, 0.5 open Matte(<0.75, 0.4, 0.25>) }
cylinder { <0.35, 0.35, 0.6>, <1.35, 0.45, -0.5>, 0.3 open Mirror(0.25, <1, 1, 1>, <0.5, 0.55, 0.6>) }
cylinder { <-1.6, 0.3, -1.0>, <-1.1, 1.2, -0.6>, 0.4 Matte(<0.2, 0.5, 0.35>) }
cylinder { <0.35, 0.28, 1.9>, <1.25, 0.48, 2.2>, 0.22 Clear(1.5, <0.3, 0.6, 0.9>) }

#declare Height = function(x, y, z) { y }
cylinder {
    <0, 0, 0>, <0, 1.3, 0>, 0.4 open
    texture { RoundChecker(<0.25, 0.45, 0.6>, <0.85, 0.85, 0.8>, 0.2, 0.4, Height) rotate 25 * y }
    translate <2.1, 0.0, -0.4>
}

disc { <-0.25, 1.2, -0.9>, <0.3, 0.8, 0.5>, 0.55 Matte(<0.55, 0.2, 0.45>) }
triangle {
    <0.7, 1.2, -1.3>, <1.7, 1.3, -0.9>, <1.1, 2.2, -1.2>
    Checker(<0.75, 0.3, 0.2>, <0.9, 0.85, 0.7>, 0.25, <0.7, 1.2, -1.3>,
            vnormalize(<1.0, 0.1, 0.4>), vnormalize(<0.4, 1.0, 0.1>))
}
triangle { <-2.6, 0.9, -0.4>, <-3.0, 2.0, -0.9>, <-1.9, 1.2, -0.7> Matte(<0.85, 0.8, 0.75>) }

#declare Arc = function(x, y, z) { 0.35 * atan2(y, sqrt(x * x + z * z)) }
sphere {
    <0, 0, 0>, 0.35
    texture { RoundChecker(<0.8, 0.75, 0.2>, <0.3, 0.15, 0.4>, 0.15, 0.35, Arc) }
    translate <1.75, 0.35, 1.3>
}
