#include "window.hpp"

#define GLFW_INCLUDE_NONE
#include <epoxy/gl.h>
// After epoxy.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "baker.hpp"
#include "comparison.hpp"
#include "cpu_frame.hpp"
#include "panel.hpp"
#include "path.hpp"
#include "picture_files.hpp"
#include "renderer.hpp"
#include "settings_text.hpp"
#include "steering.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_context.hpp"

namespace deferred {
namespace {

constexpr double hours_per_pixel = 0.01;   // that the sun is dragged sideways
constexpr double degrees_per_pixel = 0.1;  // and up and down
constexpr double ride_seconds = 40;        // from the ground into space
constexpr int ride_stations = 4001;        // on the way
constexpr double longest_step = 0.25;    // [s] that anything moves in one frame, however slow the frames are
constexpr double settle_seconds = 0.15;  // a window that is being resized gets its passes when it rests
constexpr double idle_seconds = 0.05;    // between two looks at what goes on in the background
constexpr int samples_across = 64;       // of the picture, for its exposure
constexpr int samples_up = 36;
constexpr int reference_nodes = 24;

std::string last_glfw_error;

void keep_glfw_error(int, const char* text) {
    last_glfw_error = text;
    last_glfw_error.erase(last_glfw_error.find_last_not_of(" \n") + 1);
}

/// GLFW and a window with an OpenGL 4.3 core context that is current.
class Glfw {
  public:
    Glfw(int width, int height) {
        glfwSetErrorCallback(keep_glfw_error);
        if (glfwInit() != GLFW_TRUE) {
            throw support::Error("no window: " + last_glfw_error +
                                 "; give a display, or leave --window away for pictures");
        }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        // The picture brings its own depth, and is encoded as sRGB before it comes here.
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
        window = glfwCreateWindow(width, height, "airlight", nullptr, nullptr);
        if (window == nullptr) {
            glfwTerminate();
            throw support::Error("no OpenGL 4.3 in a window: " + last_glfw_error +
                                 "; use a newer driver, or leave --window away for pictures");
        }
        glfwMakeContextCurrent(window);
        glfwSwapInterval(1);
    }
    ~Glfw() {
        glfwDestroyWindow(window);
        glfwTerminate();
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

    GLFWwindow* window;
};

/// Dear ImGui, drawing into a window.
class Gui {
  public:
    explicit Gui(GLFWwindow* window) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
        ImGui::StyleColorsDark();
        float scale = 1;
        glfwGetWindowContentScale(window, &scale, nullptr);
        if (scale > 1) {
            ImGui::GetIO().FontGlobalScale = scale;
            ImGui::GetStyle().ScaleAllSizes(scale);
        }
        // On top of the callbacks that are there already, which it calls.
        ImGui_ImplGlfw_InitForOpenGL(window, true);
        ImGui_ImplOpenGL3_Init("#version 430 core");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
};

std::string gl_text(GLenum name) {
    const GLubyte* const text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

World with_nodes(World world, int nodes) {
    world.nodes = nodes;
    return world;
}

class Window {
  public:
    explicit Window(const Options& options)
        : options_(options),
          terrain_(read_height_map(options.height_map, options.step_east, options.step_north)),
          controls_(start(options)),
          world_(options.world),
          view_(make_view(controls_.camera, picturing(options.width, options.height),
                          double(world_.atmosphere.ground_radius), terrain_)),
          glfw_(options.width, options.height) {
        glfwSetWindowUserPointer(glfw_.window, this);
        glfwSetKeyCallback(glfw_.window, [](GLFWwindow* window, int key, int, int action, int) {
            if (action == GLFW_PRESS && !ImGui::GetIO().WantCaptureKeyboard) {
                static_cast<Window*>(glfwGetWindowUserPointer(window))->press(key);
            }
        });
        glfwSetCursorPosCallback(glfw_.window, [](GLFWwindow* window, double x, double y) {
            static_cast<Window*>(glfwGetWindowUserPointer(window))->drag(x, y);
        });
        glfwSetScrollCallback(glfw_.window, [](GLFWwindow* window, double, double up) {
            if (!ImGui::GetIO().WantCaptureMouse) {
                static_cast<Window*>(glfwGetWindowUserPointer(window))->zoom(up);
            }
        });
        gui_ = std::make_unique<Gui>(glfw_.window);
        status_.driver = "OpenGL " + gl_text(GL_VERSION) + " on " + gl_text(GL_RENDERER);
        std::printf("%s\n", status_.driver.c_str());
        std::fflush(stdout);
        if (options.window_frames) {
            tables_ = bake_tables(options.tables, world_);
        } else {
            // The first picture at once: single scattering needs no table.
            tables_ = bake_tables(TableKind::none, world_);
            bake();
        }
    }

    void run() {
        double last = glfwGetTime();
        for (int frame = 0; glfwWindowShouldClose(glfw_.window) != GLFW_TRUE; ++frame) {
            if (options_.window_frames && frame == *options_.window_frames) {
                break;
            }
            if (std::size_t(frame) < options_.window_sizes.size()) {
                const auto& [width, height] = options_.window_sizes[std::size_t(frame)];
                glfwSetWindowSize(glfw_.window, width, height);
            }
            if (options_.window_frames || moving_) {
                glfwPollEvents();
            } else {
                glfwWaitEventsTimeout(idle_seconds);
            }
            const double now = glfwGetTime();
            move(std::min(now - last, longest_step));
            status_.frame_seconds += 0.2 * (now - last - status_.frame_seconds);
            last = now;

            glfwGetFramebufferSize(glfw_.window, &width_, &height_);
            if (width_ < 1 || height_ < 1) {
                glfwWaitEventsTimeout(idle_seconds);  // iconified: nothing to draw on
                continue;
            }
            draw(now);
            if (options_.window_frames && frame + 1 == *options_.window_frames &&
                !options_.screenshot.empty()) {
                write_window(options_.screenshot);
            }
            glfwSwapBuffers(glfw_.window);
        }
        if (options_.times) {
            for (const PassTime& pass : renderer_->timers().read(true)) {
                std::printf("%-12s %9.3f ms on the GPU\n", pass.name.c_str(), pass.milliseconds);
            }
        }
    }

  private:
    static Controls start(const Options& options) {
        Controls controls{};
        controls.world = options.world;
        controls.tables = options.tables;
        controls.settings = options.settings;
        controls.camera = options.cameras.front();
        controls.sun_elevation = options.sun_elevations.front();
        controls.sun_azimuth = std::fmod(options.sun_azimuth + 360, 360);
        controls.marched = options.marched;
        controls.steps = options.steps;
        controls.sky_steps = options.sky_steps;
        controls.coarseness = options.coarseness;
        controls.automatic_exposure = !options.exposure;
        controls.exposure = float(options.exposure.value_or(20));
        return controls;
    }

    Picturing picturing(int width, int height) const {
        const bool marched = controls_.marched || tables_.kind == TableKind::transmittance;
        return Picturing{width,   height,          controls_.sun_elevation, controls_.sun_azimuth,
                         marched, controls_.steps, controls_.sky_steps,     live_settings()};
    }

    // ---- what keys and mouse do

    void press(int key) {
        const int camera = key - GLFW_KEY_1;
        if (camera >= 0 && camera < int(named_cameras().size())) {
            controls_.camera = named_cameras()[std::size_t(camera)];
            controls_.riding = false;
        } else if (key == GLFW_KEY_SPACE) {
            if (!controls_.riding) {
                controls_.ride = 0;
                ride_direction_ = 1;
            }
            controls_.riding = !controls_.riding || controls_.ride_pauses;
            controls_.ride_pauses = false;
        } else if (key == GLFW_KEY_M) {
            controls_.sun_moves = !controls_.sun_moves;
        } else if (key == GLFW_KEY_F1) {
            controls_.panel = !controls_.panel;
        } else if (key == GLFW_KEY_F5) {
            reload_ = f5_ = true;
        } else if (key == GLFW_KEY_F12) {
            screenshot_ = true;
        }
        dirty_ = true;
    }

    void zoom(double up) {
        controls_.camera.field_of_view =
            std::clamp(controls_.camera.field_of_view * std::pow(0.9, up), 5.0, 120.0);
        dirty_ = true;
    }

    /// Every motion of the mouse, however many there are in a frame.
    void drag(double x, double y) {
        const double right = x - cursor_x_;
        const double down = y - cursor_y_;
        cursor_x_ = x;
        cursor_y_ = y;
        if (ImGui::GetIO().WantCaptureMouse) {
            return;
        }
        if (glfwGetMouseButton(glfw_.window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
            const double degrees = controls_.camera.field_of_view / std::max(height_, 1);
            controls_.camera = turned(controls_.camera, -right * degrees, down * degrees);
            dirty_ = true;
        } else if (glfwGetMouseButton(glfw_.window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
            set_sun(hours_later(sun(), hours_per_pixel * right, options_.latitude));
            controls_.sun_elevation =
                std::clamp(controls_.sun_elevation - degrees_per_pixel * down, -90.0, 90.0);
            dirty_ = true;
        }
    }

    bool held(int key) const {
        return glfwGetKey(glfw_.window, key) == GLFW_PRESS;
    }

    void move(double seconds) {
        moving_ = false;
        if (!ImGui::GetIO().WantCaptureKeyboard) {
            const auto axis = [&](int plus, int minus) { return double(held(plus)) - double(held(minus)); };
            const Steering steering{axis(GLFW_KEY_W, GLFW_KEY_S), axis(GLFW_KEY_D, GLFW_KEY_A),
                                    axis(GLFW_KEY_E, GLFW_KEY_Q),
                                    held(GLFW_KEY_LEFT_SHIFT)     ? 5.0
                                    : held(GLFW_KEY_LEFT_CONTROL) ? 0.2
                                                                  : 1.0};
            if (steering.forward != 0 || steering.right != 0 || steering.up != 0) {
                controls_.riding = false;
                controls_.camera = flown(controls_.camera, steering, seconds,
                                         double(world_.atmosphere.ground_radius), terrain_);
                dirty_ = moving_ = true;
            }
        }
        if (controls_.sun_moves) {
            set_sun(hours_later(sun(), double(controls_.sun_speed) * seconds, options_.latitude));
            dirty_ = moving_ = true;
        }
        if (controls_.riding && !controls_.ride_pauses) {
            // Up and, from the end on, down again.
            controls_.ride += float(ride_direction_ * seconds / ride_seconds);
            if (controls_.ride <= 0 || controls_.ride >= 1) {
                controls_.ride = std::clamp(controls_.ride, 0.0f, 1.0f);
                ride_direction_ = -ride_direction_;
            }
            moving_ = true;
        }
        if (!controls_.riding) {
            ride_.clear();
        } else {
            if (ride_.empty()) {
                ride_ = flight(ride_stations, Moment{controls_.camera, 0, 0},
                               double(world_.atmosphere.ground_radius));
            }
            const long station = std::lround(controls_.ride * float(ride_stations - 1));
            controls_.camera = ride_[std::size_t(station)].camera;
            controls_.camera.name = "ride";
            dirty_ = dirty_ || moving_;
        }
    }

    SkyPlace sun() const {
        return SkyPlace{controls_.sun_elevation, controls_.sun_azimuth};
    }

    void set_sun(const SkyPlace& place) {
        controls_.sun_elevation = place.elevation;
        controls_.sun_azimuth = place.azimuth;
    }

    // ---- air and tables

    /// Whether the tables can be of another air than the picture's while they are baked: those of scattered
    /// light hold everything, and would be read in the wrong places.
    bool air_is_live() const {
        return tables_.kind != TableKind::inscatter3d && tables_.kind != TableKind::bruneton;
    }

    void bake() {
        baked_world_ = controls_.world;
        baker_.start(controls_.tables, controls_.world);
    }

    void take_tables() {
        if (std::optional<AirTables> baked = baker_.take()) {
            const bool same_kind = baked->kind == tables_.kind;
            tables_ = std::move(*baked);
            if (same_kind && renderer_ && !reload_) {
                renderer_->use(tables_);
                reference_renderer_.reset();
            }
            world_ = baked_world_;
            dirty_ = true;
        }
        if (air_is_live()) {
            world_ = controls_.world;
        } else {
            world_.nodes = controls_.world.nodes;
        }
        reference_world_ = with_nodes(world_, reference_nodes);
        status_.baked = baker_.busy() ? std::optional<double>(baker_.share()) : std::nullopt;
    }

    // ---- the renderer and what it was made with

    using Build = std::tuple<int, int, int, bool, bool, float, TableKind>;

    Build wanted_build() const {
        const int width = std::max(1, width_ / controls_.coarseness);
        const int height = std::max(1, height_ / controls_.coarseness);
        return Build{width,
                     height,
                     world_.nodes,
                     world_.lorentzian_ozone,
                     world_.vegetated,
                     world_.atmosphere.ground_radius,
                     tables_.kind};
    }

    /// Makes the renderer again when something changed that passes are made with. When its shaders do not
    /// compile, the old one goes on until the next reload.
    void build(double now) {
        const Build wanted = wanted_build();
        if (wanted != seen_) {
            seen_ = wanted;
            seen_since_ = now;
        }
        const bool rests = options_.window_frames || now - seen_since_ > settle_seconds;
        const bool other = renderer_ == nullptr || (wanted != built_ && rests && status_.error.empty());
        if (!other && !reload_) {
            return;
        }
        reload_ = false;
        // Not again before something changes, whatever comes of it.
        built_ = wanted;
        try {
            auto fresh = std::make_unique<Renderer>(world_, tables_, terrain_, controls_.settings,
                                                    std::get<0>(wanted), std::get<1>(wanted));
            difference_ = std::make_unique<DifferencePass>(std::get<0>(wanted), std::get<1>(wanted));
            renderer_ = std::move(fresh);
            settings_ = controls_.settings;
            reference_renderer_.reset();
            if (f5_) {
                status_.note = "shaders read again";
            }
            status_.error.clear();
        } catch (const support::Error& error) {
            if (renderer_ == nullptr) {
                throw;
            }
            status_.error = error.what();
        }
        f5_ = false;
        dirty_ = true;
    }

    /// What the renderer was made with, and of what has changed since only that which no pass is made with.
    Settings live_settings() const {
        Settings settings = settings_;
        settings.phong = controls_.settings.phong;
        settings.lommel_seeliger = controls_.settings.lommel_seeliger;
        settings.moon_elevation = controls_.settings.moon_elevation;
        settings.moon_azimuth = controls_.settings.moon_azimuth;
        return settings;
    }

    // ---- a frame

    void draw(double now) {
        take_tables();
        build(now);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        status_.times = renderer_->timers().read(false);
        status_.altitude = view_.altitude;
        status_.width = renderer_->width();
        status_.height = renderer_->height();
        obey(draw_panel(controls_, status_));
        ImGui::Render();
        if (reload_) {
            build(now);
        }

        const bool drawn = dirty_;
        if (dirty_) {
            dirty_ = false;
            draw_picture();
        }
        show(!drawn && !moving_);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        if (screenshot_) {
            screenshot_ = false;
            take_screenshot();
        }
    }

    void obey(const Wishes& wishes) {
        dirty_ = dirty_ || wishes.changed;
        if (wishes.air) {
            bake();
        }
        f5_ = f5_ || wishes.reload;
        reload_ = reload_ || wishes.reload || wishes.rebuild;
        screenshot_ = screenshot_ || wishes.screenshot;
        if (wishes.copy_cpp || wishes.copy_glsl) {
            const std::string text = wishes.copy_cpp ? as_cpp(controls_.world) : as_glsl(controls_.world);
            glfwSetClipboardString(glfw_.window, text.c_str());
            std::printf("%s\n", text.c_str());
            std::fflush(stdout);
            status_.note = "copied to the clipboard, and printed";
        }
    }

    void draw_picture() {
        try {
            view_ = make_view(controls_.camera, picturing(renderer_->width(), renderer_->height()),
                              double(world_.atmosphere.ground_radius), terrain_);
        } catch (const support::Error& error) {
            status_.note = error.what();  // the last view that was possible stays
        }
        renderer_->draw(view_, live_settings());
        if (controls_.automatic_exposure) {
            const std::vector<float> samples = read_samples(renderer_->radiance(), renderer_->width(),
                                                            renderer_->height(), samples_across, samples_up);
            controls_.exposure = automatic_exposure(samples, std::vector<bool>(samples.size() / 3));
        }
        compared_ = false;
        if (controls_.reference == Reference::fine) {
            try {
                draw_reference();
            } catch (const support::Error& error) {
                controls_.reference = Reference::none;
                status_.error = error.what();
            }
        }
    }

    /// The same picture as well as this renderer can.
    void draw_reference() {
        Settings settings = live_settings();
        if (settings.shafts != Shafts::none) {
            settings.shafts = Shafts::reference;
            settings.half_shafts = false;
        }
        if (reference_renderer_ == nullptr) {
            reference_renderer_ = std::make_unique<Renderer>(reference_world_, tables_, terrain_, settings,
                                                             renderer_->width(), renderer_->height());
        }
        View view = view_;
        view.frame.marched = 0;
        reference_renderer_->draw(view, settings);
        status_.reference =
            "Against 24 nodes, and 800 even steps for each pixel where there are light shafts. "
            "Relative differences, worst channel. The reference has the same table and the same passes: an "
            "error of those does not show. Its own air is within 0.1 % of exact single scattering.";
        if (!air_is_live()) {
            status_.reference =
                "This table holds all the light of the air: both pictures have it from there, "
                "and nodes make no difference. " +
                status_.reference;
        }
    }

    /// The picture or its difference from the reference into the window; numbers when all rests.
    void show(bool rests) {
        if (rests && controls_.reference != Reference::none && !compared_) {
            compare_at_rest();
        }
        const bool fine = controls_.reference == Reference::fine && reference_renderer_ != nullptr;
        const bool cpu = controls_.reference == Reference::cpu && compared_ && cpu_picture_ != 0;
        if (!fine && !cpu) {
            renderer_->show(live_settings(), controls_.exposure, 0, width_, height_);
            return;
        }
        const GLuint reference = fine ? reference_renderer_->radiance() : GLuint(cpu_picture_);
        const std::vector<float> samples =
            read_samples(reference, renderer_->width(), renderer_->height(), samples_across, samples_up);
        double sum = 0;
        for (const float sample : samples) {
            sum += double(sample);
        }
        difference_->draw(renderer_->radiance(), reference, float(1e-3 * sum / double(samples.size())),
                          scale_of(controls_.reference));
        copy_to(0, width_, height_, difference_->target(), renderer_->width(), renderer_->height());
        support::check_gl("showing a difference");
    }

    void compare_at_rest() {
        compared_ = true;
        const GpuPicture picture = renderer_->read();
        const int width = renderer_->width();
        const int height = renderer_->height();
        std::vector<float> other;
        if (controls_.reference == Reference::cpu) {
            cpu_picture_ = support::Texture();
            if (world_.nodes != airlight::DefaultScene::nodes) {
                status_.reference = "The CPU has 8 nodes: take as many here to compare.";
                return;
            }
            other = light_on_cpu(world_, tables_, view_.frame, picture.surfaces);
            cpu_picture_ = support::create_texture(GL_RGB32F, width, height);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGB, GL_FLOAT, other.data());
            status_.reference =
                "Against the C++ headers on the CPU, in float, from the GPU's surfaces: what the "
                "GPU's arithmetic and filtering differ, not an error of the method. Computed "
                "while the picture rests.";
        } else if (reference_renderer_ != nullptr) {
            other = reference_renderer_->read().radiance;
        } else {
            return;
        }
        const Comparison comparison =
            compare(picture.radiance, other, width, height, disc_pixels(view_.frame, picture.surfaces));
        char text[128];
        std::snprintf(text, sizeof text, "\nWorst %.2e at (%d, %d); 99.9 %% are below %.2e.",
                      comparison.largest, comparison.x, comparison.y, comparison.percentile);
        status_.reference += text;
    }

    // ---- files

    void write_window(const std::filesystem::path& path) const {
        std::vector<std::uint8_t> bytes(3 * std::size_t(width_) * std::size_t(height_));
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glReadBuffer(GL_BACK);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
        support::write_png(path, upright(bytes, width_, height_));
    }

    void take_screenshot() {
        try {
            const std::filesystem::path folder = options_.output;
            support::make_writable_directory(folder);
            std::filesystem::path base;
            for (int number = 1; base.empty() || std::filesystem::exists(base.string() + ".png"); ++number) {
                base = folder / ("airlight_" + std::to_string(number));
            }
            support::write_exr(base.string() + ".exr", layers(renderer_->read(), view_.frame));
            support::write_png(base.string() + ".png",
                               upright(renderer_->display(live_settings(), controls_.exposure),
                                       renderer_->width(), renderer_->height()));
            status_.note = "wrote " + base.string() + ".png and .exr";
        } catch (const support::Error& error) {
            status_.note = error.what();
        }
    }

    const Options& options_;
    Terrain terrain_;
    AirTables tables_{};
    Controls controls_;
    Settings settings_;  // that the renderer was made with
    World world_;        // of the picture
    World reference_world_;
    World baked_world_;
    View view_;
    Glfw glfw_;
    std::unique_ptr<Gui> gui_;
    Baker baker_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Renderer> reference_renderer_;
    std::unique_ptr<DifferencePass> difference_;
    support::Texture cpu_picture_;
    Status status_{};
    Build built_{};
    Build seen_{};
    double seen_since_ = 0;
    int width_ = 1;
    int height_ = 1;
    double cursor_x_ = 0;
    double cursor_y_ = 0;
    double ride_direction_ = 1;
    std::vector<Moment> ride_;  // empty when there is none
    bool dirty_ = true;
    bool moving_ = false;
    bool reload_ = false;
    bool f5_ = false;
    bool screenshot_ = false;
    bool compared_ = false;
};

}  // namespace

void run_window(const Options& options) {
    if (!options.screenshot.empty()) {
        support::make_writable_directory_of(options.screenshot);
    }
    Window(options).run();
}

}  // namespace deferred
