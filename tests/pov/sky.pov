// Twin of sky.toml. Declare=MirrorU=1 stands for sky.mirror_u, Declare=Png=1 for the other picture.
#version 3.7;
#ifndef (MirrorU) #declare MirrorU = 0; #end
#ifndef (Png) #declare Png = 0; #end
#include "right_handed.inc"
global_settings {
    assumed_gamma 1.0
    ambient_light 0
    max_trace_level DeepestTrace
    adc_bailout LeastWeight
}
RightHandedCamera(<0.3, 0.9, 3.2>, <0.0, 0.1, 0.0>, 62.0)

// POV-Ray's picture has u = 0 at +x and runs to +z. In our frame that is the same sense as dioptre's, whose middle lies
// at -z, a quarter turn away. It seems mirrored where scenes are written left-handed, as POV-Ray's own are. `rotate`
// about y turns from +z to +x, counter-clockwise from above, as rotation_deg.
sky_sphere {
    pigment {
        #if (Png)
            image_map { png "panorama.png" gamma srgb map_type 1 interpolate 2 }
        #else
            image_map { exr "panorama.exr" map_type 1 interpolate 2 }
        #end
        rotate -90 * y
        #if (MirrorU) scale <-1, 1, 1> #end
        rotate 130 * y
    }
}

DirectionalLight(<-1.0, -2.0, -1.0>, <0.8, 0.8, 0.75>)

sphere { <-0.75, 0.1, 0.0>, 0.8 Mirror(0.9, <1, 1, 1>, <0.4, 0.3, 0.2>) }
sphere { <0.95, 0.0, 0.4>, 0.6 Clear(1.5, <0, 0, 0>) }
disc { <0.0, -0.75, 0.3>, <0, 1, 0>, 1.7 Mirror(1.0, <0.9, 0.95, 1.0>, <1, 1, 1>) }
cylinder { <0.3, -0.7, -0.9>, <0.3, 0.9, -0.9>, 0.12 Matte(<0.7, 0.7, 0.65>) }
