// Draws a real landscape on a planet in its air: surfaces, then light and air, then exposure and sRGB. The
// light and the air are computed by the GPU with the generated GLSL and by the CPU with the headers. Three
// fronts share one renderer: pictures, sequences of them, and a window.

#include <iostream>
#include <optional>

#include "options.hpp"
#include "passes/pass.hpp"
#include "pictures.hpp"
#include "sequence.hpp"
#include "window.hpp"

int main(int count, char** arguments) {
    try {
        const std::optional<deferred::Options> options = deferred::parse_options(count, arguments);
        if (options && !options->shaders.empty()) {
            deferred::set_shader_folder(options->shaders);
        }
        if (options && options->window) {
            deferred::run_window(*options);
        } else if (options && options->sequence) {
            deferred::draw_sequence(*options);
        } else if (options) {
            deferred::draw_pictures(*options);
        }
        return 0;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "deferred: " << error.what() << "\n";
        return 1;
    }
}
