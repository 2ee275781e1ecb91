#pragma once

// Compute passes that fill tables. A shader holds a function texel(uvw), which calls the same function of the
// library as the CPU does; shaders/bake.glsl is around it.

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "support/gl_objects.hpp"
#include "support/gl_table.hpp"
#include "support/presets.hpp"
#include "support/rows.hpp"

namespace bake_tables {

/// A table on the GPU, 32 bits a number.
struct GpuTable {
    support::Texture texture;
    support::TableSize size;
    support::TableShape shape;
};

/// A texture under the name that a pass has for it.
struct Source {
    std::string name;
    const GpuTable* table;
};

/// A number under the name that a pass has for it, whole where the shader says int.
struct Setting {
    std::string name;
    std::variant<int, float, airlight::vec3<float>> value;
};

/// Needs a current context of OpenGL 4.3.
class GpuBaker {
  public:
    explicit GpuBaker(const support::Preset& preset, const support::Rows& rows = support::Rows{});

    GpuTable make_table(const support::TableSize& size,
                        support::TableShape shape = support::TableShape::volume) const;

    /// Runs shaders/<shader>.comp for every texel of the targets, which are of one size; at most two.
    /// `defines` are lines that go before it.
    void pass(const std::string& shader, const std::vector<const GpuTable*>& targets,
              const std::vector<Source>& sources = {}, const std::vector<Setting>& settings = {},
              const std::string& defines = "");

    /// The same, but once for each column of slices: the shader defines BAKE_COLUMN and column(uvw), and
    /// stores all slices itself. One target, in layers.
    void column_pass(const std::string& shader, const GpuTable& target, const std::vector<Source>& sources,
                     const std::vector<Setting>& settings);

    /// How many passes there will be, for the progress bar.
    void expect_passes(int passes) const {
        rows_.expect_passes(passes);
    }

  private:
    void run(const std::string& shader, const std::vector<const GpuTable*>& targets,
             const std::vector<Source>& sources, const std::vector<Setting>& settings,
             const std::string& defines, int slices);
    GLuint program(const std::string& shader, const std::string& defines);

    support::Preset preset_;
    support::Rows rows_;
    std::map<std::string, support::Program> programs_;
};

/// The first `channels` numbers of every texel.
std::vector<float> numbers_of(const GpuTable& table, int channels);

/// The first three numbers of every texel of tables of one size, table after table in each texel.
std::vector<float> side_by_side(const std::vector<const GpuTable*>& tables);

}  // namespace bake_tables
