// What a live host moves: each at rest, by the shader's own value, or by --set.
// options: --set u_camera_target=[0.5,0.25,0.125]
// expect: 0,0 = 0.1 0.16 0.5
// expect: 3,0 = 0.75 0.42 0.9
// expect: 6,0 = 0.5 0.25 0.125
uniform int u_light_type;
uniform float u_light_height; // 7.5 [1, 9]
uniform vec3 u_camera_position;
uniform vec3 u_camera_target;
uniform float u_fov_y_deg;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec3 first = vec3(0.1 * float(u_light_type), 0.1 * u_camera_position.y, 0.1 * u_camera_position.z);
    vec3 second = vec3(0.1 * u_light_height, 0.01 * u_fov_y_deg, 0.9);
    fragColor = vec4(fragCoord.x < 3.0 ? first : fragCoord.x < 6.0 ? second : u_camera_target, 1.0);
}
