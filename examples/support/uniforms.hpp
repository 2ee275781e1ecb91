#pragma once

// Uniforms by name, the library's structures among them.

#include <epoxy/gl.h>
#include <airlight/atmosphere.hpp>
#include <airlight/habitat_mapping.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace support {

/// Sets uniforms of the program in use by name. A name that the shader does not use is passed over.
class Uniforms {
  public:
    explicit Uniforms(GLuint program) : program_(program) {
        glUseProgram(program);
    }

    void set(const std::string& name, int value) const {
        glUniform1i(location(name), value);
    }
    void set(const std::string& name, const glm::ivec4& v) const {
        glUniform4i(location(name), v.x, v.y, v.z, v.w);
    }
    void set(const std::string& name, float value) const {
        glUniform1f(location(name), value);
    }
    void set(const std::string& name, const airlight::vec3<float>& v) const {
        glUniform3f(location(name), v.x, v.y, v.z);
    }

    void set(const std::string& name, const airlight::Atmosphere<float>& a) const {
        set(name + ".ground_radius", a.ground_radius);
        set(name + ".top_altitude", a.top_altitude);
        set(name + ".rayleigh_scattering", a.rayleigh_scattering);
        set(name + ".rayleigh_scale_height", a.rayleigh_scale_height);
        set(name + ".mie_scattering", a.mie_scattering);
        set(name + ".mie_absorption", a.mie_absorption);
        set(name + ".mie_scale_height", a.mie_scale_height);
        set(name + ".mie_g", a.mie_g);
        set(name + ".ozone_absorption", a.ozone_absorption);
        set(name + ".ozone_altitude", a.ozone_altitude);
        set(name + ".ozone_half_width", a.ozone_half_width);
        set(name + ".ground_albedo", a.ground_albedo);
    }

    void set(const std::string& name, const airlight::HabitatAir<float>& a) const {
        set(name + ".radius", a.radius);
        set(name + ".density_rise", a.density_rise);
        set(name + ".rayleigh_scattering", a.rayleigh_scattering);
        set(name + ".mie_scattering", a.mie_scattering);
        set(name + ".mie_absorption", a.mie_absorption);
        set(name + ".mie_g", a.mie_g);
    }

    void set(const std::string& name, const airlight::HabitatLights<float>& l) const {
        set(name + ".half_length", l.half_length);
        set(name + ".begin", l.begin);
        set(name + ".end", l.end);
        set(name + ".width", l.width);
        set(name + ".radiance", l.radiance);
        set(name + ".fine", l.fine);
        set(name + ".fine_share", l.fine_share);
    }

  private:
    GLint location(const std::string& name) const {
        return glGetUniformLocation(program_, name.c_str());
    }

    GLuint program_;
};

}  // namespace support
