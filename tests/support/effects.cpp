#include "effects.h"

#include <permgen/manifest.h>

#include <cstdlib>
#include <map>
#include <stdexcept>

namespace tyndall::test {

const permgen::Effect* effectUnderTest(const std::string& name) {
    const char* named = std::getenv("TYNDALL_EFFECTS");
    if (!named) return nullptr;
    const std::filesystem::path folder = named;
    if (!std::filesystem::is_directory(folder))
        throw std::runtime_error("TYNDALL_EFFECTS: " + folder.string() + " is no folder");
    const std::filesystem::path manifest = folder / (name + ".fx.json");
    if (!std::filesystem::exists(manifest)) return nullptr;

    static std::map<std::string, permgen::LoadedEffect> loaded;
    const auto known = loaded.find(name);
    if (known != loaded.end()) return &known->second.tables();
    auto result = permgen::load_manifest(manifest);
    if (!result) throw std::runtime_error("TYNDALL_EFFECTS: " + result.error().message);
    return &loaded.emplace(name, std::move(*result)).first->second.tables();
}

}  // namespace tyndall::test
