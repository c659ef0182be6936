// Loads the output of `permgen compile` at run time: the same tables as in the generated header, for programs that
// reload effects and for tools that read unknown effects.
#pragma once

#include <permgen/error.h>
#include <permgen/tables.h>

#include <filesystem>
#include <memory>

namespace permgen {

/// An effect and the memory of its tables. Pointers into the tables stay valid when it is moved.
class LoadedEffect {
public:
    struct Storage;  ///< the library's own
    explicit LoadedEffect(std::unique_ptr<const Storage> storage);
    LoadedEffect(LoadedEffect&&) noexcept;
    LoadedEffect& operator=(LoadedEffect&&) noexcept;
    ~LoadedEffect();

    /// The generated header's `effect`; it has frozen modules if --freeze wrote them. Valid during the life of this
    /// object, or of the one that it was moved into. Must not be called on a moved-from object.
    const Effect& tables() const;

private:
    std::unique_ptr<const Storage> storage_;
};

/// Loads `manifest`, a NAME.fx.json or a folder with exactly one of them, and the .spv files that it names, from the
/// same folder.
///
/// Errors: File if a file cannot be read; Format if the JSON is broken or has another format, a field is absent or has
/// the wrong type, a name (of a type, stage, kind, module, resource or block) is unknown, a file's name leads out of
/// the folder, or a .spv is empty, truncated or not SPIR-V.
Result<LoadedEffect> load_manifest(const std::filesystem::path& manifest);

}  // namespace permgen
