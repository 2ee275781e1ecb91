#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace shader_cost {

/// This machine has no RADV that compiles for a GPU that is not there; the text says what is missing.
class NoRadv : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What Mesa's compiler says about one compute shader. Counts are of the code, not of what one run executes.
struct Statistics {
    double instructions = 0;
    double vector = 0;          ///< of these, those that the vector unit executes, one lane a ray
    double transcendental = 0;  ///< of these, exp, log, 1/x, sqrt, 1/sqrt, sin, cos: four times the time
    double every_branch = 0;    ///< cycles that these keep the vector unit busy; see vector_cycles
    double code_bytes = 0;
    double sgprs = 0;
    double vgprs = 0;
    double spilled = 0;             ///< registers that went to memory
    double latency = 0;             ///< cycles one wave takes
    double inverse_throughput = 0;  ///< cycles between two waves of 64 that a full SIMD finishes
    bool loops = false;             ///< some loop was left, and stands once in every count
};

/// Cycles that a wave of 64 rays keeps the vector unit of an RDNA GPU busy, when it enters every branch: each
/// vector instruction issues twice, for 32 rays at a time, and the unit for transcendental ones takes 4
/// cycles for each half. These are the rates that Mesa's compiler assumes for its own figures.
constexpr double vector_cycles(double vector, double transcendental) {
    return 2 * vector > 8 * transcendental ? 2 * vector : 8 * transcendental;
}

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
    Statistics compile(const std::vector<std::uint32_t>& spirv) const;

  private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace shader_cost
