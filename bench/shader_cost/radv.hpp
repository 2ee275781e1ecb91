#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "blocks.hpp"

namespace shader_cost {

/// This machine has no RADV that compiles for a GPU that is not there; the text says what is missing.
class NoRadv : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What Mesa's compiler says about one compute shader.
struct Compiled {
    Counts counts;  ///< of the code, every block once
    std::vector<Block> blocks;
    double reported_instructions = 0;  ///< by RADV, of which counts and blocks are the parts
    double latency = 0;                ///< cycles one wave takes, by RADV's guesses of passes and branches
    double inverse_throughput = 0;     ///< cycles between two waves of 64 that a full SIMD finishes, likewise
    double code_bytes = 0;
    double sgprs = 0;
    double vgprs = 0;
    double spilled = 0;  ///< registers that went to memory

    bool has_loops() const;
};

/// RADV, Mesa's Vulkan driver for AMD, on a null device: it compiles for a GPU family and runs nothing.
class Radv {
  public:
    /// `family` as in RADV_FORCE_FAMILY: navi21, polaris10, ... Sets environment variables that Mesa reads.
    /// Throws NoRadv, and support::Error when the driver does not know the family.
    explicit Radv(const std::string& family);
    ~Radv();
    Radv(const Radv&) = delete;
    Radv& operator=(const Radv&) = delete;

    std::string device() const;  ///< as the driver calls it, "AMD RADV NAVI21"
    std::string driver() const;  ///< "Mesa 22.3.6"

    /// Compiles a compute shader whose resources are those of `preamble` in shaders.hpp.
    /// Throws support::Error when the driver refuses it.
    Compiled compile(const std::vector<std::uint32_t>& spirv) const;

  private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace shader_cost
