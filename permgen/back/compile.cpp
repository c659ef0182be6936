#include "back/compile.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace permgen {
namespace {

struct GlslangProcess {
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
};

}  // namespace

CompileResult compile_hlsl(Stage stage, const std::string& entry, const std::string& hlsl) {
    static const GlslangProcess process;
    constexpr EShLanguage languages[] = {EShLangVertex, EShLangFragment, EShLangCompute};
    const EShLanguage language = languages[static_cast<int>(stage)];
    // No EShMsgHlslLegalization: it allows code that is valid only after further passes.
    constexpr auto messages =
        static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl | EShMsgHlslDX9Compatible);

    glslang::TShader shader(language);
    const char* text = hlsl.data();
    const int length = static_cast<int>(hlsl.size());
    shader.setStringsWithLengths(&text, &length, 1);
    shader.setEntryPoint(entry.c_str());
    shader.setSourceEntryPoint(entry.c_str());
    shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    // Every Vulkan 1.1 device accepts SPIR-V 1.3, and HLSL of this kind needs no more.
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);

    CompileResult result;
    constexpr int default_version = 100;
    const bool parsed = shader.parse(GetDefaultResources(), default_version, false, messages);
    result.log = shader.getInfoLog();
    if (!parsed) return result;

    glslang::TProgram program;
    program.addShader(&shader);
    const bool linked = program.link(messages);
    result.log += program.getInfoLog();
    if (!linked) return result;

    glslang::SpvOptions options;
    options.disableOptimizer = true;  // specialize.h removes dead code once switches are set
    spv::SpvBuildLogger logger;
    glslang::GlslangToSpv(*program.getIntermediate(language), result.code, &logger, &options);
    result.log += logger.getAllMessages();
    return result;
}

void warm_up_compiler() {
    static const bool warm = [] {
        compile_hlsl(Stage::Vertex, "main", "float4 main(float4 p : P) : SV_Position { return p; }\n");
        compile_hlsl(Stage::Pixel, "main",
                     "sampler2D s; float4 main(float2 t : T) : SV_Target { return tex2D(s, t); }\n");
        return true;
    }();
    static_cast<void>(warm);
}

}  // namespace permgen
