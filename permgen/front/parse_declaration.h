// Declarations: types, variables, structs, functions, constant buffers.
#pragma once

#include "front/parse_cursor.h"

namespace permgen {

/// Words in front of a type. Those that only the effect's interface is about are dropped from the text.
Qualifiers parse_qualifiers(ParseCursor& cursor);
TypeName parse_type(ParseCursor& cursor);

/// `< ... >` with declarations between, dropped; returns at once where there is none.
void skip_annotations(ParseCursor& cursor);

/// What may follow a declared name: brackets, `: SEMANTIC`, `: register(...)`, annotations, `= initializer`.
/// The initializer ends at one of the characters in `ends`.
void parse_declarator(ParseCursor& cursor, Variable& variable, std::string_view ends);

void parse_struct(ParseCursor& cursor);
void parse_typedef(ParseCursor& cursor);
void parse_constant_buffer(ParseCursor& cursor);

/// A function or one or more globals.
void parse_function_or_globals(ParseCursor& cursor);

}  // namespace permgen
