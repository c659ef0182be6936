// The inputs and outputs of an entry point, register by register.
//
// Locations depend on the semantic only, so that separately written stages, effects and vertex layouts agree:
//
//   vertex inputs                          vertex outputs and pixel inputs      pixel outputs
//   POSITION0      0    COLOR0-1   10-11   COLOR0-1      0-1                    COLORn       n (0 to 7)
//   NORMAL0        1    TANGENT0      12   TEXCOORD0-9   2-11
//   TEXCOORD0-7  2-9    BINORMAL0     13
//                       BLENDWEIGHT0  14
//                       BLENDINDICES0 15
//
// All other semantics of the effect get the locations after these (from 16, from 12), ordered by name and index over
// all the effect's entry points. An array takes one location for each element, with the index counting up; a matrix one
// for each column (each row, if row_major), as D3D9 assigns registers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "front/effect.h"
#include "lower/lower_types.h"
#include "lower/lowered.h"

namespace permgen {

/// The conversion between the author's variable and the interface.
enum class Conversion {
    None,
    Cast,        ///< bool is passed as uint
    PixelIndex,  ///< VPOS counts pixels, SV_Position their centres
    FaceSign,    ///< VFACE is +1 for front faces and -1 for back faces, SV_IsFrontFace is a bool
};

/// One register: a scalar or vector that crosses the stage's boundary.
struct InterfaceSlot {
    std::string path;  ///< the author's value: "permgen_argument0.position"
    unsigned matrix_column = 0;
    bool is_matrix_column = false;  ///< `path` is a matrix; the slot is its column `matrix_column`
    Semantic semantic;
    ScalarType scalar = ScalarType::Float;  ///< as it crosses the boundary
    unsigned components = 4;
    unsigned author_components = 4;  ///< VPOS may have fewer components than its builtin
    Conversion conversion = Conversion::None;
    ScalarType author_scalar = ScalarType::Float;
    std::string system_value;  ///< "SV_Position"; empty: has a location
    bool point_size = false;
    bool absent = false;        ///< no stage provides it (PSIZE in a pixel shader): reads as 0
    std::string interpolation;  ///< "centroid ", "nointerpolation ", ...
    SourceLocation place;

    /// The semantic's canonical text, see LoweredAttribute::semantic.
    std::string canonical() const;
};

enum class Direction { In, Out };

/// Appends the registers of one parameter or result. `path` is how the wrapper names the author's value.
void flatten(const ParsedEffect& effect, const Sources& sources, const Variable& variable, const std::string& path,
             Stage stage, Direction direction, std::vector<InterfaceSlot>& slots, Diagnostics& diagnostics);

/// Reports semantics that two slots share. Several paths may read one system value.
void check_distinct(const std::vector<InterfaceSlot>& slots, std::string_view entry, Diagnostics& diagnostics);

/// Widens each varying in `outputs` to the components that `inputs`, those of a pixel shader, read: D3D9 lets a pixel
/// shader read more components than the vertex shader writes, Vulkan does not.
void widen(std::vector<InterfaceSlot>& outputs, const std::vector<InterfaceSlot>& inputs);

/// Locations of the semantics that have no fixed one, effect-wide; see above.
struct LocationTable {
    std::map<std::pair<std::string, unsigned>, std::uint32_t> vertex_inputs;
    std::map<std::pair<std::string, unsigned>, std::uint32_t> varyings;
};

void collect(LocationTable& table, Stage stage, Direction direction, const std::vector<InterfaceSlot>& slots);
void number(LocationTable& table);
std::uint32_t location(const LocationTable& table, Stage stage, Direction direction, const InterfaceSlot& slot);

}  // namespace permgen
