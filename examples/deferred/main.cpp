// Draws a real landscape on a planet in its air: surfaces, then light and air, then exposure and sRGB. The
// light and the air are computed by the GPU with the generated GLSL and by the CPU with the headers. Three
// fronts share one renderer: pictures, sequences of them, and a window. The inside of a habitat has another.

#include <iostream>
#include <optional>

#include "habitat/options.hpp"
#include "habitat/pictures.hpp"
#include "options.hpp"
#include "passes/pass.hpp"
#include "pictures.hpp"
#include "sequence.hpp"
#include "window.hpp"

int main(int count, char** arguments) {
    try {
        if (deferred::asks_for_habitat(count, arguments)) {
            const std::optional<deferred::habitat::Options> habitat =
                deferred::habitat::parse_options(count, arguments);
            if (habitat) {
                deferred::habitat::draw_pictures(*habitat);
            }
            return 0;
        }
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
