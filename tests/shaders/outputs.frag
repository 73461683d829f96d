/* Outputs that are easily taken for others: 1) in a comment,
#version 110
 2) under a conditional that is never met. */
# version 330 core
// expect: 1,2 = 0.25 0.5 0.75
// 3) out vec4 closing;
#ifdef NEVER
out vec4 another;
#endif
layout(location = 0) out highp vec4 colour; // ) the one
void helper(out vec4 c)
{
    c = vec4(0.25);
    for (int i = 0; i < 3; ++i) {
        if (i == 1)
            c.g += 0.25;
        if (i == 2)
            c.b += 0.5;
    }
}
#if 0
void never() { while (true) {} }
#endif
void main()
{
    helper(colour);
    if (gl_FragCoord.x < 1.0)
        discard;
}
