// Twin of glsl/scenes/still_life.toml, with planet.png on the planet; tests/pov_anchor times it. Pictures are sought
// where POV-Ray is run.
//
// What POV-Ray has no word for:
// - Between texels `interpolate 2` is dioptre's bilinear filter, but there are no smaller levels of a picture: what is
//   far off or small is grainier here than in dioptre's picture of the same size.
// - `specular` is a number, so the highlights of frame and cylinder are grey in place of slightly warm.
// - The glass tints and fades its shadow but not the view through it, and the lamp's ball stands in the sun's way but
//   not in its own light's. Each has a second shape for that, which shadow rays alone meet.
#version 3.7;
#include "right_handed.inc"

// A tenth level is enough: with a hundred, one pixel of 160000 differs by more than 0.01. POV-Ray's own limit of
// weight, 1/255, stays.
global_settings {
    assumed_gamma 1.0
    ambient_light rgb <0.25, 0.29, 0.36>
    max_trace_level 10
}
RightHandedCamera(<0.25, 1.22, 6.4>, <-0.12, 0.93, 0.0>, 27.5)

sky_sphere {
    pigment {
        image_map { exr "sky.exr" map_type 1 interpolate 2 }
        rotate -90 * y // as in sky.pov
    }
}
DirectionalLight(<0.702, -0.454, -0.549>, <1.20, 1.00, 0.76>)

// The u axis, v axis and corner of a picture or of a shape in the unit square.
#macro OnEdges(EdgeU, EdgeV, Corner)
    #local N = vcross(EdgeU, EdgeV);
    matrix < EdgeU.x, EdgeU.y, EdgeU.z, EdgeV.x, EdgeV.y, EdgeV.z, N.x, N.y, N.z, Corner.x, Corner.y, Corner.z >
#end
#macro UnitSquare()
    5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>
#end

plane {
    y, 0
    texture {
        pigment {
            image_map { png "floor.png" gamma srgb interpolate 2 }
            OnEdges(<2.4, 0, 0>, <0, 0, -2.4>, <0.3, 0.0, 0.3>)
        }
    }
}

// Blinn's highlight (N.H)^4s is `specular` with a roughness of 1 / 4s.
polygon {
    UnitSquare()
    texture { pigment { srgb <28, 23, 20> / 255 } finish { specular 0.14 roughness 1 / 120 } }
    OnEdges(<2.98, 0.0, -0.31>, <-0.012, 2.30, -0.12>, <-2.16, 0.0, -1.42>)
}
polygon {
    UnitSquare()
    texture { pigment { image_map { png "wave.png" gamma srgb interpolate 2 } } }
    OnEdges(<2.785, 0.0, -0.29>, <-0.011, 2.097, -0.11>, <-2.057, 0.1, -1.40>)
}
disc { <1.62, 0.953, -2.1>, <-0.30, 0.12, 1.0>, 0.96 Matte(<0.055, 0.25, 0.13>) }
cylinder {
    <1.32, 0.0, -0.55>, <1.32, 0.86, -0.55>, 0.40
    texture { pigment { rgb <0.03, 0.10, 0.36> } finish { specular 0.33 roughness 1 / 96 } }
}
triangle { <-2.25, 0.0, 0.20>, <-1.42, 0.0, 0.62>, <-1.86, 1.02, 0.12> Matte(<0.44, 0.034, 0.018>) }
sphere { <0.46, 0.46, 0.55>, 0.46 Mirror(0.92, <1.0, 0.98, 0.95>, <0.05, 0.05, 0.05>) }

// On a sphere dioptre's u runs against POV-Ray's; its middle lies along +z, and is turned from there by 20 degrees.
sphere {
    <0, 0, 0>, 0.42
    texture {
        pigment {
            image_map { png "planet.png" gamma srgb map_type 1 interpolate 2 }
            scale <-1, 1, 1>
            rotate (20 - 90) * y
        }
    }
    translate <1.32, 1.28, -0.55>
}

// fade_power 1001 fades by exp(-(1 - fade_color) d / fade_distance), at less cost than a medium. It forgets the light
// that is reflected inside, which is a few hundredths of the light and would lose a tenth of that.
#declare GlassBall = sphere {
    <-0.55, 0.36, 1.25>, 0.36
    interior { ior 1.52 fade_distance 1 fade_power 1001 fade_color rgb 1 - <0.16, 0.05, 0.08> }
    hollow
}
#declare Unlit = finish { ambient 0 diffuse 0 }
object {
    GlassBall
    texture {
        pigment { rgbt 1 }
        finish { Unlit reflection { 0, 1 fresnel on } conserve_energy }
    }
    no_shadow
}
object {
    GlassBall
    texture { pigment { rgb <0.62, 0.68, 0.66> filter 1 } finish { Unlit } }
    interior_texture { pigment { rgbt 1 } finish { Unlit } } // a ray to the light is tinted once
    no_image
    no_reflection
}

// Attenuation 2 / (1 + (d / fade_distance)^2) of so small a fade_distance is as good as 2 (fade_distance / d)^2, and
// stands for (r / d)^2.
#declare LampCentre = <1.02, 0.15, 1.15>;
#declare LampRadius = 0.15;
#declare LampColour = <1.30, 0.70, 0.26>;
#declare Near = 0.001;
light_source {
    LampCentre
    rgb LampColour * pow(LampRadius / Near, 2) / 2
    fade_distance Near
    fade_power 2
}
sphere {
    LampCentre, LampRadius
    texture { pigment { rgb LampColour } finish { Unlit emission 1 reflection { 0.08 } } }
    no_shadow
}
// What stands in the sun's way is the ball's great circle; the lamp's own light starts on it.
disc {
    LampCentre, <0.702, -0.454, -0.549>, LampRadius
    no_image
    no_reflection
}
