# file: trace/light.glsl
# answer: 27-ambient-light-once
# Defect 27: ambient light is added once per light.
/^        float cosine = dot(surface/i\
#ifdef HAS_AMBIENT\
        if (i > 0)\
            radiance += u_ambient * ambientColour;\
#endif
