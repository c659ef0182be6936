// Declarations: types, variables, structs, functions, constant buffers.
#pragma once

#include "front/parse_cursor.h"

namespace permgen {

/// Words before a type. Those that concern only the effect's interface are dropped from the text.
Qualifiers parse_qualifiers(ParseCursor& cursor);
TypeName parse_type(ParseCursor& cursor);

/// Drops `< ... >` with the declarations in it, if there is one.
void skip_annotations(ParseCursor& cursor);

/// The parts that may follow a declared name: brackets, `: SEMANTIC`, `: register(...)`, annotations, `= initializer`.
/// The initializer ends at one of the characters in `ends`.
void parse_declarator(ParseCursor& cursor, Variable& variable, std::string_view ends);

void parse_struct(ParseCursor& cursor);
void parse_typedef(ParseCursor& cursor);
void parse_constant_buffer(ParseCursor& cursor);

/// A function or one or more globals.
void parse_function_or_globals(ParseCursor& cursor);

}  // namespace permgen
