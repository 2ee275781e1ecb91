#include "radv.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "shaders.hpp"
#include "support/error.hpp"

namespace shader_cost {
namespace {

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw support::Error(std::string(what) + " failed with VkResult " + std::to_string(result) +
                             "; `vulkaninfo` shows whether this Vulkan works at all");
    }
}

/// The statistics of one compiled shader, by name: what the names are depends on the version of Mesa.
double number(const std::vector<VkPipelineExecutableStatisticKHR>& statistics, const char* name) {
    for (const VkPipelineExecutableStatisticKHR& s : statistics) {
        if (std::strcmp(s.name, name) != 0) {
            continue;
        }
        switch (s.format) {
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
                return s.value.b32 ? 1 : 0;
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
                return static_cast<double>(s.value.i64);
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
                return s.value.f64;
            default:
                return static_cast<double>(s.value.u64);
        }
    }
    throw support::Error(std::string("this Mesa does not report '") + name +
                         "' of a shader; use the version that bench/shader_cost/results.csv names");
}

}  // namespace

struct Radv::Device {
    VkInstance instance = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    VkPhysicalDeviceDriverProperties driver{};
    PFN_vkGetPipelineExecutableStatisticsKHR get_statistics = nullptr;
    PFN_vkGetPipelineExecutableInternalRepresentationsKHR get_representations = nullptr;

    ~Device() {
        if (device != VK_NULL_HANDLE) {
            vkDestroyPipelineLayout(device, layout, nullptr);
            vkDestroyDescriptorSetLayout(device, set_layout, nullptr);
            vkDestroyDevice(device, nullptr);
        }
        if (instance != VK_NULL_HANDLE) {
            vkDestroyInstance(instance, nullptr);
        }
    }

    std::vector<VkPipelineExecutableStatisticKHR> statistics(VkPipeline pipeline) const {
        VkPipelineExecutableInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
        info.pipeline = pipeline;
        std::uint32_t count = 0;
        check(get_statistics(device, &info, &count, nullptr), "vkGetPipelineExecutableStatisticsKHR");
        VkPipelineExecutableStatisticKHR empty{};
        empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
        std::vector<VkPipelineExecutableStatisticKHR> out(count, empty);
        check(get_statistics(device, &info, &count, out.data()), "vkGetPipelineExecutableStatisticsKHR");
        return out;
    }

    /// One of the texts that the compiler keeps of a shader.
    std::string representation(VkPipeline pipeline, const char* name) const {
        const char* const call = "vkGetPipelineExecutableInternalRepresentationsKHR";
        VkPipelineExecutableInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
        info.pipeline = pipeline;
        std::uint32_t count = 0;
        check(get_representations(device, &info, &count, nullptr), call);
        VkPipelineExecutableInternalRepresentationKHR empty{};
        empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR;
        std::vector<VkPipelineExecutableInternalRepresentationKHR> all(count, empty);
        check(get_representations(device, &info, &count, all.data()), call);  // the sizes
        std::vector<std::string> texts;
        for (const VkPipelineExecutableInternalRepresentationKHR& one : all) {
            texts.emplace_back(one.dataSize, '\0');
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].pData = texts[i].data();
        }
        check(get_representations(device, &info, &count, all.data()), call);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (std::strcmp(all[i].name, name) == 0) {
                return texts[i];
            }
        }
        throw support::Error(std::string("this Mesa does not show the '") + name +
                             "' of a shader; use the version that bench/shader_cost/results.csv names");
    }

    VkPipeline pipeline(const std::vector<std::uint32_t>& spirv, VkPipelineCreateFlags capture) const {
        const VkShaderModuleCreateInfo module_info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, nullptr, 0,
                                                   spirv.size() * sizeof(spirv[0]), spirv.data()};
        VkShaderModule shader = VK_NULL_HANDLE;
        check(vkCreateShaderModule(device, &module_info, nullptr, &shader), "vkCreateShaderModule");
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.flags = capture;
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = shader;
        info.stage.pName = "main";
        info.layout = layout;
        VkPipeline out = VK_NULL_HANDLE;
        const VkResult result = vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &out);
        vkDestroyShaderModule(device, shader, nullptr);
        check(result, "vkCreateComputePipelines");
        return out;
    }
};

namespace {

/// Environment variables that would change what the compiler does.
void pin_environment(const std::string& family) {
    setenv("RADV_FORCE_FAMILY", family.c_str(), 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    for (const char* name : {"ACO_DEBUG", "RADV_DEBUG", "RADV_PERFTEST", "NIR_DEBUG", "AMD_DEBUG"}) {
        unsetenv(name);
    }
}

VkInstance create_instance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "shader_cost";
    application.apiVersion = VK_API_VERSION_1_2;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance out = VK_NULL_HANDLE;
    if (vkCreateInstance(&info, nullptr, &out) != VK_SUCCESS) {
        throw NoRadv(
            "no Vulkan driver was found; install RADV (Debian: apt-get install mesa-vulkan-drivers)");
    }
    return out;
}

/// Mesa ends the process when it is asked for a family it does not know, so a child process asks first.
bool knows_family() {
    const pid_t child = fork();
    if (child == 0) {
        // What Mesa says then is said again, in this program's words.
        if (std::freopen("/dev/null", "w", stderr) == nullptr) {
            _exit(1);
        }
        try {
            std::uint32_t count = 0;
            vkEnumeratePhysicalDevices(create_instance(), &count, nullptr);
        } catch (const NoRadv&) {
            // The parent finds that out for itself.
        }
        _exit(0);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
}

/// RADV among the Vulkan devices of this machine: others (a software one, another GPU) do not count.
VkPhysicalDevice find_radv(VkInstance instance, VkPhysicalDeviceProperties& properties,
                           VkPhysicalDeviceDriverProperties& driver) {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    vkEnumeratePhysicalDevices(instance, &count, devices.data());
    for (const VkPhysicalDevice device : devices) {
        driver = VkPhysicalDeviceDriverProperties{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        VkPhysicalDeviceProperties2 both{};
        both.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        both.pNext = &driver;
        vkGetPhysicalDeviceProperties2(device, &both);
        if (driver.driverID == VK_DRIVER_ID_MESA_RADV) {
            properties = both.properties;
            return device;
        }
    }
    throw NoRadv(
        "this machine's Vulkan has no RADV; install it (Debian: apt-get install mesa-vulkan-drivers)");
}

VkDevice create_device(VkPhysicalDevice gpu) {
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR reports{};
    reports.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    reports.pipelineExecutableInfo = VK_TRUE;
    const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &reports;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    VkDevice out = VK_NULL_HANDLE;
    check(vkCreateDevice(gpu, &info, nullptr, &out), "vkCreateDevice");
    return out;
}

}  // namespace

Radv::Radv(const std::string& family) : device_(std::make_unique<Device>()) {
    pin_environment(family);
    if (!knows_family()) {
        throw support::Error("RADV knows no GPU family '" + family +
                             "'; it is a name such as navi21, vega10 or polaris10");
    }
    Device& d = *device_;
    d.instance = create_instance();
    const VkPhysicalDevice gpu = find_radv(d.instance, d.properties, d.driver);
    d.device = create_device(gpu);

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    const auto bind = [&](std::uint32_t at, VkDescriptorType type) {
        bindings.push_back({at, type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    };
    bind(binding::inputs, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    bind(binding::results, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    bind(binding::atmosphere, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    for (std::uint32_t i = 0; i < binding::tables; ++i) {
        bind(binding::table + i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    }
    bind(binding::sizes, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    VkDescriptorSetLayoutCreateInfo set_info{};
    set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set_info.pBindings = bindings.data();
    check(vkCreateDescriptorSetLayout(d.device, &set_info, nullptr, &d.set_layout),
          "vkCreateDescriptorSetLayout");
    VkPipelineLayoutCreateInfo layout_info{};
    layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout_info.setLayoutCount = 1;
    layout_info.pSetLayouts = &d.set_layout;
    check(vkCreatePipelineLayout(d.device, &layout_info, nullptr, &d.layout), "vkCreatePipelineLayout");

    d.get_statistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        vkGetDeviceProcAddr(d.device, "vkGetPipelineExecutableStatisticsKHR"));
    d.get_representations = reinterpret_cast<PFN_vkGetPipelineExecutableInternalRepresentationsKHR>(
        vkGetDeviceProcAddr(d.device, "vkGetPipelineExecutableInternalRepresentationsKHR"));
    if (d.get_statistics == nullptr || d.get_representations == nullptr) {
        throw NoRadv("this RADV lacks VK_KHR_pipeline_executable_properties; Mesa 20 and later have it");
    }
}

Radv::~Radv() = default;

std::string Radv::device() const {
    return device_->properties.deviceName;
}

std::string Radv::driver() const {
    const std::string info = device_->driver.driverInfo;
    return info.substr(0, info.find(" ("));  // without the compiler that Mesa was built with
}

Compiled Radv::compile(const std::vector<std::uint32_t>& spirv) const {
    const Device& d = *device_;
    const VkPipeline pipeline =
        d.pipeline(spirv, VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR |
                              VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR);
    const std::vector<VkPipelineExecutableStatisticKHR> all = d.statistics(pipeline);
    const std::string ir = d.representation(pipeline, "ACO IR");
    const std::string assembly = d.representation(pipeline, "Assembly");
    vkDestroyPipeline(d.device, pipeline, nullptr);

    Compiled out;
    out.blocks = read_blocks(ir, assembly);
    for (const Block& block : out.blocks) {
        out.counts.instructions += block.counts.instructions;
        out.counts.vector += block.counts.vector;
        out.counts.transcendental += block.counts.transcendental;
    }
    out.reported_instructions = number(all, "Instructions");
    out.latency = number(all, "Latency");
    out.inverse_throughput = number(all, "Inverse Throughput");
    out.code_bytes = number(all, "Code size");
    out.sgprs = number(all, "SGPRs");
    out.vgprs = number(all, "VGPRs");
    out.spilled = number(all, "Spilled SGPRs") + number(all, "Spilled VGPRs");
    return out;
}

bool Compiled::has_loops() const {
    return std::any_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.loops > 0; });
}

}  // namespace shader_cost
