// Loads at run time what `permgen compile` wrote into a folder: the very tables that the generated header
// holds, for programs that reload effects while they run and for tools that meet an effect for the first time.
#pragma once

#include <permgen/error.h>
#include <permgen/tables.h>

#include <filesystem>
#include <memory>

namespace permgen {

/// An effect and the memory its tables lie in. Moving one leaves every pointer into its tables valid.
class LoadedEffect {
public:
    struct Storage;  ///< the library's own
    explicit LoadedEffect(std::unique_ptr<const Storage> storage);
    LoadedEffect(LoadedEffect&&) noexcept;
    LoadedEffect& operator=(LoadedEffect&&) noexcept;
    ~LoadedEffect();

    /// What the generated header calls `effect`; frozen modules are there where --freeze wrote them. Valid as
    /// long as this object, or the one that it was moved into, lives. Must not be called on a moved-from object.
    const Effect& tables() const;

private:
    std::unique_ptr<const Storage> storage_;
};

/// Loads `manifest`, a NAME.fx.json or a folder that holds only one of them, and the .spv files that it names,
/// which lie beside it.
///
/// Errors: File where a file cannot be read; Format where the JSON is broken or of another format, where a field is absent or
/// of the wrong type, where a name (of a type, stage, kind, module, resource or block) is unknown, where a
/// file's name leads out of the folder, and where a .spv is empty, torn or no SPIR-V.
Result<LoadedEffect> load_manifest(const std::filesystem::path& manifest);

}  // namespace permgen
