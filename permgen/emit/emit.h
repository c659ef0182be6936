// Turns a program into files. The same program gives the same bytes.
#pragma once

#include <string>
#include <vector>

#include "back/program.h"
#include "common/write_files.h"

namespace permgen {

struct EmitOptions {
    std::string name_space;  ///< of the generated header, "slices" or "studio::slices"
    bool freeze = false;     ///< emit each pass's specialized modules too
};

/// NAME.fx.h, NAME.fx.json and the .spv files, with names relative to the output folder.
std::vector<OutputFile> emit_files(const Program& program, const EmitOptions& options);

/// NAME.fx.h: all tables of permgen/tables.h, constexpr, and the output of emit_keys().
std::string emit_header(const Program& program, const EmitOptions& options);

/// The header's enum of techniques, and for each module with axes a key struct with its lookup functions.
std::string emit_keys(const Program& program);

/// NAME.fx.json: everything in the header, SPIR-V by file name.
std::string emit_manifest(const Program& program, const EmitOptions& options);

/// The entries of Module::attributes: a vertex module's inputs, a pixel module's outputs, without system
/// values; none of a compute module.
std::vector<LoweredAttribute> module_attributes(const LoweredModule& module);

/// The bytes of a SPIR-V file: little-endian on every machine.
std::string spirv_bytes(const SpirvWords& code);

/// "EFFECT.MODULE.spv", and "EFFECT.TECHNIQUE.PASS.STAGE.spv" for a frozen shader. The effect's name makes file names
/// unique if a folder holds two effects.
std::string module_file(const Program& program, std::size_t module);
std::string frozen_file(const Program& program, std::size_t technique, std::size_t pass, Stage stage);

/// Make's syntax: `target` depends on `dependencies`; spaces, '#', '%' and '$' are escaped.
std::string emit_depfile(const std::string& target, const std::vector<std::string>& dependencies);

}  // namespace permgen
