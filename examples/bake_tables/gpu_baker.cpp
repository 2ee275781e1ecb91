#include "gpu_baker.hpp"

#include <algorithm>
#include <filesystem>

#include "support/gl_context.hpp"
#include "support/glsl_source.hpp"
#include "support/uniforms.hpp"

namespace bake_tables {
namespace {

constexpr int group_size = 8;

GLuint groups(int count) {
    return GLuint((count + group_size - 1) / group_size);
}

}  // namespace

GpuBaker::GpuBaker(const support::Preset& preset, const support::Rows& rows) : preset_(preset), rows_(rows) {}

GpuTable GpuBaker::make_table(const support::TableSize& size, support::TableShape shape) const {
    GpuTable table{support::create_table_texture(GL_RGBA32F, size, shape), size, shape};
    support::upload_table(table.texture, size, {}, 4,
                          shape);  // zeros: what a driver leaves there is not defined
    return table;
}

GLuint GpuBaker::program(const std::string& shader, const std::string& defines) {
    const auto known = programs_.find(shader + defines);
    if (known != programs_.end()) {
        return known->second;
    }
    const std::vector<std::filesystem::path> folders = {BAKE_TABLES_SHADER_FOLDER, AIRLIGHT_GLSL_FOLDER};
    const std::string text = "#version 430 core\n#define AIRLIGHT_OZONE " + std::to_string(preset_.ozone) +
                             "\n" + defines + "#include \"" + shader + ".comp\"\n";
    const support::ExpandedGlsl source = support::expand_includes(text, "preamble of " + shader, folders);
    programs_[shader + defines] = support::link_program({{GL_COMPUTE_SHADER, source.text, source.names}});
    return programs_[shader + defines];
}

void GpuBaker::pass(const std::string& shader, const std::vector<const GpuTable*>& targets,
                    const std::vector<Source>& sources, const std::vector<Setting>& settings,
                    const std::string& defines) {
    run(shader, targets, sources, settings, defines, targets.front()->size.depth);
}

void GpuBaker::column_pass(const std::string& shader, const GpuTable& target,
                           const std::vector<Source>& sources, const std::vector<Setting>& settings) {
    run(shader, {&target}, sources, settings, "", 1);
}

void GpuBaker::run(const std::string& shader, const std::vector<const GpuTable*>& targets,
                   const std::vector<Source>& sources, const std::vector<Setting>& settings,
                   const std::string& defines, int slices) {
    const support::Uniforms uniforms(program(shader, defines));
    uniforms.set("atmosphere", support::converted<float>(preset_.air));
    const support::TableSize size = targets.front()->size;
    uniforms.set("width", size.width);
    uniforms.set("height", size.height);
    uniforms.set("depth", size.depth);
    for (const Setting& setting : settings) {
        std::visit([&](const auto& value) { uniforms.set(setting.name, value); }, setting.value);
    }
    for (std::size_t n = 0; n < targets.size(); ++n) {
        glBindImageTexture(GLuint(n), targets[n]->texture, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    }
    for (std::size_t n = 0; n < sources.size(); ++n) {
        uniforms.set(sources[n].name, int(n));
        glActiveTexture(GLenum(GL_TEXTURE0 + n));
        glBindTexture(support::table_target(sources[n].table->shape), sources[n].table->texture);
    }
    // Slice by slice, waiting for each: no driver takes the program for stuck, and the bar moves.
    for (int slice = 0; slice < slices; ++slice) {
        uniforms.set("slice", slice);
        glDispatchCompute(groups(size.width), groups(size.height), 1);
        glFinish();
        rows_.report(std::size_t(slice + 1), std::size_t(slices));
    }
    rows_.end_pass();
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    support::check_gl(shader.c_str());
}

std::vector<float> numbers_of(const GpuTable& table, int channels) {
    return support::download_table(table.texture, table.size, channels, table.shape);
}

std::vector<float> side_by_side(const std::vector<const GpuTable*>& tables) {
    std::vector<std::vector<float>> parts;
    for (const GpuTable* const table : tables) {
        parts.push_back(numbers_of(*table, 3));
    }
    std::vector<float> numbers;
    for (std::size_t n = 0; n < parts.front().size(); n += 3) {
        for (const std::vector<float>& part : parts) {
            numbers.insert(numbers.end(), {part[n], part[n + 1], part[n + 2]});
        }
    }
    return numbers;
}

}  // namespace bake_tables
