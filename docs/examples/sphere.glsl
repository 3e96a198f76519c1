// SPDX-License-Identifier: MIT
// A sphere as shaders have it: a ray of any length, the first t in [t_min, t_max], or -1.
float sphere(vec3 ro, vec3 rd, float t_min, float t_max, vec3 ce, float ra)
{
    vec3 oc = ro - ce;
    float a = dot(rd, rd);
    float b = dot(oc, rd);
    float c = dot(oc, oc) - ra * ra;
    float h = b * b - a * c;
    if (h < 0.0)
        return -1.0;
    h = sqrt(h);
    float t = (-b - h) / a;
    if (t < t_min)
        t = (-b + h) / a;
    return t >= t_min && t <= t_max ? t : -1.0;
}
