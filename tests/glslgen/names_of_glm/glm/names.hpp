// The names of GLM that the pairs use, without the bodies: reading a header needs no more, and a pair then
// takes milliseconds. The real headers are read with the real GLM (test glslgen.generated).
#pragma once

namespace glm {

enum qualifier { defaultp };

template <int length, typename T, qualifier q>
struct vec;

#define AIRLIGHT_NAME(name)                     \
    template <typename First, typename... Rest> \
    First name(const First& first, const Rest&... rest)
AIRLIGHT_NAME(abs);
AIRLIGHT_NAME(acos);
AIRLIGHT_NAME(ceil);
AIRLIGHT_NAME(clamp);
AIRLIGHT_NAME(cos);
AIRLIGHT_NAME(cross);
AIRLIGHT_NAME(distance);
AIRLIGHT_NAME(dot);
AIRLIGHT_NAME(exp);
AIRLIGHT_NAME(exp2);
AIRLIGHT_NAME(floor);
AIRLIGHT_NAME(fract);
AIRLIGHT_NAME(inversesqrt);
AIRLIGHT_NAME(length);
AIRLIGHT_NAME(log);
AIRLIGHT_NAME(log2);
AIRLIGHT_NAME(max);
AIRLIGHT_NAME(min);
AIRLIGHT_NAME(mix);
AIRLIGHT_NAME(mod);
AIRLIGHT_NAME(normalize);
AIRLIGHT_NAME(pow);
AIRLIGHT_NAME(round);
AIRLIGHT_NAME(roundEven);
AIRLIGHT_NAME(sign);
AIRLIGHT_NAME(smoothstep);
AIRLIGHT_NAME(sqrt);
AIRLIGHT_NAME(step);
AIRLIGHT_NAME(trunc);
#undef AIRLIGHT_NAME

}  // namespace glm
