// How a light looks at the scene for its shadow map. Lengths in metres, in the scene frame.
struct ShadowView {
    vec4 eye;     // xyz: where it looks from; w: 1 in perspective, 0 along parallel rays
    vec4 right;   // xyz: 1 over half the map's width, to the right; in perspective at unit distance ahead
    vec4 up;      // likewise
    vec4 forward; // xyz: unit; w: in perspective no more than what is nearest, metres; else 1 over half the scene's depth
};
