// What the depth buffer holds, so that the larger is the nearer: a share of what is nearest, whose digits do not run out with
// distance, as those of OpenGL's own depth do. `weight`: the homogeneous part of the place, 1 but towards infinity.
float nearness(float near_m, float weight)
{
    return near_m * weight * gl_FragCoord.w;
}
