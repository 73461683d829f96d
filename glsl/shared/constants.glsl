// Numbers that the shaders, the host and the double-precision reference must agree on.

const float PI = 3.14159265358979323846;

// Stands for "no hit within reach" and for the ends of a span that never ends; metres.
const float FAR_AWAY = 1.0e30;

// Nearer than this a point light grows no brighter; metres. A glowing sphere uses its radius.
const float NEAREST_LIGHT = 1.0e-3;

// Half the distance from 1 to the next float, whatever the arithmetic at hand.
const float SINGLE_ROUNDOFF = 5.9604644775390625e-8;

// Half the distance from 1 to the next number, and what splits a number into halves of its bits (Dekker): of the float
// arithmetic at hand.
#ifdef HAS_DOUBLE
const float UNIT_ROUNDOFF = 1.1102230246251565e-16;
const float SPLITTER = 134217729.0;
#else
const float UNIT_ROUNDOFF = 5.9604644775390625e-8;
const float SPLITTER = 4097.0;
#endif

// A place that is uncertain by more than this share of the smallest thing that there is to see of its surface means nothing;
// and the least weight of a path that is asked for it.
const float TRUSTED_SHARE = 0.1;
const float TRUSTED_WEIGHT = 0.0625;

// Shape kinds.
const int KIND_SPHERE = 0;
const int KIND_OPEN_CYLINDER = 1;
const int KIND_CAPPED_CYLINDER = 2;
const int KIND_PLANE = 3;
const int KIND_DISK = 4;
const int KIND_RECTANGLE = 5;
const int KIND_TRIANGLE = 6;
const int KIND_COUNT = 7;

// Reflectance models.
const int MODEL_LAMBERT = 0;
const int MODEL_PHONG = 1;
const int MODEL_BLINN = 2;
const int MODEL_MICROFACET = 3;

// What a material does to light on its way to a surface behind it.
const int SHADOW_OPAQUE = 0;
const int SHADOW_TINTED = 1;
const int SHADOW_NONE = 2;
